/// Limits on the size of a dictionary: far beyond what a case needs, and well within what stack, memory and patience bear.
#pragma once
#include <cstddef>

namespace sph::limit
{

/// Depth of dictionaries and included files within one another, and of brackets, signs and conditions in an expression.
inline constexpr int nesting = 100;
/// Words, numbers and brackets of a file, of all that it includes, and of what its macros bring in.
inline constexpr std::size_t words = 2'000'000;
/// Files that a dictionary includes, each counted as often as it is read.
inline constexpr int includes = 1000;
/// Mistakes of a file after which the rest of it is not read.
inline constexpr std::size_t mistakes = 100;
/// Characters of a regular expression with its repetitions {n} written out, and of a keyword that it can match.
inline constexpr std::size_t pattern = 500;
/// Characters of dimensions in their brackets.
inline constexpr std::size_t dimensions = 200;

}
