#include "figures/FigureTable.hpp"
#include "base/OutputFile.hpp"
#include "base/readText.hpp"
#include "figures/RunNumbers.hpp"
#include "sweeps/ResultTable.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/printf.h>
#include <fstream>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

/// A number as a format of printf has it.
std::string printed(const std::string& format, double value)
{
    if (std::isnan(value)) return "-";
    const auto kind = format.find_first_of("defgEG", format.find('%'));
    return format[kind] == 'd' ? fmt::sprintf(format, static_cast<long long>(value)) : fmt::sprintf(format, value);
}

/// Columns under their heads, the first to the left.
std::string aligned(const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::size_t> width;
    for (const auto& row : rows)
    {
        width.resize(std::max(width.size(), row.size()));
        for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
    }
    std::string text;
    for (const auto& row : rows)
    {
        std::string line;
        for (std::size_t k = 0; k < row.size(); ++k)
            line += (k == 0 ? "" : "   ") + (k == 0 ? fmt::format("{:<{}}", row[k], width[k]) : fmt::format("{:>{}}", row[k], width[k]));
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

std::string shown(const fs::path& folder) { return folder == "." ? "the case itself" : folder.lexically_normal().string(); }

std::vector<FigureLine> linesOf(const fs::path& caseFolder, const TablePlan& plan, FigureTable& table)
{
    std::vector<FigureLine> lines;
    std::vector<PlannedRunFolder> runs;
    for (const auto& run : plan.runs)
        for (auto& each : foldersOf(run, caseFolder)) runs.push_back(std::move(each));
    for (const auto& run : runs)
    {
        RunNumbers numbers(caseFolder, run);
        if (!numbers.isThere())
        {
            table.missing.push_back(shown(run.folder));
            continue;
        }
        for (const auto& derived : plan.derivedTables) numbers.add(derived);
        for (const auto& number : plan.numbers) numbers.add(number);
        const auto add = [&](const std::string& name, const auto& value)
        {
            FigureLine line{name, {}, numbers.day()};
            for (const auto& figure : plan.figures) line.cells.push_back(printed(figure.format, value(figure)));
            lines.push_back(std::move(line));
        };
        if (!plan.lines) add(run.name, [&](const NumberPlan& figure) { return numbers(figure); });
        else
            for (const auto& [row, place] : numbers.lines(*plan.lines))
                add(printed(plan.lines->name, place), [&, r = row](const NumberPlan& figure) { return numbers(figure, r); });
    }
    return lines;
}

/// The errors that workPrecision has found: `<norm>(<field>)` of each run, " at <time>" where a run has several times, " (2)" of a second function object; its order, steps
/// and processor time.
std::vector<RecordedFigure> sweepFigures(const fs::path& caseFolder, const TablePlan& plan)
{
    const auto folder = plan.runs.front().folder;
    const auto file = (folder / "postProcessing/workPrecision/results.csv").lexically_normal().string();
    Diagnostics diagnostics;
    const auto rows = readResultTable(caseFolder, file, Completeness::ownRows, diagnostics);
    diagnostics.throwIfAny();
    const auto runOf = [](const ResultRow& row) { return row.variant + " " + shortestText(row.resolution); };
    const auto nameOf = [](const ResultRow& row) { return fmt::format("{}({})", row.norm, row.field); };
    const auto day = RunNumbers(caseFolder, plan.runs.front()).day();
    std::map<std::string, double> first;
    std::set<std::string> several;
    for (const auto& row : rows)
        if (const auto [at, isNew] = first.emplace(runOf(row) + nameOf(row), row.time); !isNew && at->second != row.time)
            several.insert(nameOf(row));
    std::vector<RecordedFigure> figures;
    std::map<std::string, int> seen;
    for (const auto& row : rows)
    {
        if (row.status != "ok") continue;
        const auto run = runOf(row);
        auto name = nameOf(row);
        if (several.contains(name)) name += " at " + fmt::sprintf("%g", row.time);
        if (const int times = ++seen[run + name]; times > 1) name += fmt::format(" ({})", times);
        const double error = (plan.unit == "%" ? 100 : 1) * row.error;
        figures.push_back({run, name, printed(error < 100 ? "%#.3g" : "%.0f", error), plan.unit, plan.against, day});
        if (!std::isnan(row.order)) figures.push_back({run, "order of " + name, printed("%.2f", row.order), "-", plan.against, day});
        if (seen[run]++) continue;
        figures.push_back({run, "steps", printed("%.0f", row.steps), "-", "-", day});
        figures.push_back({run, "processor time", printed(row.cpuSeconds < 100 ? "%.2g" : "%.0f", row.cpuSeconds), "s", "-", day});
    }
    return figures;
}

/// The end of the log of workPrecision, which tells of costs, from its Pareto front on.
std::string paretoFront(const fs::path& log)
{
    std::string reason;
    const auto text = readText(log, reason).value_or("");
    const auto at = text.find("Pareto front");
    return at == text.npos ? "" : "\n" + text.substr(text.rfind('\n', at) + 1);
}

}

FigureTable makeFigures(const fs::path& caseFolder, const TablePlan& plan)
{
    FigureTable table;
    if (plan.isSweep)
    {
        const auto folder = caseFolder / plan.runs.front().folder;
        if (!fs::exists(folder / "postProcessing/workPrecision/results.csv"))
        {
            table.missing.push_back("workPrecision of " + shown(plan.runs.front().folder));
            return table;
        }
        table.recorded = sweepFigures(caseFolder, plan);
        table.lines = table.recorded.size();
        table.text = paretoFront(folder / "log.workPrecision");
        return table;
    }
    const auto lines = linesOf(caseFolder, plan, table);
    table.lines = lines.size();
    if (lines.empty()) return table;
    std::vector<std::vector<std::string>> shown(1);
    shown[0].push_back(plan.against);
    for (const auto& figure : plan.figures) shown[0].push_back(fmt::format("{} [{}]", figure.name, figure.unit));
    for (const auto& line : lines)
    {
        shown.push_back({line.name});
        shown.back().insert(shown.back().end(), line.cells.begin(), line.cells.end());
        for (std::size_t k = 0; k < line.cells.size(); ++k)
            if (plan.recorded && line.cells[k] != "-")
                table.recorded.push_back({line.name, plan.figures[k].name, line.cells[k], plan.figures[k].unit, plan.against, line.day});
    }
    table.text = "\n" + aligned(shown);
    return table;
}

std::string makeFigure(const fs::path& caseFolder, const NumberPlan& figure)
{
    return printed(figure.format, RunNumbers(caseFolder, {"base", ".", {}, {}})(figure));
}

void recordFigures(const fs::path& caseFolder, const std::vector<RecordedFigure>& figures, const std::string& version,
                   const std::string& machine)
{
    if (figures.empty()) return;
    createFolders(caseFolder / "run");
    std::ofstream out(caseFolder / "run/results.csv", std::ios::app);
    for (const auto& f : figures)
        out << fmt::format("{},{},{},{},{},{},{},{}\n", f.run, f.figure, f.value, f.unit, f.against, f.day, version, machine);
    if (!out.flush()) throw CaseError({"run/results.csv", 0}, "cannot be written");
}

std::string machineName()
{
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name"))
        {
            auto name = line.substr(line.find(':') + 1);
            name.erase(0, name.find_first_not_of(' '));
            std::ranges::replace(name, ',', ' ');
            return name;
        }
    return "unknown";
}

}
