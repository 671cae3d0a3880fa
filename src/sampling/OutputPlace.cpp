#include "sampling/OutputPlace.hpp"
#include <fmt/format.h>

namespace sph
{

OutputPlace outputOf(const RunTime& time)
{
    // The path of an output file is <case>/postProcessing/<function>/<startTime>/<file>.
    return {[&time](const std::string& function)
            { return time.outputFile(function, "file").parent_path().parent_path().parent_path().parent_path(); },
            [&time](const std::string& function, const std::string& file) { return time.outputFile(function, file); },
            [&time] { return time.name(); }};
}

OutputPlace outputOf(const std::filesystem::path& caseFolder, const std::string& first, const std::string& current)
{
    const auto file = [caseFolder, first](const std::string& function, const std::string& name)
    {
        const auto path = caseFolder / "postProcessing" / function / first / name;
        if (!std::filesystem::exists(path)) return path;
        return path.parent_path() / fmt::format("{}_{}{}", path.stem().string(), first, path.extension().string());
    };
    return {[caseFolder](const std::string&) { return caseFolder; }, file, [&current] { return current; }};
}

}
