/// Lattices of particles, stretched a little so that a whole number of layers fits the box.
#pragma once
#include "Points.hpp"
#include "Shape.hpp"
#include <array>
#include <cstdint>
#include <string>

namespace sph
{

/// `spacing` is the dim-th root of a particle's volume for every type, so that all types have the same number of particles per
/// volume: cubic and square lattices have it between neighbours, hexagonal ones 1.075 of it, bcc 1.091, fcc 1.122.
struct LatticeSpec
{
    std::string type = "cubic";
    double spacing = 0; ///< [m]
    double jitter = 0;  ///< largest displacement of each component, in spacings
    std::uint64_t seed = 1;
};

struct Lattice
{
    Points points;
    std::array<long, 3> layers{1, 1, 1}; ///< layers of particles along x, y, z (fcc, bcc: two a cell)
    Vector<3> fittedSpacing;             ///< what the stretching has made of `spacing` along x, y, z [m]; in 2-D z is 0
};

/// cubic, and hexagonal in 2-D or fcc and bcc in 3-D.
const std::vector<std::string>& latticeNames(int dimension);

/// Layers lie half a layer off the faces of the box, so that faces which are walls or periodic see their mirror image or
/// continuation. Where a direction is periodic, types with two layers a cell get an even number of layers. A direction too short
/// for one layer gets none: `layers` is 0 there and there are no points.
Lattice makeLattice(const LatticeSpec&, int dimension, const Box& box, const std::array<bool, 3>& periodic);

}
