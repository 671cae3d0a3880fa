#include "case/OutputTable.hpp"
#include <cassert>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

OutputTable::OutputTable(const std::filesystem::path& path, const std::vector<std::string>& header, const std::vector<Column>& columns)
    : file_(path), columns_(columns.size())
{
    for (const auto& line : header) file_.write(fmt::format("# {}\n", line));
    for (const auto& column : columns)
        if (!column.meaning.empty()) file_.write(fmt::format("# {}\n", column.text()));
    file_.write("# Time");
    for (const auto& column : columns) file_.write("\t" + column.name);
    file_.write("\n");
    file_.flush();
}

void OutputTable::row(double time, std::span<const std::string> cells)
{
    assert(cells.size() == columns_);
    file_.write(time, 0);
    for (const auto& text : cells)
    {
        file_.write("\t");
        file_.write(text);
    }
    file_.write("\n");
    file_.flush();
}

void OutputTable::row(double time, std::span<const double> values)
{
    std::vector<std::string> cells;
    for (const double value : values) cells.push_back(cell(value));
    row(time, std::span<const std::string>(cells));
}

void TableRow::add(const Column& column, std::string text)
{
    columns.push_back(column);
    cells.push_back(std::move(text));
}
void TableRow::add(const Column& column, double value) { add(column, cell(value)); }
void TableRow::add(const Column& column, Vector<3> value) { add(column, cell(value)); }

std::string cell(double value) { return shortestText(value); }

std::string cell(Vector<3> a) { return fmt::format("({} {} {})", cell(a.x), cell(a.y), cell(a.z)); }

}
