/// Normal of the wall next to a particle, for the forms of the curvature whose interfaces walls turn (WallAdhesion.hpp, PhaseCurvature.hpp, FreeSurfaceCurvature.hpp):
///
///   n_w = normal of the nearest wall where it is nearer than 5/6 H, else 0
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include <vector>

namespace sph
{

struct NearestWall
{
    static constexpr FieldInfo info{"nearestWall", "1"};
    template<int dim, class Real = double> struct At
    {
        Real nearestWall;
    };
};
struct NearestWallNormal
{
    static constexpr FieldInfo info{"nearestWallNormal", "1", Image::mirrored};
    template<int dim, class Real = double> struct At
    {
        Vector<dim, Real> n_w;
    };
};

struct WallDistance
{
    static constexpr FieldInfo info{"wallDistance", "m"};
    template<int dim, class Real = double> struct At
    {
        Real d;
    };
};

/// State that wall laws carry from place to place to find the nearest wall; the laws derived from it give their result.
struct NextToWall
{
    static constexpr bool atWalls = true;
    template<int dim> struct SoFar
    {
        bool found = false;
        double nearest = 0; ///< [m]
        Vector<dim> n_w{};
        int wall = 0;
    };
    double reach; ///< [m]

    explicit NextToWall(const Coefficients& c) : reach(5.0 / 6 * c.support) {}
    double wallReach() const { return reach; }
    template<class S> S operator()(const S& soFar, const auto&, const auto& foot) const
    {
        if (foot.distance >= (soFar.found ? soFar.nearest : reach)) return soFar;
        return {true, foot.distance, foot.normal, foot.wall};
    }
};

/// Number of the nearest wall, for AdheringPhaseGradient, which looks up the angle of each pair of phases.
struct WallNextTo : NextToWall
{
    static constexpr auto name = "wallNextTo";
    using Provides = Fields<NearestWallNormal, NearestWall>;
    using NextToWall::NextToWall;
    template<int dim> auto finish(const SoFar<dim>& q) const { return Values<Provides, dim>{{q.n_w}, {double(q.wall)}}; }
};

/// Of each wall, whether a free surface that meets it ends in a line of contact: not at a plane of symmetry, a wall that slips and has no contact angle, behind which the surface goes on.
struct LinesOfContact
{
    std::vector<char> at;
};

/// How far the nearest wall is that has lines of contact, for the free surface of a liquid alone (FreeSurfaceCurvature.hpp).
struct DistanceNextTo : NextToWall
{
    static constexpr auto name = "distanceNextTo";
    using Provides = Fields<NearestWallNormal, WallDistance>;
    const char* hasLines; ///< of each wall

    explicit DistanceNextTo(const Coefficients& c) : NextToWall(c), hasLines(c.of<LinesOfContact>().at.data()) {}
    template<class S> S operator()(const S& soFar, const auto& i, const auto& foot) const
    {
        return hasLines[foot.wall] ? NextToWall::operator()(soFar, i, foot) : soFar;
    }
    template<int dim> auto finish(const SoFar<dim>& q) const { return Values<Provides, dim>{{q.n_w}, {q.nearest}}; }
};

}
