#include "packing/Relaxation.hpp"
#include "geometry/makeWallLayers.hpp"
#include "handMadeGeometry.hpp"
#include "images/Images.hpp"
#include "packing/FluidSpace.hpp"
#include "packing/Lattice.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <omp.h>

using namespace sph;

namespace
{
constexpr double supportInSpacings = 2.6;

Points fluidPlaces(const Geometry& g, const LatticeSpec& spec)
{
    const auto lattice = Lattice(spec, g.dimension, fluidBox(g), g.periodic).points();
    Points points;
    for (std::size_t i = 0; i < lattice.size(); ++i)
        if (g.distance(lattice[i]) > 0) points.add(lattice[i]);
    return points;
}

template<int dim> RelaxationResult relaxed(const Geometry& g, double spacing, int steps, Points& points, const char* kernel = "wendlandC2")
{
    RelaxationSettings settings;
    settings.steps = steps;
    settings.tolerance = 0;
    const double V0 = fluidVolume(g, spacing / 4).value / double(points.size());
    return relax<dim>(g, Kernel<dim>(kernel, supportInSpacings * spacing), V0, spacing, settings, {}, points);
}

/// Of one particle, as the relaxation makes them.
template<int dim> Images<dim> imagesOf(const Geometry& g, Vector<dim> at, FieldStore<dim>& store)
{
    store.allocate(Position{});
    store.allocate(ImageWeight{});
    store.resize(2, 1);
    const auto x = store.pointers(Position{});
    sph::store(at, [&](int c, double q) { x[c][0] = q; });
    Images<dim> images(g, 0.5, 0.1);
    images.build(store, 1);
    return images;
}

double radiusFor(double solidFraction) { return std::cbrt(solidFraction * 3 / (4 * std::numbers::pi)); }
}

// Simple cubic bed, solid fraction 0.343, 16 spacings a period. Prototype: scatter at walls 8 % on the lattice, 0.1 % after 200 steps
// with the bias falling from 1 to 0.01. Measured here 5.86 % and 0.109 %; the limit allows a third more.
TEST(Relaxation, evensTheDensityAtTheGrainsOfABed)
{
    const double spacing = 1.0 / 16;
    const auto g = cubicBed(radiusFor(0.343), 3 * spacing);
    auto points = fluidPlaces(g, {"cubic", spacing, 0, 1});
    ASSERT_EQ(points.size(), 2720u);
    const auto r = relaxed<3>(g, spacing, 200, points);
    EXPECT_GT(r.before.nearWalls.scatter, 0.05);
    EXPECT_LT(r.after.nearWalls.scatter, 0.0015);
    EXPECT_LT(r.after.overall.scatter, 0.0015);
    // the constant that is left is the kernel's own, 0.7-1 % at this support
    EXPECT_NEAR(r.after.overall.mean, 0.007, 0.003);
    EXPECT_GT(r.closestPair, 0.7 * spacing);
    for (std::size_t i = 0; i < points.size(); ++i) ASSERT_GT(g.distance(points[i]), 0);
}

// The same bed with walls by layers, against which the fluid is relaxed in the place of mirror images: measured 2.8 % on the lattice, for
// layers do not mirror how near particles are to the wall.
TEST(Relaxation, evensTheDensityAtWallsByLayers)
{
    const double spacing = 1.0 / 16;
    auto g = cubicBed(radiusFor(0.343), 3 * spacing);
    Diagnostics none;
    g.layers = makeWallLayers(g, supportInSpacings * spacing, spacing, none);
    ASSERT_TRUE(none.ok());
    auto points = fluidPlaces(g, {"cubic", spacing, 0, 1});
    const auto r = relaxed<3>(g, spacing, 200, points);
    EXPECT_GT(r.before.nearWalls.scatter, 0.02);
    EXPECT_LT(r.after.nearWalls.scatter, 0.003);
    EXPECT_EQ(points.size(), 2720u) << "layers are no particles of the fluid";
    for (std::size_t i = 0; i < points.size(); ++i) ASSERT_GT(g.distance(points[i]), 0);
}

// Touching spheres (0.5236): no particle may end up in a grain, near the contacts least of all, and scatter still falls twentyfold.
TEST(Relaxation, keepsParticlesOutOfTouchingSpheres)
{
    const double spacing = 1.0 / 16;
    const auto g = cubicBed(0.5, 3 * spacing);
    auto points = fluidPlaces(g, {"cubic", spacing, 0, 1});
    const auto r = relaxed<3>(g, spacing, 200, points);
    EXPECT_LT(r.after.nearWalls.scatter, 0.05 * r.before.nearWalls.scatter);
    for (std::size_t i = 0; i < points.size(); ++i) ASSERT_GT(g.distance(points[i]), 0) << points[i].x << ' ' << points[i].y;
}

// The forces are antisymmetric: without walls the centre of mass stays, to round-off, although every particle moves. With more jitter
// some first steps are cut to a tenth of a spacing, and what that leaves is a thousandth of a spacing at most.
TEST(Relaxation, leavesTheCentreOfMass)
{
    const double spacing = 1.0 / 12;
    const Geometry g = emptyBox(3, {1, 1, 1}, {true, true, true});
    auto points = fluidPlaces(g, {"cubic", spacing, 0.05, 3});
    auto r = relaxed<3>(g, spacing, 60, points);
    EXPECT_LT(r.after.overall.scatter, 0.1 * r.before.overall.scatter);
    EXPECT_LT(r.centreOfMassDrift, 1e-10);

    points = fluidPlaces(g, {"cubic", spacing, 0.2, 3});
    r = relaxed<3>(g, spacing, 60, points);
    EXPECT_LT(r.after.overall.scatter, 0.05 * r.before.overall.scatter);
    EXPECT_LT(r.centreOfMassDrift, 1e-3);
}

// A full lattice between planes is even already: images complete every kernel sum, in the corners of a box too, so that the residual
// is the same everywhere to round-off and nothing moves.
TEST(Relaxation, findsNothingToDoInChannelsAndBoxes)
{
    const double spacing = 0.1;
    const auto slit = channel(2, 1, 1, 0.3);
    auto points = fluidPlaces(slit, {"cubic", spacing, 0, 1});
    ASSERT_EQ(points.size(), 100u);
    auto r = relaxed<2>(slit, spacing, 0, points);
    EXPECT_LT(r.before.overall.scatter, 1e-7);

    Geometry room = emptyBox(3, {1, 1, 1}, {});
    for (const Vector<3>& n : {Vector<3>{1, 0, 0}, Vector<3>{0, 1, 0}, Vector<3>{0, 0, 1}})
    {
        add(room, Plane({0, 0, 0}, n));
        add(room, Plane({1, 1, 1}, -n));
    }
    repeatPeriodically(room, 0.3);
    points = fluidPlaces(room, {"cubic", spacing, 0, 1});
    ASSERT_EQ(points.size(), 1000u);
    r = relaxed<3>(room, spacing, 0, points);
    EXPECT_LT(r.before.overall.scatter, 1e-7);
    EXPECT_EQ(r.before.nearWalls.particles, 1000u - 4 * 4 * 4u);
}

// A 60 degree fluid wedge needs third reflections (AB and BA differ, ABA and BAB coincide): none is counted twice. A point on its
// bisector has exactly five images, as in the kaleidoscope.
TEST(RelaxationImages, fillAWedgeOfSixtyDegreesOnce)
{
    Geometry g = emptyBox(2, {1, 1, 0}, {});
    g.low = {-1, -1, 0};
    const double angle = std::numbers::pi / 3;
    add(g, Plane({0, 0, 0}, {0, 1, 0}));
    add(g, Plane({0, 0, 0}, {std::sin(angle), -std::cos(angle), 0}));
    repeatPeriodically(g, 0.5);
    FieldStore<2> store;
    const auto images = imagesOf<2>(g, {0.1 * std::cos(0.4), 0.1 * std::sin(0.4)}, store);
    EXPECT_EQ(images.count(), 5u);
    const auto x = store.pointers(Position{});
    for (std::size_t i = 1; i <= images.count(); ++i) EXPECT_NEAR(std::hypot(x[0][i], x[1][i]), 0.1, 1e-12);
}

// The image of a particle at distance d outside a sphere of radius R has the volume factor ((R - d)/(R + d))^2 and lies d inside.
TEST(RelaxationImages, reflectInASphereWithItsVolumeFactor)
{
    Geometry g = emptyBox(3, {4, 4, 4}, {});
    add(g, Sphere({2, 2, 2}, 1, FluidSide::outside));
    repeatPeriodically(g, 0.5);
    FieldStore<3> store;
    const auto images = imagesOf<3>(g, {3.2, 2, 2}, store);
    ASSERT_EQ(images.count(), 1u);
    EXPECT_NEAR(store.component("positions", 0)[1], 2.8, 1e-12);
    EXPECT_NEAR(store.component("volumeFactor", 0)[1], sqr(0.8 / 1.2), 1e-12);
}

// The same bits with one thread and with two: every particle sums its own list in the list's order.
TEST(Relaxation, doesNotDependOnTheNumberOfThreads)
{
    const double spacing = 1.0 / 12;
    const auto g = cubicBed(0.45, 3 * spacing);
    std::vector<Points> results;
    const int threads = omp_get_max_threads();
    for (const int n : {1, 2})
    {
        omp_set_num_threads(n);
        auto points = fluidPlaces(g, {"cubic", spacing, 0.1, 5});
        relaxed<3>(g, spacing, 50, points);
        results.push_back(points);
    }
    omp_set_num_threads(threads);
    EXPECT_EQ(results[0].x, results[1].x);
    EXPECT_EQ(results[0].y, results[1].y);
    EXPECT_EQ(results[0].z, results[1].z);
}

// The cubic spline lets particles pair; relaxing with it must not (0.31 spacings when pushed with its own gradient, support 2.4).
TEST(Relaxation, doesNotPairWithTheCubicSpline)
{
    const double spacing = 1.0 / 16;
    const auto g = cubicBed(radiusFor(0.343), 3 * spacing);
    auto points = fluidPlaces(g, {"cubic", spacing, 0, 1});
    const auto r = relaxed<3>(g, spacing, 200, points, "cubicSpline");
    EXPECT_GT(r.closestPair, 0.6 * spacing);
    EXPECT_LT(r.after.nearWalls.scatter, 0.003);
}

// A circle in a periodic square, hexagonal start: the same laws in 2-D.
TEST(Relaxation, worksInTwoDimensions)
{
    const double spacing = 1.0 / 24;
    Geometry g = emptyBox(2, {1, 1, 0}, {true, true, false});
    add(g, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.3, FluidSide::outside));
    repeatPeriodically(g, 3 * spacing);
    auto points = fluidPlaces(g, {"hexagonal", spacing, 0, 1});
    const auto r = relaxed<2>(g, spacing, 200, points);
    EXPECT_GT(r.before.nearWalls.scatter, 0.03);
    EXPECT_LT(r.after.nearWalls.scatter, 0.005);
}

// A rod in the fillet of two walls seals a pocket. The lattice puts too many particles there, part of its area being too narrow for any, or, where every fourth is left out, too few. Corrected and relaxed in turns, it comes
// to a number that stays, and no two particles were put in one place.
TEST(Relaxation, fillsAPocketThatIsSealed)
{
    const double spacing = 1.0 / 32;
    Geometry g = emptyBox(2, {1, 1, 0}, {false, false, false});
    for (const auto& [at, n] : {std::pair(Vector<3>{0, 0, 0}, Vector<3>{1, 0, 0}), std::pair(Vector<3>{1, 0, 0}, Vector<3>{-1, 0, 0}),
                                std::pair(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), std::pair(Vector<3>{0, 1, 0}, Vector<3>{0, -1, 0})})
        add(g, Plane(at, n));
    const Vector<3> centre{0.35, 0.35, 0};
    add(g, Cylinder(centre, {0, 0, 1}, 0.35, FluidSide::outside));
    repeatPeriodically(g, 3 * spacing);
    const auto isSealed = [&](const Vector<3>& x) { return x.x < centre.x && x.y < centre.y; };

    for (const bool thinned : {false, true})
    {
        SCOPED_TRACE(thinned);
        Points places;
        std::size_t k = 0;
        const auto all = fluidPlaces(g, {"cubic", spacing, 0, 1});
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!isSealed(all[i]) || !thinned || ++k % 4 != 0) places.add(all[i]);
        RelaxationSettings settings;
        settings.steps = 100;
        settings.tolerance = 0;
        settings.correctsPockets = true;
        const double volume = fluidVolume(g, spacing / 4).value;
        const Kernel<2> kernel("wendlandC2", supportInSpacings * spacing);
        std::size_t added = 0, takenOut = 0, relaxations = 0;
        for (bool changes = true; changes && relaxations < 5; ++relaxations)
        {
            const std::size_t before = places.size();
            const auto r = relax<2>(g, kernel, volume / double(before), spacing, settings, {}, places);
            EXPECT_EQ(r.sealed.pockets, 1u);
            EXPECT_EQ(places.size(), before + r.sealed.added - r.sealed.takenOut);
            EXPECT_GT(r.closestPair, 0.2 * spacing);
            added += r.sealed.added;
            takenOut += r.sealed.takenOut;
            changes = r.sealed.added + r.sealed.takenOut > 0;
        }
        EXPECT_LT(relaxations, 5u);
        EXPECT_EQ(added > 0, thinned);
        EXPECT_EQ(takenOut > 0, !thinned);
    }
}
