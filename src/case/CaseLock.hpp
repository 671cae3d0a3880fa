/// Lock of a case, for one program at a time to write time folders into it: another would take away those that this one is writing.
///
/// The file `.lock` of the case holds the program, its process id and its machine, for people; the system's lock on it, which ends with the
/// process whatever ends it, decides. A file that a killed process has left is taken over.
#pragma once
#include <filesystem>
#include <string>

namespace sph
{

class CaseLock
{
    std::filesystem::path file_;
    int descriptor_ = -1;

public:
    /// Throws CaseError that names the other process where one has the case.
    CaseLock(const std::filesystem::path& caseFolder, const std::string& program);
    CaseLock(const CaseLock&) = delete;
    CaseLock& operator=(const CaseLock&) = delete;
    /// Removes the file.
    ~CaseLock();
};

}
