/// Lines of comma-separated values.
#pragma once
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace sph
{

/// The cells of a line without the blanks around each; a comma within double quotes belongs to its cell.
std::vector<std::string> csvCells(const std::string& line);

/// The lines of a table that hold cells: empty ones and those that begin with `#` are left out.
class CsvLines
{
    std::istringstream in_;
    int number_ = 0;

public:
    explicit CsvLines(const std::string& text) : in_(text) {}
    /// The cells of the next line; none at the end.
    std::optional<std::vector<std::string>> next();
    /// Number of the line that was read last, from 1.
    int number() const { return number_; }
};

/// The number that the whole text is; none for "", "1e", "nan" and "inf".
std::optional<double> finiteNumber(const std::string& text);

/// Equal as numbers where both are numbers (1e-6 is 1.0e-06), as words otherwise.
bool sameCell(const std::string& cell, const std::string& wanted);

}
