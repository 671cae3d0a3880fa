#include "solver/Monitor.hpp"
#include "base/DivergedError.hpp"
#include "geometry/Walls.hpp"
#include "solver/EnergyBalance.hpp"
#include "solver/outliers.hpp"
#include <cmath>
#include <fmt/format.h>
#include <ostream>

namespace sph
{

namespace
{
/// Speed over sound speed beyond which a state is none of a weakly compressible fluid, even where nothing is compressed: a shear flow whose viscosity is unstable.
constexpr double mostMach = 20;

/// Energy held over the most that the scene can have supplied, beyond which the log warns, and beyond which a solution is rubbish.
constexpr double suspectEnergy = 1.01, mostEnergy = 5; // beyond an upper bound by more than it may be off
constexpr long energySteps = 100;
constexpr int tracedForEnergy = 200; // some periods of the sound of a few spacings

/// Shortest step over the run's span: shorter ones would not reach its end in a user's lifetime.
constexpr double shortestStep = 1e-12;

/// Speed over sound speed, and density over rest density, beyond which the log warns: the density varies by the square of the first.
constexpr double suspectMach = 0.3, suspectCompression = 1.1;
}

Monitor::Monitor(const Settings& settings, const Geometry& geometry, AnySimulation& simulation, const RunTime& time, std::ostream& log)
    : settings_(settings), geometry_(geometry), simulation_(simulation), time_(time), log_(log)
{}

void Monitor::warn(const std::string& what) { log_ << "--> Warning: " << what << '\n'; }

void Monitor::refuseCollapsed(const StepLimit& limit) const
{
    // Without an end, as with `stopAt nextWrite;`, RunTime itself refuses a step that no longer advances time.
    const double span = std::isfinite(time_.endTime()) ? time_.endTime() - time_.startTime() : 0;
    if (!time_.adjustTimeStep() || limit.deltaT >= shortestStep * span) return;
    const auto summary = simulation_.summary();
    throw DivergedError(fmt::format("the time step has collapsed to {:.3g} s at time {}, limited by {} (largest speed {:.3g} m/s, largest "
                                    "acceleration {:.3g} m/s^2). {}",
                                    limit.deltaT, time_.name(), limit.by, summary.maxSpeed, summary.maxAcceleration, binding()));
}

void Monitor::checkFixedStep(const StepLimit& limit, double deltaT)
{
    if (warnedOfStep_ || time_.adjustTimeStep() || deltaT <= limit.deltaT) return;
    warnedOfStep_ = true;
    warn(fmt::format(
        "at time {} deltaT {:.4g} s is {:.3g} times the longest stable step, {:.4g} s by {}. Give a smaller deltaT, or leave the "
        "step to the limits (`adjustTimeStep yes;`)",
        time_.name(), deltaT, deltaT / limit.deltaT, limit.deltaT, limit.by));
}

void Monitor::check(const StepLimit& limit)
{
    const auto summary = simulation_.summary();
    const auto& rest = settings_.coefficients.restDensity;
    const auto impossible = [&](std::size_t k, double rho)
    { return !(rho >= leastCompression * rest[k] && rho <= mostCompression * rest[k]); };
    bool suspect = !summary.finite;
    for (std::size_t k = 0; k < summary.mass.size(); ++k)
        suspect = suspect || (summary.count[k] > 0 && (impossible(k, summary.minDensity[k]) || impossible(k, summary.maxDensity[k])));
    if (suspect) checkParticles(limit);
    // Sums and extremes are those of the middle of a step, at whose end all may be well again.
    if (!summary.finite) notFinite("it", limit);
    for (std::size_t k = 0; suspect && k < summary.mass.size(); ++k)
        for (const double rho : {summary.minDensity[k], summary.maxDensity[k]})
            if (summary.count[k] > 0 && impossible(k, rho)) notWeaklyCompressible(k, rho, "");
    for (std::size_t k = 0; k < summary.mass.size(); ++k)
        if (const double c = settings_.coefficients.soundSpeed[k]; c > 0 && summary.maxSpeedOf[k] > mostMach * c)
            throw DivergedError(fmt::format(
                "{} has reached {:.4g} m/s at time {}, {:.3g} times its sound speed: no flow of a weakly compressible fluid. The "
                "step was limited by {}: try a smaller factor in `integration`, or a larger sound speed",
                settings_.coefficients.phases[k], summary.maxSpeedOf[k], time_.name(), summary.maxSpeedOf[k] / c, limit.by));
    warnOfCompression();
}

void Monitor::checkParticles(const StepLimit& limit) const
{
    if (const auto found = sph::notFinite(simulation_)) notFinite(fmt::format("{} of {}", found->field, found->inWords()), limit);
    if (const auto found = impossibleDensity(simulation_, settings_.coefficients.restDensity))
        notWeaklyCompressible(found->phase, found->value, " in " + found->inWords());
}

void Monitor::notFinite(const std::string& what, const StepLimit& limit) const
{
    throw DivergedError(fmt::format("{} is no longer finite at time {} after step {}; the last time folder written is whole. "
                                    "The step was limited by {}: try a smaller factor in `integration`, or a larger sound speed",
                                    what, time_.name(), time_.index(), limit.by));
}

void Monitor::notWeaklyCompressible(std::size_t k, double rho, const std::string& where) const
{
    const auto& c = settings_.coefficients;
    throw DivergedError(fmt::format(
        "the density of {} has reached {:.4g} kg/m^3{} at time {}, {:.3g} times that at rest (largest speed {:.3g} m/s{}", c.phases[k], rho,
        where, time_.name(), rho / c.restDensity[k], simulation_.summary().maxSpeedOfScene(),
        c.soundSpeed[k] > 0
            ? fmt::format(", sound speed {:.3g} m/s): the fluid is to be weakly compressible. Choose a larger sound speed, or a "
                          "smaller step",
                          c.soundSpeed[k])
            : "): choose a smaller step, or more artificial viscosity"));
}

void Monitor::warnOfCompression()
{
    const auto& summary = simulation_.summary();
    const auto& c = settings_.coefficients;
    warned_.resize(c.phases.size());
    for (std::size_t k = 0; k < warned_.size(); ++k)
    {
        if (warned_[k] || summary.count[k] == 0 || !(c.soundSpeed[k] > 0)) continue; // soil may loosen and flow
        const double mach = summary.maxSpeedOf[k] / c.soundSpeed[k], compression = summary.maxDensity[k] / c.restDensity[k];
        std::string what;
        if (mach > suspectMach)
            what =
                fmt::format("moves at {:.3g} m/s, {:.2g} of its sound speed of {:.3g} m/s", summary.maxSpeedOf[k], mach, c.soundSpeed[k]);
        else if (compression > suspectCompression)
            what = fmt::format("has a density of {:.4g} kg/m^3, {:.3g} times that at rest, with a sound speed of {:.3g} m/s",
                               summary.maxDensity[k], compression, c.soundSpeed[k]);
        else continue;
        warned_[k] = true;
        const bool tears = mach <= suspectMach && settings_.facts.get<GasLeftOut>().isLeftOut;
        warn(fmt::format(
            "at time {} {} {}: weak compressibility is lost. {}", time_.name(), c.phases[k], what,
            tears
                ? "Without its gas a liquid that strikes a wall or tears is so in a few particles; a larger sound speed makes its pressure noisier, and helps "
                  "where the flow itself presses"
                : "A sound speed of ten times the largest of flow speed, sqrt(pressure/density) and sqrt(gravity depth) keeps the density within 1 %"));
    }
}

void Monitor::checkEnergy()
{
    if (!settings_.integration.moves) return;
    energy_ = simulation_.energy();
    const double share = energy_.held() / energy_.supplied;
    const auto what = [&]
    {
        std::string parts = fmt::format("{:.3g} J of motion", energy_.kinetic);
        for (const auto& stored : energy_.stored)
            if (stored.isHeld) parts += fmt::format(" and {:.3g} J of {}", stored.value, stored.of);
        return fmt::format("the fluid holds {:.3g} J at time {}, {}, {:.3g} times all that the scene can have supplied", energy_.held(),
                           time_.name(), parts, share);
    };
    const auto advice =
        fmt::format("The scheme creates energy: try {}, more viscosity, or a finer resolution", settings_.facts.get<EnergyAdvice>().text);
    if (share > mostEnergy) throw DivergedError(fmt::format("{}{}. {}", what(), tracedSteps_ > 0 ? "; " + sourceOfEnergy() : "", advice));
    if (share <= suspectEnergy || warnedOfEnergy_) return;
    warnedOfEnergy_ = true;
    warn(fmt::format("{}. {}", what(), advice));
}

void Monitor::checkEnergySometimes()
{
    if (time_.index() % energySteps == 0) checkEnergy();
}

void Monitor::traceEnergy(double deltaT)
{
    if (!warnedOfEnergy_ || tracedSteps_ == tracedForEnergy) return;
    if (tracedSteps_++ == 0) tracedFrom_ = time_.name();
    for (const auto& [operation, power] : simulation_.powers()) work_[operation] += power * deltaT;
    if (tracedSteps_ == tracedForEnergy || !time_.running()) warn(sourceOfEnergy());
}

std::string Monitor::sourceOfEnergy() const
{
    return fmt::format("{} in {} steps since time {}", sourceInWords(work_), tracedSteps_, tracedFrom_);
}

std::string Monitor::energyInWords() const
{
    return energy_.supplied > 0 ? fmt::format("  energy/supply {:.3g}", energy_.held() / energy_.supplied) : "";
}

std::string Monitor::binding() const
{
    const auto limit = simulation_.stepLimit();
    const auto particle = sph::binding(simulation_, limit);
    if (!particle) return "";
    return fmt::format("Step bound by {}: {} has {} {:.4g} {}\n", limit.by, particle->inWords(), particle->field, particle->value,
                       limit.field->unit);
}

void Monitor::noteLeaks()
{
    if (const auto leaks = simulation_.leaks(); leaks.deepest > deepestLeak_ || (deepestLeakAt_.empty() && leaks.count() > 0))
    {
        deepestLeak_ = leaks.deepest;
        deepestLeakAt_ = time_.name();
    }
}

std::string Monitor::leaked(bool always) const
{
    const auto leaks = simulation_.leaks();
    if (!always && leaks.count() == 0) return "";
    return settings_.facts.get<LeakedParticles>().action == LeakAction::remove
               ? fmt::format("Leaked: {} particles removed, {:.10g} kg\n", leaks.removed, leaks.removedMass)
               : fmt::format("Leaked: {} particles put back\n", leaks.putBack);
}

std::string Monitor::deepestLeak() const
{
    const auto leaks = simulation_.leaks();
    if (leaks.count() == 0) return "";
    return fmt::format("Deepest: {}, near ({:.6g} {:.6g} {:.6g}) at time {}\n",
                       leaks.patch < 0 ? "outside the domain"
                                       : fmt::format("{:.3g} m in {}", leaks.deepest, wallInWords(geometry_, leaks.patch, leaks.at)),
                       leaks.at.x, leaks.at.y, leaks.at.z, deepestLeakAt_);
}

}
