/// Shapes of a table that know their row, so that a message can name it.
#pragma once
#include "geometry/Shape.hpp"
#include <fmt/format.h>

namespace sph
{

struct TableRow
{
    std::string file; ///< empty: a list in a dictionary
    int number;       ///< line of the file, or place in the list from 1

    /// "constant/bed.csv:17", "sphere 17"
    std::string inWords() const { return fmt::format("{}{}", file.empty() ? "sphere " : file + ":", number); }
    /// Two rows of one table: "constant/bed.csv:17 and :23", "sphere 17 and 23"
    std::string inWordsWith(const TableRow& other) const
    {
        if (file != other.file) return inWords() + " and " + other.inWords();
        const auto [first, second] = std::minmax(number, other.number);
        return fmt::format("{} and {}{}", TableRow{file, first}.inWords(), file.empty() ? "" : ":", second);
    }
};

class HasRow
{
    TableRow row_;

public:
    explicit HasRow(TableRow row) : row_(std::move(row)) {}
    virtual ~HasRow() = default;
    const TableRow& row() const { return row_; }
};

/// A ball of a table; its periodic copies are of the same row.
template<class Ball> class ShapeOfRow final : public Ball, public HasRow
{
public:
    ShapeOfRow(Ball ball, TableRow row) : Ball(std::move(ball)), HasRow(std::move(row)) {}
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override
    {
        const auto moved = Ball::shifted(by);
        return std::make_unique<ShapeOfRow>(static_cast<const Ball&>(*moved), row());
    }
};

/// The row that a shape stands in; null where it is of no table.
inline const TableRow* rowOf(const Shape& shape)
{
    const auto* found = dynamic_cast<const HasRow*>(&shape);
    return found ? &found->row() : nullptr;
}

}
