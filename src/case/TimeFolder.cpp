#include "case/TimeFolder.hpp"
#include "base/CaseError.hpp"
#include "base/OutputFile.hpp"
#include "case/FoamHeader.hpp"
#include "parallel/Ranks.hpp"
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace sph
{

namespace fs = std::filesystem;

namespace
{

[[noreturn]] void fail(const fs::path& folder, const std::string& what, const std::error_code& reason)
{
    throw CaseError({folder.string(), 0}, what + ": " + reason.message());
}

void removeAll(const fs::path& folder)
{
    std::error_code reason;
    fs::remove_all(folder, reason);
    if (reason) fail(folder, "cannot be removed", reason);
}

void moveTo(const fs::path& from, const fs::path& to)
{
    std::error_code reason;
    fs::rename(from, to, reason);
    if (reason) fail(to, "cannot be renamed from " + from.filename().string(), reason);
}

/// Both names exist at every moment, where the file system can exchange them (Linux, local disks).
bool exchange(const fs::path& a, const fs::path& b) { return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0; }

void moveIntoPlace(const fs::path& partial, const fs::path& folder)
{
    if (!fs::exists(folder)) return moveTo(partial, folder);
    if (exchange(partial, folder)) return removeAll(partial);
    // The name must not be one that removePartialFolders takes away: until the second renaming this is the last good one.
    const auto former = folder.string() + ".former";
    removeAll(former);
    moveTo(folder, former);
    moveTo(partial, folder);
    removeAll(former);
}

/// Removes its folder unless it was moved away: what is left of one that could not be filled.
struct Partial
{
    fs::path folder;
    ~Partial()
    {
        std::error_code ignored;
        if (isFirstRank()) fs::remove_all(folder, ignored);
    }
};

}

void writeFolder(const fs::path& parent, const std::string& name, const std::function<void(const fs::path&)>& fill)
{
    const Partial partial{parent / (name + partialSuffix)};
    byFirst(
        [&]
        {
            removeAll(partial.folder);
            createFolders(partial.folder);
        });
    fill(partial.folder);
    byFirst([&] { moveIntoPlace(partial.folder, parent / name); });
}

void removeFolder(const fs::path& parent, const std::string& name)
{
    if (!fs::exists(parent / name)) return;
    const Partial partial{parent / (name + partialSuffix)};
    moveTo(parent / name, partial.folder);
    removeAll(partial.folder);
}

void removePartialFolders(const fs::path& parent)
{
    std::error_code unreadable;
    std::vector<fs::path> stale;
    for (const auto& entry : fs::directory_iterator(parent, unreadable))
        if (entry.path().extension() == partialSuffix && entry.is_directory(unreadable)) stale.push_back(entry.path());
    for (const auto& folder : stale) removeAll(folder);
}

void copyFolder(const fs::path& parent, const std::string& from, const std::string& to)
{
    const Partial partial{parent / fmt::format("{}.{}{}", to, ::getpid(), partialSuffix)};
    std::error_code reason;
    fs::copy(parent / from, partial.folder, fs::copy_options::recursive, reason);
    if (reason) fail(parent / to, "cannot be copied from " + from, reason);
    fs::rename(partial.folder, parent / to, reason);
    if (reason && !fs::is_directory(parent / to)) fail(parent / to, "cannot be copied from " + from, reason);
}

}
