/// Coordinates that a file has in single precision. For the sources of this module alone.
#pragma once
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace sph
{

/// The number of fewest digits that single precision takes for this one: 0.2 of a file is 0.2, not 0.200000003. What has no digits to
/// spare (denormal), and what is no number, stays what it is.
inline double asWritten(float x)
{
    if (!std::isnormal(x)) return x;
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
    double value = 0;
    std::from_chars(text.data(), end, value);
    return value;
}

/// Rounding to single precision moves a coordinate of this size by so much at most: half of the spacing of its numbers there.
inline double roundingOf(double largest)
{
    const float x = std::abs(float(largest));
    return 0.5 * (double(std::nextafter(x, std::numeric_limits<float>::infinity())) - double(x));
}

}
