/// One file of all ranks, in OpenFOAM's word a collated one.
#pragma once
#include "base/OutputFile.hpp"
#include <filesystem>
#include <functional>
#include <optional>

namespace sph
{

/// Writes a file that is not there yet: `part` writes what this rank has of it, behind what the ranks before it have. One process alone writes it as any other file.
/// `length` [bytes]: of the part; where no rank says it, `part` is called twice. All ranks throw the same CaseError, or none.
void writeCollated(const std::filesystem::path&, const std::function<void(OutputFile&)>& part, std::optional<std::size_t> length = {});

}
