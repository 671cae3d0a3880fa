#include "run/report.hpp"
#include "sampling/FunctionLibraries.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <ostream>

namespace sph
{

void reportPlan(std::ostream& log, const Settings& settings, AnySimulation& simulation)
{
    const auto& c = settings.coefficients;
    log << fmt::format("Particles : {} ({} images), spacing {:.4g} m, kernel {} with support {:.3g} spacings, {:.1f} neighbours\n",
                       simulation.total(), simulation.images(), c.spacing, settings.resolution.kernel, settings.resolution.support,
                       simulation.meanNeighbours());
    for (std::size_t k = 0; k < c.phases.size(); ++k)
        log << fmt::format("Phase     : {}, {} particles, rho {:.6g} kg/m^3, mu {:.4g} Pa s{}\n", c.phases[k],
                           simulation.summary().allOf(k), c.restDensity[k], c.viscosity[k],
                           c.soundSpeed[k] > 0 ? fmt::format(", sound speed {:.4g} m/s", c.soundSpeed[k]) : ", stress by a law");
    for (const auto& library : loadedLibraries()) log << "Library   : " << library << '\n';
    log << simulation.introduction();
    for (const auto& reason : settings.reasons) log << "Chosen    : " << reason << '\n';
    const auto limit = simulation.stepLimit();
    std::string limits;
    for (const auto& each : simulation.stepLimits())
        limits += fmt::format("{}{} {:.4g} s", limits.empty() ? "" : ", ", each.by, each.deltaT);
    log << fmt::format("Step      : at most {:.4g} s by {} ({})\nPlan of a step:\n", limit.deltaT, limit.by, limits);
    simulation.printPlan(log);
    log << fmt::format("    allocated   {:.1f} bytes a particle, images included, neighbour lists aside\n\n",
                       simulation.bytesPerParticle());
}

void reportStep(std::ostream& log, const Settings& settings, const AnySimulation& simulation, const RunTime& time, const Monitor& monitor,
                const Clock& clock, const StepLimit& limit, double deltaT)
{
    const auto s = simulation.summary();
    std::string phases, held;
    const auto describe = [&](const auto& of, std::size_t k)
    { return fmt::format(": rho {:.6g} .. {:.6g}, mass {:.10g} kg", of.minDensity[k], of.maxDensity[k], of.mass[k]); };
    for (std::size_t k = 0; k < s.mass.size(); ++k)
    {
        const auto& phase = settings.coefficients.phases[k];
        phases += (k ? "; " : "") + phase + (s.count[k] == 0 ? ": no particles" : describe(s, k));
        if (s.held.count[k] > 0) held += (held.empty() ? "held beyond openings: " : "; ") + phase + describe(s.held, k);
    }
    if (!held.empty()) phases += '\n' + held;
    const double done = time.value() - time.startTime(), span = time.endTime() - time.startTime(), sinceStart = clock.clockTime();
    const std::string expected =
        done > 0 && span < 1e30 ? fmt::format("  expected finish in {:.0f} s", sinceStart * std::max(0.0, span / done - 1)) : "";
    log << fmt::format(
        "Time = {}\nstep {}  deltaT {:.4g} ({})  max|U| {:.4g}  kinetic energy {:.6g}{}  neighbours {:.1f}  lists built {}{}\n{}\n{}{}{}"
        "ExecutionTime = {:.2f} s  ClockTime = {:.0f} s{}\n\n",
        time.name(), time.index(), deltaT, limit.by, s.maxSpeedOfScene(), s.kineticEnergy, monitor.energyInWords(),
        simulation.meanNeighbours(), simulation.rebuilds(), simulation.note(), phases, simulation.report(), monitor.binding(),
        monitor.leaked(false), Clock::executionTime(), sinceStart, expected);
    log.flush();
}

}
