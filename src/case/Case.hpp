/// The case folder: where its files are, and the Diagnostics that reading any of them shares.
#pragma once
#include "dictionary/Dictionary.hpp"
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace sph
{

class Case
{
    std::filesystem::path folder_;
    std::shared_ptr<Diagnostics> diagnostics_ = std::make_shared<Diagnostics>();

public:
    /// Throws CaseError if the folder is not there.
    explicit Case(const std::filesystem::path& folder);

    const std::filesystem::path& folder() const { return folder_; }
    Diagnostics& diagnostics() const { return *diagnostics_; }
    std::shared_ptr<Diagnostics> sharedDiagnostics() const { return diagnostics_; }

    bool has(const std::string& file) const;
    /// `dictionary("system/controlDict")`; a missing file is an error and gives an empty dictionary.
    Dictionary dictionary(const std::string& file) const;
    /// A missing file gives an empty dictionary silently.
    Dictionary dictionaryIfPresent(const std::string& file) const;

    /// Names of the time folders as they stand on disk, sorted by value; "0.orig" and non-numbers are none. `under` a folder of the case.
    std::vector<std::string> times(const std::string& under = "") const;
};

}
