#include "CellList.hpp"
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
    const double most = 4 * double(count) + 1000;
    const auto cells = [&](double s)
    {
        double product = 1;
        for (double e : extent) product *= std::max(1.0, std::floor(e / s));
        return product;
    };
    while (cells(side) > most) side *= 1.5;

    std::size_t total = 1;
    for (int c = 0; c < dim; ++c)
    {
        n_[c] = std::max(1, int(extent[c] / side));
        width_[c] = std::max(side, extent[c] / n_[c]);
        total *= n_[c];
    }
    begin_.assign(total + 1, 0);
    order_.resize(count);
    orderRows(count);
    std::vector<int> cellOfPoint(count);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < count; ++i)
    {
        const auto p = valueAt<Vector<dim>>(x, i);
        cellOfPoint[i] = index(cellOf(p));
    }
    for (std::size_t i = 0; i < count; ++i) ++begin_[cellOfPoint[i] + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    for (std::size_t i = 0; i < count; ++i) order_[begin_[cellOfPoint[i]]++] = int(i);
    std::copy_backward(begin_.begin(), begin_.end() - 1, begin_.end());
    begin_[0] = 0;
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

template<int dim> int CellList<dim>::index(const Cell& a) const
{
    if constexpr (dim == 2) return a[0] * n_[1] + a[1];
    else
    {
        const Row& row = rows_[std::size_t(a[1])];
        return (row.first + a[0] * row.stride) * n_[2] + a[2];
    }
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
    const auto add = [&](Cell b)
    {
        b[dim - 1] = first[dim - 1];
        const int begin = begin_[index(b)];
        b[dim - 1] = last[dim - 1];
        const int end = begin_[index(b) + 1];
        if (begin < end) runs.push_back({begin, end});
    };
    Cell b{};
    for (b[0] = first[0]; b[0] <= last[0]; ++b[0])
    {
        if constexpr (dim == 2) add(b);
        else
            for (b[1] = first[1]; b[1] <= last[1]; ++b[1]) add(b);
    }
}

template class CellList<2>;
template class CellList<3>;

}
