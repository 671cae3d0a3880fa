#include "base/csv.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>

namespace sph
{

std::vector<std::string> csvCells(const std::string& line)
{
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line)
        if (c == '"') quoted = !quoted;
        else if (c == ',' && !quoted) cells.emplace_back();
        else if (c != '\r') cells.back() += c;
    for (auto& cell : cells)
    {
        cell.erase(0, std::min(cell.find_first_not_of(" \t"), cell.size()));
        cell.erase(cell.find_last_not_of(" \t") + 1);
    }
    return cells;
}

std::optional<std::vector<std::string>> CsvLines::next()
{
    for (std::string line; std::getline(in_, line);)
    {
        ++number_;
        if (line.starts_with('#')) continue;
        if (auto cells = csvCells(line); cells.size() > 1 || !cells[0].empty()) return cells;
    }
    return {};
}

std::optional<double> finiteNumber(const std::string& text)
{
    double value;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

bool sameCell(const std::string& cell, const std::string& wanted)
{
    const auto a = finiteNumber(cell), b = finiteNumber(wanted);
    return a && b ? *a == *b : cell == wanted;
}

}
