/// Viscosity at the end of a step instead of at its start: stable however stiff it is.
///
///   v_1 = v_0 + dt (a(v_0) + theta L (v_1 - v_0))        a(v_0) all accelerations, L v = dv/dt by viscosity
///
/// theta 1 is Euler's implicit step: of first order, and it damps what it does not resolve. theta 1/2 is that of Crank and Nicolson: of
/// second order, and it lets what it does not resolve ring.
///
/// (1 - theta dt L) dv = dt a is solved by conjugate gradients in the inner product sum_i m_i u_i.v_i, in which L is symmetric (walls that
/// are curved make it so within a per cent, which the iteration bears), preconditioned by 1 + theta dt lambda_i with lambda_i the
/// viscous rate. Nothing is stored of the matrix: L is a plan of one term over the pairs that the evaluation has kept. What remains of the
/// residual r is added to dv: then v_1 = v_0 + dt (a + theta L dv) for the dv before, a sum over pairs of forces that cancel, and momentum is
/// conserved to round-off whatever the tolerance.
///
/// Without inertia, 0 = a(v_0) + L (v_1 - v_0), the same iteration finds the steady velocities of creeping flow; walls must hold it.
#pragma once
#include "Particles.hpp"
#include <array>

namespace sph
{

template<int dim> class ImplicitSolve final : public Part<dim>
{
public:
    ImplicitSolve(Particles<dim>& particles, const Numbers&)
        : withPressure_(particles.settings().integration.solvesPressure), viscous_(particles.plan().provides(ViscousResponse::info.name))
    {}

    std::vector<Stage<dim>> stages(Place) override;
    std::string note() const override;
    Numbers columns(const Particles<dim>&) const override { return {{"solverIterations", iterations_}}; }
    std::size_t bytes() const override;

private:
    std::array<Array, dim> change_, residual_;   ///< dv and r of the owned particles
    const bool withPressure_, viscous_;
    int iterations_ = 0;

    /// Replaces dU/dt = a(v_0) by (v_1 - v_0)/dt, for positions and pairs as of the last evaluation. Until |r| <= tolerance |v_1|, both in
    /// the norm sqrt(sum_i m_i r_i^2); throws DivergedError after `maxIter` iterations. Particles that are held, whose dU/dt is 0, keep their
    /// velocities.
    void solve(Particles<dim>&, double deltaT);
    /// v_1 of creeping flow in place of v_0. Until |r/lambda| <= tolerance |v_1|.
    void solveSteady(Particles<dim>&);
    /// What remains of the residual: a step by it makes all forces what they are at dv, in pairs that cancel.
    void addResidual(const Particles<dim>&);
    void addMeanResidual(const Particles<dim>&);
    void conjugateGradients(Particles<dim>&, double inertia, double deltaT);
};

}
