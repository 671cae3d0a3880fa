/// The part of CaseSweep that tells: the plan, tables, plots.
#include "CaseSweep.hpp"
#include "base/OutputFile.hpp"
#include "base/csv.hpp"
#include "sweeps/convergence.hpp"
#include "sweeps/plots.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

using Cells = std::vector<std::string>;

/// Columns as wide as their widest cell, words to the left, numbers to the right.
std::string aligned(const std::vector<Cells>& rows, std::size_t words)
{
    std::vector<std::size_t> width(rows.front().size(), 0);
    for (const auto& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
    std::string text;
    for (const auto& row : rows)
    {
        std::string line = "  ";
        for (std::size_t c = 0; c < row.size(); ++c)
            line += c < words ? fmt::format("{:<{}}  ", row[c], width[c]) : fmt::format("{:>{}}  ", row[c], width[c]);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

/// As a user writes it: `#eval "3*0.1"` is 0.30000000000000004, and 0.3 to read.
std::string shown(double value) { return fmt::format("{:.15g}", value); }
std::string shown(const std::string& entry)
{
    const auto value = finiteNumber(entry);
    return value ? shown(*value) : entry.find('\n') == entry.npos ? entry : "{..}";
}

std::string number(double value, const char* format)
{
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : std::string("-");
}

}

std::string CaseSweep::titleOf(std::size_t error) const
{
    const auto& choice = plan_.errors[error];
    return fmt::format("{} error of {} at time {} s", choice.norm, choice.field, shown(timeOf(choice, runs_.front())));
}

std::string CaseSweep::stemOf(std::size_t error) const
{
    const auto& choice = plan_.errors[error];
    return fmt::format("{}{}_{}_{}", choice.function == "errors" ? "" : choice.function + "_", choice.field, choice.norm,
                       shown(timeOf(choice, runs_.front())));
}

void CaseSweep::printPlan() const
{
    const auto done = std::ranges::count_if(runs_, [](const Run& run) { return !run.rows.empty(); });
    std::vector<std::string> timed;
    for (const auto& step : steps_)
        if (step.timed) timed.push_back(step.program);
    fmt::print("Case    : {}\nRuns    : {} ({} variants at {} resolutions), {} of them done already\nSteps   : {}; costs are "
               "those of {}\n"
               "Repeats : {}, the least cost counts\nLimit   : {}\nCore    : {}, one thread\n",
               fs::weakly_canonical(plan_.baseCase).string(), runs_.size(), plan_.variants.size(), plan_.resolutions.size(), done,
               fmt::join(plan_.steps, ", "), fmt::join(timed, ", "), plan_.repeats,
               plan_.timeLimit ? fmt::format("{} s a run", shortestText(*plan_.timeLimit)) : "none", core_);
    for (std::size_t k = 0; k < plan_.errors.size(); ++k)
    {
        const auto peers = peersOf(k).size();
        fmt::print("Error   : {}{}\n", titleOf(k), peers_.empty() ? "" : fmt::format(", {} rows of other codes", peers));
    }
    for (const auto& warning : case_.diagnostics().warnings()) fmt::print("--> Warning: {}\n", warning);
    fmt::print("\n");
    std::vector<Cells> rows{{"run", "state", "spacing [m]", "sets"}};
    for (const auto& run : runs_)
    {
        std::vector<std::string> sets;
        for (const auto& o : run.plan.overrides) sets.push_back(fmt::format("{}:{} {}", o.file, o.entry(), shown(o.value)));
        rows.push_back({run.plan.name(), run.rows.empty() ? "to run" : run.rows.front().status, fmt::format("{:.4g}", run.spacing),
                        fmt::format("{}", fmt::join(sets, "; "))});
    }
    fmt::print("{}\n", aligned(rows, 4));
    std::fflush(stdout);
}

void CaseSweep::writeTable()
{
    std::vector<ResultRow> all;
    for (std::size_t k = 0; k < plan_.errors.size(); ++k)
    {
        auto rows = rowsOf(k);
        setObservedOrders(rows);
        std::ranges::move(rows, std::back_inserter(all));
    }
    writeFile(outputFolder_ / "results.csv", resultTableText(all));
}

void CaseSweep::printTable(std::size_t error) const
{
    auto rows = rowsOf(error);
    const auto own = rows.size();
    setObservedOrders(rows);
    auto peers = peersOf(error);
    setObservedOrders(peers);
    std::ranges::move(peers, std::back_inserter(rows));
    const auto front = paretoFront(rows);
    std::vector<std::size_t> order(rows.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    // Rows by cost; those that did not end well come last.
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return std::pair(rows[k].status != "ok", rows[k].cpuSeconds); });

    std::vector<Cells> cells{
        {"", "variant", "status", "spacing [m]", "particles", "steps", "cpu [s]", "wall [s]", "memory [MB]", "error", "order"}};
    for (const auto k : order)
    {
        const auto& r = rows[k];
        cells.push_back({front[k] ? "*" : "", r.variant + (k < own ? "" : " (peer)"), r.status, number(r.spacing, "{:.4g}"),
                         number(r.nParticles, "{:.0f}"), number(r.steps, "{:.0f}"), number(r.cpuSeconds, "{:.3g}"),
                         number(r.wallSeconds, "{:.3g}"), number(1e-6 * r.peakMemory, "{:.1f}"), number(r.error, "{:.3e}"),
                         number(r.order, "{:.2f}")});
    }
    fmt::print("\n{}; * on the Pareto front: nothing has less error at no more processor time\n\n{}", titleOf(error), aligned(cells, 3));
}

void CaseSweep::draw() const
{
    if (!gnuplot_) return;
    fmt::print("\n");
    for (std::size_t k = 0; k < plan_.errors.size(); ++k)
    {
        auto whole = fs::weakly_canonical(plan_.baseCase);
        const auto script = gnuplotScript({stemOf(k), fmt::format("{}: {}", whole.filename().string(), titleOf(k)), rowsOf(k), peersOf(k)});
        if (script.empty())
        {
            fmt::print("No plot of the {}: no run has an error to show\n", titleOf(k));
            continue;
        }
        const auto file = stemOf(k) + ".gp", log = "log.gnuplot." + stemOf(k);
        writeFile(outputFolder_ / file, script);
        ProcessTask task;
        task.command = {gnuplot_->string(), file};
        task.folder = outputFolder_;
        task.log = outputFolder_ / log;
        if (const auto outcome = runProcess(task); !outcome.well())
            throw CaseError(fmt::format("gnuplot could not draw postProcessing/workPrecision/{}: {}; read postProcessing/workPrecision/{}",
                                        file, outcome.inWords(), log));
        fs::remove(outputFolder_ / log);
        for (const char* kind : {"cpuTime", "spacing"}) fmt::print("postProcessing/workPrecision/{}.{}.svg, .png\n", stemOf(k), kind);
    }
}

std::string sweepTable(const fs::path& caseFolder)
{
    const Case c(caseFolder);
    const auto plan = readSweepPlan(c);
    c.diagnostics().throwIfAny();
    if (!c.has(resultFile)) throw CaseError(fmt::format("{} is not there: run workPrecision first", resultFile));
    auto rows = readResultTable(c.folder(), resultFile, Completeness::ownRows, c.diagnostics());
    std::ranges::move(readPeers(c, plan), std::back_inserter(rows));
    c.diagnostics().throwIfAny();
    return resultTableText(rows);
}

}
