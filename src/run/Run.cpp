#include "run/Run.hpp"
#include "base/stopSignals.hpp"
#include "base/version.hpp"
#include "decomposition/placeOfRank.hpp"
#include "geometry/Walls.hpp"
#include "geometry/makeWallLayers.hpp"
#include "parallel/reduce.hpp"
#include "run/report.hpp"
#include "sampling/FunctionLibraries.hpp"
#include "sampling/viewOfScene.hpp"
#include "solver/WholeCloud.hpp"
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

/// A dry run takes steps for so long [s], and goes on from the last third of them: steps change as a scene sets itself in motion.
constexpr double burstTime = 3;

/// Particles of a thread or a rank below which it costs more than it brings.
constexpr std::size_t fewForOne = 2000;

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
    auto geometry = readWalls(theCase, resolution);
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
    monitor_.emplace(settings_, geometry_, *simulation_, time_, log_);
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

double Run::advance(const StepLimit& limit)
{
    monitor_->refuseCollapsed(limit);
    const double deltaT = time_.nextDeltaT(limit.deltaT);
    monitor_->checkFixedStep(limit, deltaT);
    simulation_->step(time_.value(), deltaT);
    time_.advance(deltaT);
    monitor_->check(limit);
    return deltaT;
}

void Run::dryRun()
{
    reportPlan(log_, settings_, *simulation_);
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

int Run::solve()
{
    onStopSignals(requestStop);
    reportPlan(log_, settings_, *simulation_);
    if (isFirstRank())
    {
        const auto [low, high] = boundingBox(geometry_);
        writeBoundingMesh(case_.folder(), low, high);
    }
    sample(true, false);
    monitor_->noteLeaks();
    if (!time_.running())
        log_ << fmt::format(
            "--> Warning: nothing to do: the run starts at {} s and endTime is {} s. A larger endTime in system/controlDict goes on with it\n",
            time_.startTime(), time_.endTime());
    log_ << "Starting time loop\n\n";
    double lastReport = -1;
    int stoppedBy = 0; // a signal
    StepLimit limit = simulation_->stepLimit();
    monitor_->check(limit);
    while (time_.running())
    {
        const double deltaT = advance(limit);
        monitor_->noteLeaks();
        monitor_->traceEnergy(deltaT);
        stoppedBy = int(ofAllRanks(double(stopRequested), 0.0, Larger{}));
        if (stoppedBy > 0) time_.stopNow();
        if (ofFirst(time_.controlDictModified()) > 0)
            if (const auto changed = time_.rereadIfModified(); !changed.empty()) log_ << changed << '\n';

        const bool writeTime = time_.writeTime(), end = !time_.running();
        if (writeTime)
        {
            simulation_->settle();
            monitor_->checkParticles(limit);
            monitor_->checkEnergy();
            for (const auto& warning : simulation_->warnings()) log_ << fmt::format("--> Warning: at time {} {}\n", time_.name(), warning);
        }
        else if (end) monitor_->checkEnergy();
        else monitor_->checkEnergySometimes();
        try
        {
            sample(writeTime, end);
        }
        catch (const CaseError&)
        {
            if (writeTime && !ranks()) write(); // a mistake of a function object that shows only now takes no state with it
            throw;
        }
        if (writeTime) write();
        // Steps are many and cheap: one report a second, and one for each time folder.
        if (const double now = ofFirst(clock_.clockTime()); writeTime || end || now - lastReport >= 1)
        {
            reportStep(log_, settings_, *simulation_, time_, *monitor_, clock_, limit, deltaT);
            lastReport = now;
        }
        limit = simulation_->stepLimit();
    }
    log_ << monitor_->leaked(true) << monitor_->deepestLeak();
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
