/// Errors and costs of runs as comma-separated values: what workPrecision measures, and what other codes have measured.
#pragma once
#include "base/CaseError.hpp"
#include "base/Column.hpp"
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace sph
{

/// One error of one run. Numbers that are not known are NaN, an empty cell in the file.
struct ResultRow
{
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    std::string variant = {};
    double resolution = unknown;
    double spacing = unknown;     ///< [m]
    double nParticles = unknown;  ///< particles that the error rests on; cells of a grid code
    double steps = unknown;       ///< time steps
    double cpuSeconds = unknown;  ///< processor time of the solver [s]
    double wallSeconds = unknown; ///< [s]
    double peakMemory = unknown;  ///< largest resident memory of the solver [byte]
    double time = unknown;        ///< that the error belongs to [s]
    std::string field = {}, norm = {};
    double error = unknown;
    double order = unknown; ///< observed, between the next coarser resolution of the variant and this one
    std::string status = "ok";
    std::string inputs = {}; ///< stamp of all that the run was made from

    /// Has an error and a cost that a logarithmic plot can show.
    bool drawable() const { return status == "ok" && error > 0 && cpuSeconds > 0 && spacing > 0; }
};

/// The columns, in the order of the file.
TableInfo resultTable();
const std::vector<std::string>& resultStatuses();
const std::vector<std::string>& errorNorms();

/// Completeness of a file's rows: one that somebody else made must give in each variant, spacing, cpuSeconds, field, norm and error.
enum class Completeness
{
    ownRows,
    wholeRows
};

/// Reads a table; columns in any order, lines that begin with '#' are notes. A malformed row becomes an error with file and line.
std::vector<ResultRow> readResultTable(const std::filesystem::path& folder, const std::string& file, Completeness, Diagnostics&);

/// The table as text, all columns.
std::string resultTableText(const std::vector<ResultRow>&);

}
