#include "sampling/FunctionContext.hpp"

namespace sph
{

std::filesystem::path FunctionContext::file(const std::string& fileName) const
{
    const auto path = output.file(name, fileName);
    createFolders(path.parent_path());
    return path;
}

std::filesystem::path FunctionContext::fileOfTime(const std::string& fileName) const
{
    const auto folder = output.caseFolder(name) / "postProcessing" / name / output.timeName();
    createFolders(folder);
    return folder / fileName;
}

}
