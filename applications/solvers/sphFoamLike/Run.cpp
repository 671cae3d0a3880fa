#include "Run.hpp"
#include "base/DivergedError.hpp"
#include "base/stopSignals.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "decomposition/placeOfRank.hpp"
#include "geometry/Walls.hpp"
#include "geometry/makeWallLayers.hpp"
#include "parallel/reduce.hpp"
#include "sampling/FunctionLibraries.hpp"
#include "sampling/viewOfScene.hpp"
#include "solver/EnergyBalance.hpp"
#include "solver/WholeCloud.hpp"
#include "solver/outliers.hpp"
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <iostream>
#include <omp.h>
#include <optional>

namespace sph
{

namespace
{
volatile std::sig_atomic_t stopRequested = 0; ///< the signal that asked for it
void requestStop(int signal) { stopRequested = signal; }

/// Speed over sound speed beyond which it is, even where nothing is compressed: a shear flow whose viscosity is unstable.
constexpr double mostMach = 20;

/// Energy held over the most that the scene can have supplied, beyond which the log warns, and beyond which a solution is rubbish; looked
/// at every so many steps, for it takes a loop over pairs.
constexpr double suspectEnergy = 1.01, mostEnergy = 5; // beyond an upper bound by more than it may be off
constexpr long energySteps = 100;
constexpr int tracedForEnergy = 200; // some periods of the sound of a few spacings

/// A dry run takes steps for so long [s], and goes on from the last third of them: steps change as a scene sets itself in motion.
constexpr double burstTime = 3;

/// Shortest step over the run's span: shorter ones would not reach its end in a user's lifetime.
constexpr double shortestStep = 1e-12;

/// Particles of a thread or a rank below which it costs more than it brings.
constexpr std::size_t fewForOne = 2000;

/// Speed over sound speed, and density over rest density, beyond which the log warns: the density varies by the square of the first.
constexpr double suspectMach = 0.3, suspectCompression = 1.1;

std::string durationInWords(double seconds)
{
    if (seconds < 120) return fmt::format("{:.3g} s", seconds);
    if (seconds < 7200) return fmt::format("{:.3g} minutes", seconds / 60);
    return fmt::format("{:.3g} hours", seconds / 3600);
}

/// What the first rank has, on all.
double ofFirst(double mine) { return ofAllRanks(isFirstRank() ? mine : 0.0, 0.0, Add{}); }
}

Geometry Run::loadGeometry(const Case& theCase)
{
    const auto schemes = theCase.dictionary("system/sphSchemes");
    const auto resolution = readResolution(schemes);
    if (!theCase.has("constant/walls"))
    {
        theCase.diagnostics().error({"constant/walls", 0}, "is missing: run meshToGhost, which makes it from constant/geometry");
        return {};
    }
    const auto dict = theCase.dictionary("constant/walls");
    if (theCase.has("constant/geometry") && wallsStamp(dict) != geometryStamp(theCase.folder(), resolution.spacing, resolution.support))
        theCase.diagnostics().error({"constant/walls", 0},
                                    "does not belong to the present constant/geometry and resolution: run meshToGhost again");
    auto geometry = readWalls(dict, resolution, theCase.folder());
    if (wallsAreLayers(schemes)) geometry.layers = readWallLayers(theCase.folder(), geometry.walls.size(), theCase.diagnostics());
    return geometry;
}

Run::Run(const std::filesystem::path& caseFolder, std::ostream& log, bool parallel)
    : case_(caseFolder),
      place_(parallel ? placeOfRank(case_, ranks()) : RunTime::Place{}),
      log_(log),
      time_((waitForFirst(), case_), place_),
      geometry_(loadGeometry(case_)),
      settings_(readSettings(case_, geometry_))
{
    const auto& control = time_.controlDict();
    loadLibraries(control);
    functions_ = std::make_unique<FunctionObjects>(control.subDictOrEmpty("functions"), geometry_, settings_.coefficients.phases, time_);
    control.get<std::string>("application", "sphFoamLike");
    control.reportUnused();
    firstIsThrough();
    Cloud cloud = readCloud();
    if (ranks())
    {
        if (isDecomposed()) time_.useBarrier([all = ranks()] { all->barrier(); });
        time_.useClocks({[this] { return ofFirst(clock_.clockTime()); }, [] { return ofFirst(Clock::executionTime()); }});
    }
    log_ << banner("sphFoamLike", caseFolder,
                   fmt::format("nProcs : {}\nThreads: {}\n", ranks() ? ranks()->count() : 1, omp_get_max_threads()));
    for (const auto& w : case_.diagnostics().warnings()) log_ << "--> Warning: " << w << '\n';
    // Below a few thousand particles each, threads cost more than they bring; results do not depend on their number.
    omp_set_num_threads(std::clamp(int(cloud.size() / fewForOne), 1, omp_get_max_threads()));
    simulation_ = makeSimulation(settings_, geometry_, std::move(cloud), time_.restored());
    for (std::size_t k = 0; k < settings_.coefficients.phases.size(); ++k)
        if (simulation_->summary().allOf(k) == 0)
            log_ << fmt::format("--> Warning: phase \"{}\" has no particles\n", settings_.coefficients.phases[k]);
    if (ranks()) warnOfFewParticles();
}

Cloud Run::readCloud() const
{
    const std::size_t all = ranks() ? std::size_t(ranks()->count()) : 1;
    const Slice slice = ranks() && !isDecomposed() ? Slice{std::size_t(ranks()->rank()), all} : Slice{};
    Cloud cloud;
    Diagnostics ofRank;
    auto& diagnostics = ranks() ? ofRank : case_.diagnostics();
    try
    {
        allOrNone(
            [&]
            {
                cloud = sph::readCloud(case_.folder(), time_.startFolder(), "sph", diagnostics, settings_.writtenClasses(), slice);
                ofRank.throwIfAny();
            });
    }
    catch (const CaseError& e)
    {
        case_.diagnostics().error({}, e.what());
    }
    case_.diagnostics().throwIfAny();
    // Where openings bring particles there may be none for some ranks yet.
    const auto n = ofAllRanks(cloud.size(), std::size_t(0), Add{});
    if (!isDecomposed() && !settings_.facts.get<OpenBoundary>().exists && n > 0 && n < all)
        throw CaseError(fmt::format("{} ranks for {} particles: take fewer", all, n));
    return cloud;
}

void Run::warnOfFewParticles() const
{
    const std::size_t total = simulation_->total(), all = std::size_t(ranks()->count());
    if (total < fewForOne * all)
        log_ << fmt::format(
            "--> Warning: {} ranks have {} particles each: below {} messages cost more than a rank brings, and {} would be as fast\n", all,
            total / all, fewForOne, std::max<std::size_t>(1, total / fewForOne));
}

void Run::reportPlan() const
{
    const auto& c = settings_.coefficients;
    log_ << fmt::format("Particles : {} ({} images), spacing {:.4g} m, kernel {} with support {:.3g} spacings, {:.1f} neighbours\n",
                        simulation_->total(), simulation_->images(), c.spacing, settings_.resolution.kernel, settings_.resolution.support,
                        simulation_->meanNeighbours());
    for (std::size_t k = 0; k < c.phases.size(); ++k)
        log_ << fmt::format("Phase     : {}, {} particles, rho {:.6g} kg/m^3, mu {:.4g} Pa s{}\n", c.phases[k],
                            simulation_->summary().allOf(k), c.restDensity[k], c.viscosity[k],
                            c.soundSpeed[k] > 0 ? fmt::format(", sound speed {:.4g} m/s", c.soundSpeed[k]) : ", stress by a law");
    for (const auto& library : loadedLibraries()) log_ << "Library   : " << library << '\n';
    log_ << simulation_->introduction();
    for (const auto& reason : settings_.reasons) log_ << "Chosen    : " << reason << '\n';
    const auto limit = simulation_->stepLimit();
    std::string limits;
    for (const auto& each : simulation_->stepLimits())
        limits += fmt::format("{}{} {:.4g} s", limits.empty() ? "" : ", ", each.by, each.deltaT);
    log_ << fmt::format("Step      : at most {:.4g} s by {} ({})\nPlan of a step:\n", limit.deltaT, limit.by, limits);
    simulation_->printPlan(log_);
    log_ << fmt::format("    allocated   {:.1f} bytes a particle, images included, neighbour lists aside\n\n",
                        simulation_->bytesPerParticle());
}

double Run::advance(const StepLimit& limit)
{
    const double deltaT = nextDeltaT(limit);
    simulation_->step(time_.value(), deltaT);
    time_.advance(deltaT);
    check(limit);
    warnOfCompression();
    return deltaT;
}

void Run::dryRun()
{
    reportPlan();
    if (!time_.running()) return;
    // The first step has what no other one has: memory is touched for the first time.
    advance(simulation_->stepLimit());
    const double clock = clock_.clockTime();
    struct Mark
    {
        double time, clock; ///< [s] of the run, of the burst
    };
    std::vector<Mark> marks{{time_.value(), 0}};
    while (time_.running() && (marks.size() == 1 || marks.back().clock < burstTime))
    {
        advance(simulation_->stepLimit());
        marks.push_back({time_.value(), ofFirst(clock_.clockTime()) - clock});
    }
    const auto steps = marks.size() - 1;
    if (steps == 0) return;
    const auto last = (steps + 2) / 3;
    const auto& [from, clockFrom] = marks[steps - last];
    const auto& [now, clockNow] = marks.back();
    const double each = (clockNow - clockFrom) / double(last), deltaT = (now - from) / double(last);
    log_ << fmt::format("Estimate  : {:.3g} s of clock a step, {:.3g} s of the run, by the last {} of {} steps in memory, until {} s", each,
                        deltaT, last, steps + 1, time_.name());
    if (time_.endTime() - time_.startTime() < 1e30)
    {
        const double left = time_.running() ? (time_.endTime() - now) / deltaT : 0;
        log_ << fmt::format(
            "; {:.3g} steps to endTime {:.6g} s: {}{}", double(steps + 1) + std::ceil(left - 1e-6), time_.endTime(),
            durationInWords(clockNow + each * (left + 1)),
            left > 0 ? ", if steps stay as long and cost as much as these: a scene that fills, breaks up or speeds up later may take "
                       "two or three times as long"
                     : "");
    }
    log_ << ". Nothing was written\n";
}

void Run::check(const StepLimit& limit) const
{
    const auto summary = simulation_->summary();
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
}

void Run::checkParticles(const StepLimit& limit) const
{
    if (const auto found = sph::notFinite(*simulation_)) notFinite(fmt::format("{} of {}", found->field, found->inWords()), limit);
    if (const auto found = impossibleDensity(*simulation_, settings_.coefficients.restDensity))
        notWeaklyCompressible(found->phase, found->value, " in " + found->inWords());
}

void Run::notFinite(const std::string& what, const StepLimit& limit) const
{
    throw DivergedError(fmt::format("{} is no longer finite at time {} after step {}; the last time folder written is whole. "
                                    "The step was limited by {}: try a smaller factor in `integration`, or a larger sound speed",
                                    what, time_.name(), time_.index(), limit.by));
}

void Run::notWeaklyCompressible(std::size_t k, double rho, const std::string& where) const
{
    const auto& c = settings_.coefficients;
    throw DivergedError(fmt::format(
        "the density of {} has reached {:.4g} kg/m^3{} at time {}, {:.3g} times that at rest (largest speed {:.3g} m/s{}", c.phases[k], rho,
        where, time_.name(), rho / c.restDensity[k], simulation_->summary().maxSpeedOfScene(),
        c.soundSpeed[k] > 0
            ? fmt::format(", sound speed {:.3g} m/s): the fluid is to be weakly compressible. Choose a larger sound speed, or a "
                          "smaller step",
                          c.soundSpeed[k])
            : "): choose a smaller step, or more artificial viscosity"));
}

double Run::nextDeltaT(const StepLimit& limit)
{
    // Without an end, as with `stopAt nextWrite;`, RunTime itself refuses a step that no longer advances time.
    const double span = std::isfinite(time_.endTime()) ? time_.endTime() - time_.startTime() : 0;
    if (time_.adjustTimeStep() && limit.deltaT < shortestStep * span)
        throw DivergedError(
            fmt::format("the time step has collapsed to {:.3g} s at time {}, limited by {} (largest speed {:.3g} m/s, largest "
                        "acceleration {:.3g} m/s^2). {}",
                        limit.deltaT, time_.name(), limit.by, simulation_->summary().maxSpeed, simulation_->summary().maxAcceleration,
                        binding()));
    const double deltaT = time_.nextDeltaT(limit.deltaT);
    if (!warnedOfStep_ && !time_.adjustTimeStep() && deltaT > limit.deltaT)
    {
        warnedOfStep_ = true;
        log_ << fmt::format(
            "--> Warning: at time {} deltaT {:.4g} s is {:.3g} times the longest stable step, {:.4g} s by {}. Give a smaller deltaT, or leave the "
            "step to the limits (`adjustTimeStep yes;`)\n",
            time_.name(), deltaT, deltaT / limit.deltaT, limit.deltaT, limit.by);
    }
    return deltaT;
}

void Run::warnOfCompression()
{
    const auto& summary = simulation_->summary();
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
        log_ << fmt::format(
            "--> Warning: at time {} {} {}: weak compressibility is lost. A sound speed of ten times the largest of flow speed, "
            "sqrt(pressure/density) and sqrt(gravity depth) keeps the density within 1 %\n",
            time_.name(), c.phases[k], what);
    }
}

/// Creeping flow has no inertia, so no energy of motion to keep an account of.
void Run::checkEnergy()
{
    if (!settings_.integration.moves) return;
    energy_ = simulation_->energy();
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
    log_ << fmt::format("--> Warning: {}. {}\n", what(), advice);
}

void Run::traceEnergy(double deltaT)
{
    if (!warnedOfEnergy_ || tracedSteps_ == tracedForEnergy) return;
    if (tracedSteps_++ == 0) tracedFrom_ = time_.name();
    for (const auto& [operation, power] : simulation_->powers()) work_[operation] += power * deltaT;
    if (tracedSteps_ == tracedForEnergy || !time_.running()) log_ << fmt::format("--> Warning: {}\n", sourceOfEnergy());
}

std::string Run::sourceOfEnergy() const
{
    return fmt::format("{} in {} steps since time {}", sourceInWords(work_), tracedSteps_, tracedFrom_);
}

std::string Run::binding() const
{
    const auto limit = simulation_->stepLimit();
    const auto particle = sph::binding(*simulation_, limit);
    if (!particle) return "";
    return fmt::format("Step bound by {}: {} has {} {:.4g} {}\n", limit.by, particle->inWords(), particle->field, particle->value,
                       limit.field->unit);
}

void Run::reportStep(const StepLimit& limit, double deltaT) const
{
    const auto s = simulation_->summary();
    std::string phases, held;
    const auto describe = [&](const auto& of, std::size_t k)
    { return fmt::format(": rho {:.6g} .. {:.6g}, mass {:.10g} kg", of.minDensity[k], of.maxDensity[k], of.mass[k]); };
    for (std::size_t k = 0; k < s.mass.size(); ++k)
    {
        const auto& phase = settings_.coefficients.phases[k];
        phases += (k ? "; " : "") + phase + (s.count[k] == 0 ? ": no particles" : describe(s, k));
        if (s.held.count[k] > 0) held += (held.empty() ? "held beyond openings: " : "; ") + phase + describe(s.held, k);
    }
    if (!held.empty()) phases += '\n' + held;
    const double done = time_.value() - time_.startTime(), span = time_.endTime() - time_.startTime(), clock = clock_.clockTime();
    const std::string expected =
        done > 0 && span < 1e30 ? fmt::format("  expected finish in {:.0f} s", clock * std::max(0.0, span / done - 1)) : "";
    const std::string energy = energy_.supplied > 0 ? fmt::format("  energy/supply {:.3g}", energy_.held() / energy_.supplied) : "";
    log_ << fmt::format(
        "Time = {}\nstep {}  deltaT {:.4g} ({})  max|U| {:.4g}  kinetic energy {:.6g}{}  neighbours {:.1f}  lists built {}{}\n{}\n{}{}{}"
        "ExecutionTime = {:.2f} s  ClockTime = {:.0f} s{}\n\n",
        time_.name(), time_.index(), deltaT, limit.by, s.maxSpeedOfScene(), s.kineticEnergy, energy, simulation_->meanNeighbours(),
        simulation_->rebuilds(), simulation_->note(), phases, simulation_->report(), binding(),
        simulation_->leaks().count() > 0 ? leaked() : "", Clock::executionTime(), clock, expected);
    log_.flush();
}

ParticleView Run::view(WholeCloud& cloud) const
{
    auto v = viewOfScene(settings_.coefficients, simulation_->gravity(), settings_.resolution.kernel, geometry_);
    v.n = cloud.size();
    const auto x = cloud.whole(simulation_->positions());
    v.x = x.component[0];
    v.y = x.component[1];
    v.z = x.component[2];
    for (const auto& field : simulation_->fields()) v.fields.push_back(cloud.whole(field));
    v.mass = cloud.whole(simulation_->field("m")).component[0];
    v.volume = cloud.whole(simulation_->field("V")).component[0];
    v.phase = cloud.whole(simulation_->field("phase")).component[0];
    v.heldBy = cloud.whole(simulation_->field(Holder::info.name)).component[0];
    v.numbers = simulation_->summary().columns;
    const auto energy = simulation_->energy();
    v.supply = Supply{energy.impulse, energy.measuredWork, energy.allStored(), settings_.facts.get<BoundaryPower>().isMeasured};
    v.time = time_.value();
    v.deltaT = time_.deltaT();
    v.executionTime = Clock::executionTime();
    v.step = time_.index();
    return v;
}

void Run::sample(bool writeTime, bool end)
{
    // The first rank alone has run them: it knows which are due.
    if (functions_->empty() || !(ofFirst(functions_->due(time_, writeTime, end)) > 0)) return;
    if (!writeTime) simulation_->observe();
    WholeCloud cloud(simulation_->size());
    const auto whole = view(cloud);
    if (!isFirstRank()) return;
    const Alone alone;
    for (const auto& report : functions_->execute(whole, time_, writeTime, end)) log_ << report << '\n';
}

void Run::write()
{
    const auto positions = simulation_->positions();
    const auto fields = simulation_->fields();
    const auto state = simulation_->state();
    const auto histories = isFirstRank() ? functions_->histories() : Histories{};
    std::optional<Alone> ownFolder;
    if (isDecomposed()) ownFolder.emplace();
    time_.write([&](const std::filesystem::path& folder)
                { writeCloud(folder, "sph", simulation_->size(), positions, fields, time_.writeOptions()); },
                state, histories);
}

void Run::noteLeaks()
{
    if (const auto leaks = simulation_->leaks(); leaks.deepest > deepestLeak_ || (deepestLeakAt_.empty() && leaks.count() > 0))
    {
        deepestLeak_ = leaks.deepest;
        deepestLeakAt_ = time_.name();
    }
}

std::string Run::leaked() const
{
    const auto leaks = simulation_->leaks();
    return settings_.facts.get<LeakedParticles>().action == LeakAction::remove
               ? fmt::format("Leaked: {} particles removed, {:.10g} kg\n", leaks.removed, leaks.removedMass)
               : fmt::format("Leaked: {} particles put back\n", leaks.putBack);
}

void Run::reportLeaks() const
{
    log_ << leaked();
    const auto leaks = simulation_->leaks();
    if (leaks.count() > 0)
        log_ << fmt::format("Deepest: {}, near ({:.6g} {:.6g} {:.6g}) at time {}\n",
                            leaks.patch < 0 ? "outside the domain"
                                            : fmt::format("{:.3g} m in {}", leaks.deepest, wallInWords(geometry_, leaks.patch, leaks.at)),
                            leaks.at.x, leaks.at.y, leaks.at.z, deepestLeakAt_);
}

int Run::solve()
{
    onStopSignals(requestStop);
    reportPlan();
    if (isFirstRank())
    {
        const auto [low, high] = boundingBox(geometry_);
        writeBoundingMesh(case_.folder(), low, high);
    }
    sample(true, false);
    noteLeaks();
    if (!time_.running())
        log_ << fmt::format(
            "--> Warning: nothing to do: the run starts at {} s and endTime is {} s. A larger endTime in system/controlDict goes on with it\n",
            time_.startTime(), time_.endTime());
    log_ << "Starting time loop\n\n";
    double lastReport = -1;
    int stoppedBy = 0; // a signal
    StepLimit limit = simulation_->stepLimit();
    check(limit);
    warnOfCompression();
    while (time_.running())
    {
        const double deltaT = advance(limit);
        noteLeaks();
        traceEnergy(deltaT);
        stoppedBy = int(ofAllRanks(double(stopRequested), 0.0, Larger{}));
        if (stoppedBy > 0) time_.stopNow();
        if (ofFirst(time_.controlDictModified()) > 0)
            if (const auto changed = time_.rereadIfModified(); !changed.empty()) log_ << changed << '\n';

        const bool writeTime = time_.writeTime(), end = !time_.running();
        if (writeTime)
        {
            simulation_->settle();
            checkParticles(limit);
            checkEnergy();
            for (const auto& warning : simulation_->warnings()) log_ << fmt::format("--> Warning: at time {} {}\n", time_.name(), warning);
        }
        else if (end || time_.index() % energySteps == 0) checkEnergy();
        sample(writeTime, end);
        if (writeTime) write();
        // Steps are many and cheap: one report a second, and one for each time folder.
        if (const double now = ofFirst(clock_.clockTime()); writeTime || end || now - lastReport >= 1)
        {
            reportStep(limit, deltaT);
            lastReport = now;
        }
        limit = simulation_->stepLimit();
    }
    reportLeaks();
    log_ << simulation_->reportRanks();
    if (stoppedBy == 0)
    {
        log_ << "End\n";
        return 0;
    }
    log_ << fmt::format(
        "Stopped by signal {} ({}) at time {}, before endTime {}: `startFrom latestTime;` of system/controlDict goes on from there\n",
        stoppedBy, strsignal(stoppedBy), time_.name(), time_.endTime());
    return 128 + stoppedBy;
}

}
