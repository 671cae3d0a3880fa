#include "TimeStepLimits.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

std::vector<StepLimit> stepLimits(const Settings& settings, double maxSpeed, double maxAcceleration, double maxSlowAcceleration,
                                  const std::optional<SuspensionLimits>& suspension)
{
    const auto& c = settings.coefficients;
    const auto& s = settings.factors;
    const double h = 0.5*c.support;
    const std::size_t n = c.phases.size();
    std::vector<StepLimit> limits;
    const auto ofStep = [&](double deltaT, const char* by)
    {
        if (deltaT < std::numeric_limits<double>::infinity()) limits.push_back({deltaT, by});
    };
    const auto ofPart = [&](double deltaT, const char* by) { limits.push_back({settings.maxSubSteps*deltaT, by, true}); };

    if (suspension) ofStep(settings.migrationSteps*suspension->migrationStep, "migration");
    if (settings.integrator == Integrator::quasiSteady) return limits;

    const double sound = *std::max_element(c.soundSpeed.begin(), c.soundSpeed.end());
    const bool implicit = settings.integrator == Integrator::semiImplicit;
    const double soundStep = s.sound*h/(sound + maxSpeed);
    double leastViscosity = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) leastViscosity = std::min(leastViscosity, c.viscosity[k]/c.restDensity[k]);
    if (suspension) leastViscosity = suspension->leastViscosity/c.restDensity[0];
    const double damped = std::min(s.dampedSound*leastViscosity/sqr(sound), 0.5*s.sound*h/maxSpeed);
    if (implicit && settings.implicitSolve.theta == 1 && damped > soundStep) ofPart(damped, "damped sound");
    else ofPart(soundStep, "sound");
    if (settings.stiffnessLimit)
    {
        double stiffest = 0;
        for (std::size_t k = 0; k < n; ++k) stiffest = std::max(stiffest, c.restDensity[k]*sqr(c.soundSpeed[k]));
        ofPart(s.stiffness*h/std::sqrt(stiffest/(*std::min_element(c.restDensity.begin(), c.restDensity.end()))), "stiffness");
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
    if (nu > 0 && !implicit) ofPart(s.viscous*h*h/nu, "viscosity");
    ofStep(s.capillary*capillary, "capillary");
    if (maxAcceleration > 0) ofPart(s.force*std::sqrt(h/maxAcceleration), "force");
    if (maxSlowAcceleration > 0) ofStep(s.force*std::sqrt(h/maxSlowAcceleration), "slow force");
    return limits;
}

int partsOf(double deltaT, const Settings& settings, const std::vector<StepLimit>& limits)
{
    double parts = 1;
    for (const auto& limit : limits)
        if (limit.ofPart) parts = std::max(parts, deltaT/limit.deltaT*settings.maxSubSteps);
    const double roundOff = 1e-9; // a step of the limit itself takes no part more
    return std::min(settings.maxSubSteps, 2*int(std::ceil((std::min<double>(parts, settings.maxSubSteps) - 1)/2 - roundOff)) + 1);
}

StepLimit stepLimit(const Settings& settings, double maxSpeed, double maxAcceleration, double maxSlowAcceleration,
                    const std::optional<SuspensionLimits>& suspension)
{
    const auto limits = stepLimits(settings, maxSpeed, maxAcceleration, maxSlowAcceleration, suspension);
    const auto least = std::min_element(limits.begin(), limits.end(), [](const auto& a, const auto& b) { return a.deltaT < b.deltaT; });
    return least == limits.end() ? StepLimit{std::numeric_limits<double>::infinity(), "none"} : *least;
}

}
