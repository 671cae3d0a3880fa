/// Work that walls in motion do upon the fluid: what the energy balance of such a scene lacks without it.
///
///   P = sum_i m_i a_iw.v_w
///
/// P [W], per metre of depth in 2-D; a_iw [m/s^2] the acceleration of particle i by the ghosts behind wall w, v_w [m/s] the wall's velocity where it is
/// nearest. Ghosts mirror the energy of their sources, so that a wall at rest does no work, and what one in motion does is kinetic and stored energy, or
/// dissipated.
///
/// Forces are those of the evaluation; where a step solves for viscosity they are taken at its end. It costs a pass over the particles near such walls, for
/// each motion once, and is there for the function object conservation alone. Nothing is measured with pressure within the step, whose forces no evaluation
/// sees; with several substeps; with soil, whose model counts its walls by their stress; and with openings, whose work nothing measures.
#pragma once
#include "scene/Model.hpp"
#include "scene/Particles.hpp"

namespace sph
{

/// Adds it to the settings where system/controlDict has the function object conservation and walls move; when all models have read.
void askForWallWork(const Reading&);

template<int dim> class WallWork final : public RunningModel<dim>
{
    std::vector<int> motionOf_; ///< by wall: the first wall that moves as this one does; none where it rests
    const bool solves_;
    double power_ = 0;

    void measure(Particles<dim>&);
    /// Power of the walls of one motion.
    double powerOf(Particles<dim>&, int motion);
    /// Velocity of the walls of a motion where one is nearest to x [m/s].
    Vector<3> velocityAt(const Particles<dim>&, int motion, const Vector<3>& x) const;

public:
    WallWork(Particles<dim>&, const Numbers&);
    std::vector<Stage<dim>> stages(JoinPoint) override;
    double power() const override { return power_; }
};

}
