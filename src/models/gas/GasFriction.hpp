/// Friction of the gas, as Darcy and Forchheimer have it: of gas whose motion nobody asks for.
///
///   dv/dt = a - (r + |v|/l) v      v_1 = v/(1 + (r + |v|/l) dt),  v = v_0 + dt a,  l = Delta_x/2
///
/// behind the kick of each step: however long steps are a steady slow motion has v = a/r (from two levels (1 + r dt)/(1 + r dt/2) of it), and no particle goes farther than l in one. v [m/s] of the gas alone, in both levels where there are two; r [1/s];
/// Delta_x [m] the spacing. Momentum is not kept: a liquid that drives the gas at v over a length L feels rho_gas (r + |v|/l) v L [Pa], within 2 % for r dt up to 0.2 (README.md). How large r may be: README.md. Verified by
/// test/unit/gas (a layer that drives the gas round).
#pragma once
#include "scene/slowDown.hpp"

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
        return {{"slow gas by friction", "v /= 1 + (r + 2 |v|/Delta_x) dt",
                 [this](Particles<dim>& p, const Substep& step)
                 {
                     const double* const phase = p.store().component(Phase::info.name, 0);
                     slowDown(p, step.deltaT,
                              [&](std::size_t i, double speed)
                              { return std::size_t(phase[i]) == gas_ ? 1 / (1 + (rate_ + speed / length_) * step.deltaT) : 1.0; });
                 }}};
    }
};

}
