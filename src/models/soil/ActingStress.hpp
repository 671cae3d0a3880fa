/// The acting stress of a particle, which its neighbours feel, and its pressure, both from the stress that the law integrates.
///
///   S = sigma + (p_s - p_c) I (in the plane of the flow),    p_c = c_c^2 max(0, rho - rho_c),    p = -tr(sigma)/3
///
/// and less (chi p_w - p_o) I where there is water in the pores (PoreWater.hpp, OuterWater.hpp).
///
/// sigma [Pa] tension positive; p_s [Pa] pressure on free surfaces, where nothing answers S: `confiningPressure`, or else the floorPressure of `stressFree floor`, by which stress-free soil exerts
/// nothing, or 0. The divergence of p_s I is 0, and what walls take of the soil is sigma. p_c [Pa] keeps particles of a flow apart: the law knows no
/// void ratio, and by its stress alone they clump. c_c [m/s] `compactionSpeed`, rho_c [kg/m^3] 1.05 of the density at rest. tr is that of three dimensions, zz of plane strain included. Verified by test/unit/soil.
#pragma once
#include "models/soil/OuterWater.hpp"
#include "models/soil/SoilFields.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

struct StressOnNeighbours
{
    static constexpr auto name = "actingStress";
    using Provides = ActingStress;
    using ReadsOwn = Fields<SoilStress, Density>;
    SoilNumbers soil;

    explicit StressOnNeighbours(const Coefficients& c) : soil(c.of<SoilNumbers>()) {}
    auto operator()(const auto& i) const
    {
        const auto S = inPlane(i.sigma);
        return S + (soil.surfacePressure - soil.compactionPressure(i.rho)) * identity(S);
    }
};

/// S of soil with water in its pores.
struct TotalStressOnNeighbours : StressOnNeighbours
{
    static constexpr auto name = "totalStress";
    using ReadsOwn = Fields<SoilStress, Density, PorePressure, Position>;
    const PoreWater* water;
    OuterWater standing;

    explicit TotalStressOnNeighbours(const Coefficients& c)
        : StressOnNeighbours(c), water(c.has<PoreWater>() ? &c.of<PoreWater>() : nullptr), standing(c)
    {}
    auto operator()(const auto& i) const
    {
        const auto S = StressOnNeighbours::operator()(i);
        return S + (standing.pressure(i.x) - water->acts(i.p_w) * i.p_w) * identity(S);
    }
};

struct MeanPressure
{
    static constexpr auto name = "meanPressure";
    using Provides = Pressure;
    using ReadsOwn = Fields<SoilStress>;
    auto operator()(const auto& i) const { return -trace(i.sigma) / 3; }
};

}
