#include "decomposition/divide.hpp"
#include "decomposition/hilbert.hpp"
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace sph
{

namespace
{
using Places = std::span<const Vector<3>>;
using Part = std::span<std::size_t>;

struct Box
{
    std::array<double, 3> low, size;
};

std::array<double, 3> coordinatesOf(const Vector<3>& x) { return {x.x, x.y, x.z}; }

Box boxOf(Places places, Part members)
{
    auto low = coordinatesOf(places[members[0]]), high = low;
    for (const auto i : members)
        for (std::size_t k = 0; const double q : coordinatesOf(places[i]))
        {
            low[k] = std::min(low[k], q);
            high[k] = std::max(high[k], q);
            ++k;
        }
    return {low, {high[0] - low[0], high[1] - low[1], high[2] - low[2]}};
}

Vector<3> longestSide(int dimension, Places places, Part members)
{
    const auto size = boxOf(places, members).size;
    const auto longest = std::max_element(size.begin(), size.begin() + dimension) - size.begin();
    return {double(longest == 0), double(longest == 1), double(longest == 2)};
}

/// The eigenvector of the largest eigenvalue of sum_i (x_i - x_m)(x_i - x_m)^T.
Vector<3> longestAxis(int dimension, Places places, Part members)
{
    Vector<3> mean;
    for (const auto i : members) mean += places[i];
    mean = mean / double(members.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto i : members)
    {
        const auto d = places[i] - mean;
        const Eigen::Vector3d v(d.x, d.y, dimension == 3 ? d.z : 0);
        spread += v * v.transpose();
    }
    const Eigen::Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
    return {axis[0], axis[1], axis[2]};
}

/// Particle n k/parts is the first of part k, in whatever order they are.
std::size_t firstOf(std::size_t part, std::size_t n, std::size_t parts) { return part * n / parts; }

/// Recursive bisection across `axisOf(members)`.
template<class AxisOf> class Bisection
{
    Places places_;
    std::size_t parts_;
    const AxisOf& axisOf_;
    std::vector<std::size_t> order_;

    /// Brings the particles of parts [from, to) into an order in which each part follows upon the one before it.
    void order(std::size_t from, std::size_t to)
    {
        if (to - from < 2) return;
        const auto first = [&](std::size_t part) { return firstOf(part, order_.size(), parts_); };
        const std::size_t middle = from + (to - from) / 2;
        const Part members(order_.data() + first(from), order_.data() + first(to));
        if (members.empty()) return;
        const auto axis = axisOf_(members);
        // Particles of a lattice lie in planes: those of the plane that is cut go by their other coordinates, and the parts stay compact.
        const auto key = [&](std::size_t i) { return std::tuple(dot(axis, places_[i]), places_[i].x, places_[i].y, places_[i].z, i); };
        std::nth_element(members.begin(), members.begin() + long(first(middle) - first(from)), members.end(),
                         [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
        order(from, middle);
        order(middle, to);
    }

public:
    Bisection(Places places, std::size_t parts, const AxisOf& axisOf)
        : places_(places), parts_(parts), axisOf_(axisOf), order_(places.size())
    {
        std::iota(order_.begin(), order_.end(), std::size_t(0));
        order(0, parts);
    }
    std::vector<std::size_t> take() { return std::move(order_); }
};

template<std::size_t dim> std::vector<std::uint64_t> indicesAlongCurve(Places places, const Box& box)
{
    const double longest = *std::max_element(box.size.begin(), box.size.begin() + dim), cells = std::ldexp(1.0, hilbertBits<dim>) - 1;
    std::vector<std::uint64_t> indices;
    for (const auto& place : places)
    {
        const auto x = coordinatesOf(place);
        std::array<std::uint32_t, dim> cell{};
        for (std::size_t k = 0; longest > 0 && k < dim; ++k) cell[k] = std::uint32_t((x[k] - box.low[k]) / longest * cells);
        indices.push_back(hilbertIndex(cell));
    }
    return indices;
}

std::vector<std::size_t> alongCurve(int dimension, Places places)
{
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (places.empty()) return order;
    const auto box = boxOf(places, order);
    const auto index = dimension == 2 ? indicesAlongCurve<2>(places, box) : indicesAlongCurve<3>(places, box);
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(index[i], i); });
    return order;
}

std::vector<std::size_t> ordered(Division division, int dimension, Places places, std::size_t parts)
{
    if (division == Division::hilbert) return alongCurve(dimension, places);
    const auto axis = division == Division::rib ? longestAxis : longestSide;
    return Bisection(places, parts, [&](Part members) { return axis(dimension, places, members); }).take();
}
}

std::vector<int> divide(Division division, int dimension, Places places, std::size_t parts)
{
    const std::size_t n = places.size();
    const auto order = ordered(division, dimension, places, parts);
    std::vector<int> part(n);
    for (std::size_t k = 0; k < parts; ++k)
        for (std::size_t at = firstOf(k, n, parts); at < firstOf(k + 1, n, parts); ++at) part[order[at]] = int(k);
    return part;
}

}
