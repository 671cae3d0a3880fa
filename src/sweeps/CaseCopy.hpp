/// A case of its own for each run.
#pragma once
#include "sweeps/SweepPlan.hpp"

namespace sph
{

/// Copies what a run begins with into a new folder: constant, system, reference, 0.orig (or, with `withStart`, 0), without what
/// meshToGhost and the solver write; includes by paths out of the case follow. A folder of that name is replaced.
void copyInputs(const std::filesystem::path& from, const std::filesystem::path& to, bool withStart);

/// The same into a folder that keeps whatever else it has, with files of `laidOver`, folders of such parts, in place of those of the case; what
/// these include is sought from the copy. 0 is not copied.
void renewInputs(const std::filesystem::path& from, const std::vector<std::filesystem::path>& laidOver, const std::filesystem::path& to);

/// 16 hexadecimal digits that change with any byte of the files below a folder, their names, or `more`; files `without` apart.
std::string inputsStamp(const std::filesystem::path& folder, const std::vector<std::string>& without, const std::vector<std::string>& more);

/// The content of a file as part of such a stamp.
std::string fileStamp(const std::filesystem::path&);

}
