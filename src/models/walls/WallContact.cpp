#include "models/walls/WallContact.hpp"
#include "geometry/offWalls.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>

namespace sph
{

namespace
{
template<int dim> Clearance clearanceOf(const Particles<dim>& p)
{
    const double spacing = p.coefficients().spacing;
    const double closest = std::max(LeakGuard<dim>::closestInSpacings, p.settings().facts.template get<WallClearance>().spacings);
    return {closest * spacing, narrowestCrevice * spacing};
}
}

template<int dim> std::vector<Stage<dim>> WallContact<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::sorted)
        return {{"near walls", "particles that may come to a wall before lists are built anew",
                 [this](Particles<dim>& p, const Substep&) { find(p); }}};
    // The stage stands behind all that moves particles; forces too are taken, and the leak guard looks, where drifts have led.
    if (place != JoinPoint::beforeEvaluation && place != JoinPoint::atEnd) return {};
    return {{"hold off walls", "d < d_0: x += (d_0 - d) n, likewise out of crevices, v -= min(n.(v - v_w), 0) n",
             [this](Particles<dim>& p, const Substep&)
             {
                 if (near_.empty() && !ranks()) return;
                 const auto x = p.store().pointers(Position{}), v = p.store().pointers(Velocity{});
                 p.moved(reduce(
                     near_.size(), 0.0, [&](std::size_t k) { return holdOff(p, x, v, near_[k]); }, Larger{}));
             }}};
}

template<int dim> void WallContact<dim>::find(const Particles<dim>& p)
{
    near_.clear();
    const auto x = p.store().pointers(Position{});
    // A step that no sound limits may carry a particle a quarter of a spacing on after lists have become too old.
    const double within = 0.5 * p.coefficients().spacing + p.skin();
    for (const auto& [i, d] : p.images().layers() ? nearFeet(p, within) : p.images().nearFaces(within))
    {
        near_.push_back({i, valueAt<Vector<dim>>(x, i), std::max(0.0, d - clearanceOf(p).looked()), p.movingWalls().travelled()});
    }
}

/// Particles near walls, as from Images::nearFaces, where nothing is mirrored.
template<int dim> std::vector<std::pair<std::size_t, double>> WallContact<dim>::nearFeet(const Particles<dim>& p, double distance)
{
    std::vector<std::pair<std::size_t, double>> near;
    const auto x = p.store().pointers(Position{});
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        if (const double d = p.nearWalls().nearestFoot(in3D(valueAt<Vector<dim>>(x, i)), distance).foot.distance; d < distance)
            near.emplace_back(i, d);
    }
    return near;
}

/// Puts a particle off walls, and returns the distance by which it has moved [m].
template<int dim> double WallContact<dim>::holdOff(const Particles<dim>& p, const Columns& x, const Columns& v, Near& near) const
{
    const std::size_t i = near.particle;
    const auto x_i = valueAt<Vector<dim>>(x, i);
    const double walls = p.movingWalls().travelled();
    if (mag(x_i - near.x) + (walls - near.walls) < near.clear) return 0;

    // Deeper than that the leak guard ends the run.
    const auto clearance = clearanceOf(p);
    const double reach = 0.5 * p.coefficients().spacing;
    const auto [foot, patch] = p.nearWalls().nearestFoot(in3D(x_i), reach);
    const double d = std::min(reach, foot.distance);
    near = {i, x_i, std::max(0.0, d - clearance.looked()), walls};
    if (d >= clearance.looked()) return 0;
    const auto before = valueAt<Vector<dim>>(v, i);
    auto v_i = before;
    HeldVelocity<dim> velocity(v_i);
    const auto held =
        offWalls(p.nearWalls(), x_i, clearance, reach,
                 [&](const Vector<dim>& n, int pushing) { velocity.touch(n, p.movingWalls().speedAlong(p.geometry(), pushing, in3D(n))); });
    if (held == x_i) return 0;
    v_i = velocity;
    if (const auto& geometry = p.geometry(); rubs_)
    {
        const int wall = geometry.patches[std::size_t(patch)].wallAt(foot.region);
        v_i = rubbed(v_i, before, geometry.walls[std::size_t(wall)], in<dim>(geometry.wallVelocity(wall, in3D(held))));
    }
    sph::store(held, [&](int c, double q) { x[c][i] = q; });
    sph::store(v_i, [&](int c, double q) { v[c][i] = q; });
    return mag(held - x_i);
}

template<int dim> Vector<dim> WallContact<dim>::rubbed(Vector<dim> v, Vector<dim> before, const WallProperties& wall, Vector<dim> v_w) const
{
    if (!wall.frictionAngle) return wall.slips || slips_ ? v : v_w;
    const auto sliding = v - v_w;
    const double most = wall.frictionCoefficient() * mag(v - before), speed = mag(sliding);
    return speed > most ? v - most / speed * sliding : v_w;
}

template class WallContact<2>;
template class WallContact<3>;

}
