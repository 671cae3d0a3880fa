/// Points sorted into cells, row by row with the last direction fastest: the cells next to one another along it are one run.
///
/// Where a plane of rows holds many points, rows come in bands of a few that go through all planes: what is near in space is then in a cache together,
/// whatever the size of the scene (test/benchmark/README.md).
///
/// Cells are at least `side` wide. Where points are so scattered that such cells would outnumber them by far, only the cells that hold points are kept, as
/// a sorted list of their numbers in which a search bisects: memory is bounded by the number of points, and the cost of a search by how densely they lie,
/// whatever the extent of the scene.
#pragma once
#include "fields/FieldStore.hpp"
#include <span>
#include <vector>

namespace sph
{

template<int dim> class CellList
{
public:
    /// Sorts `count` points into cells; keeps the capacity of earlier builds.
    void build(const std::array<const double*, dim>& x, std::size_t count, double side);

    /// Points by cell; the order within a cell is that of the indices.
    const std::vector<int>& order() const { return order_; }
    /// The least coordinates of all, and how far they reach in the direction in which they reach farthest.
    const std::array<double, dim>& low() const { return low_; }
    double extent() const { return extent_; }

    struct Run
    {
        int begin, end;
    };
    using Cell = std::array<int, dim>;
    Cell cellOf(Vector<dim> x) const;
    /// The runs of sorted points that hold everything within `radius` of any point of the cell, at most (2 radius/side + 3)^(dim - 1).
    void runsAround(const Cell&, double radius, std::vector<Run>& runs) const;

private:
    std::array<double, dim> low_{}, width_{};
    double extent_ = 0;
    std::array<int, dim> n_{};
    std::vector<int> begin_, order_;
    std::vector<long> filled_; ///< numbers of the cells that hold points, to which begin_ then belongs; empty where every cell is kept
    /// Numbers of a row, by its place in the second direction: where the first plane has it, and how many rows on the next plane has its own.
    struct Row
    {
        int first, stride;
    };
    std::vector<Row> rows_; ///< empty where only filled cells are kept

    void orderRows(std::size_t count);
    void keepEveryCell(const std::array<const double*, dim>& x, std::size_t count, std::size_t cells);
    void keepFilledCells(const std::array<const double*, dim>& x, std::size_t count);
    long index(const Cell&) const;
    /// The first sorted point whose cell has this number or a higher one, where only filled cells are kept.
    int start(long cell) const;
};

}
