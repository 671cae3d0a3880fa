/// Saturation of a void space: one phase gets a share of it, exact to one particle, where that phase would lie.
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Geometry.hpp"
#include "packing/Points.hpp"
#include <span>

namespace sph
{

/// The particles that hold the phase: the n = value * (number of particles), rounded, of lowest score. Ties go to the particle that
/// comes first.
///
///     contacts   sum of the distances to the two nearest patches: the gap there (pendular water between grains)
///     film       distance to the nearest wall
///     bottom     height against gravity          top      its negative
///     layer      distance from the plane of `point` and `normal`
///     drops      distance to the nearest of `centres (..)`, or of `number` particles chosen by `seed`
///     random     noise of `seed`
struct Saturation
{
    static constexpr int noGas = -1; ///< `gas none`: no particle in the rest
    int phase = 0, gas = 0;
    double value = 0; ///< of the particles, i.e. of the void space
    std::string placement = "contacts";
    Vector<3> up{0, 1, 0}; ///< unit, against gravity
    Vector<3> point, normal{0, 1, 0};
    std::vector<Vector<3>> centres;
    int number = 1;
    unsigned seed = 1;
    Location where;
};

/// Reads the sub-dictionary `saturation`; `phases` are the names in order.
EntryList saturationEntries();
Saturation readSaturation(const Dictionary&, std::span<const std::string> phases, const Vector<3>& up);

/// True for the particles that hold the phase.
std::vector<char> place(const Saturation&, const Geometry&, const Points&);

}
