/// A step of the pore pressure (PoreWater.hpp): the grains go on explicitly, the water within them implicitly, as in a projection.
///
///   v*       = v^n + dt a(sigma, p^n)                                            the kick of the integrator
///   (n/K_w/dt - kappa lap - dt/rho lap') dp = -div v* + kappa lap p^n            conjugate gradients
///   p^(n+1)  = p^n + dp,    v^(n+1) = v* + dt a(dp)
///
/// lap' is what dp does to the divergence by way of the grains, whose free surfaces give way whether they drain or not: with alpha of Seepage.hpp always, lap where they drain. With one Laplacian without alpha
/// for both an undrained column beneath a closed surface was thrown apart. With `projection exact` it is div a itself, of the forces that act, a pass more in each iteration: A is symmetric with `stressDivergence balanced`,
/// whose divergence and gradient are adjoint, and what the water resists is each particle's own change of volume, up to the surface. a(dp) is the acceleration by -dp I in the form that the stress has, div v* the trace of the corrected velocity gradient, which strains the soil too. Stable for every kappa, K_w and storage: the step is limited by
/// sound in drained soil alone, whose stiffness is that of the law, neither by the water's stiffness K_w/n nor by diffusion. With kappa = 0 the soil is undrained.
/// Of first order in time. Beside the consolidation of Terzaghi there is inertia: its rates differ by (pi/2)^2 (c_v/(c H))^2, c = sqrt(M/rho), c_v = kappa M; H/c is to be short beside H^2/c_v.
///
/// Unsaturated soil has C(p) in place of n/K_w, k_r within the first Laplacian and chi within the second and before div v, all at p^n. Water that stands on the soil or behind walls has the level of the step's middle.
///
/// Conditioning: the iterations grow as the square root of 1 + (kappa + dt/rho) dt K_w/(n dx^2), up to that of the number of particles across.
#pragma once
#include "models/soil/PoreWater.hpp"
#include "scene/Particles.hpp"
#include <cmath>

namespace sph
{

/// Groups of the plan: sums at p, at the change that is tried, and the acceleration by the change.
inline constexpr const char *ofSeepage = "seepage", *ofSeepageChange = "seepage of the change", *ofPoreForce = "force of the change",
                            *ofDivergence = "divergence of the change";

template<int dim> class PoreWaterStep final : public RunningModel<dim>
{
public:
    PoreWaterStep(Particles<dim>&, const Numbers&);

    std::vector<Stage<dim>> stages(JoinPoint) override;
    Numbers columns(const Particles<dim>&) const override;
    std::string report(const Particles<dim>&) const override;
    std::string note() const override;
    void save(Numbers&) const override;
    /// That of the pore pressure and of the water that stands on the soil upon the grains, where it drives them: what it takes is stored in the water, or has seeped away.
    double power() const override { return std::fmax(0.0, power_); }
    double measuredPower() const override { return power_; }
    std::size_t bytes() const override { return (change_.capacity() + residual_.capacity() + direction_.capacity()) * sizeof(double); }

private:
    static constexpr const char* levelTime = "waterLevelTime";
    /// C dx^2/(kappa dt) of pores that drain, below which k_r, of the step before, and p answer each other from step to step: a dam did so at 0.13, and not at 0.4.
    static constexpr double leastYield = 0.3;
    PoreWater& water_;
    const Vector<3>& g_;
    Array change_, residual_, direction_; ///< dp, what is left of the equation, and the change that is tried where no sum reads it
    std::vector<std::string> groups_;     ///< that a step runs
    int iterations_ = 0;
    double power_ = 0, outflow_ = 0; ///< [W]; through free surfaces [m^3/s]
    double levelTime_ = 0;           ///< of the levels [s]
    bool levelsVary_ = false;

    void setLevels(double t);
    void checkYield(double deltaT) const;
    void advance(Particles<dim>&, double deltaT);
    /// Evaluates the acceleration by a change [Pa] of the pressure that acts on grains.
    void accelerate(Particles<dim>&, const auto& change);
    /// The divergence of the velocities that a change [Pa] gives the grains.
    void project(Particles<dim>&, double deltaT, const double* change);
    /// dp, from the residual.
    void solve(Particles<dim>&, double deltaT);
};

}
