/// Which wall a particle is next to, for AdheringPhaseGradient (PhaseCurvature.hpp): as WallAdhesion, which sees two phases and so one angle of a wall.
///
///   n_w = normal of the nearest wall where it is nearer than 5/6 H, else 0
#pragma once
#include "Coefficients.hpp"
#include "fieldTags.hpp"

namespace sph
{

struct NearestWall { static constexpr FieldInfo info{"nearestWall", "1"}; template<int dim> struct At { double nearestWall; }; };
struct NearestWallNormal { static constexpr FieldInfo info{"nearestWallNormal", "1", Image::mirrored}; template<int dim> struct At { Vector<dim> n_w; }; };

struct WallNextTo
{
    static constexpr bool atWalls = true;
    static constexpr auto name = "wallNextTo";
    using Provides = Fields<NearestWallNormal, NearestWall>;
    template<int dim> struct SoFar
    {
        bool found = false;
        double nearest = 0;   ///< [m]
        Vector<dim> n_w{};
        double wall = 0;
    };
    double reach;             ///< [m]

    explicit WallNextTo(const Coefficients& c) : reach(5.0/6*c.support) {}
    template<class S> S operator()(const S& soFar, const auto&, const auto& foot) const
    {
        if (foot.distance >= (soFar.found ? soFar.nearest : reach)) return soFar;
        return {true, foot.distance, foot.normal, double(foot.wall)};
    }
    template<int dim> auto finish(const SoFar<dim>& q) const { return Values<Provides, dim>{{q.n_w}, {q.wall}}; }
};

}
