#include "WallTension.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph
{

template<int dim>
WallTension<dim>::WallTension(const Coefficients& c, const Kernel<dim>& kernel)
    : tension_(c.wallTension.data()), phases_(c.phases.size()), H_(kernel.support()), marginal_(257)
{
    const int panels = 400;
    for (std::size_t k = 0; k < marginal_.size(); ++k)
    {
        const double d = H_*double(k)/double(marginal_.size() - 1), reach = std::sqrt(std::max(0.0, H_*H_ - d*d)), step = reach/panels;
        for (int q = 0; q < panels; ++q)
        {
            const double t = (q + 0.5)*step, element = dim == 2 ? 2 : 2*std::numbers::pi*t;
            marginal_[k] += kernel.W(std::hypot(d, t))*element*step;
        }
    }
}

template<int dim> double WallTension<dim>::marginal(double d) const
{
    const double place = std::clamp(d/H_, 0.0, 1.0)*double(marginal_.size() - 1);
    const auto k = std::min(std::size_t(place), marginal_.size() - 2);
    return marginal_[k] + (place - double(k))*(marginal_[k + 1] - marginal_[k]);
}

template<int dim> void WallTension<dim>::evaluate(const Images<dim>& images, FieldStore<dim>& store) const
{
    const auto S = store.pointers(WallStress{});
    const double* phase = store.component(Phase::info.name, 0);
    for (double* component : S) std::fill_n(component, images.owned(), 0.0);
    images.forEachReflection([&](std::size_t i, const Reflection<dim>& r)
    {
        if (r.distance >= H_) return;
        const double gamma = tension_[std::size_t(r.wall)*phases_ + std::size_t(phase[i])];
        SymmTensor<dim> sum;
        fetch(sum, [&](int c) { return S[c][i]; });
        sum += 2*gamma*marginal(r.distance)*(identity(r.normal) - outer(r.normal));
        sph::store(sum, [&](int c, double q) { S[c][i] = q; });
    });
}

template class WallTension<2>;
template class WallTension<3>;

}
