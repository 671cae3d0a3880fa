#include "figures/RunTable.hpp"
#include "base/CaseError.hpp"
#include "base/csv.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <sstream>

namespace sph
{

namespace
{

namespace fs = std::filesystem;

/// Cells of a table of a function object: parted by tabs, so that a vector is one; where there are none, by blanks outside of brackets.
std::vector<std::string> datCells(const std::string& line)
{
    const bool byTabs = line.find('\t') != line.npos;
    std::vector<std::string> cells(1);
    int depth = 0;
    for (const char c : line)
    {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (byTabs ? c == '\t' : c == ' ' && depth == 0)
        {
            if (byTabs || !cells.back().empty()) cells.emplace_back();
        }
        else if (c != '\r') cells.back() += c;
    }
    for (auto& cell : cells)
    {
        cell.erase(0, std::min(cell.find_first_not_of(' '), cell.size()));
        cell.erase(cell.find_last_not_of(' ') + 1);
    }
    if (cells.back().empty() && cells.size() > 1) cells.pop_back();
    return cells;
}

std::vector<std::string> namesIn(const fs::path& folder)
{
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

/// "stress.xx" of "stress.xx [Pa]"
std::string withoutUnit(const std::string& name)
{
    const auto bracket = name.rfind(" [");
    return bracket == name.npos || !name.ends_with(']') ? name : name.substr(0, bracket);
}

}

RunTable::RunTable(const fs::path& folder, const std::string& file) : file_(file)
{
    std::string reason;
    const auto text = readText(folder / file, reason);
    if (!text) throw CaseError({file, 0}, "cannot be read: " + reason);
    const bool isCsv = file.ends_with(".csv");
    std::istringstream in(*text);
    int number = 0;
    for (std::string line; std::getline(in, line);)
    {
        ++number;
        if (line.starts_with('#'))
        {
            if (!isCsv && rows_.empty()) names_ = datCells(line.substr(std::min(line.find_first_not_of("# "), line.size())));
            continue;
        }
        auto cells = isCsv ? csvCells(line) : datCells(line);
        if (cells.size() == 1 && cells[0].empty()) continue;
        if (isCsv && names_.empty())
        {
            names_ = std::move(cells);
            continue;
        }
        if (cells.size() != names_.size())
            throw CaseError({file, number}, fmt::format("{} cells under {} columns", cells.size(), names_.size()));
        rows_.push_back(std::move(cells));
        lines_.push_back(number);
    }
    if (names_.empty()) throw CaseError({file, 0}, "has no line with the names of columns");
}

bool RunTable::has(const std::string& name) const { return std::ranges::find(names_, name) != names_.end(); }

std::size_t RunTable::column(const std::string& name) const
{
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end())
        throw CaseError({file_, 0}, fmt::format("has no column \"{}\". {}", name, suggestion(name, "columns", names_)));
    return std::size_t(found - names_.begin());
}

std::vector<std::size_t> RunTable::allRows() const
{
    std::vector<std::size_t> rows(rows_.size());
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

std::vector<std::size_t> RunTable::select(const std::map<std::string, std::vector<std::string>>& wanted) const
{
    auto rows = allRows();
    for (const auto& [name, words] : wanted)
    {
        const auto c = column(name);
        std::erase_if(rows, [&](std::size_t row)
                      { return std::ranges::none_of(words, [&](const auto& word) { return sameCell(rows_[row][c], word); }); });
    }
    return rows;
}

const std::string& RunTable::cell(std::size_t row, const std::string& name) const { return rows_[row][column(name)]; }

std::optional<RunTable::Column> RunTable::find(const std::string& name, const std::vector<std::size_t>& rows) const
{
    const auto shorter = [](const std::string& text) { return text.substr(0, text.rfind('_')); };
    const auto known = [&](const std::string& text) -> std::string
    {
        if (has(text)) return text;
        for (const auto& each : names_)
            if (withoutUnit(each) == text) return each;
        return text.find('_') != text.npos && has(shorter(text)) ? shorter(text) : "";
    };
    auto found = known(name);
    int component = -1;
    if (const auto end = name.size() > 2 && name[name.size() - 2] == '_' ? name.back() : ' ';
        end >= 'x' && end <= 'z' && (found.empty() || found == shorter(name)))
    {
        found = known(shorter(name));
        component = end - 'x';
    }
    if (found.empty()) return {};
    const auto c = column(found);
    Column result;
    const bool isVector = std::ranges::any_of(rows, [&](std::size_t row) { return rows_[row][c].starts_with('('); });
    if (component >= 0 && !isVector && !rows.empty()) return {};
    if (isVector && component < 0) result.kind = ExpressionProgram::Kind::vector;
    for (const auto row : rows)
    {
        const auto& text = rows_[row][c];
        std::istringstream in(isVector && text.size() > 2 ? text.substr(1, text.size() - 2) : text);
        Vector<3> value{NAN, NAN, NAN};
        std::array<double*, 3> parts{&value.x, &value.y, &value.z};
        for (std::size_t k = 0; k < (isVector ? 3u : 1u); ++k)
        {
            std::string word;
            in >> word;
            const auto number = finiteNumber(word);
            if (!number && !word.empty() && !word.ends_with("nan") && !word.ends_with("inf"))
                throw CaseError({file_, lines_[row]},
                                fmt::format("column \"{}\" holds \"{}\", which is no number: rows are chosen by words with `select`", found,
                                            text));
            if (number) *parts[k] = *number;
        }
        if (component >= 0) result.value[0].push_back(*parts[std::size_t(component)]);
        else
            for (std::size_t k = 0; k < (isVector ? 3u : 1u); ++k) result.value[k].push_back(*parts[k]);
    }
    return result;
}

std::string tableFile(const fs::path& folder, const fs::path& run, const std::string& name)
{
    const auto shown = [&](const fs::path& path) { return path.lexically_relative(folder).string(); };
    for (const auto& path : {run / name, run / "postProcessing" / name})
        if (fs::is_regular_file(path)) return shown(path.lexically_normal());
    const auto objects = run / "postProcessing";
    const auto parts = fs::path(name);
    auto at = objects / *parts.begin();
    if (!fs::is_directory(at))
        throw CaseError(fmt::format("{}: there is no table \"{}\". {}", shown(objects), name,
                                    suggestion(parts.begin()->string(), "function objects and files", namesIn(objects))));
    auto rest = parts.lexically_relative(*parts.begin());
    if (rest == ".") rest.clear();
    // The last start time, unless one is named.
    auto times = namesIn(at);
    std::erase_if(times, [](const std::string& each) { return !finiteNumber(each); });
    std::ranges::sort(times, {}, [](const std::string& each) { return *finiteNumber(each); });
    if (!rest.empty() && std::ranges::find(times, rest.begin()->string()) != times.end())
    {
        at /= *rest.begin();
        rest = rest.lexically_relative(*rest.begin());
        if (rest == ".") rest.clear();
    }
    else if (!times.empty()) at /= times.back();
    const auto files = namesIn(at);
    const auto own = rest.empty() ? parts.begin()->string() : rest.string();
    for (const auto& file : files)
        if (file == own || fs::path(file).stem() == own || (rest.empty() && files.size() == 1)) return shown(at / file);
    throw CaseError(fmt::format("{}: there is no table \"{}\". {}", shown(at), name, suggestion(own, "tables", files)));
}

}
