/// Reading of a dictionary from another text than that of its file.
#pragma once
#include "dictionary/Dictionary.hpp"

namespace sph
{

/// `text` read as though `caseFolder/file` held it: includes are sought from there, and messages name `file`.
Dictionary readAs(const std::string& text, const std::filesystem::path& caseFolder, const std::string& file, std::shared_ptr<Diagnostics>);

/// Reads as Dictionary::read, with `entries` ("n 8;") ahead of the file's own, on its first line: `$n` and `#eval "1/$n"` in it then give
/// their values. An entry of the file that has one of these names is an error.
Dictionary readWith(const std::string& entries, const std::filesystem::path& caseFolder, const std::string& file,
                    std::shared_ptr<Diagnostics>);

}
