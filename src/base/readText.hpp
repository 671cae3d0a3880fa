/// The text of a file that a person may have written: a dictionary, a table.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace sph
{

/// Far beyond any text that is written by hand; fields of particles are read otherwise (MappedFile).
inline constexpr std::size_t longestText = 64 << 20;

/// Nothing where there is none, with the reason in words: a missing file, a folder, a pipe or a device, which may have no end.
std::optional<std::string> readText(const std::filesystem::path&, std::string& reason);

}
