/// Correction of positions and velocities that keeps particles off walls: for the solver at each step, its leak guard, and packings.
#pragma once
#include "geometry/NearWalls.hpp"

namespace sph
{

/// How near to walls a particle may come [m].
struct Clearance
{
    double closest;       ///< to one
    double narrowest = 0; ///< width of a crevice

    /// The distance from a wall below which something may be to do.
    double looked() const { return std::max(closest, 0.5 * narrowest); }
};

/// x, put off the nearest wall in turn until none is nearer than `closest`: what is put off one solid may be put into the next. Calls
/// pushed(n, patch) with the wall's normal and its patch each time, and patch -1 out of a crevice. A gap of less than twice `closest` leaves it between the two. Finds x up to `reach` [m] deep.
///
/// Out of crevices narrower than `narrowest` it is put likewise, to where they are as wide, as if a wall stood across them there; by half of `narrowest` in all, since the way out of
/// one that hardly widens may lead far, to where others are. In a slit it stays: there is no wider place to go to.
template<int dim, class F>
Vector<dim> offWalls(const NearWalls& walls, Vector<dim> x, const Clearance& clearance, double reach, const F& pushed)
{
    constexpr double slit = 0.1, rounding = 1e-9; // slit: n_1 + n_2 of walls at 6 degrees
    double left = 0.5 * clearance.narrowest;
    for (int turn = 0; turn < 12; ++turn)
    {
        const auto [foot, patch] = walls.nearestFoot(in3D(x), reach);
        if (!(foot.distance < clearance.looked())) break;
        const auto crevice = clearance.narrowest > 0 ? walls.crevice(in3D(x), (1 - rounding) * clearance.narrowest) : Crevice{};
        const auto wider = in<dim>(crevice.wider);
        if (const double slope = mag(wider); slope >= slit && left > 0)
        {
            const double way = std::min((clearance.narrowest - crevice.width) / slope, left);
            x += way / slope * wider;
            left -= way;
            pushed(wider / slope, -1);
        }
        else if (foot.distance < clearance.closest)
        {
            const auto n = in<dim>(foot.normal);
            x += (clearance.closest - foot.distance) * n;
            pushed(n, patch);
        }
        else break;
    }
    return x;
}

/// Velocity without its part that points against n; where a wall moves at `speed` [m/s] along n, relative to it.
template<int dim> Vector<dim> withoutInward(const Vector<dim>& v, const Vector<dim>& n, double speed = 0)
{
    return v - std::fmin(0.0, dot(v, n) - speed) * n;
}

/// A velocity that walls in turn take what points into them of. Between two walls at an acute angle each would turn it into the other, whatever the turns: there it
/// keeps what it has along their edge, nothing in 2-D.
template<int dim> class HeldVelocity
{
    /// Share of the velocity below which the part towards a wall is none: a position put off a wall may lie a rounding short of it and touch it again.
    static constexpr double rounding = 1e-9;
    Vector<dim> v_, last_{};
    double speed_; ///< at first
    bool touched_ = false;

public:
    explicit HeldVelocity(const Vector<dim>& v) : v_(v), speed_(mag(v)) {}
    operator const Vector<dim>&() const { return v_; }
    /// `speed` of the wall along n, as of withoutInward.
    void touch(const Vector<dim>& n, double speed)
    {
        v_ = withoutInward(v_, n, speed);
        const auto edge = cross(in3D(n), in3D(last_));
        if (touched_ && speed == 0 && dot(v_, last_) < -rounding * speed_)
            v_ = in<dim>(dim == 2 ? Vector<3>{} : dot(in3D(v_), edge) / dot(edge, edge) * edge);
        last_ = n;
        touched_ = true;
    }
};

}
