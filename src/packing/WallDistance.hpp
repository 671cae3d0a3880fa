/// Distance of a particle from the nearest wall [m]; `farAway` where none is within reach of the images. Verified by test/unit/packing (how many
/// particles of a room are near its walls).
#pragma once
#include "fields/fieldTags.hpp"

namespace sph
{

// clang-format off
struct DistanceToWall { static constexpr FieldInfo info{"wallDistance", "m"};  template<int dim, class Real = double> struct At { Real d_w; }; };
// clang-format on

struct WallDistance
{
    static constexpr auto name = "wallDistance";
    static constexpr bool atWalls = true;
    static constexpr double farAway = 1e300;
    using Provides = DistanceToWall;
    template<int dim> struct SoFar
    {
        double d = farAway;
    };

    static double wallReach() { return Box::infinity; }
    template<class S> S operator()(const S& soFar, const auto&, const auto& foot) const
    {
        return {foot.distance < soFar.d ? foot.distance : soFar.d};
    }
    template<int dim> double finish(const SoFar<dim>& nearest) const { return nearest.d; }
};

}
