/// Soil at walls of a given friction angle: Coulomb's law by an elastic joint that slides where its strength is reached (Goodman, Taylor & Brekke 1968).
///
///   d tau/dt = k v_s,    |tau| <= tan(delta) max(0, -n.S n - d n.(rho g + f)),    v_s = (v - v_w)_t,    k = rho c^2/dx
///
/// tau [Pa] shear stress on the wall, on soil above a floor in the direction that it slides in; S [Pa] acting stress (ActingStress.hpp), whose normal part has the weight of the soil between added, d [m] distance
/// from the wall, n normal into the soil, f [N/m^3] body force; v_s [m/s] velocity of the soil along the wall, v_w that of the wall; delta friction angle, dx [m] spacing, rho c^2 [Pa] stiffness of the law. The joint
/// gives way by tau/k, as some tenths of a spacing of soil do. ContinuedStress.hpp puts tau at the wall, beyond which the velocity is mirrored as where soil slips: the work that tau does on the particles is then what the
/// joint takes. With v_s at the wall itself, along the velocity gradient, and a velocity that goes straight on, it is not.
///
/// Kept of each particle within a support of such a wall as a tensor T, of which tau = (T n)_t: where two walls meet at a right angle both have the one shear stress that soil can have there. What hangs on to a
/// wall by tension, as bodies of the elastic law do, has no friction there. Verified by test/unit/soil.
#pragma once
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class WallFriction final : public RunningModel<dim>
{
    std::vector<std::size_t> near_; ///< particles that may be within a support of a wall
    bool atEnds_;                   ///< of steps the stress is known, and not in their middles

    void find(Particles<dim>&);
    void slide(Particles<dim>&, std::size_t i, double deltaT) const;

public:
    WallFriction(Particles<dim>&, const Numbers&);
    std::vector<Stage<dim>> stages(JoinPoint) override;
};

}
