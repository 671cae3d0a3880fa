/// Part that gives images the rules of a scene's walls.
#pragma once
#include "Particles.hpp"
#include <string>

namespace sph
{

template<int dim> class WallRules final : public Part<dim>
{
    bool filters_;

public:
    /// Words of wallVelocity and wallPressure; whether viscosity varies, and whether velocities are interpolated in layers.
    WallRules(Particles<dim>&, const Numbers&, const std::string& velocity, const std::string& pressure, bool varies, bool interpolates);
    std::vector<Stage<dim>> stages(Place) override;
};

}
