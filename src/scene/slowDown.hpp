/// Friction behind the kick of a step: v_1 = s (v_0 + dt a), s a share of each particle.
///
/// Where two levels are kept (TwoLevels.hpp) their increment is slowed with v. Implicit steps move particles by v_0 and dv/dt: there dv/dt <- dv/dt - (1 - s) v/dt, so that positions feel the friction as
/// velocities do. Verified by test/unit/gas (SlowDown).
#pragma once
#include "fields/fieldTags.hpp"
#include "scene/Particles.hpp"
#include "scene/TwoLevels.hpp"
#include <array>
#include <cmath>

namespace sph
{

/// `share`(i, |v_i| [m/s]): s of particle i, 1 where nothing slows it; `deltaT` [s].
template<int dim> void slowDown(Particles<dim>& particles, double deltaT, const auto& share)
{
    auto& store = particles.store();
    const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{});
    const auto increment = incrementOf(stateField(Velocity{}));
    std::array<double*, dim> d{};
    for (int c = 0; store.has(increment) && c < dim; ++c) d[std::size_t(c)] = store.component(increment, c);
    const double byAcceleration = particles.settings().integration.solvesPressure ? 1 / deltaT : 0;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        double squared = 0;
        for (int c = 0; c < dim; ++c) squared += sqr(v[c][i]);
        const double s = share(i, std::sqrt(squared));
        for (int c = 0; c < dim; ++c)
        {
            if (byAcceleration > 0) a[c][i] -= byAcceleration * (1 - s) * v[c][i];
            v[c][i] *= s;
            if (d[std::size_t(c)]) d[std::size_t(c)][i] *= s;
        }
    }
}

}
