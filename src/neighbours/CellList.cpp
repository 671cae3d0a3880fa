#include "neighbours/CellList.hpp"
#include <algorithm>
#include <numeric>

namespace sph
{

namespace
{
/// Points in a plane of rows beyond which rows come in bands: the records of five planes then take 10 MB and more.
constexpr std::size_t manyInPlane = 1 << 15;
/// Rows of a band.
constexpr int bandRows = 16;
/// Cells grow where a row would have more of them than an int holds, or all of them more than a long.
constexpr double mostInRow = 1e9, mostNumbers = 4e18;
}

template<int dim> void CellList<dim>::build(const std::array<const double*, dim>& x, std::size_t count, double side)
{
    std::array<double, dim> extent{};
    for (int c = 0; c < dim; ++c)
    {
        low_[c] = extent[c] = 0;
        if (count == 0) continue;
        double low = x[c][0], high = low;
#pragma omp parallel for schedule(static) reduction(min : low) reduction(max : high)
        for (std::size_t i = 0; i < count; ++i)
        {
            low = std::min(low, x[c][i]);
            high = std::max(high, x[c][i]);
        }
        low_[c] = low;
        extent[c] = high - low;
    }
    const auto cells = [&](double s)
    {
        double product = 1;
        for (double e : extent) product *= std::max(1.0, std::floor(e / s));
        return product;
    };
    extent_ = *std::max_element(extent.begin(), extent.end());
    while (extent_ / side > mostInRow || cells(side) > mostNumbers) side *= 1.5;
    for (int c = 0; c < dim; ++c)
    {
        n_[c] = std::max(1, int(extent[c] / side));
        width_[c] = std::max(side, extent[c] / n_[c]);
    }
    order_.resize(count);
    filled_.clear();
    rows_.clear();
    if (cells(side) > 4 * double(count) + 1000) keepFilledCells(x, count);
    else keepEveryCell(x, count, std::size_t(cells(side)));
}

template<int dim> void CellList<dim>::keepEveryCell(const std::array<const double*, dim>& x, std::size_t count, std::size_t cells)
{
    begin_.assign(cells + 1, 0);
    orderRows(count);
    std::vector<int> cellOfPoint(count);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < count; ++i)
    {
        const auto p = valueAt<Vector<dim>>(x, i);
        cellOfPoint[i] = int(index(cellOf(p)));
    }
    for (std::size_t i = 0; i < count; ++i) ++begin_[cellOfPoint[i] + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    for (std::size_t i = 0; i < count; ++i) order_[begin_[cellOfPoint[i]]++] = int(i);
    std::copy_backward(begin_.begin(), begin_.end() - 1, begin_.end());
    begin_[0] = 0;
}

template<int dim> void CellList<dim>::keepFilledCells(const std::array<const double*, dim>& x, std::size_t count)
{
    std::vector<std::pair<long, int>> byCell(count);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < count; ++i)
    {
        const auto p = valueAt<Vector<dim>>(x, i);
        byCell[i] = {index(cellOf(p)), int(i)};
    }
    std::sort(byCell.begin(), byCell.end());
    begin_.clear();
    for (std::size_t k = 0; k < count; ++k)
    {
        order_[k] = byCell[k].second;
        if (!filled_.empty() && filled_.back() == byCell[k].first) continue;
        filled_.push_back(byCell[k].first);
        begin_.push_back(int(k));
    }
    begin_.push_back(int(count));
}

template<int dim> void CellList<dim>::orderRows(std::size_t count)
{
    if constexpr (dim == 3)
    {
        const int rows = n_[1], inBand = count / std::size_t(n_[0]) > manyInPlane ? bandRows : rows;
        rows_.resize(std::size_t(rows));
        for (int row = 0; row < rows; ++row)
        {
            const int band = row / inBand * inBand;
            rows_[std::size_t(row)] = {band * n_[0] + row - band, std::min(inBand, rows - band)};
        }
    }
}

template<int dim> long CellList<dim>::index(const Cell& a) const
{
    if constexpr (dim == 2) return long(a[0]) * n_[1] + a[1];
    else
    {
        const Row row = rows_.empty() ? Row{a[1], n_[1]} : rows_[std::size_t(a[1])];
        return (row.first + long(a[0]) * row.stride) * n_[2] + a[2];
    }
}

template<int dim> int CellList<dim>::start(long cell) const
{
    return begin_[std::size_t(std::lower_bound(filled_.begin(), filled_.end(), cell) - filled_.begin())];
}

template<int dim> typename CellList<dim>::Cell CellList<dim>::cellOf(Vector<dim> x) const
{
    Cell a;
    store(x, [&](int c, double q) { a[c] = std::clamp(int((q - low_[c]) / width_[c]), 0, n_[c] - 1); });
    return a;
}

template<int dim> void CellList<dim>::runsAround(const Cell& a, double radius, std::vector<Run>& runs) const
{
    runs.clear();
    Cell first, last;
    for (int c = 0; c < dim; ++c)
    {
        const int reach = int(std::ceil(radius / width_[c]));
        first[c] = std::max(0, a[c] - reach);
        last[c] = std::min(n_[c] - 1, a[c] + reach);
    }
    const auto add = [&](const Cell& row)
    {
        const long number = index(row), beyond = number + last[dim - 1] - first[dim - 1] + 1;
        const Run run = filled_.empty() ? Run{begin_[std::size_t(number)], begin_[std::size_t(beyond)]} : Run{start(number), start(beyond)};
        if (run.begin < run.end) runs.push_back(run);
    };
    Cell b = first;
    for (; b[0] <= last[0]; ++b[0])
    {
        if constexpr (dim == 2) add(b);
        else
            for (b[1] = first[1]; b[1] <= last[1]; ++b[1]) add(b);
    }
}

template class CellList<2>;
template class CellList<3>;

}
