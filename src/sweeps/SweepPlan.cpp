#include "sweeps/SweepPlan.hpp"
#include "base/OutputFile.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryText.hpp"
#include "dictionary/readWith.hpp"
#include "sweeps/ResultTable.hpp"
#include <algorithm>
#include <cctype>
#include <cstring>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace entry
{
const FileName baseCase{"baseCase", "", ".", "the case that is run"};
const ListOf<double> resolutions{"resolutions", required, "$n is one of these at a time"};
const SubDictionary setResolution{"setResolution", byScene("nothing, of one resolution alone"),
                                  "what a resolution means: entries of the case's files, as of $n"},
    variants{"variants", byScene("one, called base"), "entries that differ, on top of setResolution"};
const FreeName variant{"<variant>", "dictionary", "a variant of the case"},
    file{"<file>", "dictionary", "file of the case with the entries to change, \"system/sphSchemes\" { .. }"};
const ListOf<std::string> steps{"steps", std::vector<std::string>{"packParticles", "meshToGhost", "sphFoamLike"},
                                "applications that make a run, with arguments in quotes"},
    peers{"peers", std::vector<std::string>{}, "tables with other codes' rows, drawn beside"};
const Count repeats{"repeats", 1, atLeast(1), "runs of which the least cost counts"},
    core{"core", byScene("the last one that the process may use"), anyNumber, "processor core of the runs"};
const Scalar timeLimit{"timeLimit", units::s, byScene("none"), positive, "for the steps of one run together"};
const Switch plots{"plots", true, "draw the diagrams"};

const DictionaryList errors{"errors", required, "which errors of the function objects count"};
const Word function{"function", "errors", "function object of the type errors"}, field{"field", required, "field of its table, as U.x"};
const Choice norm{
    "norm", errorNorms(), "L2",
    "L1, L2, Linf at a time; mean and rms over time: |mean value/mean reference - 1|, sqrt(mean (value - reference)^2/mean reference^2)"};
const Scalar time{"time", units::s, byScene("the end"), nonNegative, "when"},
    averageFrom{"averageFrom", units::s, byScene("needed of mean and rms"), nonNegative, "begin of the mean over time"};
}

namespace
{

Dictionary readAt(double n, const Case& c, std::shared_ptr<Diagnostics> diagnostics)
{
    return readWith(fmt::format("n {};", shortestText(n)), c.folder(), sweepDictionary, std::move(diagnostics));
}

/// Ascending; what is wrong with the list is recorded, and what can be used of it is returned.
std::vector<double> readResolutions(const Dictionary& d)
{
    auto ladder = entry::resolutions(d);
    if (entry::resolutions.given(d) && ladder.empty())
        entry::resolutions.error(d, "\"resolutions\" is empty: give at least one, as (8 16 32)");
    for (const double n : ladder)
        if (!(n > 0)) entry::resolutions.error(d, fmt::format("resolution {} must be greater than 0", shortestText(n)));
    std::erase_if(ladder, [](double n) { return !(n > 0); });
    std::ranges::sort(ladder);
    if (const auto twice = std::ranges::adjacent_find(ladder); twice != ladder.end())
        entry::resolutions.error(d, fmt::format("resolution {} stands twice", shortestText(*twice)));
    ladder.erase(std::unique(ladder.begin(), ladder.end()), ladder.end());
    return ladder;
}

std::vector<ErrorChoice> readErrors(const Dictionary& d)
{
    std::vector<ErrorChoice> choices;
    for (const auto& e : entry::errors(d))
    {
        ErrorChoice choice;
        choice.function = entry::function(e);
        choice.field = entry::field(e);
        choice.norm = entry::norm(e);
        choice.time = entry::time.ifGiven(e);
        if (choice.norm == "mean" || choice.norm == "rms")
        {
            choice.averageFrom = entry::averageFrom(e, 0);
            if (!entry::averageFrom.given(e))
                entry::norm.error(e, fmt::format("norm {} is one over time: say from when on, as `averageFrom 1.2;`", choice.norm));
            if (choice.time && *choice.averageFrom > *choice.time)
                entry::averageFrom.error(e, fmt::format("averageFrom {} is after time {}", *choice.averageFrom, *choice.time));
        }
        choice.whereFunction = entry::function.where(e);
        choice.whereField = entry::field.where(e);
        choice.whereTime = entry::time.where(e);
        choices.push_back(std::move(choice));
    }
    if (entry::errors.given(d) && choices.empty())
        entry::errors.error(d, "\"errors\" is empty: give at least one, as ( { field U.x; norm L2; } )");
    return choices;
}

/// Reads all but the ladder; adds the runs at the resolution `n`.
void readPass(const Dictionary& d, const Case& c, double n, SweepPlan& plan)
{
    plan.baseCase = c.folder() / entry::baseCase(d);
    if (!std::filesystem::is_directory(plan.baseCase))
        entry::baseCase.error(d, fmt::format("there is no case folder \"{}\"", entry::baseCase(d)));
    plan.steps = entry::steps(d);
    plan.whereSteps = entry::steps.where(d);
    if (plan.steps.empty()) entry::steps.error(d, "\"steps\" is empty");
    plan.repeats = entry::repeats(d);
    plan.timeLimit = entry::timeLimit.ifGiven(d);
    plan.core = entry::core.ifGiven(d);
    plan.whereCore = entry::core.where(d);
    plan.errors = readErrors(d);
    plan.peers = entry::peers(d);
    plan.plots = entry::plots(d);

    const auto resolution =
        readOverrides(plan.resolutions.size() > 1 ? entry::setResolution.needed(d) : entry::setResolution(d), plan.baseCase);
    const bool hasVariants = entry::variants.given(d);
    const auto variants = entry::variants(d);
    auto names = variants.keys();
    if (!hasVariants) names.push_back("base");
    if (names.empty()) entry::variants.error(d, "\"variants\" is empty: leave it out to run the case as it is");
    for (const auto& name : names)
    {
        if (!isPlainName(name)) variants.error(name, fmt::format("variant \"{}\" needs a name of letters, digits and _-+.", name));
        PlannedRun run{name, n, hasVariants ? variants.where(name) : d.location(), resolution};
        if (hasVariants)
            for (auto& o : readOverrides(variants.subDict(name), plan.baseCase)) run.overrides.push_back(std::move(o));
        plan.runs.push_back(std::move(run));
    }
    plan.variants = names;
    d.reportUnused();
}

}

EntryList sweepEntries()
{
    using namespace entry;
    return {baseCase,
            resolutions,
            {setResolution, {file}},
            {variants, {{variant, {file}}}},
            steps,
            repeats,
            timeLimit,
            core,
            {errors, {entry::function, field, norm, entry::time, averageFrom}},
            peers,
            plots};
}

std::string PlannedRun::name() const { return variant + "/" + shortestText(resolution); }

SweepPlan readSweepPlan(const Case& c)
{
    SweepPlan plan;
    // The ladder itself must be known before $n can be: what else is wrong in this pass is found again in the next.
    plan.resolutions = readResolutions(readAt(1, c, std::make_shared<Diagnostics>()));
    for (const double n : plan.resolutions.empty() ? std::vector<double>{1} : plan.resolutions)
    {
        const auto d = readAt(n, c, c.sharedDiagnostics());
        if (!c.has(sweepDictionary)) break;
        readResolutions(d);
        readPass(d, c, n, plan);
    }
    return plan;
}

void select(SweepPlan& plan, const SweepSelection& selection)
{
    for (const auto& name : selection.variants)
        if (std::ranges::find(plan.variants, name) == plan.variants.end())
            throw CaseError(fmt::format("-variants: \"{}\" is unknown. {}", name, suggestion(name, "variants", plan.variants)));
    const auto among = [](const auto& all, const auto& one) { return std::ranges::find(all, one) != all.end(); };
    if (!selection.variants.empty())
        std::erase_if(plan.variants, [&](const std::string& name) { return !among(selection.variants, name); });
    if (const auto count = std::size_t(selection.coarsest); count > 0 && count < plan.resolutions.size()) plan.resolutions.resize(count);
    std::erase_if(plan.runs,
                  [&](const PlannedRun& run) { return !among(plan.variants, run.variant) || !among(plan.resolutions, run.resolution); });
}

}
