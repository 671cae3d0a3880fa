#include "figures/RunNumbers.hpp"
#include "base/csv.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryText.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <numeric>
#include <regex>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

struct Fact
{
    std::string name, meaning, pattern;
    bool largest = false; ///< of all reports, in place of the last
};

const std::vector<Fact>& facts()
{
    static const std::vector<Fact> all{
        {"steps", "steps", "^step ([0-9]+) "},
        {"deltaT", "last step [s]", "^step .* deltaT ([^ ]+) "},
        {"speed", "largest speed of a particle in the last report [m/s]", " max\\|U\\| +([^ ]+)"},
        {"largestSpeed", "largest speed of a particle in all reports [m/s]", " max\\|U\\| +([^ ]+)", true},
        {"energySupply", "largest energy over what the scene has supplied", "energy/supply ([^ ]+)", true},
        {"processorTime", "processor time of the solver [s]", "^ExecutionTime = ([^ ]+) s"},
        {"timeOfStep", "processor time of a step, without what comes before the first report [s]", ""}, // of two of them
        {"putBack", "particles that were put back from inside walls", "^Leaked: ([0-9]+) particles put back"},
        {"particles", "particles at the start", "^Particles *: *([0-9]+)"},
    };
    return all;
}

/// What the pattern finds, of each line that has it.
std::vector<double> numbersIn(const std::vector<std::string>& lines, const std::string& text)
{
    const std::regex pattern(text);
    std::vector<double> values;
    for (const auto& line : lines)
    {
        std::smatch found;
        if (std::regex_search(line, found, pattern)) values.push_back(finiteNumber(found[1]).value_or(NAN));
    }
    return values;
}

double reduce(const std::string& operation, const std::vector<double>& values)
{
    const auto n = double(values.size());
    if (operation == "count") return n;
    if (operation == "sum") return std::accumulate(values.begin(), values.end(), 0.0);
    if (values.empty()) return NAN;
    if (operation == "first") return values.front();
    if (operation == "last") return values.back();
    if (std::ranges::any_of(values, [](double a) { return std::isnan(a); })) return NAN; // what no comparison orders
    if (operation == "min") return *std::ranges::min_element(values);
    if (operation == "max") return *std::ranges::max_element(values);
    if (operation == "farthest") return *std::ranges::max_element(values, {}, [](double a) { return std::abs(a); });
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    if (operation == "mean") return mean;
    const double square = std::accumulate(values.begin(), values.end(), 0.0, [](double s, double a) { return s + a * a; }) / n;
    return operation == "rms" ? std::sqrt(square) : std::sqrt(std::max(square - mean * mean, 0.0));
}

double factOf(const std::vector<std::string>& log, const Fact& fact)
{
    const auto named = [](const char* name) { return std::ranges::find(facts(), name, &Fact::name)->pattern; };
    if (fact.name != "timeOfStep") return reduce(fact.largest ? "max" : "last", numbersIn(log, fact.pattern));
    const auto steps = numbersIn(log, named("steps")), times = numbersIn(log, named("processorTime"));
    return (reduce("last", times) - reduce("first", times)) / (reduce("last", steps) - reduce("first", steps));
}

/// A mistake at the entry of the dictionary where it is to be changed, if it is not there yet.
CaseError located(const CaseError& mistake, const Dictionary& dict)
{
    const std::string what = mistake.what();
    return what.starts_with(dict.location().file) ? mistake : CaseError(dict.location(), what);
}

/// A row for each column of the last row, but the first.
RunTable columnsOf(const RunTable& of)
{
    std::vector<std::vector<std::string>> rows;
    for (std::size_t k = 1; k < of.names().size() && of.size() > 0; ++k)
        rows.push_back({of.names()[k], of.cell(of.size() - 1, of.names()[k])});
    std::vector<int> lines(rows.size(), 0);
    return {of.file(), {"column", "value"}, std::move(rows), std::move(lines)};
}

}

const std::vector<std::pair<std::string, std::string>>& factsOfTheLog()
{
    static const auto all = []
    {
        std::vector<std::pair<std::string, std::string>> list;
        for (const auto& fact : facts()) list.emplace_back(fact.name, fact.meaning);
        return list;
    }();
    return all;
}

RunNumbers::RunNumbers(fs::path caseFolder, const PlannedRunFolder& run)
    : case_(std::move(caseFolder)), folder_((case_ / run.folder).lexically_normal()), words_(run.words), known_(run.constants)
{}

bool RunNumbers::isThere() const { return !day().empty(); }

std::string RunNumbers::day() const
{
    std::optional<fs::file_time_type> newest;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_, none))
        if (entry.path().filename().string().starts_with("log."))
            if (const auto time = entry.last_write_time(none); !newest || time > *newest) newest = time;
    if (!newest) return "";
    const auto time = std::chrono::system_clock::to_time_t(std::chrono::file_clock::to_sys(*newest));
    return fmt::format("{:%Y-%m-%d}", fmt::localtime(time));
}

const RunTable& RunNumbers::table(const std::string& pattern)
{
    const auto name = filledName(pattern, words_);
    if (const auto known = tables_.find(name); known != tables_.end()) return known->second;
    // Taken out first: one that is made of itself is not found.
    const auto derived = derived_.extract(name);
    return tables_.emplace(name, derived.empty() ? RunTable(case_, tableFile(case_, folder_, name)) : derive(derived.mapped()))
        .first->second;
}

/// Also that of a run that has failed, which may be what is to be shown.
std::string RunNumbers::log(const std::string& name) const
{
    const auto file = "log." + name;
    const auto shown = (folder_ / file).lexically_relative(case_).string();
    return fs::exists(folder_ / file) || !fs::exists(folder_ / (file + ".failed")) ? shown : shown + ".failed";
}

std::vector<std::string> RunNumbers::logs(const std::string& name) const
{
    const bool isPath = name.find('/') != name.npos, isOpen = name.ends_with('*');
    if (!isPath && !isOpen) return {log(name)};
    std::vector<std::string> files;
    const fs::path path(isPath ? name : "log." + name);
    auto beginning = path.filename().string();
    if (isOpen) beginning.pop_back();
    std::error_code none;
    for (const auto& folder : foldersOf({"", folder_.lexically_relative(case_) / path.parent_path(), {}, {}}, case_))
    {
        const auto first = files.size();
        for (const auto& entry : fs::directory_iterator(case_ / folder.folder, none))
            if (const auto file = entry.path().filename().string(); isOpen ? file.starts_with(beginning) : file == beginning)
                files.push_back((folder.folder / file).lexically_normal().string());
        std::sort(files.begin() + std::ptrdiff_t(first), files.end());
    }
    return files;
}

const std::optional<std::vector<std::string>>& RunNumbers::linesOfLog(const std::string& file)
{
    const auto [known, isNew] = linesOfLogs_.try_emplace(file);
    if (!isNew) return known->second;
    if (std::ifstream in(case_ / file); in)
    {
        auto& lines = known->second.emplace();
        for (std::string line; std::getline(in, line);) lines.push_back(line);
    }
    return known->second;
}

RunTable RunNumbers::logged(const NumberPlan& plan)
{
    std::regex pattern;
    try
    {
        pattern.assign(filledName(plan.pattern, words_));
    }
    catch (const std::regex_error& mistake)
    {
        throw CaseError(plan.dict.where("pattern"), fmt::format("\"{}\" is no regular expression: {}", plan.pattern, mistake.what()));
    }
    if (pattern.mark_count() != plan.columns.size())
        throw CaseError(plan.dict.where("pattern"),
                        fmt::format("the pattern has {} groups ( ) and {} names of columns", pattern.mark_count(), plan.columns.size()));
    const auto files = logs(filledName(plan.log, words_));
    std::vector<std::vector<std::string>> rows;
    std::vector<int> lines;
    for (const auto& file : files)
    {
        const auto& log = linesOfLog(file);
        if (!log) throw CaseError(plan.dict.where("pattern"), fmt::format("{} is not there", file));
        int number = 0;
        for (const auto& line : *log)
        {
            ++number;
            std::smatch found;
            if (!std::regex_search(line, found, pattern)) continue;
            rows.emplace_back(found.begin() + 1, found.end());
            lines.push_back(number);
        }
    }
    return {files.empty() ? plan.log : files.back(), plan.columns, std::move(rows), std::move(lines)};
}

std::optional<double> RunNumbers::ofTheLog(const std::string& name)
{
    const auto fact = std::ranges::find(facts(), name, &Fact::name);
    if (fact == facts().end()) return {};
    if (const auto told = told_.find(name); told != told_.end()) return told->second;
    const auto& lines = linesOfLog(log("sphFoamLike"));
    if (!lines) return NAN;
    return told_[name] = factOf(*lines, *fact);
}

/// A table of what the number asks for, with a row for each log that tells it.
RunTable RunNumbers::toldByLogs(const NumberPlan& plan)
{
    std::vector<Fact> asked;
    for (const auto& fact : facts())
        if ((plan.value + plan.where).find("$" + fact.name) != std::string::npos) asked.push_back(fact);
    std::vector<std::string> names;
    for (const auto& fact : asked) names.push_back(fact.name);
    std::vector<std::vector<std::string>> rows;
    for (const auto& file : logs(filledName(plan.log, words_)))
    {
        const auto& lines = linesOfLog(file);
        if (!lines) throw CaseError(plan.dict.where("log"), fmt::format("{} is not there", file));
        auto& row = rows.emplace_back();
        for (const auto& fact : asked) row.push_back(fmt::format("{}", factOf(*lines, fact)));
    }
    std::vector<int> lines(rows.size(), 0);
    return {"log." + plan.log, std::move(names), std::move(rows), std::move(lines)};
}

RunTable RunNumbers::derive(const DerivedTablePlan& plan)
{
    try
    {
        const auto& of = table(plan.table);
        return plan.type == "crossings" ? crossings(plan, of) : columnsOf(of);
    }
    catch (const CaseError& mistake)
    {
        throw located(mistake, plan.dict);
    }
}

/// A row for each change of sign. It lies between the rows around it that have a value other than 0.
RunTable RunNumbers::crossings(const DerivedTablePlan& plan, const RunTable& of)
{
    const auto all = of.allRows();
    const auto value = evaluate(plan.value, plan.dict, "value", &of, all, {}),
               along = evaluate(plan.along, plan.dict, "along", &of, all, {});
    std::vector<std::vector<std::string>> rows;
    double peak = NAN, placeBefore = NAN;
    std::size_t before = 0;
    for (const auto k : all)
    {
        if (!(std::abs(value[k]) > 0)) continue;
        if (value[before] * value[k] < 0)
        {
            const double place = along[before] + (along[k] - along[before]) * value[before] / (value[before] - value[k]);
            rows.push_back({fmt::format("{}", rows.size() + 1), fmt::format("{}", place), fmt::format("{}", place - placeBefore),
                            fmt::format("{}", peak)});
            placeBefore = place;
            peak = 0;
        }
        if (!rows.empty()) peak = std::max(peak, std::abs(value[k]));
        before = k;
    }
    std::vector<int> lines(rows.size(), 0);
    return {of.file(), {"number", "place", "interval", "peak"}, std::move(rows), std::move(lines)};
}

/// An entry as a table of one row; a dimensioned number has its dimensions in front, `mu [1 -1 -1 0 0 0 0] 1e-3;`.
RunTable RunNumbers::entryOf(const NumberPlan& plan) const
{
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto shown = (folder_ / plan.file).lexically_relative(case_).string();
    auto text = valueText(Dictionary::read(case_, shown, diagnostics), plan.entry);
    diagnostics->throwIfAny();
    if (text.find('(') == text.npos) text.erase(0, text.find_last_of(' ') + 1);
    return {shown, {"value"}, {{text}}, {0}};
}

std::optional<double> RunNumbers::number(const std::string& name)
{
    if (const auto known = known_.find(name); known != known_.end()) return known->second;
    return ofTheLog(name);
}

std::vector<double> RunNumbers::evaluate(const std::string& text, const Dictionary& dict, const std::string& key, const RunTable* of,
                                         const Rows& rows, const Columns& more, bool* usesColumns)
{
    std::deque<RunTable::Column> columns;
    std::vector<ExpressionProgram::Values> values;
    const auto kindOf = [&](const std::string& name)
    {
        if (const auto looked = more.find(name); looked != more.end())
        {
            values.push_back({{looked->second.data()}, {}});
            if (usesColumns) *usesColumns = true;
            return ExpressionProgram::Kind::number;
        }
        if (const auto known = known_.find(name); known == known_.end() && of)
            if (auto column = of->find(name, rows))
            {
                const auto& kept = columns.emplace_back(std::move(*column));
                values.push_back({{kept.value[0].data(), kept.value[1].data(), kept.value[2].data()}, {}});
                if (usesColumns) *usesColumns = true;
                return kept.kind;
            }
        if (const auto one = number(name))
        {
            values.push_back({{}, {*one, 0, 0}});
            return ExpressionProgram::Kind::number;
        }
        std::vector<std::string> names = of ? of->names() : std::vector<std::string>{};
        for (const auto& [each, value] : known_) names.push_back(each);
        for (const auto& fact : facts()) names.push_back(fact.name);
        throw ExpressionError(
            fmt::format("{}has no column or number \"{}\". {}", of ? of->file() + " " : "", name, suggestion(name, "names", names)));
    };
    try
    {
        const ExpressionProgram program(text, kindOf);
        if (program.kind() == ExpressionProgram::Kind::vector)
            throw ExpressionError("the value is a vector: take a component, as $momentum_x, or mag()");
        // Without a table there is one value.
        std::vector<double> result(of ? rows.size() : 1);
        if (!result.empty()) program(0, result.size(), values, {result.data(), nullptr, nullptr});
        return result;
    }
    catch (const ExpressionError& mistake)
    {
        throw CaseError(dict.where(key), fmt::format("\"{}\": {}", text, mistake.what()));
    }
}

std::vector<std::optional<double>> RunNumbers::lookUp(const LookUpPlan& plan, const RunTable& of, const Rows& rows, const Columns& more)
{
    const auto at = evaluate(plan.at, plan.dict, "at", &of, rows, more);
    std::vector<std::optional<double>> found(rows.size());
    std::string last;
    std::vector<double> key, value;
    std::size_t next = 0;
    const auto pattern = filledName(plan.table, words_);
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        // <column> in the name of the table is this row's cell.
        auto name = pattern;
        for (auto open = name.find('<'); open != name.npos; open = name.find('<'))
        {
            const auto close = std::min(name.find('>', open), name.size() - 1);
            name.replace(open, close - open + 1, of.cell(rows[k], name.substr(open + 1, close - open - 1)));
        }
        if (name != last || last.empty())
        {
            const auto& other = table(name);
            const auto theirs = other.select(plan.select);
            key = evaluate(plan.key, plan.dict, "key", &other, theirs, {});
            value = evaluate(plan.value, plan.dict, "value", &other, theirs, {});
            last = name;
            next = 0;
        }
        if (plan.exact)
        {
            // Rows come in the order of the other table: a path that turns back has a strain twice.
            for (std::size_t turn = 0; turn < key.size() && !found[k]; ++turn, next = (next + 1) % key.size())
                if (std::abs(key[next] - at[k]) <= 1e-8 * std::abs(at[k])) found[k] = value[next];
            continue;
        }
        for (std::size_t l = 0; l + 1 < key.size() && !found[k]; ++l)
            if ((key[l] - at[k]) * (key[l + 1] - at[k]) <= 0 && key[l] != key[l + 1])
                found[k] = value[l] + (at[k] - key[l]) / (key[l + 1] - key[l]) * (value[l + 1] - value[l]);
    }
    return found;
}

void RunNumbers::keepWhere(const std::string& text, const Dictionary& dict, const RunTable& of, Rows& rows, Columns& more)
{
    if (text.empty()) return;
    const auto keep = evaluate(text, dict, "where", &of, rows, more);
    const auto chosen = [&](auto& list)
    {
        std::size_t n = 0;
        for (std::size_t k = 0; k < keep.size(); ++k)
            if (keep[k] != 0 && !std::isnan(keep[k])) list[n++] = list[k];
        list.resize(n);
    };
    for (auto& [name, column] : more) chosen(column);
    chosen(rows);
}

double RunNumbers::reduced(const NumberPlan& plan, const RunTable* of, std::optional<Rows> only)
{
    if (!of) return evaluate(plan.value, plan.dict, "value", nullptr, {}, {}).front();
    auto rows = only ? *only : of->select(plan.select);
    Columns more;
    for (const auto& l : plan.lookUps)
    {
        const auto found = lookUp(l, *of, rows, more);
        Rows kept;
        Columns keptMore;
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (found[k])
            {
                kept.push_back(rows[k]);
                for (const auto& [name, column] : more) keptMore[name].push_back(column[k]);
                keptMore[l.name].push_back(*found[k]);
            }
        keptMore[l.name];
        rows = std::move(kept);
        more = std::move(keptMore);
    }
    keepWhere(plan.where, plan.dict, *of, rows, more);
    bool usesColumns = false;
    const auto values = evaluate(plan.value, plan.dict, "value", of, rows, more, &usesColumns);
    // A formula of numbers has a value whatever the rows of the table are.
    if (!usesColumns && plan.operation != "count") return evaluate(plan.value, plan.dict, "value", nullptr, {}, {}).front();
    return reduce(plan.operation, values);
}

double RunNumbers::operator()(const NumberPlan& plan)
{
    if (!plan.file.empty())
    {
        const auto rows = entryOf(plan);
        return reduced(plan, &rows);
    }
    if (!plan.pattern.empty() || plan.ofLogs)
    {
        const auto rows = plan.ofLogs ? toldByLogs(plan) : logged(plan);
        return reduced(plan, &rows);
    }
    try
    {
        if (plan.table.empty()) return reduced(plan, nullptr);
        // A value that has no column needs no table.
        return reduced(plan, &table(plan.table));
    }
    catch (const CaseError& mistake)
    {
        throw located(mistake, plan.dict);
    }
}

double RunNumbers::operator()(const NumberPlan& plan, std::size_t row) { return reduced(plan, &table(plan.table), Rows{row}); }

void RunNumbers::add(const NumberPlan& plan) { known_[plan.name] = (*this)(plan); }

void RunNumbers::add(const DerivedTablePlan& plan) { derived_.emplace(plan.name, plan); }

std::vector<std::pair<std::size_t, double>> RunNumbers::lines(const LinesPlan& plan)
{
    const auto& of = table(plan.table);
    auto rows = of.select(plan.select);
    Columns none;
    keepWhere(plan.where, plan.dict, of, rows, none);
    std::vector<double> numbered(rows.size());
    std::iota(numbered.begin(), numbered.end(), 1);
    const auto places = evaluate(plan.of, plan.dict, "of", &of, rows, {{"line", numbered}});
    std::vector<std::pair<std::size_t, double>> lines;
    double next = places.empty() ? 0 : places.front();
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        if (plan.every > 0 && places[k] < next - 1e-9 * plan.every) continue;
        lines.emplace_back(rows[k], places[k]);
        if (plan.every > 0) next = plan.every * (std::floor(places[k] / plan.every + 1e-9) + 1);
    }
    return lines;
}

}
