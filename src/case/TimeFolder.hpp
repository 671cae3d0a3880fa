/// A time folder comes to be at once: it is filled under another name, `<time>.partial`, and renamed when it is whole.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace sph
{

/// Fills `parent/name`, replacing what has that name. When `fill` throws, or the disk is full, neither the folder nor anything of it is
/// left and what had the name before is untouched; the failure goes on as CaseError, or as whatever `fill` threw. Ranks fill one folder together:
/// `fill` throws on all of them or on none (allOrNone).
void writeFolder(const std::filesystem::path& parent, const std::string& name,
                 const std::function<void(const std::filesystem::path&)>& fill);

/// Removes a time folder, under another name: a half-removed one is never taken for a time.
void removeFolder(const std::filesystem::path& parent, const std::string& name);

/// Removes the partial folders that a killed run has left.
void removePartialFolders(const std::filesystem::path& parent);

/// Copies `parent/from` to `parent/to` in the same manner. Several processes may do so at the same time: one wins, all go on.
void copyFolder(const std::filesystem::path& parent, const std::string& from, const std::string& to);

}
