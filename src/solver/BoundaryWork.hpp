/// Work that walls in motion and open boundaries do upon the fluid: what the energy balance of such a scene lacks without it.
///
///   P = sum_i m_i a_iw.v_w                                                    walls
///   P = -sum_h m_h (a_hf.v_h + p_h/rho_h^2 (drho_h/dt)_f)                     openings
///
/// P [W], per metre of depth in 2-D. i: particles of the fluid, w: ghosts behind a wall in motion, v_w [m/s] its velocity where it is nearest: ghosts mirror the
/// energy of their sources, so that a wall at rest does no work. h: particles that an opening holds, f: free ones; what a pair of them gives to motion and
/// compression of both sums to what it dissipates, so that what the held one does not get is the free one's. What passes a plane brings its energy besides
/// (RunningModel::measuredPower of openings). What the walls and openings give is kinetic and stored energy, or dissipated.
///
/// Forces are those of the evaluation; where a step solves for viscosity they are taken at its end. It costs a pass over the particles near such walls, for
/// each motion once, and one over the held ones, and is there for the function object conservation alone. Nothing is measured with pressure within the step, whose
/// forces no evaluation sees; with several substeps; and with soil, whose model counts its walls by their stress. Openings neither where interfaces have an energy, which passes
/// them too, nor with a background pressure, whose work on what comes and goes the energy of compression leaves out.
#pragma once
#include "scene/Model.hpp"
#include "scene/Particles.hpp"

namespace sph
{

/// Adds it to the settings where system/controlDict has the function object conservation and walls move or are open; when all models have read.
void askForBoundaryWork(const Reading&);

template<int dim> class BoundaryWork final : public RunningModel<dim>
{
    std::vector<int> motionOf_; ///< by wall: the first wall that moves as this one does; none where it rests
    const bool solves_, opens_;
    std::vector<std::string> groups_;
    double power_ = 0, powerOfHeld_ = 0;

    void measure(Particles<dim>&);
    /// Power of the walls of one motion.
    double powerOfWalls(Particles<dim>&, int motion);
    double powerOfHeld(Particles<dim>&);
    /// Velocity of the walls of a motion where one is nearest to x [m/s].
    Vector<3> velocityAt(const Particles<dim>&, int motion, const Vector<3>& x) const;

public:
    BoundaryWork(Particles<dim>&, const Numbers&);
    std::vector<Stage<dim>> stages(JoinPoint) override;
    double power() const override { return power_; }
    double measuredPower() const override { return power_ + powerOfHeld_; }
};

}
