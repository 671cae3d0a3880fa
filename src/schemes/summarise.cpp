#include "summarise.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

template<int dim> Summary summarise(ParticleSystem<dim>& particles, const Settings& settings)
{
    auto& store = particles.store();
    const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{});
    const double *m = store.component("m", 0), *rho = store.component("rho", 0);
    const double* phase = settings.multiphase() ? store.component("phase", 0) : nullptr;
    const std::size_t n = particles.size(), phases = settings.coefficients.phases.size(), block = 4096, blocks = (n + block - 1)/block;
    const double infinity = std::numeric_limits<double>::infinity();

    std::vector<Summary> parts(blocks);
    #pragma omp parallel for schedule(static)
    for (std::size_t b = 0; b < blocks; ++b)
    {
        Summary s;
        s.mass.assign(phases, 0);
        s.count.assign(phases, 0);
        s.minDensity.assign(phases, infinity);
        s.maxDensity.assign(phases, -infinity);
        s.maxSpeedOf.assign(phases, 0);
        double a2 = 0;
        for (std::size_t i = b*block; i < std::min(n, (b + 1)*block); ++i)
        {
            Vector<dim> v_i, a_i;
            fetch(v_i, [&](int c) { return v[c][i]; });
            fetch(a_i, [&](int c) { return a[c][i]; });
            const std::size_t k = phase ? std::size_t(phase[i]) : 0;
            s.maxSpeedOf[k] = std::max(s.maxSpeedOf[k], mag(v_i));
            a2 = std::max(a2, dot(a_i, a_i));
            s.kineticEnergy += 0.5*m[i]*dot(v_i, v_i);
            s.momentum += m[i]*in3D(v_i);
            s.mass[k] += m[i];
            ++s.count[k];
            s.minDensity[k] = std::min(s.minDensity[k], rho[i]);
            s.maxDensity[k] = std::max(s.maxDensity[k], rho[i]);
        }
        s.maxSpeed = *std::max_element(s.maxSpeedOf.begin(), s.maxSpeedOf.end());
        s.maxAcceleration = std::sqrt(a2);
        parts[b] = s;
    }
    Summary total;
    total.mass.assign(phases, 0);
    total.count.assign(phases, 0);
    total.minDensity.assign(phases, infinity);
    total.maxDensity.assign(phases, -infinity);
    total.maxSpeedOf.assign(phases, 0);
    for (const auto& s : parts)
    {
        total.maxSpeed = std::max(total.maxSpeed, s.maxSpeed);
        total.maxAcceleration = std::max(total.maxAcceleration, s.maxAcceleration);
        total.kineticEnergy += s.kineticEnergy;
        total.momentum += s.momentum;
        for (std::size_t k = 0; k < phases; ++k)
        {
            total.mass[k] += s.mass[k];
            total.count[k] += s.count[k];
            total.minDensity[k] = std::min(total.minDensity[k], s.minDensity[k]);
            total.maxDensity[k] = std::max(total.maxDensity[k], s.maxDensity[k]);
            total.maxSpeedOf[k] = std::max(total.maxSpeedOf[k], s.maxSpeedOf[k]);
        }
    }
    total.finite = std::isfinite(total.kineticEnergy) && std::isfinite(total.maxAcceleration);
    return total;
}

template Summary summarise(ParticleSystem<2>&, const Settings&);
template Summary summarise(ParticleSystem<3>&, const Settings&);

}
