/// Friction of the gas, dv/dt = -r v [1/s]: of gas whose motion nobody asks for.
///
///   v_1 = v/(1 + r dt)
///
/// behind each step's kick. What the gas then takes of a liquid that drives it is rho_gas r v L over a pore of length L [Pa]: see README.md for how large r may be.
#pragma once
#include "fields/fieldTags.hpp"
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class GasFriction final : public RunningModel<dim>
{
    std::size_t gas_;
    double rate_;

public:
    /// `gas`: number of its phase; `rate` [1/s].
    GasFriction(Particles<dim>&, const Numbers&, std::size_t gas, double rate) : gas_(gas), rate_(rate) {}

    std::vector<Stage<dim>> stages(JoinPoint place) override
    {
        if (place != JoinPoint::afterKick) return {};
        return {{"slow gas", "v /= 1 + r dt",
                 [this](Particles<dim>& p, const Substep& step)
                 {
                     const double* const phase = p.store().component(Phase::info.name, 0);
                     const auto v = p.store().pointers(Velocity{});
                     const double share = 1 / (1 + rate_ * step.deltaT);
#pragma omp parallel for schedule(static)
                     for (std::size_t i = 0; i < p.size(); ++i)
                         for (int c = 0; c < dim; ++c) v[c][i] *= std::size_t(phase[i]) == gas_ ? share : 1;
                 }}};
    }
};

}
