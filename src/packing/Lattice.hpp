/// Lattices of particles, stretched a little so that a whole number of layers fits the box.
#pragma once
#include "geometry/Shape.hpp"
#include "packing/CellRange.hpp"
#include "packing/Points.hpp"
#include <array>
#include <cstdint>
#include <span>
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

/// A stack of layers along each direction with every second place empty in some pattern. Each layer has a cell of the box to itself, and where the particle
/// of a cell lies is known from its number alone: a lattice takes no memory, and any part of it can be had without the rest.
class Lattice
{
public:
    /// Layers lie half a layer off the faces of the box, so that faces which are walls or periodic see their mirror image or
    /// continuation. Where a direction is periodic, types with two layers a cell get an even number of layers. A direction too short
    /// for one layer gets none: `layers` is 0 there and there are no points.
    Lattice(const LatticeSpec&, int dimension, const Box& box, const std::array<bool, 3>& periodic);

    std::array<long, 3> layers{1, 1, 1}; ///< layers of particles along x, y, z (fcc, bcc: two a cell)
    Vector<3> fittedSpacing;             ///< what the stretching has made of `spacing` along x, y, z [m]; in 2-D z is 0
    RegularCells cells;

    /// Displacement of a particle from the middle of its cell, at most [m].
    double farthestOff() const;
    CellRange all() const { return {{0, 0, 0}, layers}; }
    /// The cells whose particles may lie in the box.
    CellRange cellsIn(const Box&) const;
    /// The ranges, larger by `by` [m] to each side, and what of them lies across periodic faces.
    std::vector<CellRange> grown(std::span<const CellRange>, double by) const;

    std::size_t count(const CellRange&) const;
    bool holds(const std::array<long, 3>& cell) const;
    Vector<3> particle(const std::array<long, 3>& cell) const;
    /// The particles of all cells in any of the ranges and in none of `without`, once each, x fastest.
    Points points(std::span<const CellRange>, std::span<const CellRange> without = {}) const;
    Points points() const { return points(std::array{all()}); }

private:
    LatticeSpec spec_;
    int dimension_;
    std::array<bool, 3> periodic_;
    bool (*occupied_)(long i, long j, long k);

    std::size_t numberOf(const std::array<long, 3>& cell) const;
};

/// cubic, and hexagonal in 2-D or fcc and bcc in 3-D.
const std::vector<std::string>& latticeNames(int dimension);

}
