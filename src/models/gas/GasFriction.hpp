/// Friction of the gas: of gas whose motion nobody asks for.
///
///   dv/dt = a - r v      v_1 = (v_0 + dt a)/(1 + r dt)
///
/// behind the kick of each step, so that a steady velocity is a/r however long steps are. v [m/s] of the gas alone, in both levels where there are two; r [1/s]. Momentum is not kept: a liquid that drives the
/// gas at v over a length L feels rho_gas r v L [Pa], to first order in r dt. How large r may be: README.md. Verified by test/unit/gas (a layer that drives the gas round).
#pragma once
#include "fields/fieldTags.hpp"
#include "scene/Particles.hpp"
#include "scene/TwoLevels.hpp"

namespace sph
{

template<int dim> class GasFriction final : public RunningModel<dim>
{
    std::size_t gas_;
    double rate_;

public:
    /// `gas`: number of its phase; `rate`: r.
    GasFriction(Particles<dim>&, const Numbers&, std::size_t gas, double rate) : gas_(gas), rate_(rate) {}

    std::vector<Stage<dim>> stages(JoinPoint place) override
    {
        if (place != JoinPoint::afterKick) return {};
        return {{"slow gas", "v /= 1 + r dt",
                 [this](Particles<dim>& p, const Substep& step)
                 {
                     auto& store = p.store();
                     const double* const phase = store.component(Phase::info.name, 0);
                     const double slowed = 1 / (1 + rate_ * step.deltaT);
                     for (const auto& name : {std::string(Velocity::info.name), incrementOf(stateField(Velocity{}))})
                         for (int c = 0; c < dim && store.has(name); ++c)
                         {
                             double* const v = store.component(name, c);
#pragma omp parallel for schedule(static)
                             for (std::size_t i = 0; i < p.size(); ++i) v[i] *= std::size_t(phase[i]) == gas_ ? slowed : 1;
                         }
                 }}};
    }
};

}
