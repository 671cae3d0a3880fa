/// The term of a scalar.
#pragma once
#include "models/scalarTransport/TransportedScalar.hpp"
#include "scene/Settings.hpp"

namespace sph
{

/// 2 k_a k_b/(k_a + k_b) of all pairs of phases, phases x phases; 0 where one of the two is 0.
std::vector<double> harmonicMeans(const std::vector<double>& k);

/// k of all pairs of phases, phases x phases: harmonic means of rho_0 D [kg/(m s)].
std::vector<double> pairDiffusivities(const TransportedScalar&, const Coefficients&);

/// Defines the term in the scene, and returns its name. `evenAtWalls`: ghosts behind walls that nothing passes go on evenly (ScalarFlux.hpp).
std::string defineScalarFlux(Settings&, const TransportedScalar&, bool walls, bool evenAtWalls);

}
