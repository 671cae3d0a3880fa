/// Figures of a case's runs, as system/figuresDict asks for them: printed as tables and recorded.
#include "base/CommandLine.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "case/Case.hpp"
#include "figures/FigurePlan.hpp"
#include "figures/FigureTable.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace
{

struct Options
{
    std::vector<std::string> tables;
    bool unrecorded = false;
    std::string value, table, where, operation = "last", format = "%.6g";
};

/// One number of the case itself, for scripts.
int printValue(const std::filesystem::path& path, const Options& options)
{
    const auto mistakes = std::make_shared<sph::Diagnostics>();
    const auto text = fmt::format("name value; value \"{}\"; table \"{}\"; where \"{}\"; operation {}; format \"{}\";", options.value,
                                  options.table, options.where, options.operation, options.format);
    const auto figure = sph::readOneFigure(sph::Dictionary::parse(text, "the command line", mistakes));
    mistakes->throwIfAny();
    fmt::print("{}\n", sph::makeFigure(sph::Case(path).folder(), figure));
    return 0;
}

/// A line on the runs of the tables that have not been made; a case has more of them than are made at a time.
std::string notRun(std::vector<std::string> folders)
{
    if (folders.empty()) return "";
    const std::size_t all = folders.size(), shown = 3;
    folders.resize(std::min(all, shown));
    return fmt::format("\nNot run: {}{}\n", fmt::join(folders, ", "), all > shown ? fmt::format(" and {} more", all - shown) : "");
}

int run(const std::filesystem::path& path, const Options& options)
{
    const sph::Case theCase(path);
    const auto plans = sph::readFigurePlan(theCase.dictionary(sph::figuresDictionary));
    theCase.diagnostics().throwIfAny();
    std::vector<std::string> names;
    for (const auto& plan : plans) names.push_back(plan.name);
    for (const auto& table : options.tables)
        if (std::ranges::find(names, table) == names.end())
            throw sph::CaseError({sph::figuresDictionary, 0},
                                 fmt::format("has no table \"{}\". {}", table, sph::suggestion(table, "tables", names)));

    const auto version = sph::version().commit.empty() ? sph::version().number : sph::version().commit;
    std::size_t lines = 0;
    std::vector<std::string> missing;
    for (const auto& plan : plans)
    {
        const bool asked = std::ranges::find(options.tables, plan.name) != options.tables.end();
        if (!options.tables.empty() && !asked) continue;
        const auto table = sph::makeFigures(theCase.folder(), plan);
        fmt::print("{}", table.text);
        for (const auto& each : table.missing)
            if (std::ranges::find(missing, each) == missing.end()) missing.push_back(each);
        if (table.lines == 0 && asked) throw sph::CaseError(plan.dict.location(), "none of its runs has been made");
        if (!options.unrecorded) sph::recordFigures(theCase.folder(), table.recorded, version, sph::machineName());
        lines += table.lines;
    }
    if (lines == 0) throw sph::CaseError({sph::figuresDictionary, 0}, "none of the runs has been made");
    fmt::print("{}", notRun(missing));
    return 0;
}

}

int main(int argc, char** argv)
{
    Options options;
    return sph::runApplication(
        "caseFigures", argc, argv,
        "Prints the tables of figures that system/figuresDict asks for, from what runs have left, and appends them to run/results.csv.",
        [&](sph::CommandLine& line)
        {
            line.argument("tables", options.tables, "These tables only");
            const auto value = line.option(
                "value", options.value, "expression",
                "Print this expression alone: of numbers, of what the log of the case tells, of columns of a table at its last row");
            line.option("table", options.table, "name", "The table: a function object, or a file of the case").needs(value);
            line.option("where", options.where, "expression", "Condition on the rows of the table").needs(value);
            line.option("operation", options.operation, "word", "What is made of the rows: last (default), first, min, max, mean, sum ..")
                .needs(value);
            line.option("format", options.format, "format", "How it is written, as printf has it (default: %.6g)").needs(value);
            line.flag("noRecord", options.unrecorded, "Leave run/results.csv alone");
        },
        [&](const std::filesystem::path& folder) { return options.value.empty() ? run(folder, options) : printValue(folder, options); },
        sph::Banner::none);
}
