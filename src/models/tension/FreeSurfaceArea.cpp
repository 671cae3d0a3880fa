#include "models/tension/FreeSurfaceArea.hpp"
#include "fields/freeSurfaceTags.hpp"
#include "models/tension/Tensions.hpp"
#include "parallel/reduce.hpp"

namespace sph
{

template<int dim> std::optional<StoredEnergy> FreeSurfaceArea<dim>::energy(const Particles<dim>& particles) const
{
    const double* const V = particles.store().pointers(Volume{})[0];
    const auto g = particles.store().pointers(SlopeSum{});
    const double half = sum(particles.size(), [&](std::size_t i) { return sqr(V[i]) * mag(valueAt<Vector<dim>>(g, i)); });
    return StoredEnergy{"free surface", 2 * tensionsOf(particles.coefficients()).largest() * half};
}

template class FreeSurfaceArea<2>;
template class FreeSurfaceArea<3>;

}
