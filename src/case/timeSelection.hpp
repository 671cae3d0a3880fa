/// Selection of a case's times, in OpenFOAM's words.
#pragma once
#include <string>
#include <vector>

namespace sph
{

/// `selection` is a list of times and ranges, separated by commas or blanks: "0.1", "0.1:0.5", ":0.5", "0.4:"; empty: all.
/// A time or range that no folder matches is an error that lists the times there are.
std::vector<std::string> selectTimes(const std::vector<std::string>& times, const std::string& selection);

}
