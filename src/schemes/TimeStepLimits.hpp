/// How large a step may be.
///
///   sound      s h/(c + |v|)                              s = 0.4
///   damped sound  s nu/c^2, at most 0.2 h/|v|             s = 0.25, where it is longer: an Euler step of implicit viscosity damps the waves
///                                                         that it does not resolve; stable to 2, within 1 % to 0.5; nu the least
///   stiffness  s h/c_eff,  c_eff = sqrt(max(rho c^2)/min(rho))   s = 1.2, for the Hu-Adams pressure between phases: it pushes the
///                                                         light particle with the heavy side's stiffness
///   viscosity  s h^2/nu                                   s = 0.125, unless it is implicit; nu the largest pair viscosity over the smaller density
///   capillary  s sqrt((rho_k + rho_l) h^3/(4 pi gamma))   s = 0.5
///   force      s sqrt(h/|dv/dt|)                          s = 0.25
///   migration  so many steps of the powder's own (Migration.hpp) as the settings allow to one of the flow
///
/// h = H/2 [m]. All that do not apply are left out. Where a step has parts (`maxSubSteps`) the limits of what acts in each are as many
/// times as long: all but the capillary one, half as long then, and that of the forces that act once.
#pragma once
#include "Settings.hpp"
#include "Simulation.hpp"

namespace sph
{

/// What a suspension adds: its viscosities are those of the moment.
struct SuspensionLimits
{
    double leastViscosity, largestViscosity;   ///< [Pa s]
    double migrationStep;                      ///< [s]
};

std::vector<StepLimit> stepLimits(const Settings&, double maxSpeed, double maxAcceleration, double maxSlowAcceleration = 0,
                                  const std::optional<SuspensionLimits>& = {});
/// The least odd number of parts that brings each within its limit.
int partsOf(double deltaT, const Settings&, const std::vector<StepLimit>&);
/// The least; infinity by "none" where there is none.
StepLimit stepLimit(const Settings&, double maxSpeed, double maxAcceleration, double maxSlowAcceleration = 0,
                    const std::optional<SuspensionLimits>& = {});

}
