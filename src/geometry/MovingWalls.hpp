/// Walls that move across themselves without turning: the platens of a press, a footing, a wall that holds soil back.
///
///   x_w = x_0 + v_w t
///
/// x_0 [m] where constant/geometry has them, v_w [m/s], t [s] since the start of the first run. Planes and all shapes but meshes do.
#pragma once
#include "geometry/Geometry.hpp"

namespace sph
{

/// Share of a wall's speed by which its direction in the dictionary may be off the wall, by rounding.
inline constexpr double slidingTolerance = 1e-6;

/// Whether a velocity of the wall carries the patch to another place: across a plane, and along any direction in which another shape ends.
bool movesAcross(const Geometry&, const Patch&);

class MovingWalls
{
    struct Moving
    {
        std::size_t patch;
        std::shared_ptr<const Shape> atStart;
        Vector<3> velocity;
    };
    std::vector<Moving> moving_;
    double time_ = 0, fastest_ = 0;

public:
    /// Searches over all patches of a geometry with such walls: what is nearest no longer stays.
    explicit MovingWalls(Geometry&);

    bool any() const { return !moving_.empty(); }
    double fastest() const { return fastest_; }           ///< [m/s]
    double time() const { return time_; }                 ///< t [s]
    double travelled() const { return time_ * fastest_; } ///< at most [m]
    /// n.v_w [m/s] of a patch; 0 of one that stays.
    double speedAlong(int patch, const Vector<3>& n) const;
    void advance(Geometry&, double deltaT);
};

}
