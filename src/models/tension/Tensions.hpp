/// Surface tensions of a scene: of each pair of phases, and of each wall with each phase.
#pragma once
#include "plan/Coefficients.hpp"
#include <algorithm>
#include <vector>

namespace sph
{

struct Tensions
{
    std::vector<double>
        between; ///< gamma_kl [N/m], phases x phases; of one phase alone that of its free surface, where the gas is left out
    std::vector<double> ofWalls; ///< gamma_sk [N/m], walls x phases; empty where no wall has a contact angle

    bool any() const
    {
        return std::ranges::any_of(between, [](double gamma) { return gamma > 0; });
    }
    double largest() const { return between.empty() ? 0 : std::ranges::max(between); }
};

/// Those of the scene; none where no model has set any.
inline const Tensions& tensionsOf(const Coefficients& c)
{
    static const Tensions none;
    return c.has<Tensions>() ? c.of<Tensions>() : none;
}

}
