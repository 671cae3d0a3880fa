/// Lines of comma-separated values.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace sph
{

/// The cells of a line without the blanks around each; a comma within double quotes belongs to its cell.
std::vector<std::string> csvCells(const std::string& line);

/// The number that the whole text is; none for "", "1e", "nan" and "inf".
std::optional<double> finiteNumber(const std::string& text);

}
