/// The loops over lanes do what plain loops do, in the same order, to the same bits, at every width that the build has: with AVX-512
/// 8, 4 and 2 lanes, with AVX2 (preset avx2) 4 and 2. The code of a width is the same in either build.
#include "neighbours/NeighbourLists.hpp"
#include "neighbours/Stencil.hpp"
#include "neighbours/records.hpp"
#include "neighbours/select.hpp"
#include "particlesByHand.hpp"
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
    explicit Scene(std::size_t n)
    {
        if constexpr (dim == 2) points = randomPoints<2>(n, {1, 1});
        else points = randomPoints<3>(n, {1, 1, 1});
        for (int c = 0; c < dim; ++c) coordinate[c].resize(n);
        for (std::size_t i = 0; i < n; ++i) store(points[i], [&](int c, double q) { coordinate[c][i] = q; });
    }
};

template<class L> class AtEveryWidth : public testing::Test
{};
#if defined(__AVX512F__)
using Widths = testing::Types<Lanes<8>, Lanes<4>, Lanes<2>>;
#elif defined(__AVX2__)
using Widths = testing::Types<Lanes<4>, Lanes<2>>;
#else
using Widths = testing::Types<Lanes<2>>;
#endif
TYPED_TEST_SUITE(AtEveryWidth, Widths);

template<class L, class V, class T> void compressesEverySet()
{
    for (unsigned set = 0; set < 1u << L::count; ++set)
    {
        V v;
        std::vector<T> expected;
        for (int k = 0; k < L::count; ++k)
        {
            v[k] = T(10 + k);
            if (set >> k & 1) expected.push_back(T(10 + k));
        }
        const V packed = L::compress(v, set);
        for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_EQ(packed[k], expected[k]) << "set " << set << " of " << L::count;
    }
}
TYPED_TEST(AtEveryWidth, CompressesEverySet)
{
    compressesEverySet<TypeParam, typename TypeParam::Doubles, double>();
    compressesEverySet<TypeParam, typename TypeParam::Longs, long>();
    compressesEverySet<TypeParam, typename TypeParam::Ints, int>();
}

template<int dim, class L> void selectionEqualsAPlainLoop()
{
    constexpr std::size_t n = 200;
    const double radius = std::sqrt(0.2);
    const Scene<dim> scene(n);
    const WholePlaces<dim> places({}, 1, radius);
    std::vector<int> order(n + SortedPoints<dim>::readBeyond), place[dim];
    std::iota(order.rbegin(), order.rend(), 1000);
    SortedPoints<dim> sorted{{}, order.data()};
    for (int c = 0; c < dim; ++c)
    {
        for (const double x : scene.coordinate[c]) place[c].push_back(places(c, x));
        place[c].resize(order.size());
        sorted.place[c] = place[c].data();
    }
    const auto x = scene.points[7];
    // Runs of every length from 0 to beyond two vectors, from every offset in one, and to the last of all points.
    for (int first = 0; first < 9; ++first)
        for (int length = 0; length < 40; ++length)
        {
            const int begin = first < 8 ? first : int(n) - length;
            std::vector<int> found(64, -1), expected;
            const int count = selectWithin<dim, L>(sorted, begin, begin + length, places(x), places.limit(radius), found.data());
            for (int b = begin; b < begin + length; ++b)
                if (const auto d = scene.points[b] - x; dot(d, d) < sqr(radius)) expected.push_back(order[b]);
            found.resize(count);
            EXPECT_EQ(found, expected) << begin << ' ' << length;
        }
}
TYPED_TEST(AtEveryWidth, SelectsAsAPlainLoopIn2D) { selectionEqualsAPlainLoop<2, TypeParam>(); }
TYPED_TEST(AtEveryWidth, SelectsAsAPlainLoopIn3D) { selectionEqualsAPlainLoop<3, TypeParam>(); }

// Lists of every length up to beyond two vectors, of indices at both ends of pages and in between, of a scene of so many particles.
template<class L> void unpackingGivesWhatWasPacked(int particles, const std::vector<int>& firstOfPages)
{
    IndexPacker packer;
    for (std::size_t length = 0; length < 40; ++length)
    {
        std::vector<int> indices;
        for (std::size_t k = 0; k < length; ++k)
            indices.push_back(firstOfPages[k * 7 % firstOfPages.size()] + std::array{0, 4095, 2048, 1023, 1024}[k % 5]);
        IndexPages pages;
        std::vector<std::uint16_t> codes(48);
        ASSERT_TRUE(packer.pack<L>(indices, std::size_t(particles), pages, codes.data())) << length;
        std::vector<int> unpacked(48, -1);
        unpackIndices<L>(codes.data(), int(length), pages, unpacked.data());
        unpacked.resize(length);
        EXPECT_EQ(unpacked, indices) << length;
    }
}
TYPED_TEST(AtEveryWidth, UnpacksIndicesOfASmallScene)
{
    std::vector<int> pages;
    for (int page = 0; page < 15; ++page) pages.push_back(4096 * page);
    unpackingGivesWhatWasPacked<TypeParam>(65535, pages);
}
TYPED_TEST(AtEveryWidth, UnpacksIndicesOfALargeScene)
{
    std::vector<int> pages;
    for (int page = 0; page < 16; ++page) pages.push_back(page % 3 * 1024 + 131072 * page);
    unpackingGivesWhatWasPacked<TypeParam>(131072 * 16, pages);
    unpackingGivesWhatWasPacked<TypeParam>(2000000000, {1024 * 1900000, 0, 4096});
}
// Indices in 17 pages are refused; the next ones are packed as if nothing had been.
TEST(IndexPacker, RefusesTooManyPages)
{
    IndexPacker packer;
    IndexPages pages;
    std::vector<int> indices;
    for (int page = 0; page < 17; ++page) indices.push_back(page * 5000);
    std::vector<std::uint16_t> codes(24);
    EXPECT_FALSE(packer.pack(indices, 100000, pages, codes.data()));
    indices.pop_back();
    ASSERT_TRUE(packer.pack(indices, 100000, pages, codes.data()));
    std::vector<int> unpacked(16);
    unpackIndices(codes.data(), 16, pages, unpacked.data());
    EXPECT_EQ(unpacked, indices);
}

/// Columns that a stencil gathers into.
template<int dim> struct Block
{
    alignas(64) double x[dim][256], r[256], field[recordSize][256];
};

template<int dim, class L> void gatheringEqualsAPlainLoop()
{
    const Scene<dim> scene(300);
    std::vector<int> list;
    for (int k = 0; k < 200; ++k) list.push_back(k * 37 % 300);
    const auto x = scene.points[11];
    const double radiusSqr = 0.15;

    // The last record is a null particle far away.
    const int nFields = recordSize - dim;
    Array columns[recordSize], records(301 * recordSize);
    const double* from[recordSize];
    for (int c = 0; c < recordSize; ++c)
    {
        columns[c].resize(301);
        for (int i = 0; i < 300; ++i) columns[c][i] = c < dim ? scene.coordinate[c][i] : 100 * c + i;
        columns[c][300] = 1e3;
        from[c] = columns[c].data();
    }
    packRecords<L>(from, recordSize, 301, records.data());
    for (int i = 0; i < 301; ++i)
        for (int c = 0; c < recordSize; ++c) ASSERT_EQ(records[i * recordSize + c], columns[c][i]) << i << ' ' << c;

    std::vector<int> within(256), expected;
    const int n = selectRecords<dim, L>(records.data(), list.data(), int(list.size()), x, radiusSqr, within.data());
    for (int p : list)
        if (const auto d = x - scene.points[p]; dot(d, d) < radiusSqr) expected.push_back(p);
    within.resize(n);
    ASSERT_EQ(within, expected);

    while (within.size() % 8) within.push_back(300);
    ASSERT_GT(within.size(), expected.size()) << "no padding to look at";
    static Block<dim> block;
    gatherRecords<dim, nFields, true, L>(records.data(), within.data(), int(within.size()), x, radiusSqr, block);
    for (int k = 0; k < int(within.size()); ++k)
    {
        for (int f = 0; f < nFields; ++f) EXPECT_EQ(block.field[f][k], columns[dim + f][within[k]]);
        const auto d = k < n ? x - scene.points[within[k]] : Vector<dim>{};
        store(d, [&](int c, double q) { EXPECT_EQ(block.x[c][k], q); });
        // Fused multiply-add may round the square once less.
        EXPECT_DOUBLE_EQ(block.r[k], k < n ? std::sqrt(dot(d, d)) : 2 * std::sqrt(radiusSqr));
    }

    for (int width = 2; width <= recordSize; width += 2)
    {
        static double further[recordSize][256];
        packRecords<L>(from, width, 301, records.data());
        gatherColumns<L>(records.data(), width, within.data(), int(within.size()), further);
        for (int k = 0; k < int(within.size()); ++k)
            for (int c = 0; c < width; ++c) EXPECT_EQ(further[c][k], columns[c][within[k]]) << width;
    }
}
TYPED_TEST(AtEveryWidth, GathersAsAPlainLoopIn2D) { gatheringEqualsAPlainLoop<2, TypeParam>(); }
TYPED_TEST(AtEveryWidth, GathersAsAPlainLoopIn3D) { gatheringEqualsAPlainLoop<3, TypeParam>(); }

// Places are whole numbers of 2^-30 of the domain's extent, columns are floats; a null particle far away is at some finite distance, beyond the domain. What is behind the listed
// particles repeats the last.
template<int dim, class L> void singleRecordsEqualAPlainLoop()
{
    const Scene<dim> scene(300);
    std::vector<int> list;
    for (int k = 0; k < 190; ++k) list.push_back(k * 37 % 300);
    while (list.size() % 8) list.push_back(300);
    Vector<dim> low, high;
    fetch(low, [](int c) { return -0.5 - c; });
    fetch(high, [](int c) { return 1.5 + c; });
    const PlaceUnits<dim> units(low, high);
    const auto place = [&](int c, double x) { return std::nearbyint((x - 0.5) * std::ldexp(1, 30) / (2 + 2 * c)); };
    for (const int nFields : {0, 1, 2, 5, 8, 13, 14, 19, 29, 40})
    {
        const auto numbers = std::size_t(singleRecordSize<dim>(nFields));
        ASSERT_GE(numbers, dim + nFields);
        const auto size = [](std::size_t c) { return c % 3 == 0 ? 1e-30 : c % 3 == 1 ? 1 : 1e30; };
        std::vector<Array> columns(numbers, Array(301));
        std::vector<const double*> from;
        for (std::size_t c = 0; c < numbers; ++c)
        {
            for (std::size_t i = 0; i < 300; ++i)
                columns[c][i] = c < dim ? scene.coordinate[c][i] : size(c) * (100. * double(c) + double(i) + 1 / 3.);
            columns[c][300] = c < dim ? 1e300 : columns[c][0];
            from.push_back(columns[c].data());
        }
        SingleArray records(301 * numbers);
        packSingleRecords<dim, L>(from.data(), nFields, units, 301, records.data());

        constexpr int particle = 11;
        const auto difference = [&](int c, std::size_t j)
        {
            return float(int(place(c, columns[std::size_t(c)][particle]) - place(c, columns[std::size_t(c)][j]))) *
                   float((2 + 2 * c) * std::ldexp(1, -30));
        };
        static Stencil<dim, Single> block;
        const int n = gatherSingleRecords<dim, L>(records.data(), nFields, units, particle, list.data(), int(list.size()), block);
        EXPECT_EQ(n % (2 * L::count), 0);
        EXPECT_LT(n - int(list.size()), 2 * L::count);
        for (int k = 0; k < n; ++k)
        {
            const auto j = std::size_t(list[std::min(std::size_t(k), list.size() - 1)]);
            for (int c = 0; c < dim; ++c)
                if (j == 300) EXPECT_GE(std::fabs(double(block.x[c][k])), 2 + 2 * c);
                else EXPECT_EQ(block.x[c][k].value, difference(c, j)) << c << ' ' << k;
            for (int f = 0; f < nFields; ++f) EXPECT_EQ(block.field[f][k].value, float(columns[std::size_t(dim + f)][j])) << f << ' ' << k;
        }

        const double radius = 0.3;
        std::vector<int> within(256), expected;
        const int found =
            selectSingleRecords<dim, L>(records.data(), nFields, units, particle, list.data(), int(list.size()), radius, within.data());
        for (const int j : list)
        {
            if (j == 300) continue;
            float square = 0;
            for (int c = 0; c < dim; ++c) square += sqr(double(difference(c, std::size_t(j))));
            if (std::fabs(square - sqr(radius)) < 1e-6) continue; // as round-off has it
            if (square < sqr(radius)) expected.push_back(j);
        }
        within.resize(std::size_t(found));
        ASSERT_EQ(within, expected);
    }
}
TYPED_TEST(AtEveryWidth, GathersRecordsInSinglePrecisionAsAPlainLoopIn2D) { singleRecordsEqualAPlainLoop<2, TypeParam>(); }
TYPED_TEST(AtEveryWidth, GathersRecordsInSinglePrecisionAsAPlainLoopIn3D) { singleRecordsEqualAPlainLoop<3, TypeParam>(); }

}
}
