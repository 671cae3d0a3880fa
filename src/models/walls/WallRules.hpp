/// Part that gives images the rules of a scene's walls.
#pragma once
#include "scene/Particles.hpp"
#include <string>

namespace sph
{

template<int dim> class WallRules final : public RunningModel<dim>
{
    bool filters_;

public:
    /// Words of wallVelocity and wallPressure; whether viscosity varies, and whether velocities are interpolated in layers.
    WallRules(Particles<dim>&, const Numbers&, const std::string& velocity, const std::string& pressure, bool varies, bool interpolates);
    std::vector<Stage<dim>> stages(JoinPoint) override;
    /// M u_w^2/2: the speed u_w of the fastest wall beside which there are particles, to the whole mass M.
    double supply(const Particles<dim>&, const std::vector<double>& mass) const override;
};

}
