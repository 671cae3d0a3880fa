/// Gives images the rules of a scene's walls.
#pragma once
#include "Particles.hpp"
#include <string>

namespace sph
{

template<int dim> class WallRules final : public Part<dim>
{
    bool filters_;

public:
    /// Words of wallVelocity and wallPressure.
    WallRules(Particles<dim>&, const Numbers&, const std::string& velocity, const std::string& pressure);
    std::vector<Stage<dim>> stages(Place) override;
};

}
