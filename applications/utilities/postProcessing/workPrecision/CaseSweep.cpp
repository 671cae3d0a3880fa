#include "CaseSweep.hpp"
#include "base/OutputFile.hpp"
#include "base/words.hpp"
#include "checkCase.hpp"
#include "sweeps/CaseCopy.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

/// A folder for copies to be looked at, which is gone afterwards, with those above it that are then empty.
class ScratchFolder
{
    fs::path runFolder_, folder_;

public:
    explicit ScratchFolder(const fs::path& runFolder) : runFolder_(runFolder), folder_(runFolder / ".check") {}
    ~ScratchFolder()
    {
        std::error_code kept; // a folder that is not empty stays
        fs::remove_all(folder_, kept);
        fs::remove(runFolder_, kept);
        fs::remove(runFolder_.parent_path(), kept);
    }
    /// As deep below the case as the runs' own folders are, so that relative includes mean the same.
    fs::path copy() const { return folder_ / "copy"; }
};

std::vector<std::string> siblingPrograms()
{
    std::vector<std::string> names;
    std::error_code none;
    const auto self = fs::read_symlink("/proc/self/exe", none);
    for (const auto& entry : fs::directory_iterator(self.parent_path(), none)) names.push_back(entry.path().filename().string());
    std::erase_if(names, [](const std::string& name) { return name.starts_with("unit_") || !findProgram(name); });
    std::ranges::sort(names);
    return names;
}

std::vector<std::string> wordsOf(const std::string& text)
{
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

/// "system/sphSchemes:14: what" taken apart; file empty where the text has no place.
std::pair<Location, std::string> placeAndText(const std::string& mistake)
{
    const auto colon = mistake.find(": ");
    if (colon == mistake.npos) return {{}, mistake};
    Location where{mistake.substr(0, colon), 0};
    if (const auto last = where.file.rfind(':'); last != where.file.npos)
    {
        where.line = std::atoi(where.file.c_str() + last + 1);
        where.file.erase(last);
    }
    if (where.file.find(' ') != where.file.npos) return {{}, mistake};
    return {where, mistake.substr(colon + 2)};
}

}

bool sameTime(double a, double b) { return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)); }

CaseSweep::CaseSweep(const fs::path& caseFolder, const SweepSelection& selection)
    : case_(fs::weakly_canonical(fs::absolute(caseFolder))),
      plan_(readSweepPlan(case_)),
      runFolder_(case_.folder() / "run" / "workPrecision"),
      outputFolder_(case_.folder() / "postProcessing" / "workPrecision")
{
    if (case_.diagnostics().ok()) select(plan_, selection);
    findPrograms();
    peers_ = readPeers(case_, plan_);
    for (const auto& plan : plan_.runs) runs_.push_back({plan, 0, 0, {}, {}});
    // Even where there are mistakes already: they are to be reported together.
    if (!plan_.resolutions.empty() && fs::is_directory(plan_.baseCase)) checkRuns();
    if (case_.diagnostics().ok() && case_.has(resultFile)) takeOldRows();
    case_.diagnostics().throwIfAny();
}

std::vector<std::string> CaseSweep::programs() const
{
    std::vector<std::string> names;
    for (const auto& step : steps_) names.push_back(step.program);
    return names;
}

bool CaseSweep::packs() const { return std::ranges::find(steps_, "packParticles", &Step::program) != steps_.end(); }

void CaseSweep::findPrograms()
{
    auto& diagnostics = case_.diagnostics();
    const auto control = Dictionary::read(plan_.baseCase, "system/controlDict", std::make_shared<Diagnostics>());
    const auto solver = control.get("application", "");
    for (const auto& text : plan_.steps)
    {
        auto words = wordsOf(text);
        const auto name = words.empty() ? std::string() : words.front();
        const auto path = findProgram(name);
        if (!path)
        {
            diagnostics.error(plan_.whereSteps, fmt::format("there is no application \"{}\". {}", name,
                                                            suggestion(name, "applications of the suite", siblingPrograms())));
            continue;
        }
        words.front() = path->string();
        steps_.push_back({name, words, name == solver});
    }
    // Where the solver is not among them, everything counts.
    if (std::ranges::none_of(steps_, &Step::timed))
        for (auto& step : steps_) step.timed = true;

    const auto cores = usableCores();
    core_ = plan_.core.value_or(cores.empty() ? 0 : cores.back());
    if (plan_.core && std::ranges::find(cores, core_) == cores.end())
        diagnostics.error(plan_.whereCore, fmt::format("core {} cannot be used. Usable: {}", core_, fmt::join(cores, ", ")));
    if (!plan_.plots) return;
    gnuplot_ = findProgram("gnuplot");
    if (!gnuplot_)
        diagnostics.error({sweepDictionary, 0},
                          "the plots need gnuplot, which is not installed: install the package gnuplot-nox (etc/setup "
                          "does), or say `plots no;`");
}

std::vector<ResultRow> readPeers(const Case& c, const SweepPlan& plan)
{
    std::vector<ResultRow> peers;
    for (const auto& file : plan.peers)
    {
        const auto before = c.diagnostics().errors();
        auto rows = readResultTable(c.folder(), file, Completeness::wholeRows, c.diagnostics());
        if (c.diagnostics().errors() == before) peers.insert(peers.end(), rows.begin(), rows.end());
    }
    return peers;
}

void CaseSweep::checkRuns()
{
    const ScratchFolder scratch(runFolder_);
    copyInputs(plan_.baseCase, scratch.copy(), !packs());
    for (const auto& mistake : checkCase(scratch.copy(), programs()).mistakes) baseMistakes_.insert(mistake);

    std::vector<std::string> stamps{fmt::format("repeats {}", plan_.repeats)};
    for (const auto& step : steps_)
    {
        stamps.insert(stamps.end(), step.command.begin() + 1, step.command.end());
        stamps.push_back(fileStamp(step.command.front()));
    }
    for (const auto& choice : plan_.errors)
        if (choice.averageFrom) stamps.push_back("averageFrom " + shortestText(*choice.averageFrom));
    // A variant more, or another code's rows, change no run.
    std::vector<std::string> noInputs{sweepDictionary};
    for (const auto& file : plan_.peers) noInputs.push_back(fs::path(file).lexically_normal().string());
    for (auto& run : runs_)
    {
        copyInputs(plan_.baseCase, scratch.copy(), !packs());
        const auto before = case_.diagnostics().errors();
        checkOverrides(run);
        apply(run.plan.overrides, scratch.copy(), case_.diagnostics());
        if (case_.diagnostics().errors() > before) continue;
        run.inputs = inputsStamp(scratch.copy(), noInputs, stamps);
        const auto check = checkCase(scratch.copy(), programs());
        run.spacing = check.spacing;
        run.endTime = check.endTime;
        reportMistakes(run, scratch.copy(), check.mistakes);
        checkErrors(run, scratch.copy(), check.mistakes.empty());
    }
}

/// In files that some step reads whole an entry may be new: whether it is known there is found when the copy is read.
void CaseSweep::checkOverrides(const Run& run)
{
    const auto whole = filesReadWhole(programs());
    for (const auto& o : run.plan.overrides)
        if (std::ranges::find(whole, o.file) == whole.end() && placeOf(o, plan_.baseCase).line == 0)
            case_.diagnostics().error(o.where, fmt::format("{} has no entry \"{}\"", o.file, o.entry()));
}

void CaseSweep::reportMistakes(const Run& run, const fs::path& copy, const std::vector<std::string>& mistakes)
{
    auto& diagnostics = case_.diagnostics();
    for (const auto& mistake : mistakes)
    {
        const auto [where, what] = placeAndText(mistake);
        if (baseMistakes_.contains(mistake))
        {
            diagnostics.error(where, what);
            continue;
        }
        // The last override of a line decides: a variant's stands behind that of setResolution.
        const auto& all = run.plan.overrides;
        const auto guilty = std::find_if(all.rbegin(), all.rend(),
                                         [&](const Override& o)
                                         {
                                             const auto place = placeOf(o, copy);
                                             return place.file == where.file && place.line > 0 && place.line == where.line;
                                         });
        if (guilty != all.rend()) diagnostics.error(guilty->where, fmt::format("{}: {}", guilty->file, what));
        else
            diagnostics.error(run.plan.where,
                              fmt::format("with variant {} at n = {}: {}", run.plan.variant, shortestText(run.plan.resolution), mistake));
    }
}

void CaseSweep::checkErrors(const Run& run, const fs::path& copy, bool endIsKnown)
{
    auto& diagnostics = case_.diagnostics();
    const auto functions = Dictionary::read(copy, "system/controlDict", std::make_shared<Diagnostics>()).subDictOrEmpty("functions");
    std::vector<std::string> known;
    for (const auto& key : functions.keys())
        if (functions.isDictionary(key) && functions.subDict(key).get("type", "") == "errors") known.push_back(key);
    for (std::size_t k = 0; k < plan_.errors.size(); ++k)
    {
        const auto& choice = plan_.errors[k];
        if (std::ranges::find(known, choice.function) == known.end())
        {
            diagnostics.error(choice.whereFunction, fmt::format("system/controlDict has no function object \"{}\" of type errors. {}",
                                                                choice.function, suggestion(choice.function, "ones", known)));
            continue;
        }
        const auto fields = errorFields(functions.subDict(choice.function));
        if (std::ranges::find(fields, choice.field) == fields.end())
            diagnostics.error(choice.whereField, fmt::format("function object {} compares no field \"{}\". {}", choice.function,
                                                             choice.field, suggestion(choice.field, "fields", fields)));
        if (endIsKnown && choice.time && *choice.time > run.endTime && !sameTime(*choice.time, run.endTime))
            diagnostics.error(choice.whereTime, fmt::format("time {} is after the end of the run, endTime {}", shortestText(*choice.time),
                                                            shortestText(run.endTime)));
        if (endIsKnown && !choice.time && !std::isfinite(run.endTime))
            diagnostics.error(choice.whereTime, "system/controlDict gives no endTime: say which time is meant, as `time 1;`");
        for (std::size_t other = 0; other < k; ++other)
            if (stemOf(other) == stemOf(k)) diagnostics.error(choice.whereField, fmt::format("error {} is asked for twice", titleOf(k)));
    }
}

double CaseSweep::timeOf(const ErrorChoice& choice, const Run& run) const { return choice.time.value_or(run.endTime); }

bool CaseSweep::isFinal(const ResultRow& row) const
{
    // A failure may have been the machine's; a limit may have been raised.
    if (row.status == "timeLimit") return plan_.timeLimit && *plan_.timeLimit <= row.wallSeconds;
    return row.status != "failed";
}

void CaseSweep::takeOldRows()
{
    const auto old = readResultTable(case_.folder(), resultFile, Completeness::ownRows, case_.diagnostics());
    std::size_t used = 0;
    for (auto& run : runs_)
    {
        std::vector<ResultRow> rows;
        for (const auto& choice : plan_.errors)
            for (const auto& row : old)
                if (row.variant == run.plan.variant && row.resolution == run.plan.resolution && row.inputs == run.inputs &&
                    row.field == choice.field && row.norm == choice.norm && sameTime(row.time, timeOf(choice, run)) && isFinal(row))
                {
                    rows.push_back(row);
                    break;
                }
        if (rows.size() < plan_.errors.size()) continue;
        run.rows = std::move(rows);
        used += run.rows.size();
    }
    keepOld_ = used < old.size();
}

std::vector<ResultRow> CaseSweep::rowsOf(std::size_t error) const
{
    std::vector<ResultRow> rows;
    for (const auto& variant : plan_.variants)
        for (const auto& run : runs_)
            if (run.plan.variant == variant && !run.rows.empty()) rows.push_back(run.rows[error]);
    return rows;
}

std::vector<ResultRow> CaseSweep::peersOf(std::size_t error) const
{
    const auto& choice = plan_.errors[error];
    std::vector<ResultRow> rows;
    for (const auto& row : peers_)
        if (row.field == choice.field && row.norm == choice.norm &&
            (!std::isfinite(row.time) || sameTime(row.time, timeOf(choice, runs_.front()))))
            rows.push_back(row);
    return rows;
}

}
