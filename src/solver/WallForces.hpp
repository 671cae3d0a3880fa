/// Forces of the fluid or soil on walls, for the function object `forces`.
///
///   F_w = -sum_i m_i a_iw
///
/// F_w [N], per metre of depth in 2-D; a_iw [m/s^2] acceleration of particle i by the ghosts behind wall w, in a corner by those whose last reflection was in it. What all walls, gravity and body forces give is
/// then the rate of momentum of a scene whose pair forces are antisymmetric, to round-off. Forces are those that the last step has acted with; where it solves for viscosity they are taken at its end. Impulses of
/// what touches a wall (WallContact) are no forces, and not in them. It costs a pass over the particles near the walls that are asked for, each step. Verified by test/unit/solver (rate of momentum, with corners and a body that moves).
#pragma once
#include "scene/Model.hpp"
#include "scene/Particles.hpp"

namespace sph
{

/// Adds it to the settings where system/controlDict has function objects `forces`; when all models have read.
void askForWallForces(const Reading&);

template<int dim> class WallForces final : public RunningModel<dim>
{
    std::vector<int> walls_;             ///< those that are asked for
    std::vector<Vector<dim>> forces_;    ///< of each [N]
    std::vector<std::vector<int>> near_; ///< particles that ghosts behind each act on
    const bool solves_;
    bool listed_ = false; ///< near_ is that of the present lists

    void measure(Particles<dim>&);

public:
    WallForces(Particles<dim>&, const Numbers&, std::vector<std::string> walls);
    std::vector<Stage<dim>> stages(JoinPoint) override;
    Numbers columns(const Particles<dim>&) const override;
};

}
