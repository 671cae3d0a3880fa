/// Damping until a time:
///
///   dv/dt = -rate v
///
/// rate [1/s]. It is for a start far off equilibrium.
#pragma once
#include "scene/slowDown.hpp"
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
                     slowDown(p, substep.deltaT, [factor](std::size_t, double) { return factor; });
                 }}};
    }
};

}
