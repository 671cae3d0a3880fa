/// Forces of the fluid or soil on walls, for the function object `forces` and for walls under load.
///
///   F_w = -sum_i m_i a_iw,    of walls under load m_w dv_w/dt = F + F_w.d - m_w c v_w along d
///
/// F_w [N], per metre of depth in 2-D; a_iw [m/s^2] acceleration of particle i by the ghosts behind wall w, in a corner by those whose last reflection was in it. What all walls, gravity and body forces give is
/// then the rate of momentum of a scene whose pair forces are antisymmetric, to round-off. Forces are those that the last step has acted with; where it solves for viscosity they are taken at its end. Impulses of
/// what touches a wall (WallContact) are no forces, and not in them. It costs a pass over the particles near the walls that are asked for, each step.
///
/// F [N] is the load (geometry/Geometry.hpp, WallLoad), m_w [kg] the mass of the wall, d its direction, c [1/s] its damping. The wall takes F_w as it takes F, with what was measured in the step: F is that of its middle, c acts at its end.
/// That is stable where the wall has at least the mass that moves with it at once: of what has a speed of sound the particles within a spacing, which is checked whenever lists are built; of soil full of water, or of all that is solved for
/// within the step, an added mass that hangs on the scene. With less than it wall and particles throw one another to and fro, further at each turn, and the run ends in an error.
/// Verified by test/unit/solver (rate of momentum, with corners and a body that moves; weight that a plate carries, restart).
#pragma once
#include "scene/Model.hpp"
#include "scene/Particles.hpp"

namespace sph
{

/// Adds it to the settings where system/controlDict has function objects `forces` or a wall is under load; when all models have read.
void askForWallForces(const Reading&);

template<int dim> class WallForces final : public RunningModel<dim>
{
    std::vector<int> walls_;             ///< those that are asked for
    std::vector<Vector<dim>> forces_;    ///< of each [N]
    std::vector<std::vector<int>> near_; ///< particles that ghosts behind each act on
    /// Swings of the acceleration of a wall under load [m/s^2].
    struct Swing
    {
        double last = 0;          ///< acceleration
        double turn = 0;          ///< the same where it last turned
        double widest = 0;        ///< of the last swing, from turn to turn
        double first = 0;         ///< the swing that the growth is measured from
        int steps = 0, turns = 0; ///< since that turn, and turns that each went further
        /// Whether swings of a few steps each have grown beyond doubt.
        bool hasGrown(double acceleration);
    };
    std::vector<Swing> swings_;
    const bool solves_;
    bool listed_ = false;  ///< near_ is that of the present lists
    bool anyLoad_ = false; ///< some wall is under load

    void measure(Particles<dim>&);
    void push(Particles<dim>&, const Substep&);
    void checkMass(const Particles<dim>&, std::size_t k) const;

public:
    WallForces(Particles<dim>&, const Numbers&, std::vector<std::string> walls);
    std::vector<Stage<dim>> stages(JoinPoint) override;
    Numbers columns(const Particles<dim>&) const override;
};

}
