/// Walls that move across themselves without turning: the platens of a press, a footing, a wall that holds soil back.
///
///   x_w = x_0 + v_w t,    of a wall under load x_w = x_0 + int v_w dt
///
/// x_0 [m] where constant/geometry has them, v_w [m/s], t [s] since the start of the first run. Planes and all shapes but meshes do.
#pragma once
#include "geometry/Geometry.hpp"
#include <map>

namespace sph
{

/// Share of a wall's speed by which its direction in the dictionary may be off the wall, by rounding.
inline constexpr double slidingTolerance = 1e-6;

/// Whether a velocity or load of the wall carries the patch to another place: across a plane, and along any direction in which another shape ends.
bool movesAcross(const Geometry&, const Patch&);

class MovingWalls
{
    struct Moving
    {
        std::size_t patch;
        std::shared_ptr<const Shape> atStart;
        int wall;
    };
    std::vector<Moving> moving_;
    std::map<int, Vector<3>> displacement_; ///< of each wall under load, along its direction [m]
    double time_ = 0, fastest_ = 0, travelled_ = 0;

    void place(Geometry&) const;
    void findFastest(const Geometry&);

public:
    /// Searches over all patches of a geometry with such walls: what is nearest no longer stays.
    explicit MovingWalls(Geometry&);

    bool any() const { return !moving_.empty(); }
    double fastest() const { return fastest_; }     ///< [m/s]
    double travelled() const { return travelled_; } ///< at most [m]
    /// n.v_w [m/s] of a patch; 0 of one that stays.
    double speedAlong(const Geometry&, int patch, const Vector<3>& n) const;
    /// Sets the velocity of a wall under load.
    void push(Geometry&, int wall, const Vector<3>& velocity);
    /// [m] of a wall under load since the start of the first run.
    const Vector<3>& displacement(int wall) const { return displacement_.at(wall); }
    void advance(Geometry&, double deltaT);

    /// Adds the numbers of a restart, and goes on from them.
    void save(const Geometry&, std::map<std::string, double>& numbers) const;
    void restore(Geometry&, const std::map<std::string, double>& numbers);
};

}
