/// Reading one file of a cloud: the FoamFile header, then one list, and nothing else.
#pragma once
#include "case/Cloud.hpp"
#include <optional>
#include <string>

namespace sph
{

struct Positions
{
    std::vector<double> x, y, z; ///< of the slice
    std::size_t count = 0;       ///< in the file
};

/// Both record what is wrong, with file (as given, relative to the case) and line, and then return nothing. Lines are given for
/// ascii data and for the header; in binary data there are none.

std::optional<Positions> readPositions(const std::filesystem::path& caseFolder, const std::string& file, Diagnostics&, const Slice& = {});

/// `expected`: how many positions are in their file; a list of another length is an error, and so is a class other than the wanted one.
std::optional<CloudField> readField(const std::filesystem::path& caseFolder, const std::string& file, std::size_t expected,
                                    std::optional<FieldClass> wanted, Diagnostics&, const Slice& = {});

}
