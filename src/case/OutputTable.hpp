/// The .dat file of a function object, laid out as OpenFOAM's: header lines from `#`, the column `# Time` first, tabs between columns.
#pragma once
#include "base/OutputFile.hpp"
#include "base/Vector.hpp"
#include <span>
#include <string>
#include <vector>

namespace sph
{

class OutputTable
{
    OutputFile file_;
    std::size_t columns_;

public:
    /// `header`: lines above the names of the columns, without their `#`. `columns`: names without `Time`.
    OutputTable(const std::filesystem::path&, const std::vector<std::string>& header, const std::vector<std::string>& columns);

    /// Each row reaches the disk before the call returns: what a killed run has computed can still be plotted. Throws CaseError on a
    /// full disk.
    void row(double time, std::span<const std::string> cells);
    void row(double time, std::span<const double> values);
};

/// The shortest text that reads back to the same number, and "(x y z)".
std::string cell(double);
std::string cell(Vector<3>);

}
