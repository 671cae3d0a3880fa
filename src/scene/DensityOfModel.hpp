/// A fact of scenes whose density follows a state variable of a material, as the void ratio of soil: the model that advances it changes rho
/// with it, and no continuity equation runs.
#pragma once

namespace sph
{

struct DensityOfModel
{
    static constexpr auto says = "that the density follows a state variable";
    bool exists = false;
};

}
