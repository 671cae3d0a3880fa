#include "sweeps/ResultTable.hpp"
#include "base/OutputFile.hpp"
#include "base/csv.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace sph
{

namespace
{

enum class Range
{
    any,
    nonNegative,
    positive
};

struct NumberColumn
{
    std::string name;
    double ResultRow::*value;
    bool required;
    Range range;
};
struct WordColumn
{
    std::string name;
    std::string ResultRow::*value;
    bool required;
    const std::vector<std::string>& (*words)() = nullptr; ///< those possible; any where there is no such list
};

/// Names of the columns, in the order of the file.
const std::vector<std::string>& columnNames()
{
    static const auto names = []
    {
        std::vector<std::string> all;
        for (const auto& column : resultTable().columns) all.push_back(column.name);
        return all;
    }();
    return names;
}

const std::vector<NumberColumn>& numberColumns()
{
    using R = ResultRow;
    static const std::vector<NumberColumn> columns{{"resolution", &R::resolution, false, Range::positive},
                                                   {"spacing", &R::spacing, true, Range::positive},
                                                   {"nParticles", &R::nParticles, false, Range::nonNegative},
                                                   {"steps", &R::steps, false, Range::nonNegative},
                                                   {"cpuSeconds", &R::cpuSeconds, true, Range::nonNegative},
                                                   {"wallSeconds", &R::wallSeconds, false, Range::nonNegative},
                                                   {"peakMemory", &R::peakMemory, false, Range::nonNegative},
                                                   {"time", &R::time, false, Range::any},
                                                   {"error", &R::error, true, Range::nonNegative},
                                                   {"order", &R::order, false, Range::any}};
    return columns;
}

const std::vector<WordColumn>& wordColumns()
{
    using R = ResultRow;
    static const std::vector<WordColumn> columns{{"variant", &R::variant, true},
                                                 {"field", &R::field, true},
                                                 {"norm", &R::norm, true, errorNorms},
                                                 {"status", &R::status, false, resultStatuses},
                                                 {"inputs", &R::inputs, false}};
    return columns;
}

/// Mistake in a number, "" where there is none.
std::string mistakeIn(Range range, double value)
{
    if (range == Range::positive && !(value > 0)) return "must be greater than 0";
    if (range == Range::nonNegative && !(value >= 0)) return "must not be negative";
    return "";
}

bool readHeader(const std::vector<std::string>& header, const Location& here, Completeness wanted, Diagnostics& diagnostics)
{
    bool well = true;
    const auto fail = [&](const std::string& what)
    {
        diagnostics.error(here, what);
        well = false;
    };
    for (auto cell = header.begin(); cell != header.end(); ++cell)
    {
        if (std::ranges::find(columnNames(), *cell) == columnNames().end())
            fail(fmt::format("column \"{}\" is unknown. {}", *cell, suggestion(*cell, "columns", columnNames())));
        else if (std::find(header.begin(), cell, *cell) != cell) fail(fmt::format("column \"{}\" stands twice", *cell));
    }
    const auto require = [&](const auto& column)
    {
        if ((column.required || wanted == Completeness::ownRows) && std::ranges::find(header, column.name) == header.end())
            fail(fmt::format("column \"{}\" is missing", column.name));
    };
    for (const auto& column : wordColumns()) require(column);
    for (const auto& column : numberColumns()) require(column);
    return well;
}

/// A row, or nothing where a cell of it is wrong.
std::optional<ResultRow> readRow(const std::vector<std::string>& header, const std::vector<std::string>& cells, const Location& here,
                                 Completeness wanted, Diagnostics& diagnostics)
{
    const auto before = diagnostics.errors();
    const auto cellOf = [&](const std::string& name)
    {
        const auto at = std::ranges::find(header, name);
        return at == header.end() ? std::string() : cells[std::size_t(at - header.begin())];
    };
    ResultRow row;
    for (const auto& column : wordColumns())
    {
        const auto cell = cellOf(column.name);
        if (!cell.empty()) row.*column.value = cell;
        const auto& word = row.*column.value;
        if (word.empty() && column.required) diagnostics.error(here, fmt::format("\"{}\" is empty", column.name));
        if (!word.empty() && column.words && std::ranges::find(column.words(), word) == column.words().end())
            diagnostics.error(here, fmt::format("{} \"{}\" is unknown. {}", column.name, word,
                                                suggestion(word, column.name == "norm" ? "norms" : "statuses", column.words())));
    }
    for (const auto& column : numberColumns())
    {
        const auto cell = cellOf(column.name);
        if (cell.empty())
        {
            if (column.required && wanted == Completeness::wholeRows) diagnostics.error(here, fmt::format("\"{}\" is empty", column.name));
            continue;
        }
        const auto value = finiteNumber(cell);
        if (!value) diagnostics.error(here, fmt::format("\"{}\" in column {} is not a number", cell, column.name));
        else if (const auto mistake = mistakeIn(column.range, *value); !mistake.empty())
            diagnostics.error(here, fmt::format("{} is {} but {}", column.name, cell, mistake));
        else row.*column.value = *value;
    }
    if (diagnostics.errors() > before) return {};
    return row;
}

}

const std::vector<std::string>& resultStatuses()
{
    static const std::vector<std::string> statuses{"ok", "failed", "timeLimit", "diverged"};
    return statuses;
}

const std::vector<std::string>& errorNorms()
{
    static const std::vector<std::string> norms{"L1", "L2", "Linf", "mean", "rms"};
    return norms;
}

std::vector<ResultRow> readResultTable(const std::filesystem::path& folder, const std::string& file, Completeness wanted,
                                       Diagnostics& diagnostics)
{
    std::vector<ResultRow> rows;
    std::string reason;
    const auto text = readText(folder / file, reason);
    if (!text)
    {
        diagnostics.error({file, 0}, "cannot be read: " + reason);
        return rows;
    }
    CsvLines lines(*text);
    std::vector<std::string> header;
    bool any = false;
    while (const auto line = lines.next())
    {
        const auto& cells = *line;
        const Location here{file, lines.number()};
        if (header.empty())
        {
            header = cells;
            if (!readHeader(header, here, wanted, diagnostics)) return rows;
            continue;
        }
        any = true;
        if (cells.size() != header.size()) diagnostics.error(here, fmt::format("{} cells under {} columns", cells.size(), header.size()));
        else if (auto row = readRow(header, cells, here, wanted, diagnostics)) rows.push_back(*std::move(row));
    }
    if (header.empty()) diagnostics.error({file, 0}, fmt::format("has no line of column names: {}", list(columnNames())));
    else if (!any && wanted == Completeness::wholeRows) diagnostics.error({file, 0}, "has no rows");
    return rows;
}

TableInfo resultTable()
{
    return {"workPrecision",
            "results.csv",
            "a row an error of a run; cells of what is not known are empty",
            {{"variant", "", "variant of the case"},
             {"resolution", "-", "number that the sweep varies, spacings to a length"},
             {"spacing", "m", "spacing of the particles, or size of the cells of a grid"},
             {"nParticles", "-", "particles that the error rests on, or cells"},
             {"steps", "-", "time steps"},
             {"cpuSeconds", "s", "processor time of the solver"},
             {"wallSeconds", "s", "clock time of the solver"},
             {"peakMemory", "byte", "largest resident memory of the solver"},
             {"time", "s", "time that the error belongs to"},
             {"field", "", "field or measure"},
             {"norm", "", "L1, L2, Linf, or mean and rms over time"},
             {"error", "of the field", "or a share, as `norm` of the function object says"},
             {"order", "-", "observed, between the next coarser resolution of the variant and this one"},
             {"status", "", "ok, failed, timeLimit or diverged"},
             {"inputs", "", "stamp of all that the run was made from"}}};
}

std::string resultTableText(const std::vector<ResultRow>& rows)
{
    std::string text;
    for (const auto& name : columnNames()) text += (text.empty() ? "" : ",") + name;
    text += '\n';
    for (const auto& row : rows)
    {
        std::string line;
        for (const auto& name : columnNames())
        {
            if (name != columnNames().front()) line += ',';
            for (const auto& column : wordColumns())
                if (column.name == name) line += row.*column.value;
            for (const auto& column : numberColumns())
                if (column.name == name && std::isfinite(row.*column.value)) line += shortestText(row.*column.value);
        }
        text += line + '\n';
    }
    return text;
}

}
