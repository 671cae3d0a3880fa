#include "WallPotential.hpp"

namespace sph
{

template<int dim>
WallPotential<dim>::WallPotential(const Coefficients& c)
    : tension_(c.wallTension.data()), restDensity_(c.restDensity.data()), phases_(c.phases.size()), H_(c.support)
{}

template<int dim> double WallPotential<dim>::slope(double d, double k1, double k2) const
{
    const double s = d/H_, left = 1 - sqr(s), a = 1 - k1*d, b = 1 - k2*d;
    const double least = 0.1; // nearer to a centre of curvature there is no image either
    if (left <= 0 || a < least || b < least) return 0;
    const double Phi = 35.0/16/H_*left*left*left, dPhi = -105.0/8/sqr(H_)*s*sqr(left);
    return (dPhi + Phi*(k1/a + k2/b))/(a*b);
}

template<int dim> void WallPotential<dim>::addAcceleration(const Images<dim>& images, FieldStore<dim>& store) const
{
    const auto a = store.pointers(Acceleration{});
    const double* phase = store.component(Phase::info.name, 0);
    images.forEachWallNear(store, [&](std::size_t i, const Foot& foot, const Patch& patch)
    {
        const auto k = std::size_t(phase[i]);
        const double curved = patch.shape->uniformlyCurved() ? 1 : 0;
        const double gamma = tension_[std::size_t(patch.wall)*phases_ + k];
        const auto pull = -gamma/restDensity_[k]*slope(foot.distance, curved*foot.k1, curved*foot.k2)*in<dim>(foot.normal);
        sph::store(pull, [&](int c, double q) { a[c][i] += q; });
    });
}

template class WallPotential<2>;
template class WallPotential<3>;

}
