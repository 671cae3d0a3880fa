/// Contact angle as a potential of the wall, the same energy as WallTension's but felt along the normal:
///
///   dv_i/dt += -1/rho_k sum_(walls within H of i) gamma_sk Phi'(d) n,    Phi(d) = 35/(16 H) (1 - (d/H)^2)^3
///
/// n [-] normal and d [m] distance of the wall, gamma_sk [N/m] its tension with the particle's phase k, rho_k [kg/m^3] that phase's rest
/// density. Phi [1/m] integrates to 1 over the fluid's side, so a wall covered by phase k stores gamma_sk. It is flat at the wall and at H:
/// no step in the force, and ghosts need no rule of their own. d is that of the nearest place of each body, its edges included: the force of a
/// box is the gradient of one potential, and a liquid around its corner is at rest.
///
/// The force has an energy whatever the particles' arrangement: liquid bodies of a few spacings stay on the wall, where the stress
/// works them loose and stirs the gas (tutorials/heapLeaching/bccBed). The interface must bend within H of the wall: the curvature form
/// does, and has angles within 3 degrees; the interface stress does not, and has them too far from 90 (tutorials/verification/contactAngle).
#pragma once
#include "Coefficients.hpp"
#include "Images.hpp"

namespace sph
{

template<int dim> class WallPotential
{
    const double *tension_, *restDensity_;   ///< [N/m], walls x phases; [kg/m^3]
    std::size_t phases_;
    double H_;

public:
    explicit WallPotential(const Coefficients&);
    /// dPhi/dd [1/m^2]
    double slope(double d) const;
    /// Adds to dv/dt of all owned particles, from the images as last moved.
    void addAcceleration(const Images<dim>&, FieldStore<dim>&) const;
};

}
