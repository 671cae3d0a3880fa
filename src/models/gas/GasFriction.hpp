/// Friction of the gas, as Darcy and Forchheimer have it: of gas whose motion nobody asks for.
///
///   dv/dt = a - (r + |v|/l) v      v_1 = v/(1 + (r + |v|/l) dt),  v = v_0 + dt a,  l = Delta_x/2
///
/// behind the kick of each step: however long steps are a steady slow motion has v = a/r, and no particle goes farther than l in one. v [m/s] of the gas alone, in both levels where there are two; r [1/s];
/// Delta_x [m] the spacing. Momentum is not kept: a liquid that drives the gas at v over a length L feels rho_gas (r + |v|/l) v L [Pa], to first order in the step. How large r may be: README.md. Verified by
/// test/unit/gas (a layer that drives the gas round).
#pragma once
#include "fields/fieldTags.hpp"
#include "scene/Particles.hpp"
#include "scene/TwoLevels.hpp"
#include <array>
#include <cmath>

namespace sph
{

template<int dim> class GasFriction final : public RunningModel<dim>
{
    std::size_t gas_;
    double rate_, length_;

public:
    /// `gas`: number of its phase; `rate`: r.
    GasFriction(Particles<dim>& particles, const Numbers&, std::size_t gas, double rate)
        : gas_(gas), rate_(rate), length_(0.5 * particles.coefficients().spacing)
    {}

    std::vector<Stage<dim>> stages(JoinPoint place) override
    {
        if (place != JoinPoint::afterKick) return {};
        return {{"slow gas", "v /= 1 + (r + 2 |v|/Delta_x) dt",
                 [this](Particles<dim>& p, const Substep& step)
                 {
                     auto& store = p.store();
                     const double* const phase = store.component(Phase::info.name, 0);
                     for (const auto& name : {std::string(Velocity::info.name), incrementOf(stateField(Velocity{}))})
                         if (store.has(name)) slow(store, name, phase, p.size(), step.deltaT);
                 }}};
    }

private:
    void slow(FieldStore<dim>& store, const std::string& name, const double* phase, std::size_t n, double deltaT) const
    {
        std::array<double*, dim> v;
        for (int c = 0; c < dim; ++c) v[std::size_t(c)] = store.component(name, c);
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < n; ++i)
        {
            if (std::size_t(phase[i]) != gas_) continue;
            double squared = 0;
            for (const auto* v_c : v) squared += sqr(v_c[i]);
            const double slowed = 1 / (1 + (rate_ + std::sqrt(squared) / length_) * deltaT);
            for (auto* v_c : v) v_c[i] *= slowed;
        }
    }
};

}
