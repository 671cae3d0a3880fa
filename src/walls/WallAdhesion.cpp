#include "WallAdhesion.hpp"
#include <algorithm>

namespace sph
{

template<int dim> WallAdhesion<dim>::WallAdhesion(const Geometry& geometry, double support) : reach_(5.0/6*support)
{
    for (const auto& wall : geometry.walls) cosTheta_.push_back(wall.cosine());
}

template<int dim> void WallAdhesion<dim>::evaluate(const Images<dim>& images, FieldStore<dim>& store) const
{
    const auto n_w = store.pointers(WallNormal{});
    double* cosTheta = store.component(WallCosine::info.name, 0);
    for (double* component : n_w) std::fill_n(component, images.owned(), 0.0);
    std::fill_n(cosTheta, images.owned(), 0.0);
    std::vector<double> nearest(images.owned(), reach_);
    images.forEachWallNear(store, [&](std::size_t i, const Foot& foot, const Patch& patch)
    {
        if (foot.distance >= nearest[i]) return;
        nearest[i] = foot.distance;
        sph::store(in<dim>(foot.normal), [&](int c, double q) { n_w[c][i] = q; });
        cosTheta[i] = cosTheta_[std::size_t(patch.wall)];
    });
}

template class WallAdhesion<2>;
template class WallAdhesion<3>;

}
