#include "models/tension/FreeSurfaceArea.hpp"
#include "fields/freeSurfaceTags.hpp"
#include "models/tension/Tensions.hpp"
#include "models/tension/WallWetting.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>

namespace sph
{

/// sum_i V_i k_w,i: cos(theta) times the wetted area of each wall; 0 where no wall turns the surface.
template<int dim> static double wettedArea(const Particles<dim>& particles)
{
    const auto& store = particles.store();
    if (!store.has(WettingCurvature::info.name)) return 0;
    const double *const V = store.component(Volume::info.name, 0), *const k_w = store.component(WettingCurvature::info.name, 0);
    return sum(particles.size(), [&](std::size_t i) { return V[i] * k_w[i]; });
}

template<int dim> std::optional<StoredEnergy> FreeSurfaceArea<dim>::energy(const Particles<dim>& particles) const
{
    const double* const V = particles.store().pointers(Volume{})[0];
    const auto g = particles.store().pointers(SlopeSum{});
    const double half = sum(particles.size(), [&](std::size_t i) { return sqr(V[i]) * mag(valueAt<Vector<dim>>(g, i)); });
    return StoredEnergy{"free surface", tensionsOf(particles.coefficients()).largest() * (2 * half - wettedArea(particles))};
}

template<int dim> double FreeSurfaceArea<dim>::supply(const Particles<dim>& particles, const std::vector<double>&) const
{
    return 2 * tensionsOf(particles.coefficients()).largest() * std::max(0.0, wettedArea(particles));
}

template class FreeSurfaceArea<2>;
template class FreeSurfaceArea<3>;

}
