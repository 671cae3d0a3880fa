/// A dictionary in which some entries are given from outside.
#pragma once
#include "Dictionary.hpp"

namespace sph
{

/// As Dictionary::read, with `entries` ("n 8;") ahead of the file's own, on its first line: `$n` and `#eval "1/$n"` in it then give
/// their values. An entry of the file that has one of these names is an error.
Dictionary readWith(const std::string& entries, const std::filesystem::path& caseFolder, const std::string& file,
                    std::shared_ptr<Diagnostics>);

}
