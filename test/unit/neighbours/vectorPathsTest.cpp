/// The loops with vector instructions keep what plain loops keep, in the same order, to the same bits.
#include "NeighbourLists.hpp"
#include "records.hpp"
#include "scenes.hpp"
#include "select.hpp"
#include <gtest/gtest.h>
#include <numeric>

namespace sph
{
namespace
{

using namespace test;

template<int dim> struct Scene
{
    std::vector<Vector<dim>> points;
    std::vector<double> coordinate[dim];
    const double* position[dim];

    explicit Scene(std::size_t n)
    {
        if constexpr (dim == 2)
            points = randomPoints<2>(n, {1, 1});
        else
            points = randomPoints<3>(n, {1, 1, 1});
        for (int c = 0; c < dim; ++c) coordinate[c].resize(n);
        for (std::size_t i = 0; i < n; ++i) store(points[i], [&](int c, double q) { coordinate[c][i] = q; });
        for (int c = 0; c < dim; ++c) position[c] = coordinate[c].data();
    }
};

template<int dim> void selectionEqualsAPlainLoop()
{
    const Scene<dim> scene(200);
    std::vector<int> order(200);
    std::iota(order.rbegin(), order.rend(), 1000);
    const auto x = scene.points[7];
    // Runs of every length from 0 to beyond two vectors, from every offset in one.
    for (int begin = 0; begin < 9; ++begin)
        for (int length = 0; length < 40; ++length)
        {
            std::vector<int> found(64, -1), expected;
            const int n = selectWithin<dim>(scene.position, order.data(), begin, begin + length, x, 0.2, found.data());
            for (int b = begin; b < begin + length; ++b)
                if (const auto d = scene.points[b] - x; dot(d, d) < 0.2) expected.push_back(order[b]);
            found.resize(n);
            EXPECT_EQ(found, expected) << begin << ' ' << length;
        }
}
TEST(SelectWithin, EqualsAPlainLoopIn2D) { selectionEqualsAPlainLoop<2>(); }
TEST(SelectWithin, EqualsAPlainLoopIn3D) { selectionEqualsAPlainLoop<3>(); }

template<int dim> void gatheringEqualsAPlainLoop()
{
    using Column = double[256];
    const Scene<dim> scene(300);
    std::vector<int> list;
    for (int k = 0; k < 200; ++k) list.push_back(k * 37 % 300);
    const auto x = scene.points[11];
    const double radiusSqr = 0.15;

    const int nFields = recordSize - dim;
    std::vector<double> field[recordSize];
    Array records(300 * recordSize);
    for (int f = 0; f < nFields; ++f)
        for (int i = 0; i < 300; ++i) field[f].push_back(100 * f + i);
    for (int i = 0; i < 300; ++i)
    {
        for (int c = 0; c < dim; ++c) records[i * recordSize + c] = scene.coordinate[c][i];
        for (int f = 0; f < nFields; ++f) records[i * recordSize + dim + f] = field[f][i];
    }

    alignas(64) static Column xij[dim], rSqr, column[recordSize]; // as in a stencil: whole vectors are stored
    alignas(64) long j[256];
    const auto check = [&](int n, bool withFields)
    {
        int k = 0;
        for (int p : list)
        {
            const auto d = x - scene.points[p];
            // Fused multiply-add may round the sum once less: bits of distances are compared to 1 ulp or two.
            if (!(dot(d, d) < radiusSqr)) continue;
            ASSERT_LT(k, n);
            EXPECT_EQ(j[k], p);
            store(d, [&](int c, double q) { EXPECT_EQ(xij[c][k], q); });
            EXPECT_NEAR(rSqr[k], dot(d, d), 4e-16);
            for (int f = 0; withFields && f < nFields; ++f) EXPECT_EQ(column[f][k], field[f][p]);
            ++k;
        }
        EXPECT_EQ(k, n);
    };
    check(gatherWithin<dim>(scene.position, list.data(), int(list.size()), x, radiusSqr, j, xij, rSqr), false);
    if constexpr (packsRecords)
    {
        const int n = gatherRecords<dim, nFields>(records.data(), list.data(), int(list.size()), x, radiusSqr, j, xij, rSqr, column);
        check(n, true);
        // What was found, padded with a point far away, needs no selection: all of it again, and the padding at twice the radius.
        std::vector<int> within(j, j + n);
        records.resize(301 * recordSize);
        std::fill_n(records.end() - recordSize, recordSize, 1e3);
        while (within.size() % 8) within.push_back(300);
        const int all = gatherRecords<dim, nFields, false>(records.data(), within.data(), int(within.size()), x, radiusSqr, j, xij, rSqr, column);
        ASSERT_EQ(std::size_t(all), within.size());
        ASSERT_GT(all, n) << "no padding to look at";
        check(n, true);
        for (int k = n; k < all; ++k)
        {
            EXPECT_EQ(rSqr[k], 4 * radiusSqr);
            for (int c = 0; c < dim; ++c) EXPECT_EQ(xij[c][k], 0);
        }
    }
}
TEST(GatherWithin, EqualsAPlainLoopIn2D) { gatheringEqualsAPlainLoop<2>(); }
TEST(GatherWithin, EqualsAPlainLoopIn3D) { gatheringEqualsAPlainLoop<3>(); }

}
}
