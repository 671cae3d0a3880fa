/// The .dat file of a function object, laid out as OpenFOAM's: header lines from `#`, among them one for each column, the column `# Time` first, tabs between columns.
#pragma once
#include "base/Column.hpp"
#include "base/OutputFile.hpp"
#include "base/Vector.hpp"
#include <span>
#include <string>
#include <vector>

namespace sph
{

/// A row as it is made: cells, each with its column.
struct TableRow
{
    std::vector<Column> columns;
    std::vector<std::string> cells;

    void add(const Column&, std::string);
    void add(const Column&, double);
    void add(const Column&, Vector<3>);
};

class OutputTable
{
    OutputFile file_;
    std::size_t columns_;

public:
    /// `header`: lines above those of the columns, without their `#`. `columns`: those behind `Time`; one without a meaning has no line of its own.
    OutputTable(const std::filesystem::path&, const std::vector<std::string>& header, const std::vector<Column>& columns);

    /// Each row reaches the disk before the call returns: what a killed run has computed can still be plotted. Throws CaseError on a
    /// full disk.
    void row(double time, std::span<const std::string> cells);
    void row(double time, std::span<const double> values);
};

/// The shortest text that reads back to the same number, and "(x y z)".
std::string cell(double);
std::string cell(Vector<3>);

}
