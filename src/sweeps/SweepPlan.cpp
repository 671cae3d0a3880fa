#include "SweepPlan.hpp"
#include "DictionaryText.hpp"
#include "OutputFile.hpp"
#include "ResultTable.hpp"
#include "readWith.hpp"
#include "words.hpp"
#include <algorithm>
#include <cctype>
#include <cstring>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace
{

Dictionary readAt(double n, const Case& c, std::shared_ptr<Diagnostics> diagnostics)
{
    return readWith(fmt::format("n {};", shortestText(n)), c.folder(), sweepDictionary, std::move(diagnostics));
}

/// Ascending; what is wrong with the list is recorded, and what can be used of it is returned.
std::vector<double> readResolutions(const Dictionary& d)
{
    auto ladder = d.get<std::vector<double>>("resolutions");
    if (d.found("resolutions") && ladder.empty())
        d.error("resolutions", "\"resolutions\" is empty: give at least one, as (8 16 32)");
    for (const double n : ladder)
        if (!(n > 0)) d.error("resolutions", fmt::format("resolution {} must be greater than 0", shortestText(n)));
    std::erase_if(ladder, [](double n) { return !(n > 0); });
    std::ranges::sort(ladder);
    if (const auto twice = std::ranges::adjacent_find(ladder); twice != ladder.end())
        d.error("resolutions", fmt::format("resolution {} stands twice", shortestText(*twice)));
    ladder.erase(std::unique(ladder.begin(), ladder.end()), ladder.end());
    return ladder;
}

/// The name of a variant is that of a folder and of a curve.
bool isPlainName(const std::string& name)
{
    return !name.empty() && name[0] != '.' &&
           std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || std::strchr("_-+.", c); });
}

std::vector<std::string> filesOf(const std::filesystem::path& folder)
{
    std::vector<std::string> files;
    std::error_code none;
    for (const char* part : {"system", "constant"})
        for (const auto& entry : std::filesystem::directory_iterator(folder / part, none))
            if (entry.is_regular_file(none)) files.push_back(fmt::format("{}/{}", part, entry.path().filename().string()));
    std::ranges::sort(files);
    return files;
}

void collectEntries(const Dictionary& d, Override under, std::vector<Override>& overrides)
{
    for (const auto& key : d.keys())
    {
        auto next = under;
        next.keywords.push_back(key);
        if (d.isDictionary(key))
            collectEntries(d.subDict(key), next, overrides);
        else
        {
            next.value = valueText(d, key);
            next.where = d.where(key);
            overrides.push_back(std::move(next));
        }
        d.ignore(key);
    }
}

/// `"system/sphSchemes" { entries }` for any number of files.
std::vector<Override> readOverrides(const Dictionary& d, const std::filesystem::path& baseCase)
{
    std::vector<Override> overrides;
    for (const auto& file : d.keys())
    {
        const auto known = filesOf(baseCase);
        if (!d.isDictionary(file))
            d.error(
                file,
                fmt::format("\"{}\" must be a file of the case with the entries to change in it: \"system/sphSchemes\" {{ .. }}",
                            file));
        else if (std::ranges::find(known, file) == known.end())
            d.error(file, fmt::format("the case has no file \"{}\". {}", file, suggestion(file, "files", known)));
        else
            collectEntries(d.subDict(file), {file, {}, {}, {}}, overrides);
        d.ignore(file);
    }
    return overrides;
}

std::vector<ErrorChoice> readErrors(const Dictionary& d)
{
    std::vector<ErrorChoice> choices;
    for (const auto& e : d.dictionaries("errors"))
    {
        ErrorChoice choice;
        choice.function = e.get<std::string>("function", "errors");
        choice.field = e.get<std::string>("field");
        choice.norm = e.choose("norm", errorNorms(), "L2");
        if (e.found("time")) choice.time = e.getNonNegative("time", units::s, 0);
        if (choice.norm == "mean" || choice.norm == "rms")
        {
            choice.averageFrom = e.getNonNegative("averageFrom", units::s, 0);
            if (!e.found("averageFrom"))
                e.error("norm", fmt::format("norm {} is one over time: say from when on, as `averageFrom 1.2;`", choice.norm));
            if (choice.time && *choice.averageFrom > *choice.time)
                e.error("averageFrom", fmt::format("averageFrom {} is after time {}", *choice.averageFrom, *choice.time));
        }
        choice.whereFunction = e.where("function");
        choice.whereField = e.where("field");
        choice.whereTime = e.where("time");
        choices.push_back(std::move(choice));
    }
    if (d.found("errors") && choices.empty())
        d.error("errors", "\"errors\" is empty: give at least one, as ( { field U.x; norm L2; } )");
    return choices;
}

/// All but the ladder; adds the runs at the resolution `n`.
void readPass(const Dictionary& d, const Case& c, double n, SweepPlan& plan)
{
    plan.baseCase = c.folder() / d.get<std::string>("baseCase", ".");
    if (!std::filesystem::is_directory(plan.baseCase))
        d.error("baseCase", fmt::format("there is no case folder \"{}\"", d.get<std::string>("baseCase", ".")));
    plan.steps = d.get<std::vector<std::string>>("steps", {"packParticles", "meshToGhost", "sphFoamLike"});
    plan.whereSteps = d.where("steps");
    if (plan.steps.empty()) d.error("steps", "\"steps\" is empty");
    plan.repeats = d.get<int>("repeats", 1);
    if (plan.repeats < 1) d.error("repeats", "\"repeats\" must be at least 1");
    if (d.found("timeLimit")) plan.timeLimit = d.getPositive("timeLimit", units::s);
    if (d.found("core")) plan.core = d.get<int>("core");
    plan.whereCore = d.where("core");
    plan.errors = readErrors(d);
    plan.peers = d.get<std::vector<std::string>>("peers", std::vector<std::string>{});
    plan.plots = d.get<bool>("plots", true);

    const auto resolution = readOverrides(
        d.found("setResolution") || plan.resolutions.size() > 1 ? d.subDict("setResolution") : d.subDictOrEmpty("setResolution"),
        plan.baseCase);
    const auto variants = d.subDictOrEmpty("variants");
    auto names = variants.keys();
    if (!d.found("variants")) names.push_back("base");
    if (names.empty()) d.error("variants", "\"variants\" is empty: leave it out to run the case as it is");
    for (const auto& name : names)
    {
        if (!isPlainName(name))
            variants.error(name, fmt::format("variant \"{}\" needs a name of letters, digits and _-+.", name));
        PlannedRun run{name, n, d.found("variants") ? variants.where(name) : d.location(), resolution};
        if (d.found("variants"))
            for (auto& o : readOverrides(variants.subDict(name), plan.baseCase)) run.overrides.push_back(std::move(o));
        plan.runs.push_back(std::move(run));
    }
    plan.variants = names;
    d.reportUnused();
}

}

std::string Override::entry() const { return fmt::format("{}", fmt::join(keywords, ".")); }

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

}
