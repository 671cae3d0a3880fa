#include "case/replaceCloud.hpp"
#include "case/TimeFolder.hpp"
#include <algorithm>
#include <system_error>

namespace sph
{

namespace
{
/// Copies all of a time folder but its particles and what a run has stored of them.
void copyOthers(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& cloud)
{
    namespace fs = std::filesystem;
    const std::vector<fs::path> own{"lagrangian/" + cloud, "uniform/lagrangian/" + cloud, "uniform/time", "uniform/sphState",
                                    "uniform/functionObjects"};
    std::error_code reason, none;
    for (auto at = fs::recursive_directory_iterator(from, none); at != fs::recursive_directory_iterator() && !reason; ++at)
        if (const auto name = at->path().lexically_relative(from); std::ranges::find(own, name) != own.end())
            at.disable_recursion_pending();
        else if (at->is_directory()) fs::create_directories(to / name, reason);
        else fs::copy(at->path(), to / name, fs::copy_options::copy_symlinks, reason);
    if (reason) throw CaseError({from.string(), 0}, "cannot be copied: " + reason.message());
}
}

void replaceCloud(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud, std::size_t n,
                  const FieldView& positions, const std::vector<FieldView>& fields, const WriteOptions& options)
{
    writeFolder(caseFolder, time,
                [&](const std::filesystem::path& folder)
                {
                    copyOthers(caseFolder / time, folder, cloud);
                    writeCloud(folder, cloud, n, positions, fields, options);
                });
}

}
