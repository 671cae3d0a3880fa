/// Folder in which function objects write: below postProcessing/ of a running case, or of one whose stored times are looked at.
#pragma once
#include "case/RunTime.hpp"
#include <filesystem>
#include <functional>

namespace sph
{

struct OutputPlace
{
    std::function<std::filesystem::path(const std::string& function)> caseFolder;
    /// postProcessing/<function>/<startTime>/<file>; an existing file is kept and another name taken.
    std::function<std::filesystem::path(const std::string& function, const std::string& file)> file;
    /// Name of the current time.
    std::function<std::string()> timeName;
};

/// `time` must outlive the result.
OutputPlace outputOf(const RunTime& time);

/// Place of output for stored times, of which `first` is the first to be looked at; `current` must outlive the result.
OutputPlace outputOf(const std::filesystem::path& caseFolder, const std::string& first, const std::string& current);
OutputPlace outputOf(const std::filesystem::path& caseFolder, const std::string& first, std::string&& current) = delete;

}
