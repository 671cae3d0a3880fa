/// Division of particles into parts of equal numbers, by one process, for folders on disk. Ranks of a run cut their shared particles by Ranks::cut.
#pragma once
#include "base/Vector.hpp"
#include <cstddef>
#include <span>
#include <vector>

namespace sph
{

/// rcb: recursive bisection across the longest side of each part's box (Berger & Bokhari 1987). rib: across its longest axis of inertia (Simon 1991).
/// hilbert: along a space-filling curve. As Zoltan's RCB, RIB and HSFC.
enum class Division
{
    rcb,
    rib,
    hilbert
};

/// The part of each particle, 0 to parts - 1. The number of particles of two parts differs by one at most. In two dimensions z does not count.
std::vector<int> divide(Division, int dimension, std::span<const Vector<3>> places, std::size_t parts);

}
