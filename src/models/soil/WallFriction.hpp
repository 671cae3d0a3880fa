/// Soil at walls of a given friction angle: Coulomb's law by an elastic joint that slides where its strength is reached (Goodman, Taylor & Brekke 1968).
///
///   d tau/dt = k v_s,    |tau| <= tan(delta) max(0, -n.sigma n - p_f - d n.(rho g + f)),    v_s = (v - v_w - d L n)_t,    k = rho c^2/dx
///
/// tau [Pa] shear stress on the wall, on soil above a floor in the direction that it slides in; the normal stress is that of the particle with the weight of the soil between, f [N/m^3] body force; v_s [m/s] velocity of the soil along the wall, from the particle's own along its velocity gradient L to the wall at
/// distance d [m]; v_w that of the wall, n normal into the soil, t the part along the wall; delta friction angle, p_f [Pa] floorPressure with `stressFree floor`, dx [m] spacing, rho c^2 [Pa] stiffness of
/// the law. The joint gives way by tau/k, as half a spacing of soil does. Kept of each particle within a support of such a wall as a tensor T, of which tau = (T n)_t: where two walls meet at a
/// right angle both have the one shear stress that soil can have there. ContinuedStress.hpp puts T at the wall; L_w = L is where RubbingVelocity (models/walls/ghostRules.hpp) reads it. Verified by test/unit/soil.
#pragma once
#include "Particles.hpp"

namespace sph
{

template<int dim> class WallFriction final : public Part<dim>
{
    std::vector<std::size_t> near_; ///< particles that may be within a support of a wall
    bool atEnds_;                   ///< of steps the stress is known, and not in their middles

    void slide(Particles<dim>&, std::size_t i, double deltaT) const;

public:
    WallFriction(Particles<dim>&, const Numbers&);
    std::vector<Stage<dim>> stages(Place) override;
    void sorted(Particles<dim>&) override;
};

}
