/// Damping until a time:
///
///   dv/dt = -rate v
///
/// rate [1/s]. It is for a start far off equilibrium. Velocities of both levels decay, where there are two.
#pragma once
#include "scene/Particles.hpp"
#include "scene/TwoLevels.hpp"
#include <cmath>

namespace sph
{

template<int dim> class Damping final : public RunningModel<dim>
{
    double rate_, until_;

public:
    Damping(Particles<dim>&, const Numbers&, double rate, double until) : rate_(rate), until_(until) {}
    std::vector<Stage<dim>> stages(JoinPoint place) override
    {
        if (place != JoinPoint::afterKick) return {};
        return {{"damp", "v *= exp(-rate dt)",
                 [this](Particles<dim>& p, const Substep& substep)
                 {
                     if (substep.time >= until_) return;
                     const double factor = std::exp(-rate_ * substep.deltaT);
                     for (const auto& name : {std::string(Velocity::info.name), incrementOf(stateField(Velocity{}))})
                         for (int c = 0; c < dim && p.store().has(name); ++c)
                         {
                             double* const v = p.store().component(name, c);
                             for (std::size_t i = 0; i < p.size(); ++i) v[i] *= factor;
                         }
                 }}};
    }
};

}
