#include "models/pressure/CompressionEnergy.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

template<int dim> std::optional<StoredEnergy> CompressionEnergy<dim>::energy(const Particles<dim>& particles) const
{
    const auto& c = particles.coefficients();
    const auto& store = particles.store();
    const double *m = store.pointers(Mass{})[0], *rho = store.pointers(Density{})[0];
    const double* phase = c.phases.size() > 1 ? store.pointers(Phase{})[0] : nullptr;
    const double* holder = store.has(Holder{}) ? store.pointers(Holder{})[0] : nullptr;
    const double total = sum(particles.size(),
                             [&](std::size_t i)
                             {
                                 const std::size_t k = phase ? std::size_t(phase[i]) : 0;
                                 return holder && holder[i] > 0 ? 0.0 : m[i] * c.stateEquation[k].energy(rho[i]);
                             });
    return StoredEnergy{"compression", total, false};
}

template<int dim> double CompressionEnergy<dim>::supply(const Particles<dim>& particles, const std::vector<double>& mass) const
{
    const double slack = 0.02, noise = 0.01; // of the background pressure; Mach number
    const double mostBackground = 0.05;      // of rho c^2
    const auto& c = particles.coefficients();
    double stiffest = 0;
    for (std::size_t k = 0; k < c.phases.size(); ++k) stiffest = std::max(stiffest, c.restDensity[k] * sqr(c.soundSpeed[k]));
    const double background = std::min(std::fabs(c.backgroundPressure), mostBackground * stiffest);
    const double *m = particles.store().pointers(Mass{})[0], *rho = particles.store().pointers(Density{})[0];
    double total = slack * background * sum(particles.size(), [&](std::size_t i) { return m[i] / rho[i]; });
    for (std::size_t k = 0; k < c.phases.size(); ++k) total += 0.5 * mass[k] * sqr(noise * c.soundSpeed[k]);
    return total;
}

template class CompressionEnergy<2>;
template class CompressionEnergy<3>;

}
