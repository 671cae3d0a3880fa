#include "models/gas/CalmGas.hpp"
#include "models/gas/AmbientGas.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
constexpr double from = 3, to = 5; ///< distances from the liquid between which s rises from 0 to 1 [spacings]
}

template<int dim>
CalmGas<dim>::CalmGas(Particles<dim>& particles, const Numbers&, std::size_t gas)
    : distance_(particles.geometry(), particles.coefficients().spacing), gas_(gas)
{}

template<int dim> std::vector<Stage<dim>> CalmGas<dim>::stages(JoinPoint place)
{
    if (place != JoinPoint::exchange) return {};
    return {{"find calm gas", "s = (d - 3)/2 of gas at a distance d from the liquid [spacings]",
             [this](Particles<dim>& p, const Substep&) { find(p); }}};
}

template<int dim> void CalmGas<dim>::find(Particles<dim>& particles)
{
    auto& store = particles.store();
    const double* const phase = store.component(Phase::info.name, 0);
    double* const ambient = store.component(Ambient::info.name, 0);
    const auto x = store.pointers(Position{});
    const auto place = [&](std::size_t i) { return in3D(valueAt<Vector<dim>>(x, i)); };
    const auto isGas = [&](std::size_t i) { return std::size_t(phase[i]) == gas_; };
    distance_.clear();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (!isGas(i)) distance_.mark(place(i));
    distance_.measure(to);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        const double d = std::sqrt(distance_.squaredDistance(distance_.cellOf(place(i))));
        ambient[i] = isGas(i) ? Ambient::moving(std::clamp((d - from) / (to - from), 0.0, 1.0)) : 0;
    }
}

template class CalmGas<2>;
template class CalmGas<3>;

}
