/// A step of the pore pressure (PoreWater.hpp): the grains go on explicitly, the water within them implicitly, as in a projection.
///
///   v*       = v^n + dt a(sigma, p^n)                                            the kick of the integrator
///   (n/K_w/dt - kappa lap - dt/rho lap') dp = -div v* + kappa lap p^n            conjugate gradients
///   p^(n+1)  = p^n + dp,    v^(n+1) = v* + dt a(dp)
///
/// lap' is what dp does to the divergence by way of the grains, whose free surfaces give way whether they drain or not: with alpha of Seepage.hpp always, lap where they drain. With one Laplacian without alpha
/// for both an undrained column beneath a closed surface was thrown apart. a(dp) is the acceleration by -dp I in the form that the stress has, div v* the trace of the corrected velocity gradient, which strains the soil too. Stable for every kappa, K_w and storage: the step is limited by
/// sound in drained soil alone, whose stiffness is that of the law, neither by the water's stiffness K_w/n nor by diffusion. With kappa = 0 the soil is undrained.
/// Of first order in time. Beside the consolidation of Terzaghi there is inertia: its rates differ by (pi/2)^2 (c_v/(c H))^2, c = sqrt(M/rho), c_v = kappa M; H/c is to be short beside H^2/c_v.
///
/// Conditioning: the iterations grow as the square root of 1 + (kappa + dt/rho) dt K_w/(n dx^2), up to that of the number of particles across.
#pragma once
#include "models/soil/PoreWater.hpp"
#include "scene/Particles.hpp"
#include <cmath>

namespace sph
{

/// Groups of the plan: sums at p, at the change that is tried, and the acceleration by the change.
inline constexpr const char *ofSeepage = "seepage", *ofSeepageChange = "seepage of the change", *ofPoreForce = "force of the change";

template<int dim> class PoreWaterStep final : public RunningModel<dim>
{
public:
    PoreWaterStep(Particles<dim>&, const Numbers&);

    std::vector<Stage<dim>> stages(JoinPoint) override;
    Numbers columns(const Particles<dim>&) const override;
    std::string report(const Particles<dim>&) const override;
    std::string note() const override;
    /// That of the pore pressure upon the grains, where it drives them: what it takes is stored in the water, or has seeped away.
    double power() const override { return std::fmax(0.0, power_); }
    double measuredPower() const override { return power_; }
    std::size_t bytes() const override { return (change_.capacity() + residual_.capacity()) * sizeof(double); }

private:
    const PoreWater& water_;
    Array change_, residual_; ///< dp, and what is left of the equation
    int iterations_ = 0;
    double power_ = 0;

    void advance(Particles<dim>&, double deltaT);
    /// dp, from the residual.
    void solve(Particles<dim>&, double deltaT);
};

}
