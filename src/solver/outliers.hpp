/// Particles that a run has to name: those with numbers that no solution has, and the one that the step waits for.
#pragma once
#include "solver/Simulation.hpp"
#include <optional>
#include <string>

namespace sph
{

struct NamedParticle
{
    std::size_t particle = 0, phase = 0;
    Vector<3> position;
    std::optional<double> label; ///< origId, where particles have it
    int rank = 0;
    /// "particle 3 at (0.1 0.2 0)"; "particle 3 of rank 2 (origId 1203) at ..." where there are several ranks, and labels.
    std::string inWords() const;
};

struct Outlier : NamedParticle
{
    std::string field;
    double value = 0;
};

/// The first position or value that is not finite, of the fields that are written.
std::optional<Outlier> notFinite(const AnySimulation&);
/// The density in the scene that is furthest outside of leastCompression to mostCompression times that at rest, or is NaN.
std::optional<Outlier> impossibleDensity(const AnySimulation&, const std::vector<double>& restDensity);
/// The particle, among those of all ranks, that sets a limit: whose value of the limit's field is the largest at present. None where
/// constants of the scene set it. All ranks have to ask.
std::optional<Outlier> binding(const AnySimulation&, const StepLimit&);

}
