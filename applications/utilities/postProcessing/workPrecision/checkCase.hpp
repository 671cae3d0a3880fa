/// Reads a case as the applications of the suite do, to find its mistakes before the first run.
#pragma once
#include "case/Case.hpp"
#include <string>
#include <vector>

namespace sph
{

struct CaseCheck
{
    /// "file:line: what" each; empty where all is well.
    std::vector<std::string> mistakes;
    double endTime = 0; ///< [s]
    double spacing = 0; ///< [m]
};

/// The files that `programs` read whole: an entry that is not meant for them is found by the check.
std::vector<std::string> filesReadWhole(const std::vector<std::string>& programs);

/// Checks a copy of a case that has not been packed yet. Adds an empty folder 0 to it.
CaseCheck checkCase(const std::filesystem::path& folder, const std::vector<std::string>& programs);

/// What the `field` column of errors.dat holds for a function object of type errors.
std::vector<std::string> errorFields(const Dictionary& function);

}
