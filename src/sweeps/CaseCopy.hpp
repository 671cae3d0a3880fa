/// A case of its own for each run.
#pragma once
#include "sweeps/SweepPlan.hpp"

namespace sph
{

/// Copies what a run begins with into a new folder: constant, system, reference, 0.orig (or, with `withStart`, 0), without what
/// meshToGhost and the solver write; includes by paths out of the case follow. A folder of that name is replaced.
void copyInputs(const std::filesystem::path& from, const std::filesystem::path& to, bool withStart);

/// Gives the entries their values, in order; comments, macros and includes stay, so that entries made of others by macros follow.
/// A dictionary that is missing is added. An entry that cannot be set is recorded at its place in workPrecisionDict.
void apply(const std::vector<Override>&, const std::filesystem::path& caseFolder, Diagnostics&);

/// Location of an override in the copy; file without line where it is not there.
Location placeOf(const Override&, const std::filesystem::path& caseFolder);

/// 16 hexadecimal digits that change with any byte of the files below a folder, their names, or `more`; files `without` apart.
std::string inputsStamp(const std::filesystem::path& folder, const std::vector<std::string>& without, const std::vector<std::string>& more);

/// The content of a file as part of such a stamp.
std::string fileStamp(const std::filesystem::path&);

}
