/// Images: where they are, how often, with which weight, and what values they carry.
#include "Images.hpp"
#include "NeighbourLists.hpp"
#include "scenes.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <omp.h>
#include <set>

namespace sph
{
namespace
{

using namespace test;

template<int dim> struct Imaged
{
    Geometry geometry;
    FieldStore<dim> store;
    Images<dim> images;

    Imaged(Geometry g, double reach, const std::vector<Vector<dim>>& points, double spacing = 0.1)
        : geometry((repeatPeriodically(g, reach), std::move(g))), images(geometry, reach, spacing)
    {
        images.rules().set(Velocity{}, std::make_unique<Reversed<dim>>());
        store.allocate(ImageWeight{});
        setPositions(store, points);
        images.build(store, points.size());
    }
    std::vector<Vector<dim>> places()
    {
        std::vector<Vector<dim>> p;
        for (std::size_t k = 0; k < images.count(); ++k) p.push_back(positionOf(store, images.owned() + k));
        return p;
    }
    int countAt(Vector<dim> x, double tolerance = 1e-12)
    {
        const auto all = places();
        return int(std::count_if(all.begin(), all.end(), [&](const auto& p) { return mag(p - x) < tolerance; }));
    }
};

Geometry cornerOfBox(int dimension)
{
    Geometry g = domain(dimension, {1, 1, 1});
    addWall(g, Plane({0, 0, 0}, {1, 0, 0}));
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    if (dimension == 3) addWall(g, Plane({0, 0, 0}, {0, 0, 1}));
    return g;
}

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

// 1 + the wall that an image lies behind, 0 for the fluid, its periodic images and the null particle; the corner's image lies behind both
// walls and has the one that it was mirrored in last. A refresh, which would copy the source's value, leaves it alone; without the field
// in the store nothing is written.
TEST(Images, KnowTheWallTheyLieBehind)
{
    Geometry g = domain(2, {1, 1, 0}, {true, false, false});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    addWall(g, Plane({0, 1, 0}, {0, -1, 0}));
    Imaged<2> scene(g, 0.3, {{0.1, 0.15}, {0.5, 0.8}, {0.5, 0.5}});
    EXPECT_FALSE(scene.store.has(GhostWall{}));
    scene.store.allocate(GhostWall{});
    scene.images.move(scene.store);
    Images<2>::refresh<GhostWall>(scene.images, scene.store);
    const double* const wall = scene.store.component("ghostWall", 0);
    int ghosts[3] = {};
    for (std::size_t j = 0; j <= scene.images.nullParticle(); ++j)
    {
        const auto x = positionOf(scene.store, j);
        const bool null = j == scene.images.nullParticle();
        EXPECT_EQ(wall[j], null || (x.y > 0 && x.y < 1) ? 0 : x.y < 0 ? 1 : 2) << j;
        ++ghosts[int(wall[j])];
    }
    EXPECT_EQ(ghosts[1], 2); // of the first particle and of its periodic image
    EXPECT_EQ(ghosts[2], 1);

    Imaged<2> corner(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    corner.store.allocate(GhostWall{});
    corner.images.move(corner.store);
    for (std::size_t j = 1; j < corner.images.nullParticle(); ++j)
    {
        const auto x = positionOf(corner.store, j);
        const double found = corner.store.component("ghostWall", 0)[j];
        if (x.x > 0) EXPECT_EQ(found, 2);
        else if (x.y > 0) EXPECT_EQ(found, 1);
        else EXPECT_TRUE(found == 1 || found == 2);
    }
}

// Wall ghosts carry the stress of the solid where the scene has one; periodic images carry their sources'.
TEST(Images, TakeTheStressOfTheSolidBehindWalls)
{
    Geometry g = domain(2, {1, 1, 0}, {true, false, false});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    Imaged<2> scene(g, 0.3, {{0.1, 0.15}});
    scene.store.allocate(Stress{});
    const auto fill = [&](auto tag, std::array<double, 3> q)
    {
        for (int c = 0; c < 3; ++c) scene.store.component(tag.info.name, c)[0] = q[std::size_t(c)];
    };
    const auto values = [&](bool behind)
    {
        Images<2>::refresh<Stress>(scene.images, scene.store);
        for (std::size_t j = 1; j < scene.images.nullParticle(); ++j)
            if ((positionOf(scene.store, j).y < 0) == behind)
                return std::array{scene.store.component("S", 0)[j], scene.store.component("S", 1)[j], scene.store.component("S", 2)[j]};
        return std::array<double, 3>{};
    };
    fill(Stress{}, {1, 2, 3});
    EXPECT_EQ(values(true), (std::array<double, 3>{1, -2, 3}));
    scene.store.allocate(SolidStress{});
    fill(SolidStress{}, {5, 6, 7});
    EXPECT_EQ(values(true), (std::array<double, 3>{5, -6, 7}));
    EXPECT_EQ(values(false), (std::array<double, 3>{1, 2, 3}));
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
    scene.images.nearWalls().forEachFoot({0.4, 0.5, 0},
                                         [&](const Foot&, const Patch& patch)
                                         {
                                             ++walls;
                                             EXPECT_EQ(patch.wall, 1);
                                         });
    EXPECT_EQ(walls, 1);
}

// Inside a circle of radius R a particle's image moves (R + d)/(R - d) times as far along the wall as the particle; the images say so, and
// nothing of the kind where walls are plane or convex.
TEST(Images, TellHowFastTheyMove)
{
    const double R = 1, d = 0.3, skin = 0.1;
    Geometry disc = domain(2, {1, 1, 0});
    disc.low = {-1, -1, 0};
    addWall(disc, Cylinder({0, 0, 0}, {0, 0, 1}, R, FluidSide::inside));
    repeatPeriodically(disc, 0.5);
    FieldStore<2> store;
    Images<2> images(disc, 0.5, 0.1, skin);
    images.rules().set(Velocity{}, std::make_unique<Reversed<2>>());
    setPositions<2>(store, {{R - d, 0}});
    images.build(store, 1);
    const auto before = positionOf(store, 1);
    const double angle = 1e-3;
    store.component(Position::info.name, 0)[0] = (R - d) * std::cos(angle);
    store.component(Position::info.name, 1)[0] = (R - d) * std::sin(angle);
    images.move(store);
    const double factor = mag(positionOf(store, 1) - before) / (2 * (R - d) * std::sin(0.5 * angle));
    EXPECT_NEAR(factor, (R + d) / (R - d), 1e-9);
    EXPECT_GE(images.closingSpeed(), 0.5 * (1 + factor));
    EXPECT_NEAR(images.closingSpeed(), 0.5 * (1 + (R + d + 0.5 * skin) / (R - d - 0.5 * skin)), 1e-12);

    Imaged<2> plane(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    EXPECT_EQ(plane.images.closingSpeed(), 1);
    Geometry ball = domain(2, {1, 1, 0});
    addWall(ball, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.3, FluidSide::outside));
    Imaged<2> convex(ball, 0.2, {{0.1, 0.5}});
    EXPECT_EQ(convex.images.count(), 1u);
    EXPECT_EQ(convex.images.closingSpeed(), 1);
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

// Weight of an image = product of the volume factors of its reflections: ((2R - r)/r)^2 of a sphere, (2R - r)/r of a circle; 1
// of planes and periods. Round-off.
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

// Scalars are copied; vectors and tensors are mirrored as the plane x = 0 mirrors them: the x-component and the xy-component
// change sign. Twice mirrored in a corner: both components change sign, xy is itself again. Velocity follows the wall's rule
// (here -v, twice in the corner).
TEST(Images, CarryValuesByTheRuleOfTheField)
{
    Imaged<2> scene(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    auto& store = scene.store;
    store.allocate(Density{});
    store.allocate(ColourGradient{});
    store.allocate(Stress{});
    store.allocate(Velocity{});
    store.component("rho", 0)[0] = 7;
    const double gradient[] = {1, 2}, stress[] = {3, 4, 5}, velocity[] = {6, 8};
    for (int c = 0; c < 2; ++c) store.component("gradC", c)[0] = gradient[c];
    for (int c = 0; c < 3; ++c) store.component("S", c)[0] = stress[c];
    for (int c = 0; c < 2; ++c) store.component("U", c)[0] = velocity[c];
    Images<2>::refresh<Density>(scene.images, store);
    Images<2>::refresh<ColourGradient>(scene.images, store);
    Images<2>::refresh<Stress>(scene.images, store);
    Images<2>::refresh<Velocity>(scene.images, store);
    for (std::size_t k = 1; k < 4; ++k)
    {
        const auto x = positionOf(store, k);
        const double a = x.x < 0 ? -1 : 1, b = x.y < 0 ? -1 : 1;
        EXPECT_EQ(store.component("rho", 0)[k], 7);
        EXPECT_EQ(store.component("gradC", 0)[k], a * 1);
        EXPECT_EQ(store.component("gradC", 1)[k], b * 2);
        EXPECT_EQ(store.component("S", 0)[k], 3);
        EXPECT_EQ(store.component("S", 1)[k], a * b * 4);
        EXPECT_EQ(store.component("S", 2)[k], 5);
        EXPECT_EQ(store.component("U", 0)[k], a * b * 6);
        EXPECT_EQ(store.component("U", 1)[k], a * b * 8);
    }
    // The null particle's values are computed with, times W = 0: they must be finite.
    EXPECT_EQ(store.component("rho", 0)[scene.images.nullParticle()], 7);
}

// Vectors and tensors at a sphere are mirrored in the tangent plane of the foot point: the ghost of (n, t) components has (-n,
// t).
TEST(Images, MirrorVectorsInTheTangentPlaneOfASphere)
{
    Geometry ball = domain(3, {2, 2, 2});
    ball.low = {-2, -2, -2};
    addWall(ball, Sphere({0, 0, 0}, 1, FluidSide::outside));
    const Vector<3> n{2.0 / 3, -1.0 / 3, 2.0 / 3};
    Imaged<3> scene(ball, 0.3, {1.1 * n});
    auto& store = scene.store;
    store.allocate(ColourGradient{});
    store.allocate(Stress{});
    const Vector<3> v{0.3, 0.5, -0.7};
    sph::store(v, [&](int c, double q) { store.component("gradC", c)[0] = q; });
    sph::store(outer(v), [&](int c, double q) { store.component("S", c)[0] = q; });
    Images<3>::refresh<ColourGradient>(scene.images, store);
    Images<3>::refresh<Stress>(scene.images, store);
    const auto expected = v - 2 * dot(v, n) * n;
    sph::store(expected, [&](int c, double q) { EXPECT_NEAR(store.component("gradC", c)[1], q, 1e-15); });
    // R (v v) R = (R v)(R v)
    sph::store(outer(expected), [&](int c, double q) { EXPECT_NEAR(store.component("S", c)[1], q, 1e-15); });
}

/// Keeps the foot points that it is told.
class Listening : public GhostVelocity<2>
{
public:
    mutable std::vector<Vector<3>> feet;
    Vector<2> operator()(Vector<2> v, std::size_t, const Reflection<2>& r, bool) const override
    {
        feet.push_back(r.foot);
        return v;
    }
    Vector<2> change(Vector<2> dv, const Reflection<2>&) const override { return dv; }
};

// The velocity rule is told the foot point of each reflection, on the wall it is mirrored in: the second one is that of the
// ghost, not that of the source. (A wall that turns has another velocity at each place.)
TEST(Images, TellTheFootPointOfEveryReflection)
{
    Imaged<2> scene(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    auto owned = std::make_unique<Listening>();
    const auto& rule = *owned;
    scene.images.rules().set(Velocity{}, std::move(owned));
    scene.store.allocate(Velocity{});
    omp_set_num_threads(1); // the listener's notebook is not shared
    Images<2>::refresh<Velocity>(scene.images, scene.store);
    const auto told = [&](Vector<3> foot)
    { return std::count_if(rule.feet.begin(), rule.feet.end(), [&](Vector<3> f) { return mag(f - foot) < 1e-14; }); };
    EXPECT_EQ(rule.feet.size(), 4u);
    EXPECT_EQ(told({0, 0.15, 0}), 2);
    EXPECT_EQ(told({0.1, 0, 0}), 1);
    EXPECT_EQ(told({-0.1, 0, 0}), 1);
}

// The walls near a particle in a corner are two, although it has a third image; each once, with foot, normal and wall, and never again for its
// periodic copies.
TEST(Images, TellEachWallNearOnce)
{
    Geometry g = domain(2, {1, 1, 0}, {true, false, false});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    addWall(g, Plane({0, 1, 0}, {0, -1, 0}));
    const auto points = randomPoints<2>(300, {1, 1});
    Imaged<2> channel(g, 0.6, points, 0.05);
    for (const auto& x : points)
    {
        std::vector<int> walls;
        channel.images.nearWalls().forEachFoot(in3D(x),
                                               [&](const Foot& foot, const Patch& patch)
                                               {
                                                   if (foot.distance > 0.6)
                                                       return; // within reach of some particles of its cell, not of this
                                                   walls.push_back(patch.wall);
                                                   EXPECT_NEAR(foot.distance, patch.wall == 0 ? x.y : 1 - x.y, 1e-15);
                                                   EXPECT_EQ(foot.normal.y, patch.wall == 0 ? 1 : -1);
                                                   EXPECT_EQ(foot.exposure, 1);
                                               });
        std::sort(walls.begin(), walls.end());
        std::vector<int> expected;
        if (x.y <= 0.6) expected.push_back(0);
        if (x.y >= 0.4) expected.push_back(1);
        EXPECT_EQ(walls, expected) << x.x << ' ' << x.y;
    }

    Imaged<2> corner(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    int told = 0;
    corner.images.nearWalls().forEachFoot({0.1, 0.15, 0},
                                          [&](const Foot& foot, const Patch& patch)
                                          {
                                              ++told;
                                              EXPECT_NEAR(foot.distance, patch.wall == 0 ? 0.1 : 0.15, 1e-15);
                                          });
    EXPECT_EQ(told, 2);
}

// After the particles have moved, move() gives what build() would, as long as the same images exist.
TEST(Images, MoveWithTheirSources)
{
    Geometry ball = domain(2, {1, 1, 0}, {true, false, false});
    addWall(ball, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.3, FluidSide::outside));
    std::vector<Vector<2>> points{{0.5, 0.85}, {0.05, 0.5}, {0.9, 0.9}};
    Imaged<2> scene(ball, 0.25, points);
    for (auto& p : points) p += Vector<2>{0.01, 0.005};
    for (std::size_t i = 0; i < points.size(); ++i)
        sph::store(points[i], [&](int c, double q) { scene.store.component("positions", c)[i] = q; });
    scene.images.move(scene.store);
    Imaged<2> afresh(ball, 0.25, points);
    ASSERT_EQ(scene.images.count(), afresh.images.count());
    for (std::size_t k = 0; k <= scene.images.nullParticle(); ++k)
    {
        EXPECT_EQ(positionOf(scene.store, k).x, positionOf(afresh.store, k).x);
        EXPECT_EQ(positionOf(scene.store, k).y, positionOf(afresh.store, k).y);
        EXPECT_EQ(scene.store.component("volumeFactor", 0)[k], afresh.store.component("volumeFactor", 0)[k]);
    }
}

// Images that no list names are forgotten: the others stay in their places, and lists, sums and what moves are as before.
TEST(Images, ThatNobodySeesAreForgotten)
{
    Geometry ball = domain(2, {1, 1, 0}, {true, false, false});
    addWall(ball, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.3, FluidSide::outside));
    std::vector<Vector<2>> points;
    for (int k = 0; k < 400; ++k)
        if (const Vector<2> p{std::fmod(0.5 + k * 0.7548776662, 1.0), std::fmod(0.5 + k * 0.5698402910, 1.0)};
            mag(p - Vector<2>{0.5, 0.5}) > 0.3)
            points.push_back(p);
    const double reach = 0.2;
    Imaged<2> all(ball, reach, points), seen(ball, reach, points);
    NeighbourLists<2> lists;
    lists.build(std::as_const(seen.store).pointers(Position{}), points.size(), seen.images.nullParticle(), reach);
    seen.images.keepSeen(lists.seen());
    std::set<int> named;
    NeighbourLists<2>::Room room;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const int j : lists.of(i, room))
            if (j >= int(points.size()) && j < int(seen.images.nullParticle())) named.insert(j);
    EXPECT_EQ(seen.images.count(), named.size());
    EXPECT_LT(seen.images.count(), 0.9 * double(all.images.count()));
    EXPECT_EQ(seen.images.nullParticle(), all.images.nullParticle());
    const auto places = all.places();
    for (std::size_t k = 0; k < places.size(); ++k)
        sph::store(Vector<2>{}, [&](int c, double q) { seen.store.component("positions", c)[points.size() + k] = q; });
    seen.images.move(seen.store);
    for (const int j : named)
    {
        EXPECT_EQ(mag(positionOf(seen.store, std::size_t(j)) - positionOf(all.store, std::size_t(j))), 0) << j;
        EXPECT_EQ(seen.store.component("volumeFactor", 0)[j], all.store.component("volumeFactor", 0)[j]) << j;
    }
}

// Of the three within 0.06 m of the floor or of the block one is also near both, and is told once.
TEST(Images, NameTheParticlesThatAreNearTheirFaces)
{
    Imaged<2> scene(tankWithBlock(), 0.2, {{0.2, 0.5}, {0.2, 0.05}, {0.35, 0.05}, {0.36, 0.2}, {0.2, 0.07}}, 0.05);
    const auto near = scene.images.nearFaces(0.06);
    ASSERT_EQ(near.size(), 3);
    const std::pair<std::size_t, double> expected[]{{1, 0.05}, {2, 0.05}, {3, 0.04}};
    for (std::size_t k = 0; k < 3; ++k)
    {
        EXPECT_EQ(near[k].first, expected[k].first);
        EXPECT_NEAR(near[k].second, expected[k].second, 1e-15);
    }
}

}
}
