/// What the stress of a particle shows of itself: the acting stress, which its neighbours feel, and the pressure.
///
///   S = sigma + p_f I (in the plane of the flow),    p = -tr(sigma)/3
///
/// sigma [Pa] tension positive; p_f [Pa] floorPressure with `stressFree floor`, by which stress-free soil exerts nothing; else 0. tr is that of three dimensions, zz
/// of plane strain included. Verified by test/unit/soil.
#pragma once
#include "Coefficients.hpp"
#include "SoilFields.hpp"

namespace sph
{

struct StressOnNeighbours
{
    static constexpr auto name = "actingStress";
    using Provides = ActingStress;
    using ReadsOwn = Fields<SoilStress>;
    double floorPressure;

    explicit StressOnNeighbours(const Coefficients& c) : floorPressure(c.of<SoilNumbers>().floorPressure) {}
    auto operator()(const auto& i) const
    {
        const auto S = inPlane(i.sigma);
        return S + floorPressure * identity(S);
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
