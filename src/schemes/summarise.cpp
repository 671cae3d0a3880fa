#include "summarise.hpp"
#include "overBlocks.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

template<int dim> Summary summarise(ParticleSystem<dim>& particles, const Settings& settings)
{
    auto& store = particles.store();
    const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{});
    const auto slow = store.has(SlowAcceleration{}) ? store.pointers(SlowAcceleration{}) : std::array<double*, dim>{};
    const double *m = store.component("m", 0), *rho = store.component("rho", 0);
    const double* phase = settings.multiphase() ? store.component("phase", 0) : nullptr;
    const auto force = settings.coefficients.bodyForce; // [N/m^3]
    const bool driven = mag(force) > 0;
    const std::size_t phases = settings.coefficients.phases.size();
    Summary nothing;
    nothing.mass.assign(phases, 0);
    nothing.count.assign(phases, 0);
    nothing.minDensity.assign(phases, std::numeric_limits<double>::infinity());
    nothing.maxDensity.assign(phases, -std::numeric_limits<double>::infinity());
    nothing.maxSpeedOf.assign(phases, 0);

    const bool suspension = settings.suspension();
    const double *phi = suspension ? store.component(PowderFraction::info.name, 0) : nullptr,
                 *mu = suspension ? store.component(DynamicViscosity::info.name, 0) : nullptr;
    if (suspension)
    {
        nothing.minPhi = nothing.minViscosity = std::numeric_limits<double>::infinity();
        nothing.maxPhi = nothing.maxViscosity = -std::numeric_limits<double>::infinity();
    }

    const auto parts = overBlocks(particles.size(), [&](std::size_t begin, std::size_t end)
    {
        Summary s = nothing;
        double a2 = 0, slow2 = 0;
        for (std::size_t i = begin; i < end; ++i)
        {
            Vector<dim> v_i, a_i;
            fetch(v_i, [&](int c) { return v[c][i]; });
            fetch(a_i, [&](int c) { return a[c][i]; });
            const std::size_t k = phase ? std::size_t(phase[i]) : 0;
            s.maxSpeedOf[k] = std::max(s.maxSpeedOf[k], dot(v_i, v_i)); // its square, to the end of the block
            a2 = std::max(a2, dot(a_i, a_i));
            if (slow[0])
            {
                fetch(a_i, [&](int c) { return slow[c][i]; });
                slow2 = std::max(slow2, dot(a_i, a_i));
            }
            s.kineticEnergy += 0.5*m[i]*dot(v_i, v_i);
            s.momentum += m[i]*in3D(v_i);
            if (driven) s.power += m[i]/rho[i]*dot(force, in3D(v_i));
            s.mass[k] += m[i];
            ++s.count[k];
            s.minDensity[k] = std::min(s.minDensity[k], rho[i]);
            s.maxDensity[k] = std::max(s.maxDensity[k], rho[i]);
            if (!suspension) continue;
            s.powderVolume += phi[i]*m[i];
            s.minPhi = std::min(s.minPhi, phi[i]);
            s.maxPhi = std::max(s.maxPhi, phi[i]);
            s.minViscosity = std::min(s.minViscosity, mu[i]);
            s.maxViscosity = std::max(s.maxViscosity, mu[i]);
        }
        s.powderVolume /= settings.coefficients.restDensity[0];
        for (double& speed : s.maxSpeedOf) speed = std::sqrt(speed);
        s.maxAcceleration = std::sqrt(a2);
        s.maxSlowAcceleration = std::sqrt(slow2);
        return s;
    });
    Summary total = nothing;
    for (const auto& s : parts)
    {
        total.maxAcceleration = std::max(total.maxAcceleration, s.maxAcceleration);
        total.maxSlowAcceleration = std::max(total.maxSlowAcceleration, s.maxSlowAcceleration);
        total.kineticEnergy += s.kineticEnergy;
        total.momentum += s.momentum;
        total.power += s.power;
        total.powderVolume += s.powderVolume;
        total.minPhi = std::min(total.minPhi, s.minPhi);
        total.maxPhi = std::max(total.maxPhi, s.maxPhi);
        total.minViscosity = std::min(total.minViscosity, s.minViscosity);
        total.maxViscosity = std::max(total.maxViscosity, s.maxViscosity);
        for (std::size_t k = 0; k < phases; ++k)
        {
            total.mass[k] += s.mass[k];
            total.count[k] += s.count[k];
            total.minDensity[k] = std::min(total.minDensity[k], s.minDensity[k]);
            total.maxDensity[k] = std::max(total.maxDensity[k], s.maxDensity[k]);
            total.maxSpeedOf[k] = std::max(total.maxSpeedOf[k], s.maxSpeedOf[k]);
        }
    }
    total.power += dot(settings.coefficients.g, total.momentum);
    total.maxSpeed = *std::max_element(total.maxSpeedOf.begin(), total.maxSpeedOf.end());
    total.finite = std::isfinite(total.kineticEnergy) && std::isfinite(total.maxAcceleration) && std::isfinite(total.powderVolume);
    return total;
}

template Summary summarise(ParticleSystem<2>&, const Settings&);
template Summary summarise(ParticleSystem<3>&, const Settings&);

}
