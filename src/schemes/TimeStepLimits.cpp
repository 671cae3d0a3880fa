#include "TimeStepLimits.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

StepLimit stepLimit(const Settings& settings, double maxSpeed, double maxAcceleration, const std::optional<SuspensionLimits>& suspension)
{
    const auto& c = settings.coefficients;
    const auto& s = settings.factors;
    const double h = 0.5*c.support;
    const std::size_t n = c.phases.size();
    StepLimit limit{std::numeric_limits<double>::infinity(), "none"};
    const auto consider = [&](double deltaT, const char* by)
    {
        if (deltaT < limit.deltaT) limit = {deltaT, by};
    };

    if (suspension) consider(settings.migrationSteps*suspension->migrationStep, "migration");
    if (settings.integrator == Integrator::quasiSteady) return limit;

    const double sound = *std::max_element(c.soundSpeed.begin(), c.soundSpeed.end());
    const bool implicit = settings.integrator == Integrator::semiImplicit;
    const double soundStep = s.sound*h/(sound + maxSpeed);
    double leastViscosity = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) leastViscosity = std::min(leastViscosity, c.viscosity[k]/c.restDensity[k]);
    if (suspension) leastViscosity = suspension->leastViscosity/c.restDensity[0];
    const double damped = std::min(s.dampedSound*leastViscosity/sqr(sound), 0.5*s.sound*h/maxSpeed);
    if (implicit && settings.implicitSolve.theta == 1 && damped > soundStep) consider(damped, "damped sound");
    else consider(soundStep, "sound");
    if (settings.stiffnessLimit)
    {
        double stiffest = 0;
        for (std::size_t k = 0; k < n; ++k) stiffest = std::max(stiffest, c.restDensity[k]*sqr(c.soundSpeed[k]));
        consider(s.stiffness*h/std::sqrt(stiffest/(*std::min_element(c.restDensity.begin(), c.restDensity.end()))), "stiffness");
    }
    double nu = 0, capillary = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t l = 0; l < n; ++l)
        {
            const double sum = c.viscosity[k] + c.viscosity[l];
            if (sum > 0) nu = std::max(nu, 2*c.viscosity[k]*c.viscosity[l]/sum/std::min(c.restDensity[k], c.restDensity[l]));
            if (const double gamma = c.surfaceTension[k*n + l]; gamma > 0)
                capillary = std::min(capillary, std::sqrt((c.restDensity[k] + c.restDensity[l])*h*h*h/(4*std::numbers::pi*gamma)));
        }
    if (suspension) nu = suspension->largestViscosity/c.restDensity[0];
    if (nu > 0 && !implicit) consider(s.viscous*h*h/nu, "viscosity");
    consider(s.capillary*capillary, "capillary");
    if (maxAcceleration > 0) consider(s.force*std::sqrt(h/maxAcceleration), "force");
    return limit;
}

}
