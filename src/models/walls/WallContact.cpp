#include "WallContact.hpp"
#include "offWalls.hpp"
#include "reduce.hpp"

namespace sph
{

namespace
{
template<int dim> double closestOf(const Particles<dim>& p) { return LeakGuard<dim>::closestInSpacings * p.coefficients().spacing; }
}

template<int dim> std::vector<Stage<dim>> WallContact<dim>::stages(Place place)
{
    // Behind all that moves particles.
    if (place != Place::atEnd) return {};
    return {{"hold off walls", "d < d_0: x += (d_0 - d) n, v -= min(n.v, 0) n", [this](Particles<dim>& p, const Substep&) { holdOff(p); }}};
}

template<int dim> void WallContact<dim>::sorted(Particles<dim>& p) { near_ = p.images().nearFaces(closestOf(p) + p.skin()); }

template<int dim> void WallContact<dim>::holdOff(Particles<dim>& p) const
{
    const auto x = p.store().pointers(Position{}), v = p.store().pointers(Velocity{});
    const double closest = closestOf(p);
    const double reach = 0.5 * p.coefficients().spacing; // deeper than that the leak guard ends the run
    if (near_.empty()) return;
    p.moved(most(near_.size(),
                 [&](std::size_t k)
                 {
                     const std::size_t i = near_[k];
                     Vector<dim> x_i, v_i;
                     fetch(x_i, [&](int c) { return x[c][i]; });
                     fetch(v_i, [&](int c) { return v[c][i]; });
                     const auto held =
                         offWalls(p.images(), x_i, closest, reach, [&](const Vector<dim>& n) { v_i = withoutInward(v_i, n); });
                     const double by = mag(held - x_i);
                     if (by > 0)
                     {
                         sph::store(held, [&](int c, double q) { x[c][i] = q; });
                         sph::store(v_i, [&](int c, double q) { v[c][i] = q; });
                     }
                     return by;
                 }));
}

template class WallContact<2>;
template class WallContact<3>;

}
