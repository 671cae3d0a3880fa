/// Implicit solve for the velocities: viscosity, and with `scheme implicit` pressure too, acts within a step, not at its start, and is stable however stiff.
///
///   v_1 = v_0 + dt (a(v_0) + theta L (v_1 - v_0))                                a(v_0) all accelerations, L v = dv/dt by viscosity
///   v_1 = v_0 + dt (a(x_0 + theta dt v_0, v_0) + (theta L + theta^2 dt K)(v_1 - v_0))
///
/// dt K u is how the acceleration by pressure changes where particles move by dt u; here they do so by theta^2 dt (v_1 - v_0), to theta of the step.
///
/// theta 1 is Euler's implicit step: of first order, and it damps what it does not resolve. theta 1/2 is that of Crank and Nicolson: of
/// second order, and it lets what it does not resolve ring. K <= 0, of the energy of Hu and Adams, is that of PressureResponse.hpp.
///
/// Where surface tension allows no longer steps than viscosity does, an implicit step of first order takes viscosity as it is at its start (models/viscosity):
/// it is a part of a alone, and L is left out of all that follows.
///
/// (1 - theta dt L - theta^2 dt^2 K) dv = dt a is solved by conjugate gradients in the inner product sum_i m_i u_i.v_i, in which L and K are symmetric
/// (walls that are curved make them so within a per cent, which the iteration bears), preconditioned by 1 + theta dt lambda_i + theta^2 dt^2 kappa_i with
/// the rates of a particle alone. Nothing is stored of the matrix: L and K are a plan of few terms over the pairs that the evaluation has kept. They are computed
/// in single precision (plan/README.md) down to a tolerance of 1e-6, below it in double: rounding by 6e-8 is far below what the iteration leaves.
///
/// What is held and has no stiffness, as gas that stands (models/gas), needs no product: its neighbours are not looked at.
///
/// The remaining residual r must not change the momentum. With viscosity alone r is added to dv, and v_1 = v_0 + dt (a + theta L dv) for the dv
/// before, a sum over pairs of forces that cancel. With the stiffness of pressure r would be a large velocity of single particles. What of it is smooth is an
/// impulse that the forces have given and the particles have not had: its means over boxes of two supports (averageInBoxes.hpp) are kept, as the state
/// DelayedImpulse, and added to dt a of the next step. A body that is slow to be found by the iteration gets all of its impulse, a step late. Without it the
/// loss is of one sign and adds up: a drop above a pool at rest was 5 % too slow after 0.1 s. Single particles' residuals are not kept: a particle that leaves
/// a stiff surrounding would take its own as a velocity.
///
/// A residual that is small beside the forces of all may be large beside those of motions that hardly have any: conjugate gradients multiply what they do not see. A stiff motion
/// whose residual is rho times its own force is x, x + dt v = X at one step and rho X, 2 rho X - x at the next, mu^2 - 2 rho mu + rho = 0: it decays for rho between
/// -1/3 and 1 and grows by any factor outside, until its forces are a share `tolerance` of all. At rest there is nothing beside it that could end its growth.
/// Where a scene asks for calm gas (the fact CalmPhase), and forces have grown from one solve to the next by more than 1.5 (rms over particles), the tolerance is therefore a third of what it was, down to
/// 0.03 of the one asked for, and goes back by a tenth a step. Other scenes keep theirs: where the flow itself grows, its rate hangs on what the tolerance damps. Figures: README.md.
///
/// A velocity that all particles have in common is its own response where no wall holds it, since forces in pairs cancel; viscosity at walls takes
///
///   gamma_c = -sum_i m_i (L e_c)_i.e_c/sum_i m_i        e_c: unit vector of the component c
///
/// of it in a time. The share 1/(1 + theta dt gamma_c) of the mean of r is added to dv at once, and the rest goes into the next step. All of it added is a
/// velocity that viscosity would have taken in the same step from what creeps between walls: the flow through an array of spheres had -1.6 to 1.0 times its
/// drag (tutorials/verification/facetedSphere). None of it added is a step's delay for a drop that falls in a vessel: it was 0.9905 of g t in place of 0.9950
/// (test/accuracy fallingDrop). gamma varies as slowly as the particles move: it is asked for every few steps, and kept in between and over restarts.
///
/// A step is refused (StepTooLong) where the iteration does not end, and with pressure where dt |dv| of any particle exceeds h/2, the limit by acceleration having
/// allowed for h/16 at the forces of the step before: farther than that no response is linear. The state is taken back, the impulse of the step before by one more product, and the step made in halves;
/// with viscosity alone the run ends where the iteration does not.
///
/// Without inertia, 0 = a(v_0) + L (v_1 - v_0), the same iteration finds the steady velocities of creeping flow; walls must hold it.
#pragma once
#include "scene/Particles.hpp"
#include <array>

namespace sph
{

template<int dim> class ImplicitSolve final : public RunningModel<dim>
{
public:
    ImplicitSolve(Particles<dim>&, const Numbers& restored);

    std::vector<Stage<dim>> stages(JoinPoint) override;
    std::string note() const override;
    Numbers columns(const Particles<dim>&) const override { return {{"solverIterations", iterations_}}; }
    void save(Numbers&) const override;
    std::size_t bytes() const override;

private:
    class Matrix;

    std::array<Array, dim> change_, residual_; ///< dv of the owned particles, and r where viscosity is solved for alone
    std::vector<std::uint8_t> leftOut_;        ///< particles at which no product is asked for; empty where there is none
    const bool withPressure_, viscous_, followsForces_;
    int iterations_ = 0;
    std::array<double, dim> wallRate_{}; ///< gamma [1/s]
    long steps_ = 0;                     ///< solves in which gamma was needed
    double share_ = 1;                   ///< of the tolerance asked for
    double forces_ = 0;                  ///< mean a^2 of the last solve [m^2/s^4]

    /// Sets the share of the tolerance by how the forces have grown since the last solve.
    void followForces(const Particles<dim>&);
    /// Replaces dU/dt = a by (v_1 - v_0)/dt, for positions and pairs as of the last evaluation. It iterates until |r| <= tolerance |v_1|, both in
    /// the norm sqrt(sum_i m_i r_i^2), or with pressure until |r| <= tolerance times |dt a|, both in sqrt(sum_i m_i r_i^2/diagonal_i): forces that
    /// balance one another are larger than any velocity. Throws StepTooLong after `maxIter` iterations and where
    /// a particle is thrown too far, DivergedError where nothing is finite. Particles
    /// in a buffer, whose dU/dt is 0, keep their velocities.
    void solve(Particles<dim>&, double deltaT);
    /// Marks what is held and has no stiffness: its residual stays 0, and q, which others would read, is 0 (PressureResponse.hpp).
    void findLeftOut(const Particles<dim>&);
    /// Throws StepTooLong where dv carries a particle farther than a linear response knows.
    void refuseLeaps(const Particles<dim>&, double deltaT) const;
    /// Sets r, which is dt a + the impulse of the step before - A dv by now, to that impulse.
    void takeBack(Particles<dim>&, double deltaT);
    /// Replaces v_0 by v_1 of creeping flow. It iterates until |r/lambda| <= tolerance |v_1|.
    void solveSteady(Particles<dim>&);
    /// Adds the remaining residual to dv: all forces are then those at dv, in pairs that cancel.
    void addResidual(const Particles<dim>&);
    /// Adds of the mean of the remaining residual to dv what walls let pass, and keeps means over boxes of the rest for the next step.
    void delayResidual(Particles<dim>&, double deltaT);
    /// Sets gamma of one component every few steps, of each in turn, and of all at the start.
    void measureWallRates(Particles<dim>&, double mass);
    void solveForChange(Particles<dim>&, double inertia, double deltaT);
};

}
