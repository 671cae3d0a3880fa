/// Neighbour lists against every pair tried: they must hold all pairs within the radius, and none that is farther by more than rounding.
#include "neighbours/NeighbourLists.hpp"
#include "base/CaseError.hpp"
#include "particlesByHand.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <omp.h>

namespace sph
{
namespace
{

using namespace test;

/// Those within a distance of a point, ascending.
template<int dim> std::vector<int> within(double radius, const std::vector<Vector<dim>>& points, std::size_t i)
{
    std::vector<int> all;
    for (std::size_t j = 0; j < points.size(); ++j)
        if (const auto d = points[i] - points[j]; dot(d, d) < sqr(radius)) all.push_back(int(j));
    return all;
}

/// `list`, without null particles, holds what is within the radius, and nothing beyond what is within a little more.
template<int dim> void holdsWhatIsWithin(double radius, const std::vector<Vector<dim>>& points, std::size_t i, std::span<const int> list)
{
    std::vector<int> found(list.begin(), list.end());
    std::erase(found, int(points.size()));
    std::ranges::sort(found);
    EXPECT_TRUE(std::ranges::includes(found, within(radius, points, i))) << "particle " << i;
    double extent = 0;
    for (const auto& p : points) extent = std::max(extent, mag(p - points[0]));
    EXPECT_TRUE(std::ranges::includes(within((1 + 2e-6) * radius + std::ldexp(extent, -27), points, i), found)) << "particle " << i;
}

template<int dim> void listsHoldWhatIsWithin(const std::vector<Vector<dim>>& points, std::size_t owned, double radius)
{
    FieldStore<dim> store;
    setPositions(store, points);
    NeighbourLists<dim> lists;
    lists.build(positions(store), owned, points.size(), radius);
    std::size_t pairs = 0;
    typename NeighbourLists<dim>::Room room;
    for (std::size_t i = 0; i < owned; ++i)
    {
        const auto list = lists.of(i, room);
        ASSERT_EQ(list.size() % NeighbourLists<dim>::lanes, 0u) << "particle " << i;
        holdsWhatIsWithin(radius, points, i, list);
        pairs += std::size_t(std::ranges::count_if(list, [&](int j) { return j != int(points.size()); }));
        ASSERT_FALSE(testing::Test::HasFailure());
    }
    EXPECT_EQ(lists.pairs(), pairs);
}

TEST(NeighbourLists, HoldWhatIsWithinOfRandomPointsIn2D) { listsHoldWhatIsWithin<2>(randomPoints<2>(3000, {3, 1}), 2500, 0.11); }
TEST(NeighbourLists, HoldWhatIsWithinOfRandomPointsIn3D) { listsHoldWhatIsWithin<3>(randomPoints<3>(3000, {1, 2, 1.5}), 2200, 0.23); }

// Every point in one cell, and lists that hold everything.
TEST(NeighbourLists, HoldWhatIsWithinWhereTheRadiusSpansTheScene)
{
    listsHoldWhatIsWithin<2>(randomPoints<2>(100, {1, 1}), 100, 5);
    listsHoldWhatIsWithin<3>(randomPoints<3>(100, {1, 1, 1}), 100, 0.9);
}

// Points along a line and in a plane: extents of zero.
TEST(NeighbourLists, HoldWhatIsWithinOfDegenerateClouds)
{
    listsHoldWhatIsWithin<2>(randomPoints<2>(500, {1, 0}), 500, 0.05);
    listsHoldWhatIsWithin<3>(randomPoints<3>(500, {0, 1, 0}), 400, 0.05);
    listsHoldWhatIsWithin<2>({{0.3, 0.4}}, 1, 0.1);
}

/// Of every `each`-th particle, where all of them would take too long: lists that are stored, and lists that are not.
void someListsHoldWhatIsWithin(const std::vector<Vector<3>>& points, double radius, std::size_t each, double bytesOfANeighbour)
{
    using Lists = NeighbourLists<3>;
    FieldStore<3> store;
    setPositions(store, points);
    Lists stored, found;
    std::vector<double> room(3 * points.size());
    stored.build(positions(store), points.size(), points.size(), radius, Lists::Stored::yes, room);
    found.build(positions(store), points.size(), points.size(), radius, Lists::Stored::no);
    EXPECT_EQ(stored.pairs(), found.pairs());
    EXPECT_NEAR(double(stored.bytes()) / double(stored.pairs()), bytesOfANeighbour, 0.3);
    EXPECT_EQ(found.bytes(), 0u);
    Lists::Room room1, room2;
    for (std::size_t i = 0; i < points.size(); i += each)
    {
        const auto list = stored.of(i, room1), same = found.of(i, room2);
        ASSERT_TRUE(std::ranges::equal(list, same)) << "particle " << i;
        holdsWhatIsWithin(radius, points, i, list);
        ASSERT_FALSE(testing::Test::HasFailure());
    }
}

/// Particles in the order of the cells that a solver sorts them by.
std::vector<Vector<3>> sortedByCells(const std::vector<Vector<3>>& points, double radius)
{
    FieldStore<3> store;
    setPositions(store, points);
    CellList<3> cells;
    cells.build(positions(store), points.size(), 0.5 * radius);
    std::vector<Vector<3>> sorted;
    for (const int k : cells.order()) sorted.push_back(points[std::size_t(k)]);
    return sorted;
}

// A scene whose indices take more than two bytes, sorted by cells: lists take 2 bytes a neighbour, and 4 each that a particle has by itself. In any other
// order what a few particles see lies in more pages than there are, and lists are plain.
TEST(NeighbourLists, HoldWhatIsWithinInASceneOfManyPages)
{
    const double radius = 0.05;
    const auto points = randomPoints<3>(90000, {1, 1, 1});
    someListsHoldWhatIsWithin(sortedByCells(points, radius), radius, 997, 2.1);
    someListsHoldWhatIsWithin(points, radius, 997, 4.1);
}

/// Lists in which all others than the first `owned` that nobody sees have lost their places: the same particles in the same order, by their new numbers.
void renumberedListsNameTheSame(const std::vector<Vector<3>>& points, std::size_t owned, double radius, double bytesOfANeighbour)
{
    using Lists = NeighbourLists<3>;
    FieldStore<3> store;
    setPositions(store, points);
    Lists before, lists;
    before.build(positions(store), owned, points.size(), radius);
    lists.build(positions(store), owned, points.size(), radius);
    std::vector<int> numbers;
    int next = int(owned);
    for (const char seen : lists.seen())
    {
        numbers.push_back(next);
        next += seen;
    }
    ASSERT_LT(next, int(points.size()) - 1000);
    ASSERT_GT(next, int(owned) + 1000);
    numbers.push_back(next);
    lists.renumber(numbers);
    EXPECT_EQ(lists.pairs(), before.pairs());
    EXPECT_NEAR(double(lists.bytes()) / double(lists.pairs()), bytesOfANeighbour, 0.3);
    Lists::Room room1, room2;
    for (std::size_t i = 0; i < owned; ++i)
    {
        std::vector<int> expected;
        for (const int j : before.of(i, room1)) expected.push_back(j < int(owned) ? j : numbers[std::size_t(j) - owned]);
        ASSERT_TRUE(std::ranges::equal(lists.of(i, room2), expected)) << "particle " << i;
    }
}

TEST(NeighbourLists, NameTheSameByOtherNumbers)
{
    const double radius = 0.05;
    auto points = randomPoints<3>(90000, {1, 1, 1});
    const auto owned = std::ranges::partition(points, [](const auto& p) { return p.x < 0.8; }).begin() - points.begin();
    renumberedListsNameTheSame(points, std::size_t(owned), radius, 4.1);
    points = sortedByCells(points, radius);
    std::ranges::stable_partition(points, [](const auto& p) { return p.x < 0.8; });
    renumberedListsNameTheSame(points, std::size_t(owned), radius, 2.1);
    renumberedListsNameTheSame({points.begin() + owned - 20000, points.begin() + owned + 10000}, 20000, radius, 2.1);
}

// So many particles in a plane of cells that rows come in bands.
TEST(NeighbourLists, HoldWhatIsWithinWhereRowsComeInBands)
{
    const double radius = 0.02;
    const auto points = sortedByCells(randomPoints<3>(90000, {0.025, 1, 0.5}), radius);
    // Three bands' worth of rows along y would come one after another in either plane; in bands the second plane begins after 16 rows.
    const auto second = std::ranges::find_if(points, [](const auto& p) { return p.x > 0.0125; });
    ASSERT_NE(second, points.end());
    EXPECT_LT(second->y, 0.011);
    EXPECT_LT(second - points.begin(), 90000 / 10);
    someListsHoldWhatIsWithin(points, radius, 997, 2.1);
}

// As many neighbours as a list may have, all at one place, and one particle by itself.
TEST(NeighbourLists, HoldAsManyAsTheyMay)
{
    const int most = NeighbourLists<3>::mostNeighbours;
    std::vector<Vector<3>> points(std::size_t(most), Vector<3>{0.25, 0.5, 0.75});
    points.push_back({1, 1, 1});
    listsHoldWhatIsWithin<3>(points, points.size(), 0.01);
    FieldStore<3> store;
    setPositions(store, points);
    NeighbourLists<3> lists;
    lists.build(positions(store), points.size(), points.size(), 0.01, NeighbourLists<3>::Stored::no);
    NeighbourLists<3>::Room room;
    holdsWhatIsWithin(0.01, points, 7, lists.of(7, room));
}

// Neighbours that a pass keeps of each particle come back, and spoil no other particle's.
TEST(NeighbourLists, KeepWhatAPassFound)
{
    const auto points = randomPoints<2>(1500, {1, 1});
    FieldStore<2> store;
    setPositions(store, points);
    NeighbourLists<2> lists;
    lists.build(positions(store), points.size(), points.size(), 0.1);
    lists.makeRoomWithin();
    const auto kept = [&](std::size_t i)
    {
        NeighbourLists<2>::Room room;
        const auto list = lists.of(i, room), all = list.first(list.size() - 8 * (i % 2));
        return std::vector<int>(all.begin(), all.end());
    };
    for (std::size_t i = 0; i < points.size(); ++i) lists.keepWithin(i, kept(i).data(), int(kept(i).size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_EQ(std::vector<int>(lists.within(i).begin(), lists.within(i).end()), kept(i)) << "particle " << i;
}

// Two plans share the lists of a scene, and may keep in two precisions: what is kept lies in the room that was made last, also where lists have grown since the room of the other was made.
TEST(NeighbourLists, KeepSlopesInThePrecisionAskedForLast)
{
    const auto points = randomPoints<2>(600, {1, 1});
    FieldStore<2> store;
    setPositions(store, points);
    NeighbourLists<2> lists;
    const auto build = [&](double radius)
    {
        lists.build(positions(store), points.size(), points.size(), radius);
        lists.makeRoomWithin();
        NeighbourLists<2>::Room room;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const auto list = lists.of(i, room);
            lists.keepWithin(i, list.data(), int(list.size()));
        }
    };
    const auto numbersOf = [&](std::size_t i)
    {
        std::vector<double> numbers(lists.within(i).size());
        for (std::size_t t = 0; t < numbers.size(); ++t) numbers[t] = double(1000 * i + t);
        return numbers;
    };
    for (const auto& [radius, inSinglePrecision] : {std::pair{0.05, true}, {0.2, false}, {0.1, true}, {0.3, false}, {0.4, true}})
    {
        build(radius);
        lists.makeRoomForSlopes(inSinglePrecision);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const auto slopes = lists.slopes(i);
            ASSERT_EQ(slopes.single != nullptr, inSinglePrecision) << "radius " << radius;
            ASSERT_EQ(slopes.exact == nullptr, inSinglePrecision) << "radius " << radius;
            slopes.keep(numbersOf(i).data(), int(numbersOf(i).size()));
        }
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            std::vector<double> read(lists.within(i).size());
            lists.slopes(i).read(read.data(), int(read.size()));
            ASSERT_EQ(read, numbersOf(i)) << "particle " << i << ", radius " << radius;
        }
    }
}

// A lattice, whose distances equal the radius up to round-off: those may be listed or not.
TEST(NeighbourLists, HoldWhatIsWithinOfALattice)
{
    std::vector<Vector<3>> points;
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j)
            for (int k = 0; k < 9; ++k) points.push_back({i * 0.125, j * 0.125, k * 0.125});
    for (double radius : {0.25, 0.3, 0.375}) listsHoldWhatIsWithin<3>(points, points.size(), radius);
}

// A scene 10^6 spacings long with particles at both ends alone: only the cells that hold some are kept (10^18 cells of side 1 in 3-D).
TEST(NeighbourLists, HoldWhatIsWithinOfTwoClustersFarApart)
{
    auto points = randomPoints<3>(600, {8, 8, 8});
    for (std::size_t i = 0; i < points.size(); i += 2) points[i] += Vector<3>{1e6, 1e6, 1e6};
    listsHoldWhatIsWithin<3>(points, points.size(), 2.6);
    auto plane = randomPoints<2>(600, {20, 20});
    for (std::size_t i = 0; i < plane.size(); i += 3) plane[i] += Vector<2>{1e6, -1e6};
    listsHoldWhatIsWithin<2>(plane, 600, 2.6);
    CellList<2> cells;
    FieldStore<2> store;
    setPositions(store, plane);
    cells.build(positions(store), 600, 1.3);
    EXPECT_EQ(cells.order().size(), 600u);
}

// What a search looks at hangs on how densely particles lie around it, not on how far off others are: cells do not grow. Candidates of two clusters 10^5
// spacings apart are those of the same two side by side but for how the cells lie over the points, a tenth at the most.
TEST(NeighbourLists, LookAtNoMoreWhereClustersAreFarApart)
{
    const auto candidates = [](double distance)
    {
        auto points = randomPoints<3>(4000, {12, 12, 12});
        for (std::size_t i = 0; i < points.size(); i += 2) points[i] += Vector<3>{distance, distance, distance};
        FieldStore<3> store;
        setPositions(store, points);
        CellList<3> cells;
        cells.build(positions(store), points.size(), 1.3);
        std::vector<CellList<3>::Run> runs;
        double sum = 0;
        for (const auto& x : points)
        {
            cells.runsAround(cells.cellOf(x), 2.6, runs);
            for (const auto& r : runs) sum += r.end - r.begin;
        }
        return sum;
    };
    const double near = candidates(16);
    EXPECT_NEAR(candidates(1e5), near, 0.1 * near);
}

// A cluster in a wide scene, as a drop in an empty box: half of all points within one radius of one another.
TEST(NeighbourLists, HoldWhatIsWithinOfAClusteredCloud)
{
    auto points = randomPoints<2>(800, {10, 10}, 3);
    for (std::size_t i = 0; i < 400; ++i) points[i] = Vector<2>{5, 5} + 0.02 * points[i];
    listsHoldWhatIsWithin<2>(points, points.size(), 0.3);
}

// A second build with fewer, more and no particles reuses the memory of the first and must not see its contents.
TEST(NeighbourLists, ForgetTheLastBuild)
{
    NeighbourLists<2> lists;
    for (std::size_t n : {2000, 10, 3000, 0, 50})
    {
        const auto points = randomPoints<2>(n, {1, 1}, unsigned(n));
        FieldStore<2> store;
        setPositions(store, points);
        lists.build(positions(store), n, n, 0.06);
        std::size_t pairs = 0, pairsOfMore = 0;
        for (const auto& p : points)
            for (const auto& q : points)
            {
                pairs += dot(p - q, p - q) < sqr(0.06);
                pairsOfMore += dot(p - q, p - q) < sqr(0.06 * (1 + 2e-6));
            }
        EXPECT_GE(lists.pairs(), pairs) << n;
        EXPECT_LE(lists.pairs(), pairsOfMore) << n;
    }
}

// More than 1024 neighbours end in an error that names the first such particle and its place, whatever the number of threads.
TEST(NeighbourLists, RefuseParticlesOnTopOfOneAnother)
{
    auto points = randomPoints<3>(3000, {1, 1, 1});
    for (std::size_t i = 1500; i < 3000; ++i) points[i] = {0.25, 0.5, 0.75};
    FieldStore<3> store;
    setPositions(store, points);
    for (int threads : {1, 2})
    {
        omp_set_num_threads(threads);
        NeighbourLists<3> lists;
        try
        {
            lists.build(positions(store), 3000, 3000, 0.001);
            FAIL() << "no error";
        }
        catch (const CaseError& e)
        {
            EXPECT_STREQ(e.what(),
                         "particle 1500 at (0.25 0.5 0.75) has more than 1024 neighbours: particles lie on top of one another, or the "
                         "kernel support is too many spacings");
        }
    }
}

}
}
