/// Short-wave noise of a stress that each particle integrates for itself: how far it is off the line through its neighbours' (operators/LinearFit.hpp). StressUpdate.hpp uses it.
///
///   noise_i = fit_i(sigma) - sigma_i [Pa]
///
/// Verified by test/unit/soil.
#pragma once
#include "models/soil/SoilFields.hpp"
#include "operators/LinearFit.hpp"

namespace sph
{

struct StressOffLine
{
    static constexpr auto name = "stressNoise";
    using Provides = StressNoise;
    using Reads = Fields<Volume, SoilStress, GhostWall>;
    using ReadsOwn = Fields<FitScale, FitSlope>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return fitWeight(ij, j) * (i.q + dot(i.z, ij.x)) * (j.sigma - i.sigma);
    }
};

}
