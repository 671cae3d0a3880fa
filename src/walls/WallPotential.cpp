#include "WallPotential.hpp"

namespace sph
{

template<int dim>
WallPotential<dim>::WallPotential(const Coefficients& c)
    : tension_(c.wallTension.data()), restDensity_(c.restDensity.data()), phases_(c.phases.size()), H_(c.support)
{}

template<int dim> double WallPotential<dim>::slope(double d) const
{
    const double s = d/H_;
    return s < 1 ? -105.0/8/sqr(H_)*s*sqr(1 - s*s) : 0;
}

template<int dim> void WallPotential<dim>::addAcceleration(const Images<dim>& images, FieldStore<dim>& store) const
{
    const auto a = store.pointers(Acceleration{});
    const double* phase = store.component(Phase::info.name, 0);
    images.forEachWallNear(store, [&](std::size_t i, const Foot& foot, int wall)
    {
        const auto k = std::size_t(phase[i]);
        const auto pull = -tension_[std::size_t(wall)*phases_ + k]/restDensity_[k]*slope(foot.distance)*in<dim>(foot.normal);
        sph::store(pull, [&](int c, double q) { a[c][i] += q; });
    });
}

template class WallPotential<2>;
template class WallPotential<3>;

}
