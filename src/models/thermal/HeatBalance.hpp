/// Account of heat, the limit of the step by conduction, and the rules behind walls.
///
///   dt <= f h^2/a,    h = H/2,  a = max kappa_kl/(rho_k Cp_k) of all pairs of phases [m^2/s],  f = `diffusiveFactor` as of scalars (ScalarBalance.hpp)
///
/// Power of buoyancy upon the fluid [W], with the velocities of the end of a step: what feeds natural convection.
///
///   P = -sum m beta (T - T0) g.v
///
/// Heat-balance error: sum m Cp T now, minus that at the start, minus what all walls have given, relative to sum m Cp |T|. Where an inlet or outlet carries
/// heat the error has no meaning, and is left out. In two dimensions [J] and [W] are of a metre of depth.
#pragma once
#include "models/thermal/ThermalProperties.hpp"
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class HeatBalance final : public RunningModel<dim>
{
public:
    /// `even`: ghosts behind adiabatic walls exchange pairwise; `wallPressure`: rule of the pressure where fluid is buoyant, else empty.
    HeatBalance(Particles<dim>&, const Numbers& restored, bool even, const std::string& wallPressure);

    std::vector<StepLimit> limits() const override { return limits_; }
    /// Columns: min(T), max(T) [K], heat [J], heatBalanceError, of each heated wall the heat into the fluid,
    /// heat(wall) [J] and power(wall) [W], and what the flow carries, convectionX = sum m Cp (T - T0) v_x, Y, Z [W m].
    Numbers columns(const Particles<dim>&) const override;
    std::string report(const Particles<dim>&) const override;
    void save(Numbers&) const override;
    std::vector<Stage<dim>> stages(JoinPoint) override;
    double power() const override { return power_; }

private:
    const ThermalProperties& thermal_;
    std::vector<StepLimit> limits_;
    std::optional<double> start_; ///< heat at the first start [J]
    double power_ = 0;            ///< of buoyancy in the last step [W]

    /// A value of each phase as a function of the particle.
    auto ofPhase(const Particles<dim>&, const std::vector<double>& values) const;
    /// sum m_i Cp_i (T_i - T0) v_ic
    double convection(const Particles<dim>&, int c) const;
    /// sum m_i Cp_i f(T_i)
    double heat(const Particles<dim>&, double (*f)(double)) const;
    /// sum m_i q_i of a field per mass.
    double total(const Particles<dim>&, const std::string& field) const;
};

}
