/// The part of CaseSweep that runs cases.
#include "CaseSweep.hpp"
#include "base/DivergedError.hpp"
#include "base/OutputFile.hpp"
#include "base/csv.hpp"
#include "base/stopSignals.hpp"
#include "sweeps/CaseCopy.hpp"
#include "sweeps/convergence.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

volatile std::sig_atomic_t interrupted = 0;
void interrupt(int) { interrupted = 1; }

constexpr double progressInterval = 15;   ///< [s] between lines of a run's progress
constexpr std::streamoff tailSize = 8192; ///< of a log that is looked at [byte]

struct Interrupted
{};

/// As finely as the system counts; a sum has digits behind that.
double toMicroseconds(double seconds) { return std::round(1e6 * seconds) / 1e6; }

std::string tailOf(const fs::path& log)
{
    std::ifstream in(log, std::ios::binary | std::ios::ate);
    const auto size = std::streamoff(in.tellg());
    if (size <= 0) return "";
    in.seekg(std::max<std::streamoff>(0, size - tailSize));
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The last line that begins with, or holds, the words; "" where none does.
std::string lastLine(const std::string& text, const std::string& words, bool atBegin)
{
    std::istringstream in(text);
    std::string last;
    for (std::string line; std::getline(in, line);)
        if (atBegin ? line.starts_with(words) : line.find(words) != line.npos) last = line;
    return last;
}

std::string progressOf(const fs::path& log)
{
    const auto tail = tailOf(log);
    const auto time = lastLine(tail, "Time = ", true), cost = lastLine(tail, "expected finish", false);
    return time + (time.empty() || cost.empty() ? "" : "  ") + cost;
}

/// Steps taken until the last time folder, as the solver left their number there.
double stepsIn(const Case& c)
{
    const auto times = c.times();
    if (times.empty()) return ResultRow::unknown;
    const auto file = times.back() + "/uniform/time";
    return c.has(file) ? c.dictionary(file).get<double>("index", ResultRow::unknown) : ResultRow::unknown;
}

struct ErrorLine
{
    double particles = 0, error = 0;
    bool referenceIsZero = false;
};

/// The row of a function object's errors.dat at a time, or the means up to it, if there is one. NaN and infinity are errors, too: of a run
/// that has diverged.
std::optional<ErrorLine> readErrorLine(const fs::path& folder, const ErrorChoice& choice, double time)
{
    std::error_code none;
    fs::path file;
    for (const auto& entry : fs::directory_iterator(folder / "postProcessing" / choice.function, none))
        if (fs::exists(entry.path() / "errors.dat", none)) file = entry.path() / "errors.dat";
    std::ifstream in(file);
    std::vector<std::string> names;
    std::optional<ErrorLine> found;
    double values = 0, references = 0, squares = 0, referenceSquares = 0; // sums over time, for the norms mean and rms
    for (std::string line; std::getline(in, line);)
    {
        std::vector<std::string> cells;
        std::istringstream parts(line.starts_with("# ") ? line.substr(2) : line);
        for (std::string cell; std::getline(parts, cell, '\t');) cells.push_back(cell);
        if (line.starts_with("#"))
        {
            names = cells;
            continue;
        }
        const auto cell = [&](const std::string& name)
        {
            const auto at = std::size_t(std::ranges::find(names, name) - names.begin());
            return at < cells.size() ? cells[at] : std::string();
        };
        const auto t = finiteNumber(cell("Time"));
        if (!t || cell("field") != choice.field) continue;
        const auto number = [&](const std::string& name) { return finiteNumber(cell(name)).value_or(ResultRow::unknown); };
        if (choice.averageFrom && *t >= *choice.averageFrom && (*t < time || sameTime(*t, time)))
        {
            const double value = number("value"), reference = number("reference");
            values += value;
            references += reference;
            squares += (value - reference) * (value - reference);
            referenceSquares += reference * reference;
            const double error = choice.norm == "rms" ? std::sqrt(squares / referenceSquares) : std::abs(values / references - 1);
            found = ErrorLine{number("nParticles"), error, referenceSquares == 0};
        }
        if (choice.averageFrom || !sameTime(*t, time)) continue;
        found = ErrorLine{number("nParticles"), number(choice.norm), finiteNumber(cell("reference")) == 0};
    }
    return found;
}

std::string duration(double seconds)
{
    if (seconds < 100) return fmt::format("{:.2g} s", seconds);
    if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

}

fs::path CaseSweep::folderOf(const Run& run) const { return runFolder_ / run.plan.variant / shortestText(run.plan.resolution); }

std::string CaseSweep::expectedFinish(std::size_t next) const
{
    const auto rows = rowsOf(0);
    double sum = 0;
    for (auto k = next; k < runs_.size(); ++k)
    {
        if (!runs_[k].rows.empty()) continue;
        const auto& plan = runs_[k].plan;
        const auto seconds = expectedWallSeconds(rows, plan.variant, plan.resolution);
        if (!seconds) return "";
        const double limit = plan_.timeLimit.value_or(*seconds);
        sum += plan_.repeats * std::min(*seconds, limit);
    }
    if (sum == 0) return "";
    const auto end = std::time(nullptr) + std::time_t(sum);
    return fmt::format("expected finish in {}, at {:%H:%M}", duration(sum), fmt::localtime(end));
}

std::string CaseSweep::executeSteps(const Run& run, Cost& cost, std::string& note)
{
    const auto folder = folderOf(run);
    copyInputs(plan_.baseCase, folder, !packs());
    apply(run.plan.overrides, folder, case_.diagnostics());
    case_.diagnostics().throwIfAny();
    const Clock clock;
    double shown = 0;
    for (const auto& step : steps_)
    {
        ProcessTask task;
        task.command = step.command;
        task.folder = folder;
        task.log = folder / ("log." + fs::path(step.program).filename().string());
        task.core = core_;
        if (plan_.timeLimit) task.wallLimit = std::max(0.0, *plan_.timeLimit - clock.clockTime());
        task.goOn = [&]
        {
            if (const double now = clock.clockTime(); now - shown >= progressInterval)
            {
                shown = now;
                if (const auto progress = progressOf(task.log); !progress.empty()) fmt::print("        {}: {}\n", step.program, progress);
                std::fflush(stdout);
            }
            return interrupted == 0;
        };
        const auto outcome = runProcess(task);
        if (outcome.stopped || interrupted) throw Interrupted{};
        if (step.timed)
        {
            cost.cpuSeconds += outcome.cpuSeconds;
            cost.wallSeconds += outcome.wallSeconds;
            cost.peakMemory = std::max(cost.peakMemory, outcome.peakMemory);
        }
        if (outcome.well()) continue;
        auto failure = failureIn(tailOf(task.log));
        std::ranges::replace(failure, '\n', ' ');
        note = fmt::format("{}: {}{}; read {}", step.program, outcome.inWords(), failure.empty() ? "" : ": " + failure,
                           fs::relative(task.log, case_.folder()).string());
        if (outcome.reachedLimit) return "timeLimit";
        return failure.starts_with(DivergedError::mark) ? "diverged" : "failed";
    }
    return "ok";
}

/// Fills the errors in. The status of a run that ended well is "ok", "diverged" where an error is not finite, "failed" where one is
/// missing or relative to nothing.
std::string CaseSweep::readErrors(const Run& run, std::vector<ResultRow>& rows, std::string& note) const
{
    std::string status = "ok";
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        const auto& choice = plan_.errors[k];
        const double time = timeOf(choice, run);
        const auto line = readErrorLine(folderOf(run), choice, time);
        if (!line)
        {
            note = fmt::format("postProcessing/{}/*/errors.dat has no {} at time {}: is it sampled then?", choice.function, choice.field,
                               shortestText(time));
            return "failed";
        }
        rows[k].nParticles = line->particles;
        rows[k].error = line->error;
        if (std::isfinite(line->error)) continue;
        note = fmt::format("the {} error of {} at time {} is not finite{}", choice.norm, choice.field, shortestText(time),
                           line->referenceIsZero ? ": it is relative to a reference of 0" : "");
        if (line->referenceIsZero) return "failed";
        status = "diverged";
    }
    return status;
}

void CaseSweep::execute(Run& run)
{
    Cost best{ResultRow::unknown, ResultRow::unknown, ResultRow::unknown};
    std::string status, note;
    for (int repeat = 0; repeat < plan_.repeats && (repeat == 0 || status == "ok"); ++repeat)
    {
        Cost cost;
        status = executeSteps(run, cost, note);
        // Whatever else the machine did made a run slower, never faster: the least is nearest to the truth.
        if (cost.peakMemory == 0) continue; // the solver was not reached
        best.cpuSeconds = std::fmin(best.cpuSeconds, cost.cpuSeconds);
        best.wallSeconds = std::fmin(best.wallSeconds, cost.wallSeconds);
        best.peakMemory = std::fmax(best.peakMemory, cost.peakMemory);
    }
    // What the steps before the solver took belongs to the limit, too; by it a later sweep sees whether the limit has been raised.
    if (status == "timeLimit") best.wallSeconds = std::fmax(best.wallSeconds, *plan_.timeLimit);
    ResultRow row;
    row.variant = run.plan.variant;
    row.resolution = run.plan.resolution;
    row.spacing = run.spacing;
    row.steps = stepsIn(Case(folderOf(run)));
    row.cpuSeconds = toMicroseconds(best.cpuSeconds);
    row.wallSeconds = toMicroseconds(best.wallSeconds);
    row.peakMemory = best.peakMemory;
    row.inputs = run.inputs;
    std::vector<ResultRow> rows;
    for (const auto& choice : plan_.errors)
    {
        row.time = timeOf(choice, run);
        row.field = choice.field;
        row.norm = choice.norm;
        rows.push_back(row);
    }
    if (status == "ok") status = readErrors(run, rows, note);
    for (auto& r : rows) r.status = status;
    run.rows = std::move(rows);

    if (best.peakMemory > 0)
        fmt::print("        {}: {:.3g} s of processor time in {:.3g} s, {:.1f} MB\n", status, best.cpuSeconds, best.wallSeconds,
                   1e-6 * best.peakMemory);
    else fmt::print("        {}\n", status);
    if (!note.empty()) fmt::print("        {}\n", note);
    if (status != "ok") return;
    for (std::size_t k = 0; k < run.rows.size(); ++k) fmt::print("        {}: {:.4g}\n", titleOf(k), run.rows[k].error);
}

int CaseSweep::run()
{
    // No run may use more than its core; OpenMP reads this when a child starts.
    ::setenv("OMP_NUM_THREADS", "1", 1);
    interrupted = 0;
    onStopSignals(interrupt);
    createFolders(outputFolder_);
    if (keepOld_) fs::copy_file(outputFolder_ / "results.csv", outputFolder_ / "results.old.csv", fs::copy_options::overwrite_existing);

    for (std::size_t k = 0; k < runs_.size(); ++k)
    {
        auto& run = runs_[k];
        if (!run.rows.empty()) continue;
        const auto finish = expectedFinish(k);
        fmt::print("[{}/{}] {}: spacing {:.4g} m{}\n", k + 1, runs_.size(), run.plan.name(), run.spacing,
                   finish.empty() ? "" : "; " + finish);
        std::fflush(stdout);
        try
        {
            execute(run);
        }
        catch (const Interrupted&)
        {
            throw CaseError(fmt::format("interrupted in {}. What was done before is in postProcessing/workPrecision/results.csv; run "
                                        "workPrecision again to go on",
                                        run.plan.name()));
        }
        writeTable();
        std::fflush(stdout);
    }
    writeTable();
    for (std::size_t k = 0; k < plan_.errors.size(); ++k) printTable(k);
    draw();
    const auto well = std::ranges::count_if(runs_, [](const Run& run) { return run.rows.front().status == "ok"; });
    if (well < long(runs_.size())) fmt::print("\n{} of {} runs ended well\n", well, runs_.size());
    fmt::print("\nEnd\n");
    return well > 0 ? 0 : 1;
}

}
