/// Particles with numbers that no solution has, for whoever stops a run and says where.
#pragma once
#include "Simulation.hpp"
#include <optional>
#include <string>

namespace sph
{

struct Outlier
{
    std::string field;
    double value = 0;
    std::size_t particle = 0, phase = 0;
    Vector<3> position;
    /// "particle 3 at (0.1 0.2 0)"
    std::string inWords() const;
};

/// The first position or value that is not finite, of the fields that are written.
std::optional<Outlier> notFinite(const AnySimulation&);
/// Of densities in the scene outside of leastCompression to mostCompression times that at rest, and of NaN, the furthest from it.
std::optional<Outlier> impossibleDensity(const AnySimulation&, const std::vector<double>& restDensity);

}
