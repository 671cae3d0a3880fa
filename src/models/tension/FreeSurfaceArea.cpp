#include "models/tension/FreeSurfaceArea.hpp"
#include "fields/freeSurfaceTags.hpp"
#include "models/tension/Tensions.hpp"
#include "models/tension/WallWetting.hpp"
#include "parallel/reduce.hpp"

namespace sph
{

template<int dim> std::optional<StoredEnergy> FreeSurfaceArea<dim>::energy(const Particles<dim>& particles) const
{
    const double* const V = particles.store().pointers(Volume{})[0];
    const auto g = particles.store().pointers(SlopeSum{});
    const double half = sum(particles.size(), [&](std::size_t i) { return sqr(V[i]) * mag(valueAt<Vector<dim>>(g, i)); });
    double area = 2 * half;
    if (const auto& store = particles.store(); store.has(WettingCurvature::info.name))
    {
        const double* const k_w = store.component(WettingCurvature::info.name, 0);
        area -= sum(particles.size(), [&](std::size_t i) { return V[i] * k_w[i]; });
    }
    return StoredEnergy{"free surface", tensionsOf(particles.coefficients()).largest() * area};
}

template class FreeSurfaceArea<2>;
template class FreeSurfaceArea<3>;

}
