#include "geometry/sphereTable.hpp"
#include "base/csv.hpp"
#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <optional>

namespace sph
{

namespace
{

using Cells = std::vector<std::string>;

std::string lowerCase(std::string word)
{
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return word;
}

Cells cellsOf(const std::string& line)
{
    if (line.find(',') != std::string::npos) return csvCells(line);
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

/// Where a row has its numbers.
struct Columns
{
    std::array<std::size_t, 3> centre{0, 1, 2};
    std::size_t radius = 3, count = 4;
    double toRadius = 1; ///< 0.5 where the column holds diameters
};

/// None where a name is missing.
std::optional<Columns> columnsNamed(Cells names)
{
    std::ranges::transform(names, names.begin(), lowerCase);
    const auto find = [&](const std::string& name) { return std::size_t(std::ranges::find(names, name) - names.begin()); };
    Columns c{{find("x"), find("y"), find("z")}, names.size(), names.size()};
    for (const auto& [name, toRadius] : {std::pair{"r", 1.0}, {"radius", 1.0}, {"d", 0.5}, {"diameter", 0.5}})
        if (const auto found = find(name); found < names.size() && c.radius == names.size())
        {
            c.radius = found;
            c.toRadius = toRadius;
        }
    return std::max({c.centre[0], c.centre[1], c.centre[2], c.radius}) < names.size() ? std::optional(c) : std::nullopt;
}

class Reader
{
    const std::string& file_;
    Diagnostics& diagnostics_;
    Columns columns_;
    int mistakes_ = 0;
    std::vector<TableSphere> spheres_;

    void error(int line, const std::string& what)
    {
        if (++mistakes_ <= 10) diagnostics_.error({file_, line}, what);
    }

    void nameColumns(const Cells& names, int line)
    {
        if (const auto found = columnsNamed(names)) columns_ = *found;
        else
            error(line, fmt::format("the columns \"{}\" name no sphere: x, y, z and one of r, radius, d, diameter are needed",
                                    fmt::join(names, ", ")));
    }

    void addRow(const Cells& cells, int line)
    {
        if (cells.size() != columns_.count) return error(line, fmt::format("{} cells under {} columns", cells.size(), columns_.count));
        std::array<double, 4> number{};
        const std::array<std::size_t, 4> places{columns_.centre[0], columns_.centre[1], columns_.centre[2], columns_.radius};
        for (std::size_t k = 0; k < 4; ++k)
        {
            const auto value = finiteNumber(cells[places[k]]);
            if (!value) return error(line, fmt::format("\"{}\" is no number", cells[places[k]]));
            number[k] = *value;
        }
        if (!(number[3] > 0)) return error(line, fmt::format("the sphere has the radius {}; it must be > 0", cells[columns_.radius]));
        spheres_.push_back({{number[0], number[1], number[2]}, columns_.toRadius * number[3], line});
    }

public:
    Reader(const std::string& file, Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

    std::vector<TableSphere> operator()(const std::string& text)
    {
        const std::string byteOrderMark = "\xEF\xBB\xBF"; // of spreadsheets' UTF-8
        std::istringstream in(text.starts_with(byteOrderMark) ? text.substr(byteOrderMark.size()) : text);
        bool isFirst = true, isHeader = false; // `isHeader`: of a dump, where no atoms stand
        int number = 0, times = 0;
        for (std::string line; std::getline(in, line);)
        {
            ++number;
            if (!line.empty() && line.back() == '\r') line.pop_back();
            const std::string atoms = "ITEM: ATOMS", time = "ITEM: TIMESTEP";
            if (line.starts_with(time) && ++times > 1)
            {
                error(number, "a second time of the dump begins here: keep one of them in the file");
                break;
            }
            if (line.starts_with("ITEM:"))
            {
                isHeader = !line.starts_with(atoms);
                if (!isHeader) nameColumns(cellsOf(line.substr(atoms.size())), number);
                isFirst = false;
                continue;
            }
            const auto cells = cellsOf(line);
            if (isHeader || line.starts_with('#') || cells.empty() || (cells.size() == 1 && cells[0].empty())) continue;
            const bool isNames = isFirst && std::ranges::none_of(cells, [](const auto& cell) { return finiteNumber(cell).has_value(); });
            isFirst = false;
            isNames ? nameColumns(cells, number) : addRow(cells, number);
            if (mistakes_ > 0 && isNames) break;
        }
        if (mistakes_ > 10) diagnostics_.error({file_, 0}, fmt::format("{} more rows are wrong", mistakes_ - 10));
        if (mistakes_ == 0 && spheres_.empty()) diagnostics_.error({file_, 0}, "there are no spheres in it");
        return std::move(spheres_);
    }
};

}

std::vector<TableSphere> spheresInTable(const std::string& text, const std::string& file, Diagnostics& diagnostics)
{
    return Reader(file, diagnostics)(text);
}

}
