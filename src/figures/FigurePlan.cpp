#include "figures/FigurePlan.hpp"
#include "base/csv.hpp"
#include "dictionary/DictionaryText.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <regex>

namespace sph
{

namespace entry
{
const SubDictionary tables{"tables", required, "tables of figures, in the order in which they are printed"},
    numbers{"numbers", notGiven, "numbers of a run that have no column of their own, for what stands below them"},
    derivedTables{"derivedTables", notGiven, "tables that are made of those of a run, called by these names"},
    select{"select", byScene("all rows"), "only the rows that have these words or numbers"};
const FreeName table{"<table>", "dictionary", "a table, called by this name"},
    number{"<number>", "dictionary", "a number, $<number> below it"},
    column{"<column>", "word or number", "what the column must hold, or several in round brackets"},
    constant{"<constant>", "number", "number of this run, $<constant> in its figures; of the other runs it has no value"};
const Choice type{"type",
                  {{"figures", "a line for each run or row, a column for each figure"},
                   {"workPrecision", "errors, orders and costs of a sweep, as workPrecision has written them"}},
                  "figures",
                  "what the table shows"};
const Choice derivation{
    "type",
    {{"crossings",
      "a row for each change of sign of `value`: its `number` from 1, its `place` along `along`, by proportion between two rows, and, but of the "
      "first, the `interval` since the crossing before and the `peak`, the largest magnitude within that interval"},
     {"columns", "a row for each column of the last row, but the first: its `column`, by name, and its `value`; of probes a row each"}},
    required,
    "what the rows are"};
const Text signal{"value", required, "expression of columns whose changes of sign are found"},
    along{"along", required, "expression of columns, increasing: \"$Time\""};
const Text against{"against", required,
                   "what the figures are held against: the head of the table, and the column `against` of run/results.csv"},
    nameOfRun{"name", byScene("the words in curly brackets, or the last folder"),
              "name of a run; <1> stands for the first of the words in curly brackets, or for the last folder"},
    folder{"folder", byScene("run/<name>"), "folder of the run"},
    nameOfLine{"name", required, "name of a line, with a format for the number `of`: \"t = %.1f\""},
    nameOfFigure{"name", required, "name of the figure with its unit: \"largest speed [m/s]\""},
    format{"format", "%.4g", "how the number is written, as printf has it"},
    value{"value", byScene("the value of the pattern or entry"), "expression of columns, numbers and constants by name"},
    where{"where", byScene("all rows"), "condition on the columns of a row"},
    of{"of", required, "expression of a row; $line is its number from 1"},
    table_{
        "table", byScene("that of the table, or none"),
        "whose columns are meant: a function object (`conservation`), one of its tables or start times (\"bottom/p\", \"errors/0.5\"), or a path in the folder of "
        "the run; <1> in it is the first of the run's words, in a look-up <column> the cell of a row"},
    pattern{"pattern", notGiven, "regular expression; each line of the log that has it is a row, each of its groups a column"},
    key{"key", required, "expression of the columns of the other table"}, at{"at", required, "expression of the columns of this one"},
    entry_{"entry", notGiven, "entry of `dictionary`, \"gas.mu\""};
const ListOf<std::string> runs{
    "runs", std::vector<std::string>{"."},
    "folders below run, paths of the case, and several at once by words in curly brackets, \"run/workPrecision/{a b}/{8 16}\"; {*} stands for all that are there"},
    columns{"columns", std::vector<std::string>{"value"}, "names of the groups of the pattern"};
const DictionaryList figures{"figures", required, "the columns"},
    runsByName{"named", notGiven, "runs with a name or constants of their own, behind those of `runs`"},
    lookUps{"lookUps", notGiven, "columns that come from other tables; a row for which they have none is left out"};
const SubDictionary lines{"lines", notGiven, "a line for each row of a table, in place of one for each run"};
const Text log{
    "log", "sphFoamLike",
    "log that the pattern is sought in, or that $steps .. are of, a row each of several: log.<name>, or a path from the run's folder; * stands for any "
    "folder, and at the end of a name for any ending"};
const Word dictionary{"dictionary", notGiven, "dictionary of the run"}, nameOfLookUp{"name", required, "of the column"};
const Text unit{"unit", "%", "of the errors of a sweep: % of the reference, or another unit for errors as they are"};
const Scalar every{"every", units::none, 0, nonNegative, "rows whose `of` is a multiple of this or the first above it; 0: all rows"};
const Switch recorded{"record", true, "append the figures to run/results.csv"};
const Choice match{"match",
                   {{"linear", "between two rows that follow one another, the first that have it between them"},
                    {"exact", "the next row that has it to 1e-8 of itself"}},
                   "linear",
                   "how `key` comes to `at`"};
const Choice operation{"operation",
                       {{"last", "value of the last row"},
                        {"first", "value of the first row"},
                        {"min", "the least value"},
                        {"max", "the largest value"},
                        {"farthest", "the value farthest from 0, with its sign"},
                        {"mean", "mean of the rows"},
                        {"rms", "root of the mean square"},
                        {"deviation", "root of the mean square distance from the mean"},
                        {"sum", "sum of the rows"},
                        {"count", "number of rows"}},
                       "last",
                       "what is made of the values of the rows; none where the value has no column"};
}

namespace
{

Selection readSelection(const Dictionary& d)
{
    Selection wanted;
    const auto select = entry::select(d);
    for (const auto& key : select.keys())
    {
        const auto text = valueText(select, key);
        wanted[key] = text.starts_with('(') ? select.get<std::vector<std::string>>(key) : std::vector{select.get<std::string>(key)};
    }
    return wanted;
}

NumberPlan readNumber(const Dictionary& d, const std::string& table)
{
    NumberPlan plan(d);
    plan.name = d.keyword();
    plan.operation = entry::operation(d);
    plan.pattern = entry::pattern(d, "");
    plan.log = entry::log(d);
    plan.ofLogs = entry::log.given(d) && plan.pattern.empty();
    plan.file = entry::dictionary(d, "");
    plan.entry = entry::entry_(d, "");
    plan.columns = entry::columns(d);
    plan.table = entry::table_(d, table);
    const bool hasValue = !plan.pattern.empty() || !plan.file.empty();
    if (hasValue) plan.value = entry::value(d, "$" + (plan.columns.empty() ? "value" : plan.columns.front()));
    else plan.value = entry::value.needed(d);
    if (!plan.file.empty() && plan.entry.empty()) entry::dictionary.error(d, "say which entry of it: `entry gas.mu;`");
    plan.where = entry::where(d, "");
    plan.select = readSelection(d);
    for (const auto& l : entry::lookUps(d))
        plan.lookUps.push_back({entry::nameOfLookUp(l), entry::table_.needed(l), entry::key(l), entry::at(l), entry::value.needed(l),
                                readSelection(l), entry::match(l) == "exact", l});
    return plan;
}

DerivedTablePlan readDerivedTable(const Dictionary& d, const std::string& table)
{
    DerivedTablePlan plan(d);
    plan.name = d.keyword();
    plan.type = entry::derivation(d);
    plan.table = entry::table_(d, table);
    if (plan.type != "crossings") return plan;
    plan.value = entry::signal(d);
    plan.along = entry::along(d);
    return plan;
}

NumberPlan readFigure(const Dictionary& d, const std::string& table)
{
    auto plan = readNumber(d, table);
    plan.isFigure = true;
    plan.name = entry::nameOfFigure(d);
    plan.unit = "-";
    if (const auto bracket = plan.name.rfind(" ["); bracket != plan.name.npos && plan.name.ends_with(']'))
    {
        plan.unit = plan.name.substr(bracket + 2, plan.name.size() - bracket - 3);
        plan.name.erase(bracket);
    }
    plan.format = entry::format(d);
    static const std::regex numberFormat("%[-+ #0]*[0-9]{0,3}(\\.[0-9]{1,3})?[defgEG]");
    if (!std::regex_match(plan.format, numberFormat))
        entry::format.error(d, fmt::format("\"{}\" is no format of one number: \"%.2f\", \"%+.1f\", \"%d\", \"%.3g\"", plan.format));
    if (plan.name.find_first_of(",\n") != plan.name.npos) entry::nameOfFigure.error(d, "a comma parts the columns of run/results.csv");
    return plan;
}

/// "rest" is run/rest, a path or pattern as it stands.
std::string folderOf(const std::string& text) { return text == "." || text.find('/') != text.npos ? text : "run/" + text; }

std::vector<PlannedRunFolder> readRuns(const Dictionary& d)
{
    std::vector<PlannedRunFolder> all;
    const auto named = entry::runsByName(d);
    const auto add = [&](const Dictionary& at, const Parameter& place, const std::string& text, const std::string& name)
    {
        try
        {
            for (auto [folder, words] : expandBraces(folderOf(text)))
            {
                for (const auto& part : std::filesystem::path(folder))
                    if (part != "*" && part.string().find('*') != std::string::npos)
                        throw std::invalid_argument(
                            fmt::format("\"{}\": {{*}} stands for a whole folder, not for a part of its name", text));
                std::string byWords;
                for (std::size_t k = 1; k <= words.size(); ++k) byWords += fmt::format("{}<{}>", k == 1 ? "" : " ", k);
                if (words.empty()) words = {folder == "." ? "base" : std::filesystem::path(folder).filename().string()};
                // A name without words of its own is what <1> stands for.
                if (byWords.empty() && !name.empty() && name.find('<') == name.npos) words = {name};
                all.push_back({!name.empty() ? name : byWords.empty() ? "<1>" : byWords, folder, words, {}});
            }
        }
        catch (const std::invalid_argument& mistake)
        {
            place.error(at, mistake.what());
        }
    };
    if (entry::runs.given(d) || named.empty())
        for (const auto& text : entry::runs(d)) add(d, entry::runs, text, entry::nameOfRun(d, ""));
    for (std::size_t k = 0; k < named.size(); ++k)
    {
        const auto& n = named[k];
        const auto first = all.size();
        // One without a keyword is called by its number.
        const bool hasKeyword = n.keyword() != std::to_string(k);
        add(n, entry::folder, hasKeyword ? entry::folder(n, n.keyword()) : entry::folder.needed(n),
            entry::nameOfRun(n, hasKeyword ? n.keyword() : ""));
        std::map<std::string, double> constants;
        for (const auto& key : n.keys())
            if (key != "name" && key != "folder") constants[key] = n.get<double>(key);
        for (auto run = first; run < all.size(); ++run) all[run].constants = constants;
    }
    for (const auto& run : all)
        if (run.name.find_first_of(",\n") != run.name.npos)
            d.error("runs", fmt::format("\"{}\": a comma parts the columns of run/results.csv", run.name));
    // What one run has all have: a run without it has no such value.
    std::map<std::string, double> names;
    for (const auto& run : all)
        for (const auto& [name, value] : run.constants) names[name] = NAN;
    for (auto& run : all) run.constants.insert(names.begin(), names.end());
    return all;
}

LinesPlan readLines(const Dictionary& d, const std::string& table)
{
    LinesPlan plan(d);
    plan.name = entry::nameOfLine(d);
    plan.of = entry::of(d);
    plan.table = table.empty() ? entry::table_.needed(d) : entry::table_(d, table);
    plan.where = entry::where(d, "");
    plan.every = entry::every(d);
    plan.select = readSelection(d);
    static const std::regex oneFormat("[^%]*%[-+ #0]*[0-9]{0,3}(\\.[0-9]{1,3})?[defgEG][^%]*");
    if (!std::regex_match(plan.name, oneFormat))
        entry::nameOfLine.error(d, fmt::format("\"{}\" has no format of one number: \"t = %.1f\"", plan.name));
    return plan;
}

TablePlan readTable(const Dictionary& d)
{
    TablePlan plan(d);
    plan.name = d.keyword();
    plan.recorded = entry::recorded(d);
    plan.against = entry::against(d);
    if (plan.recorded && plan.against.find_first_of(",\n") != plan.against.npos)
        entry::against.error(d, "a comma parts the columns of run/results.csv");
    plan.isSweep = entry::type(d) == "workPrecision";
    if (plan.isSweep)
    {
        plan.runs.push_back({"", entry::folder(d, "."), {}, {}});
        plan.unit = entry::unit(d);
        return plan;
    }
    plan.runs = readRuns(d);
    const auto table = entry::table_(d, "");
    if (entry::lines.given(d)) plan.lines = readLines(entry::lines(d), table);
    const auto rows = plan.lines ? plan.lines->table : table;
    const auto derived = entry::derivedTables(d);
    for (const auto& key : derived.keys()) plan.derivedTables.push_back(readDerivedTable(derived.subDict(key), table));
    const auto numbers = entry::numbers(d);
    for (const auto& key : numbers.keys()) plan.numbers.push_back(readNumber(numbers.subDict(key), table));
    for (const auto& f : entry::figures(d)) plan.figures.push_back(readFigure(f, rows));
    return plan;
}

}

std::vector<std::pair<std::string, std::vector<std::string>>> expandBraces(const std::string& pattern)
{
    const auto open = pattern.find('{');
    if (open == pattern.npos) return {{pattern, {}}};
    const auto close = pattern.find('}', open);
    if (close == pattern.npos) throw std::invalid_argument(fmt::format("\"{}\" has a curly bracket that is not closed", pattern));
    std::vector<std::pair<std::string, std::vector<std::string>>> all;
    const auto rest = expandBraces(pattern.substr(close + 1));
    std::istringstream words(pattern.substr(open + 1, close - open - 1));
    for (std::string word; words >> word;)
        for (const auto& [tail, further] : rest)
        {
            std::vector<std::string> put{word};
            put.insert(put.end(), further.begin(), further.end());
            all.emplace_back(pattern.substr(0, open) + word + tail, put);
        }
    return all;
}

std::string filledName(std::string name, const std::vector<std::string>& words)
{
    for (std::size_t k = 0; k < words.size(); ++k)
    {
        const auto mark = fmt::format("<{}>", k + 1);
        for (auto at = name.find(mark); at != name.npos; at = name.find(mark, at + words[k].size()))
            name.replace(at, mark.size(), words[k]);
    }
    return name;
}

std::vector<PlannedRunFolder> foldersOf(const PlannedRunFolder& run, const std::filesystem::path& caseFolder)
{
    auto found = run;
    std::filesystem::path above;
    std::size_t star = 0;
    for (auto part = run.folder.begin(); part != run.folder.end(); ++part)
    {
        if (*part != "*")
        {
            above /= *part;
            continue;
        }
        std::vector<std::string> names;
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(caseFolder / above, none))
            if (entry.is_directory(none) && !entry.path().filename().string().starts_with('.'))
                names.push_back(entry.path().filename().string());
        std::ranges::sort(names, {}, [](const std::string& name) { return std::pair(finiteNumber(name).value_or(-1), name); });
        while (star < found.words.size() && found.words[star] != "*") ++star;
        std::vector<PlannedRunFolder> all;
        for (const auto& name : names)
        {
            auto one = found;
            one.folder = above / name;
            for (auto rest = std::next(part); rest != run.folder.end(); ++rest) one.folder /= *rest;
            if (star < one.words.size()) one.words[star] = name;
            for (auto& each : foldersOf(one, caseFolder)) all.push_back(std::move(each));
        }
        return all;
    }
    found.name = filledName(run.name, run.words);
    return {found};
}

std::vector<TablePlan> readFigurePlan(const Dictionary& d)
{
    std::vector<TablePlan> plans;
    const auto tables = entry::tables(d);
    for (const auto& key : tables.keys()) plans.push_back(readTable(tables.subDict(key)));
    d.reportUnused();
    return plans;
}

NumberPlan readOneFigure(const Dictionary& d) { return readFigure(d, ""); }

EntryList figureEntries()
{
    using namespace entry;
    const EntryList number_{
        operation, value, table_,  {select, {column}}, where, {lookUps, {nameOfLookUp, table_, {select, {column}}, key, at, value, match}},
        pattern,   log,   columns, dictionary,         entry_};
    const EntryList ofFigures{runs,
                              nameOfRun,
                              {runsByName, {nameOfRun, folder, constant}},
                              table_,
                              {lines, {nameOfLine, of, table_, {select, {column}}, where, every}},
                              {derivedTables,
                               {{table, EntryList{{derivation, {{"crossings", {signal, along}}, {"columns", {}}}}, table_}}}},
                              {numbers, {{number, number_}}},
                              {figures, EntryList{nameOfFigure, format} + number_}};
    return {{tables, {{table, EntryList{against, recorded, {type, {{"figures", ofFigures}, {"workPrecision", {folder, unit}}}}}}}}};
}

}
