/// Images: where they are, how often, and with which weight.
#include "Imaged.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace sph
{
namespace
{

using namespace test;

// Every combination of signs appears exactly once in the corner of a box: 3 images in 2-D, 7 in 3-D. Mirroring in plane walls rounds
// once or twice.
TEST(Images, OfABoxCornerAppearOnceEach)
{
    Imaged<2> plane(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    EXPECT_EQ(plane.images.count(), 3u);
    for (double a : {-1, 1})
        for (double b : {-1, 1}) EXPECT_EQ(plane.countAt({a * 0.1, b * 0.15}), a + b < 2) << a << b;

    Imaged<3> space(cornerOfBox(3), 0.3, {{0.1, 0.15, 0.2}});
    EXPECT_EQ(space.images.count(), 7u);
    for (double a : {-1, 1})
        for (double b : {-1, 1})
            for (double c : {-1, 1}) EXPECT_EQ(space.countAt({a * 0.1, b * 0.15, c * 0.2}), a + b + c < 3) << a << b << c;
}

// A particle that all but touches both walls of a corner: its three images lie within a hundredth of a spacing of one another
// and of it.
TEST(Images, OfAParticleInTheVeryCornerAppearOnceEach)
{
    Imaged<2> scene(cornerOfBox(2), 0.3, {{0.002, 0.002}});
    EXPECT_EQ(scene.images.count(), 3u);
    EXPECT_EQ(scene.countAt({-0.002, 0.002}, 1e-6), 1);
    EXPECT_EQ(scene.countAt({0.002, -0.002}, 1e-6), 1);
    EXPECT_EQ(scene.countAt({-0.002, -0.002}, 1e-6), 1);
}

/// Ghosts of one particle by place, with their weights: those of no weight left out.
std::vector<std::pair<Vector<2>, double>> weighedGhosts(Imaged<2>& scene)
{
    std::vector<std::pair<Vector<2>, double>> all;
    const double* weight = scene.store.component(ImageWeight::info.name, 0);
    for (std::size_t j = scene.images.owned(); j < scene.images.nullParticle(); ++j)
        if (weight[j] > 0) all.emplace_back(positionOf(scene.store, j), weight[j]);
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return std::pair(a.first.x, a.first.y) < std::pair(b.first.x, b.first.y); });
    return all;
}

// Beside a block that stands on the floor, is sunk into it, or juts out over a step, a particle has the three images of the corner of a box, at
// the same places and whole; before, those of the block faded towards the floor and the corner had none.
TEST(Images, BesideABlockOnAFloorAreThoseOfACorner)
{
    for (const Vector<2> x : {Vector<2>{0.02, 0.01}, {0.01, 0.02}, {0.002, 0.05}, {0.15, 0.001}})
    {
        Geometry corner = domain(2, {1, 1, 0});
        addWall(corner, Plane({0, 0, 0}, {1, 0, 0}));
        addWall(corner, Plane({0, 0, 0}, {0, 1, 0}));
        Imaged<2> expected(corner, 0.3, {x});
        const auto wanted = weighedGhosts(expected);
        ASSERT_EQ(wanted.size(), 3u);
        for (const int bottom : {0, 1, 2})
        {
            Geometry g = domain(2, {1, 1, 0});
            if (bottom < 2) addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
            else addWall(g, SolidBox({-0.4, -0.9, -Box::infinity}, {0.8, 0, Box::infinity})); // the block juts out beyond it
            addWall(g, SolidBox({-0.9, bottom == 1 ? -0.5 : 0, -Box::infinity}, {0, 0.9, Box::infinity}));
            Imaged<2> scene(g, 0.3, {x});
            const auto found = weighedGhosts(scene);
            ASSERT_EQ(found.size(), 3u) << bottom << " " << x.x << " " << x.y;
            for (std::size_t k = 0; k < 3; ++k)
            {
                EXPECT_NEAR(mag(found[k].first - wanted[k].first), 0, 1e-15);
                EXPECT_DOUBLE_EQ(found[k].second, 1);
            }
        }
    }
}

// What lies in another body neither mirrors nor counts as a wall: the particle is beside the outer of two boxes, the inner one's face is behind.
TEST(Images, AreNotOfHiddenFaces)
{
    Geometry g = domain(2, {1, 1, 0});
    addWall(g, SolidBox({0.5, 0.2, -Box::infinity}, {0.9, 0.8, Box::infinity}));
    addWall(g, SolidBox({0.45, 0.1, -Box::infinity}, {0.95, 0.9, Box::infinity}));
    Imaged<2> scene(g, 0.3, {{0.4, 0.5}});
    const auto found = weighedGhosts(scene);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_DOUBLE_EQ(found[0].first.x, 0.5);
    int walls = 0;
    scene.images.nearWalls().forEachFoot({0.4, 0.5, 0}, Box::infinity,
                                         [&](const Foot&, const Patch& patch)
                                         {
                                             ++walls;
                                             EXPECT_EQ(patch.wall, 1);
                                         });
    EXPECT_EQ(walls, 1);
}

// Nothing further than `reach` from the particles' side of a wall or face has images.
TEST(Images, EndAtTheReach)
{
    Imaged<2> scene(cornerOfBox(2), 0.3, {{0.29, 0.5}, {0.31, 0.5}, {0.5, 0.31}});
    EXPECT_EQ(scene.images.count(), 1u);
    EXPECT_EQ(scene.countAt({-0.29, 0.5}), 1);
}

// Doubly periodic square, particle near a corner: 3 shifted images; a particle near one face: 1; in the middle: none.
TEST(Images, OfPeriodicFacesAndCorners)
{
    Imaged<2> scene(domain(2, {1, 1, 0}, {true, true, false}), 0.3, {{0.1, 0.9}, {0.95, 0.5}, {0.5, 0.5}});
    EXPECT_EQ(scene.images.count(), 4u);
    EXPECT_EQ(scene.countAt({1.1, 0.9}), 1);
    EXPECT_EQ(scene.countAt({0.1, -0.1}), 1);
    EXPECT_EQ(scene.countAt({1.1, -0.1}), 1);
    EXPECT_EQ(scene.countAt({-0.05, 0.5}), 1);
}

// A period of 1.2 reaches: images on both sides of every particle.
TEST(Images, OfANarrowPeriodAppearOnBothSides)
{
    Imaged<2> scene(domain(2, {0.36, 2, 0}, {true, false, false}), 0.3, {{0.18, 1}});
    EXPECT_EQ(scene.countAt({0.54, 1}), 1);
    EXPECT_EQ(scene.countAt({-0.18, 1}), 1);
}

// Every point around particles in a channel with periodic ends sees exactly what an endless channel holds: compared with a
// channel that is built of all its copies, each mirrored by hand.
TEST(Images, OfAPeriodicChannelEqualThoseOfAnEndlessOne)
{
    Geometry g = domain(2, {1, 1, 0}, {true, false, false});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    addWall(g, Plane({0, 1, 0}, {0, -1, 0}));
    const auto points = randomPoints<2>(200, {1, 1});
    Imaged<2> scene(g, 0.3, points);
    std::size_t expected = 0;
    for (const auto& p : points)
        for (int shift = -2; shift <= 2; ++shift)
            for (double y : {p.y, -p.y, 2 - p.y})
            {
                const Vector<2> x{p.x + shift, y};
                const bool self = shift == 0 && y == p.y, near = x.x > -0.3 && x.x < 1.3 && x.y > -0.3 && x.y < 1.3;
                if (self || !near) continue;
                ++expected;
                EXPECT_EQ(scene.countAt(x), 1) << x.x << ' ' << x.y;
            }
    EXPECT_EQ(scene.images.count(), expected);
}

// Round grains cut by a periodic face. Around each fluid particle the images must be those of the same grains in a domain of
// three periods in x and y, of which this is the middle: same number within reach of every owned particle, and same total
// weight.
TEST(Images, OfGrainsAcrossAPeriodicFaceEqualThoseOfThreePeriods)
{
    const double reach = 0.16, radius = 0.3;
    Geometry one = domain(2, {1, 1, 0}, {true, true, false});
    addWall(one, Cylinder({0.02, 0.1, 0}, {0, 0, 1}, radius, FluidSide::outside));
    auto points = randomPoints<2>(900, {1, 1});
    Geometry copied = one;
    repeatPeriodically(copied, reach);
    std::erase_if(points, [&](Vector<2> p) { return copied.distance(in3D(p)) < 0.01; });
    Imaged<2> scene(one, reach, points);

    Geometry nine = domain(2, {3, 3, 0}, {true, true, false});
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) addWall(nine, Cylinder({0.02 + a, 0.1 + b, 0}, {0, 0, 1}, radius, FluidSide::outside));
    std::vector<Vector<2>> manyPoints;
    for (const auto& p : points)
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) manyPoints.push_back(p + Vector<2>{double(a), double(b)});
    Imaged<2> many(nine, reach, manyPoints);

    const auto seen = [&](Imaged<2>& from, Vector<2> x)
    {
        double count = 0, weight = 0;
        for (std::size_t k = 0; k < from.images.nullParticle(); ++k)
            if (const auto d = positionOf(from.store, k) - x; dot(d, d) < sqr(reach))
            {
                ++count;
                weight += from.store.component("volumeFactor", 0)[k];
            }
        return Vector<2>{count, weight};
    };
    for (const auto& p : points)
    {
        const auto a = seen(scene, p), b = seen(many, p + Vector<2>{1, 1});
        ASSERT_EQ(a.x, b.x) << p.x << ' ' << p.y;
        ASSERT_NEAR(a.y, b.y, 1e-10 * b.y);
    }
}

// A particle in the pinch between two spheres: mirrored in each, and each ghost in the other sphere, in turn: where the surfaces make an angle of 24 degrees until the
// next sphere is beyond the reach, where it is less than 8 three times, since a fourth image would have no weight. Places from the formula x' = c + (2R - r)(x - c)/r.
TEST(Images, OfAPinchGoOnAsFarAsTheReach)
{
    const std::array<Vector<3>, 2> centre{Vector<3>{-1.05, 0, 0}, {1.05, 0, 0}};
    Geometry g = domain(3, {2, 2, 2});
    g.low = {-2, -2, -2};
    for (const auto& c : centre) addWall(g, Sphere(c, 1, FluidSide::outside));
    const double reach = 0.4;
    const auto count = [&](const Vector<3>& x, std::size_t most)
    {
        Imaged<3> scene(g, reach, {x});
        std::size_t images = 0;
        for (const std::size_t first : {0u, 1u})
        {
            auto y = x;
            std::size_t ofChain = 0;
            for (std::size_t in = first; mag(y - centre[in]) - 1 < reach && ofChain < most; in = 1 - in, ++ofChain)
            {
                y = centre[in] + (2 - mag(y - centre[in])) / mag(y - centre[in]) * (y - centre[in]);
                EXPECT_EQ(scene.countAt(y), 1) << images + ofChain;
            }
            images += ofChain;
        }
        EXPECT_EQ(scene.images.count(), images);
        return images;
    };
    EXPECT_EQ(count({0.01, 0.22, 0}, 9), 6u);
    EXPECT_EQ(count({0.01, 0.02, 0}, 3), 6u);
}

// Behind a convex edge two faces share the images: none comes or goes at once as its source goes round the edge, and a lattice around
// it fills the solid once.
TEST(Images, ShareWhatIsBehindAnEdge)
{
    Geometry g = domain(2, {1, 1, 1});
    addWall(g, SolidBox({-9, -9, -Box::infinity}, {0.5, 0.5, Box::infinity}));
    double last = 1;
    for (double x = 0.3; x < 0.5; x += 0.001)
    {
        Imaged<2> near(g, 0.3, {{x, 0.55}});
        double weight = 0;
        for (std::size_t k = 0; k < near.images.count(); ++k)
        {
            EXPECT_LT(mag(positionOf(near.store, 1 + k) - Vector<2>{x, 0.45}), 1e-12);
            weight += near.store.component("volumeFactor", 0)[1 + k];
        }
        EXPECT_LE(weight, last);
        EXPECT_LT(last - weight, 0.02);
        if (x < 0.4) { EXPECT_EQ(weight, 1); }
        if (std::abs(x - 0.45) < 1e-9) { EXPECT_NEAR(weight, 0.5, 1e-9); }
        last = weight;
    }
    EXPECT_NEAR(last, 0, 1e-3);

    std::vector<Vector<2>> lattice;
    for (double x = 0.025; x < 1; x += 0.05)
        for (double y = 0.025; y < 1; y += 0.05)
            if (x > 0.5 || y > 0.5) lattice.push_back({x, y});
    Imaged<2> all(g, 0.3, lattice, 0.05);
    double behind = 0;
    for (std::size_t k = 0; k < all.images.count(); ++k)
    {
        const auto x = positionOf(all.store, all.images.owned() + k);
        EXPECT_TRUE(x.x < 0.5 && x.y < 0.5);
        if (x.x > 0.25 && x.y > 0.25) behind += all.store.component("volumeFactor", 0)[all.images.owned() + k];
    }
    EXPECT_NEAR(behind, 25, 1e-9);
}

// Weight of an image = product of the volume factors of its reflections: ((2R - r)/r)^2 of a sphere, (2R - r)/r of a circle; 1
// of planes and periods. Round-off.
TEST(Images, CarryTheVolumeFactor)
{
    const double r = 1.1;
    const auto weight = [](auto& scene) { return scene.store.component("volumeFactor", 0)[scene.images.owned()]; };
    Geometry ball = domain(3, {2, 2, 2});
    ball.low = {-2, -2, -2};
    addWall(ball, Sphere({0, 0, 0}, 1, FluidSide::outside));
    Imaged<3> outside(ball, 0.3, {{0, 0, r}});
    ASSERT_EQ(outside.images.count(), 1u);
    EXPECT_NEAR(weight(outside), sqr((2 - r) / r), 1e-14);

    Geometry disc = domain(2, {2, 2, 0});
    disc.low = {-2, -2, 0};
    addWall(disc, Cylinder({0, 0, 0}, {0, 0, 1}, 1, FluidSide::inside));
    Imaged<2> inside(disc, 0.3, {{0.9, 0}});
    ASSERT_EQ(inside.images.count(), 1u);
    EXPECT_NEAR(weight(inside), 1.1 / 0.9, 1e-14);

    Imaged<2> plane(cornerOfBox(2), 0.3, {{0.1, 0.5}});
    EXPECT_EQ(weight(plane), 1);
    EXPECT_EQ(plane.store.component("volumeFactor", 0)[0], 1);
}

}
}
