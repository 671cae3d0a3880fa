/// Version and commit of the suite, as `-version` prints them and as they stand at the head of every log.
#pragma once
#include <filesystem>
#include <string>

namespace sph
{

struct Version
{
    std::string number; ///< of the project, "0.1"
    std::string
        commit; ///< as git describes it, "f403b019-dirty" of sources that have been changed since; empty of an archive without its history

    /// "0.1 (f403b019)"
    std::string text() const;
};

/// Version of the program that runs. Applications set it before main (applications/version.cpp.in); tests do not, so that a commit links
/// applications alone again.
const Version& version();
void setVersion(Version);

/// Head of a log, in the layout of OpenFOAM's, ended by a blank line. `further` are lines of the program's own.
std::string banner(const std::string& program, const std::filesystem::path& caseFolder, const std::string& further = "");

}
