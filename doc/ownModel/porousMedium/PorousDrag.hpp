/// Resistance of a porous medium that the particles do not resolve: Darcy (1856) and Forchheimer (1901), in the form of OpenFOAM's model DarcyForchheimer.
///
///   dv_i/dt = -(nu d + 1/2 |v_i| f) v_i    within a box, 0 outside
///
/// nu = mu/rho_0 [m^2/s], d = 1/K [1/m^2] one over the permeability, f [1/m], v [m/s] the superficial velocity. It takes momentum, which the medium has
/// from it. Verified by test/unit/ownModel (hand values; start and steady speed of a flow by their formulas, order 2).
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

/// Numbers of the medium, as constant/porousMedium gives them.
struct PorousMedium
{
    double d = 0, f = 0; ///< [1/m^2], [1/m]
    Vector<3> min, max;  ///< the box [m]
};

struct PorousDrag
{
    static constexpr auto name = "porousDrag";
    using Adds = Acceleration;
    using ReadsOwn = Fields<Position, Velocity>;
    PorousMedium medium;
    double nu;

    auto operator()(const auto& i) const
    {
        const Vector<3>&low = medium.min, &high = medium.max;
        bool inside = i.x.x >= low.x && i.x.x <= high.x && i.x.y >= low.y && i.x.y <= high.y;
        if constexpr (dimensions(decltype(i.x){}) == 3) inside = inside && i.x.z >= low.z && i.x.z <= high.z;
        return -inside * (nu * medium.d + 0.5 * mag(i.v) * medium.f) * i.v;
    }
};

}
