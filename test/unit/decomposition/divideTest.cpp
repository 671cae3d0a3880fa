/// Parts of equal numbers, and compact ones.
#include "decomposition/divide.hpp"
#include "decomposition/hilbert.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

using namespace sph;

namespace
{
std::vector<Vector<3>> randomPlaces(std::size_t n, Vector<3> size)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<Vector<3>> places;
    while (places.size() < n) places.push_back({size.x * uniform(random), size.y * uniform(random), size.z * uniform(random)});
    return places;
}

std::vector<Vector<3>> lattice(int n)
{
    std::vector<Vector<3>> places;
    for (int i = 0; i < n * n * n; ++i) places.push_back({double(i % n), double(i / n % n), double(i / n / n)});
    return places;
}

std::vector<std::size_t> sizesOf(const std::vector<int>& part, std::size_t parts)
{
    std::vector<std::size_t> sizes(parts);
    for (const int k : part) ++sizes.at(std::size_t(k));
    return sizes;
}

/// The largest side of the box of any part.
double widest(const std::vector<Vector<3>>& places, const std::vector<int>& part, int parts)
{
    double most = 0;
    for (int k = 0; k < parts; ++k)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Vector<3> low{infinity, infinity, infinity}, high = -low;
        for (std::size_t i = 0; i < places.size(); ++i)
            if (part[i] == k)
                for (const auto c : {&Vector<3>::x, &Vector<3>::y, &Vector<3>::z})
                {
                    low.*c = std::min(low.*c, places[i].*c);
                    high.*c = std::max(high.*c, places[i].*c);
                }
        most = std::max({most, high.x - low.x, high.y - low.y, high.z - low.z});
    }
    return most;
}

class Dividing : public testing::TestWithParam<Division>
{};

// n/N rounded down or up, whatever n and N and however many lie in one place.
TEST_P(Dividing, GivesEachAsMany)
{
    auto places = randomPlaces(1000, {3, 1, 2});
    for (std::size_t i = 0; i < 300; ++i) places[i] = {1, 0.5, 1};
    for (const int dimension : {2, 3})
        for (const std::size_t parts : {1, 2, 3, 7, 16, 999, 1000})
        {
            const auto sizes = sizesOf(divide(GetParam(), dimension, places, parts), parts);
            EXPECT_GE(*std::ranges::min_element(sizes), 1000 / parts) << parts;
            EXPECT_LE(*std::ranges::max_element(sizes), (1000 + parts - 1) / parts) << parts;
        }
}

// Eight to the cube: each has an octant (rib may turn; its parts are no wider than that cube's diagonal).
TEST_P(Dividing, KeepsPartsTogether)
{
    const auto places = lattice(16);
    const auto part = divide(GetParam(), 3, places, 8);
    EXPECT_EQ(sizesOf(part, 8), std::vector<std::size_t>(8, 512));
    const double side = widest(places, part, 8);
    if (GetParam() == Division::rib) EXPECT_LT(side, 7 * std::sqrt(3.0));
    else EXPECT_EQ(side, 7);
}

TEST_P(Dividing, LooksAtThePlaneAloneInTwoDimensions)
{
    const auto flat = randomPlaces(500, {2, 1, 0});
    auto deep = flat;
    for (std::size_t i = 0; i < deep.size(); ++i) deep[i].z = double(i % 10);
    EXPECT_EQ(divide(GetParam(), 2, flat, 6), divide(GetParam(), 2, deep, 6));
}

TEST_P(Dividing, OfNothing) { EXPECT_TRUE(divide(GetParam(), 3, {}, 4).empty()); }

INSTANTIATE_TEST_SUITE_P(Methods, Dividing, testing::Values(Division::rcb, Division::rib, Division::hilbert),
                         [](const auto& method) {
                             return method.param == Division::rcb ? "rcb" : method.param == Division::rib ? "rib" : "hilbert";
                         });

// A slab of 10 x 1 x 0.2 turned by 30 degrees: rib cuts it across at its middle, rcb along a coordinate, which leaves longer edges.
TEST(InertialBisection, CutsATurnedSlabAcrossItsLongAxis)
{
    auto places = randomPlaces(4000, {10, 1, 0.2});
    const double angle = std::numbers::pi / 6;
    const Vector<3> along{std::cos(angle), std::sin(angle), 0};
    for (auto& x : places) x = {x.x * std::cos(angle) - x.y * std::sin(angle), x.x * std::sin(angle) + x.y * std::cos(angle), x.z};
    const auto overlap = [&](Division method)
    {
        const auto part = divide(method, 3, places, 2);
        double end = -1e9, start = 1e9;
        const int first = dot(along, places[std::size_t(std::ranges::find(part, 0) - part.begin())]) < 5 ? 0 : 1;
        for (std::size_t i = 0; i < places.size(); ++i)
            if (const double s = dot(along, places[i]); part[i] == first) end = std::max(end, s);
            else start = std::min(start, s);
        return end - start;
    };
    // The axis of 4000 random places is that of the slab to a hundredth or so.
    EXPECT_LT(overlap(Division::rib), 0.03);
    EXPECT_GT(overlap(Division::rcb), 0.4);
}

// Every cell once, and from each to one that shares a face with it: on aligned cubes of the whole lattice.
template<std::size_t dim> void expectCurve(std::uint32_t n)
{
    std::vector<std::pair<std::uint64_t, std::array<std::uint32_t, dim>>> cells;
    for (std::uint32_t i = 0; i < std::uint32_t(std::pow(n, dim)); ++i)
    {
        std::array<std::uint32_t, dim> x;
        for (std::uint32_t rest = i; auto& x_k : x)
        {
            x_k = rest % n;
            rest /= n;
        }
        cells.emplace_back(hilbertIndex(x), x);
    }
    std::ranges::sort(cells);
    for (std::size_t k = 1; k < cells.size(); ++k)
    {
        EXPECT_EQ(cells[k].first, cells[k - 1].first + 1);
        int steps = 0;
        for (std::size_t c = 0; c < dim; ++c) steps += std::abs(int(cells[k].second[c]) - int(cells[k - 1].second[c]));
        EXPECT_EQ(steps, 1) << k;
    }
}
TEST(HilbertCurve, GoesFromNeighbourToNeighbour)
{
    expectCurve<2>(32);
    expectCurve<3>(16);
}

// 64 pieces of 64 cells are cubes: the most compact that there are.
TEST(HilbertCurve, HasCompactPieces)
{
    const auto places = lattice(16);
    EXPECT_EQ(widest(places, divide(Division::hilbert, 3, places, 64), 64), 3);
}

}
