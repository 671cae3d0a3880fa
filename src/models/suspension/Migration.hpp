/// Powder that migrates while a step of the flow passes: steps of its own at the velocities and positions of the flow.
///
///   mu(phi), gammaDot(v, mu), dphi/dt by the terms of this room;    phi += dt dphi/dt
///   dt <= f h^2/max_i D_i,    D = gammaDot phi (D_c a^2 + D_eta a^2 phi 1/mu dmu/dphi)        f = 0.25; unstable from 0.4 in three dimensions
///
/// Near phi_m, D_eta makes D a hundred times what D_c does, and `migration semiImplicit` solves for J_eta at the end of the step,
///
///   (1 - dt K) dphi = dt dphi/dt,    K of ViscosityFlux.hpp        dt <= f h^2/max_i (gammaDot phi D_c a^2)
///
/// by conjugate gradients in the product sum_i m_i a_i b_i, B held; what is added to phi in the end is of fluxes between pairs, so that powder is
/// kept whatever their tolerance. The solve is of first order in time: dt is also such that no phi moves farther than a hundredth of the way to phi_m
/// (max_i |dphi_i/dt| dt/(phi_m - phi_i) <= 0.01, phi_m - phi_c where that is more), unless an explicit step would be longer.
///
/// h = H/2 [m], D [m^2/s]. The time that the flow takes by itself is often a thousand times shorter, and one solve for the velocities
/// serves four explicit steps (`migrationSteps`) within 0.1 % of phi, and one of those that solve.
#pragma once
#include "scene/Particles.hpp"

namespace sph
{

/// The groups of the plan: the gradient's correction, once in a step of the flow, and all rates.
inline constexpr const char *ofCorrection = "correct the gradient", *ofMigration = "rates of migration",
                            *ofMigrationSolve = "response of migration";

struct MigrationSteps
{
    double factor = 0.25; ///< f
    int most = 4;         ///< to a step of the flow
    bool solves = false;  ///< for J_eta at the end of a step
};

template<int dim> class Migration final : public RunningModel<dim>
{
public:
    Migration(Particles<dim>&, const Numbers& restored, const MigrationSteps&, bool corrects);

    std::vector<Stage<dim>> stages(JoinPoint) override;
    std::vector<StepLimit> limits() const override;
    Numbers columns(const Particles<dim>&) const override;
    std::string report(const Particles<dim>&) const override;
    /// Warning of a cusp that is not resolved: powder gathers where the shear stress vanishes, and between that place and the next particle phi rises by the more
    /// the coarser they are. In the middle of a channel, s = |y|/h from it (Kauzlaric et al. 2011, eq. 4.1, for other ratios of the fluxes):
    ///
    ///   s = (phi_0/phi) ((phi_m - phi)/(phi_m - phi_0))^n,    n = c (D_eta/D_c - 1)
    ///
    /// The fluxes between two particles are means of both, which err by the square of the rise phi_i/phi_j - 1. Channels in which it is below 0.3
    /// have phi right within 2.3 %, most within 1 %; beyond up to 31 % are off: README.md. It falls with the spacing to the power
    /// of about 2/(1 + n), by itself for n <= 1.
    std::string warning(const Particles<dim>&) override;
    void save(Numbers&) const override;
    std::size_t bytes() const override { return (change_.capacity() + residual_.capacity()) * sizeof(double); }

private:
    MigrationSteps steps_;
    bool corrects_;
    double limit_;  ///< of one step, at the last evaluation of a migration [s]
    int taken_ = 0; ///< in the last step of the flow
    bool warned_ = false;
    double leastViscosity_ = 0, largestViscosity_ = 0;
    std::optional<double> startVolume_; ///< of powder at the first start [m^3]
    Array change_, residual_;           ///< of the owned particles, where J_eta is solved for

    /// Viscosity, shear rate and dphi/dt at the present phi and velocities, for positions and pairs as of the last evaluation of the flow.
    /// Returns the limit of one step [s].
    double complete(Particles<dim>&);
    double evaluateRates(Particles<dim>&);
    void look(Particles<dim>&);
    void advance(Particles<dim>&, double deltaT);
    /// dphi/dt of a step in which J_eta is that of its end. Throws DivergedError where nothing is finite, or no solution is found.
    void solve(Particles<dim>&, double deltaT);
    double volume(const Particles<dim>&) const;
};

}
