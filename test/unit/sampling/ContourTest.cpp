/// Level sets of functions and of particles against shapes that are known.
#include "sampling/Contour.hpp"
#include "Observed.hpp"
#include "geometry/Plane.hpp"
#include "geometry/Sphere.hpp"
#include "sampling/Errors.hpp"
#include "sampling/Reduction.hpp"
#include "sampling/SphereFit.hpp"
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numbers>

using namespace sph;

namespace
{

constexpr double pi = std::numbers::pi;

/// Nodes of a cube of side 2 around the origin, in so many directions.
Lattice around(std::size_t dimension, std::size_t n)
{
    const std::array<Vector<3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Lattice lattice{{}, {}, {}};
    for (std::size_t k = 0; k < dimension; ++k)
    {
        lattice.origin -= axes[k];
        lattice.edges.push_back(2.0 / double(n) * axes[k]);
        lattice.cells.push_back(n);
    }
    return lattice;
}

LevelSet setOf(
    const Lattice& lattice, const std::function<double(const Vector<3>&)>& f,
    const std::function<double(const Vector<3>&)>& inside = [](const Vector<3>&) { return 10.0; })
{
    std::vector<double> atNodes;
    for (std::size_t k = 0; k < lattice.nodes(); ++k) atNodes.push_back(f(lattice.node(k)));
    return levelSet(lattice, atNodes, 0, f, inside);
}

/// The columns of the row that a contour of the particles has, by their names.
std::map<std::string, double> contourOf(const Particles& particles, const std::string& text)
{
    Observed<Contour> object;
    const auto row = object.rowsOf(particles, text).at(0);
    const auto file = object.folder.read("postProcessing/own/0/contour.dat");
    std::istringstream names(file.substr(file.find("# Time") + 7));
    std::map<std::string, double> columns;
    std::string name;
    for (std::size_t k = 1; k < row.size() && names >> name; ++k) columns[name] = std::stod(row[k]);
    return columns;
}

/// Water where f is true, air beside it, in a box.
Particles twoPhases(int dimension, Vector<3> low, Vector<3> high, double spacing, const std::function<bool(const Vector<3>&)>& f)
{
    Particles particles(dimension, low, high, spacing);
    particles.phases = {"water", "air"};
    particles.setPhase([&](Vector<3> x) { return f(x) ? 0 : 1; });
    return particles;
}

/// The water alone.
Particles withoutAir(const Particles& both)
{
    Particles water(both.geometry.dimension, {}, {}, both.spacing);
    water.geometry = both.geometry;
    for (std::size_t i = 0; i < both.size(); ++i)
        if (both.phase[i] == 0) water.add(both.position(i));
    return water;
}

void addFloor(Particles& particles, double contactAngle = 90)
{
    auto& g = particles.geometry;
    g.walls.resize(1);
    g.walls[0].name = "floor";
    g.walls[0].contactAngle = contactAngle;
    g.patches = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0}};
}

}

// Places lie on the set to round-off; size and content are those of its chords, of second order.
TEST(LevelSet, ofCirclesAndSpheresConvergesInTheSecondOrder)
{
    const auto f = [](const Vector<3>& x) { return 0.75 - mag(x - Vector<3>{0.03, 0.02, 0}); };
    for (const std::size_t dimension : {2u, 3u})
    {
        const double content = dimension == 2 ? pi * sqr(0.75) : 4 * pi * std::pow(0.75, 3) / 3;
        const double surface = dimension == 2 ? 2 * pi * 0.75 : 4 * pi * sqr(0.75);
        double before = 0, sizeBefore = 0;
        for (const std::size_t n : {8u, 16u, 32u})
        {
            const auto set = setOf(around(dimension, n), f);
            for (const auto& place : set.places) ASSERT_NEAR(f(place.x), 0, 1e-10);
            const double error = std::fabs(set.enclosed / content - 1), sizeError = std::fabs(set.size / surface - 1);
            if (before > 0)
            {
                EXPECT_GT(before / error, 3) << dimension << " " << n;
                EXPECT_GT(sizeBefore / sizeError, 3) << dimension << " " << n;
            }
            before = error;
            sizeBefore = sizeError;
        }
        EXPECT_LT(before, 0.005);
        EXPECT_LT(sizeBefore, 0.005);
    }
}

// A linear function, cut by a slanted plane: areas of polygons by hand, on a line, in a plane and in space.
TEST(LevelSet, ofALinearFunctionIsExact)
{
    const auto f = [](const Vector<3>& x) { return 0.3 - x.x; };
    const auto inside = [](const Vector<3>& x) { return (0.4 - x.y) / std::sqrt(2.0); };
    const auto onLine = setOf(around(1, 7), f);
    EXPECT_EQ(onLine.size, 1);
    EXPECT_NEAR(onLine.enclosed, 1.3, 1e-12);
    for (const std::size_t dimension : {2u, 3u})
    {
        const double depth = dimension == 3 ? 2 : 1;
        const auto set = setOf(around(dimension, 9), f, inside);
        EXPECT_NEAR(set.size, 1.4 * depth, 1e-12);
        EXPECT_NEAR(set.enclosed, 1.3 * 1.4 * depth, 1e-12);
        EXPECT_NEAR(set.moment.x / set.enclosed, -0.35, 1e-12);
        EXPECT_NEAR(set.moment.y / set.enclosed, -0.3, 1e-12);
    }
}

TEST(LevelSet, endsWhereThereIsNothing)
{
    const auto lattice = around(2, 10);
    std::vector<double> atNodes;
    for (std::size_t k = 0; k < lattice.nodes(); ++k)
        atNodes.push_back(lattice.node(k).y > 0.01 ? std::numeric_limits<double>::quiet_NaN() : -lattice.node(k).x + 0.1);
    const auto set = levelSet(
        lattice, atNodes, 0, [](const Vector<3>& x) { return 0.1 - x.x; }, [](const Vector<3>&) { return 10.0; });
    EXPECT_NEAR(set.size, 1, 1e-12);
    EXPECT_NEAR(set.enclosed, 1.1, 1e-12);
}

// Exact points: round-off times the condition of the fit.
TEST(EllipsoidFit, recoversWhatPointsLieOn)
{
    std::vector<Vector<3>> ellipse, ellipsoid;
    const Vector<3> a{0.6, 0.8, 0}, b{-0.8, 0.6, 0};
    for (int k = 0; k < 40; ++k)
    {
        const double angle = k * 0.1; // two thirds of it
        ellipse.push_back(Vector<3>{5, -3, 0} + 2 * std::cos(angle) * a + 0.5 * std::sin(angle) * b);
        for (int m = 1; m < 12; ++m)
            ellipsoid.push_back(Vector<3>{1, 2, 3} + std::cos(angle) * std::sin(m / 4.0) * a + 2 * std::sin(angle) * std::sin(m / 4.0) * b +
                                0.5 * std::cos(m / 4.0) * Vector<3>{0, 0, 1});
    }
    const auto flat = fitEllipsoid(ellipse, 2), spatial = fitEllipsoid(ellipsoid, 3);
    EXPECT_NEAR(mag(flat.centre - Vector<3>{5, -3, 0}), 0, 1e-9);
    EXPECT_NEAR(mag(flat.semiAxes - Vector<3>{2, 0.5, 0}), 0, 1e-9);
    EXPECT_NEAR(mag(spatial.centre - Vector<3>{1, 2, 3}), 0, 1e-9);
    EXPECT_NEAR(mag(spatial.semiAxes - Vector<3>{2, 1, 0.5}), 0, 1e-9);
    EXPECT_EQ(fitEllipsoid(std::vector<Vector<3>>(4), 2).semiAxes.x, 0);
}

// Circles and spheres cut out of a lattice: the volume, of chords of one spacing, is too small by 1.5 % in 3-D, the radius that of the sphere, which the lattice's staircase misses by a small part of the spacing.
TEST(Contour, ofAPhaseIsItsSurface)
{
    for (const int dimension : {2, 3})
    {
        const double spacing = 1.0 / (dimension == 2 ? 24 : 12);
        const Vector<3> centre{0.1 * spacing, -0.2 * spacing, dimension == 3 ? 0.3 * spacing : 0};
        const auto ball =
            twoPhases(dimension, {-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}, spacing, [&](const Vector<3>& x) { return mag(x - centre) < 1; });
        for (const auto& particles : {ball, withoutAir(ball)})
        {
            auto c = contourOf(particles, "phase water;");
            const double content = dimension == 2 ? pi : 4 * pi / 3, surface = dimension == 2 ? 2 * pi : 4 * pi;
            EXPECT_NEAR(c["radius"], 1, 0.1 * spacing);
            EXPECT_NEAR(c["volume"] / content, 1, dimension == 2 ? 0.01 : 0.02); // that of its chords
            EXPECT_NEAR(c["area"] / surface, 1, 0.01);
            EXPECT_NEAR(c["front"], 1 + centre.x, 0.25 * spacing);
            EXPECT_NEAR(c["rear"], -1 + centre.x, 0.25 * spacing);
            EXPECT_NEAR(c["centre_y"], centre.y, 0.1 * spacing);
            EXPECT_NEAR(c["centroid_x"], centre.x, 0.1 * spacing);
            EXPECT_LT(c["misfit"], 0.2 * spacing);
            EXPECT_NEAR(c["semiAxis1"], 1, 0.2 * spacing);
            EXPECT_NEAR(c[dimension == 2 ? "semiAxis2" : "semiAxis3"], 1, 0.2 * spacing);
            EXPECT_FALSE(c.contains("angle"));
        }
    }
}

// The level of a smooth field: the interpolation is of second order, and so is the radius.
TEST(Contour, ofAFieldConvergesInTheSecondOrder)
{
    double before = 0;
    for (const int n : {10, 20})
    {
        const Particles particles(3, {-1, -1, -1}, {1, 1, 1}, 1.0 / n);
        auto c = contourOf(particles, "value \"$x^2 + $y^2/4 + $z^2\"; level 0.2; direction (0 1 0);");
        const double error = std::fabs(c["semiAxis1"] / (2 * std::sqrt(0.2)) - 1);
        if (before > 0)
        {
            EXPECT_GT(before / error, 3);
            EXPECT_LT(error, 0.01);
            EXPECT_NEAR(c["semiAxis2"] / std::sqrt(0.2), 1, 0.02);
            EXPECT_NEAR(c["semiAxis3"] / std::sqrt(0.2), 1, 0.02);
            EXPECT_NEAR(c["front"] / (2 * std::sqrt(0.2)), 1, 0.02);
        }
        before = error;
    }
}

// Caps cut out of a lattice, 24 spacings high in 2-D and 16 in 3-D, in air and alone: the staircase is what keeps the fit from the exact angle.
TEST(Contour, meetsAWallAtTheAngleOfACap)
{
    for (const auto& [dimension, degrees, bound] :
         {std::tuple{2, 30.0, 0.5}, {2, 60.0, 0.5}, {2, 120.0, 0.5}, {2, 150.0, 0.5}, {3, 60.0, 1.0}, {3, 120.0, 1.0}})
    {
        const double height = dimension == 2 ? 24 : 16, theta = degrees * pi / 180, R = height / (1 - std::cos(theta));
        const double half = std::ceil((degrees < 90 ? R * std::sin(theta) : R) + 4);
        const Vector<3> centre{0.3, -R * std::cos(theta), dimension == 3 ? 0.2 : 0};
        auto particles =
            twoPhases(dimension, {-half, 0, -half}, {half, height + 4, half}, 1, [&](const Vector<3>& x) { return mag(x - centre) < R; });
        addFloor(particles);
        EXPECT_NEAR(contourOf(particles, "phase water; wall floor;")["angle"], degrees, bound);
        EXPECT_NEAR(contourOf(particles, "phase air; wall floor;")["angle"], 180 - degrees, bound);
        EXPECT_NEAR(contourOf(withoutAir(particles), "phase water; wall floor;")["angle"], degrees, 1.5 * bound);
        auto c = contourOf(particles, "phase water; wall floor;");
        const double cap = dimension == 2 ? sqr(R) * (theta - std::sin(theta) * std::cos(theta)) : pi * sqr(height) * (3 * R - height) / 3;
        EXPECT_NEAR(c["volume"] / cap, 1, 0.02);
    }
}

// Outside of a sphere, whose curvature counts.
TEST(Contour, meetsASphereAtTheAngleOfACap)
{
    const double solid = 40, R = 25, theta = pi / 3, away = std::sqrt(sqr(R) + sqr(solid) - 2 * R * solid * std::cos(theta));
    auto particles = twoPhases(2, {-60, 0, 0}, {60, 80, 0}, 1,
                               [&](const Vector<3>& x) {
                                   return mag(x) > solid && mag(x - Vector<3>{0.3, away, 0}) < R;
                               });
    addFloor(particles);
    particles.geometry.patches = {{std::make_shared<Sphere>(Vector<3>{}, solid, FluidSide::outside), 0}};
    EXPECT_NEAR(contourOf(particles, "phase water; wall floor;")["angle"], 60, 1);
}

// The section of a sphere by a plane beside its middle is a circle; a centre that is given stays where it is.
TEST(Contour, inACutIsThatOfTheSection)
{
    const double spacing = 1.0 / 16, height = 0.6, section = 0.8;
    const auto ball = twoPhases(3, {-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25}, spacing, [](const Vector<3>& x) { return mag(x) < 1; });
    auto c = contourOf(ball, "phase water; cut { point (0 0 0.6); normal (0 0 1); }");
    EXPECT_NEAR(c["radius"], section, 0.15 * spacing);
    EXPECT_NEAR(c["area"], 2 * pi * section, 0.05);
    EXPECT_NEAR(c["volume"], pi * sqr(section), 0.05);
    EXPECT_NEAR(c["centre_z"], height, 1e-12);
    auto fixed = contourOf(
        ball, "phase water; cut { point (0 0.6 0); normal (0 1 0); } centre (0 0.6 0); region { min (0 -1.25 0); max (1.25 1.25 1.25); }");
    EXPECT_NEAR(fixed["radius"], section, 0.15 * spacing);
    EXPECT_NEAR(fixed["area"], pi * section / 2, 0.03);
    EXPECT_NEAR(fixed["centre_y"], height, 1e-12);
    // On a line in 2-D two places are left.
    auto disc = twoPhases(2, {-1.5, -1.5, 0}, {1.5, 1.5, 0}, spacing, [](const Vector<3>& x) { return mag(x) < 1; });
    auto line = contourOf(disc, "phase water; cut { point (0 0.6 0); normal (0 1 0); } centre (0 0.6 0);");
    EXPECT_EQ(line["area"], 2);
    EXPECT_NEAR(line["radius"], section, 0.25 * spacing);
}

// Mirrored in planes of symmetry a quarter has the section of the whole, also without air.
TEST(Contour, goesOnBeyondPlanesOfSymmetry)
{
    const double spacing = 1.0 / 16;
    auto quarter = twoPhases(2, {0, 0, 0}, {1.5, 1.5, 0}, spacing, [](const Vector<3>& x) { return mag(x) < 1; });
    auto& g = quarter.geometry;
    g.walls.resize(2);
    g.walls[0].slips = g.walls[1].slips = true;
    g.patches = {{std::make_shared<Plane>(Vector<3>{}, Vector<3>{1, 0, 0}), 0},
                 {std::make_shared<Plane>(Vector<3>{}, Vector<3>{0, 1, 0}), 1}};
    const auto whole = twoPhases(2, {-1.5, -1.5, 0}, {1.5, 1.5, 0}, spacing, [](const Vector<3>& x) { return mag(x) < 1; });
    for (const bool alone : {false, true})
    {
        auto a = contourOf(alone ? withoutAir(quarter) : quarter, "phase water; centre (0 0 0);"),
             b = contourOf(alone ? withoutAir(whole) : whole, "phase water; centre (0 0 0);");
        EXPECT_NEAR(a["area"], b["area"] / 4, 2e-3);
        EXPECT_NEAR(a["volume"], b["volume"] / 4, 1e-3);
        EXPECT_NEAR(a["radius"], b["radius"], 1e-3);
    }
}

TEST(Contour, isInOnePieceAcrossAPeriodicFace)
{
    const double spacing = 0.05;
    const auto across = [](const Vector<3>& x) { return std::hypot(std::fabs(x.x - 1) < 0.5 ? x.x - 1 : x.x, x.y - 0.5) < 0.3; };
    auto particles = twoPhases(2, {0, 0, 0}, {1, 1, 0}, spacing, across);
    particles.geometry.periodic = {true, false, false};
    auto c = contourOf(particles, "phase water;");
    EXPECT_NEAR(c["radius"], 0.3, 0.1 * spacing);
    EXPECT_NEAR(c["front"] - c["rear"], 0.6, 0.5 * spacing);
    EXPECT_NEAR(c["volume"], pi * 0.09, 0.01);
}

// A level of a field ends at walls and where the particles end; it is straight, and so its length is exact to what the end of the particles is known to.
TEST(Contour, ofAFieldEndsWhereTheFluidEnds)
{
    const double spacing = 0.05;
    Particles particles(2, {0, 0, 0}, {1, 2, 0}, spacing);
    addFloor(particles);
    particles.geometry.low.y = 0;
    Particles basin(2, {}, {}, spacing);
    basin.geometry = particles.geometry;
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (particles.y[i] < 1) basin.add(particles.position(i));
    auto c = contourOf(basin, "value \"$x + 0.5\"; level 0.8;");
    EXPECT_NEAR(c["area"], 1, 0.1 * spacing);
    EXPECT_NEAR(c["volume"], 0.7, 0.1 * spacing);
    EXPECT_NEAR(c["front"], 0.3, 1e-9);
    EXPECT_NEAR(c["rear"], 0.3, 1e-9);
}

// A front that moves at 0.4: it was past 0.3 and 0.5 at the times when it was there; the last place it has not reached.
TEST(Contour, arrivesWhenTheFrontDoes)
{
    Observed<Contour> object;
    Particles particles(2, {0, 0, 0}, {1, 0.5, 0}, 0.05);
    const auto contour = object.made(particles, "value \"$p\"; level 0; stations (0.3 0.5 0.9);");
    EXPECT_EQ(errorsOf(object.theCase.diagnostics()), "");
    for (const double t : {0.0, 0.6, 1.1})
    {
        particles.time = t;
        particles.setP([&](Vector<3> x) { return 0.2 + 0.4 * t - x.x; });
        contour->execute(particles.view());
    }
    const auto row = object.folder.rows("postProcessing/own/0/contour.dat").at(2);
    EXPECT_NEAR(std::stod(row.at(row.size() - 3)), 0.25, 1e-9);
    EXPECT_NEAR(std::stod(row.at(row.size() - 2)), 0.75, 1e-9);
    EXPECT_EQ(row.back(), "nan");
    Observed<Contour> restarted;
    const auto again = restarted.made(particles, "value \"$p\"; level 0; stations (0.3 0.5 0.9);");
    again->restore(contour->histories());
    again->execute(particles.view());
    EXPECT_NEAR(std::stod(restarted.folder.rows("postProcessing/own/0/contour.dat").at(0).at(row.size() - 3)), 0.25, 1e-9);
}

TEST(Contour, isANumberThatErrorsCompare)
{
    auto particles = twoPhases(2, {-1.5, 0, 0}, {1.5, 1.5, 0}, 1.0 / 24, [](const Vector<3>& x) { return mag(x) < 1; });
    addFloor(particles, 85);
    Observed<Errors> object;
    const auto rows = object.rowsOf(particles, R"n(norm absolute; numbers
        {
            theta  { operation contour; phase water; wall floor; gives angle; reference { type expression; value "${contactAngle(floor)}"; } }
            length { operation contour; phase water; gives area; }
            radius { value "$length/pi()"; reference { type expression; value 1; } }
        })n");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_NEAR(std::stod(rows[0][7]), 90, 0.5);
    EXPECT_EQ(std::stod(rows[0][8]), 85);
    EXPECT_NEAR(std::stod(rows[0][3]), 5, 0.5);
    EXPECT_NEAR(std::stod(rows[1][7]), 1, 0.01);
}

TEST(Contour, ofALevelThatNothingReachesIsNoNumberAndSaysWhatThereIs)
{
    Observed<Contour> object;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.1);
    particles.setP([](Vector<3> x) { return x.x; });
    const auto contour = object.made(particles, "value \"$p\"; level 2;");
    contour->execute(particles.view());
    EXPECT_EQ(object.folder.rows("postProcessing/own/0/contour.dat").at(0).at(3), "nan");
    EXPECT_TRUE(contour->report().starts_with("own: nothing is at 2; values lie between ")) << contour->report();
}

TEST(Contour, mistakesNameTheirLine)
{
    Particles particles(3, {0, 0, 0}, {1, 1, 1}, 0.25);
    addFloor(particles);
    const auto expectIn = [](const std::string& text, const std::vector<std::string>& parts)
    {
        for (const auto& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
    };
    Observed<Contour> object;
    expectIn(object.mistakesIn(particles, "value \"$p\";\nphase watr;\nwall flor;\nregion { min (0 0 0); max (0 1 1); }\n"),
             {"level", "system/controlDict:2: phase \"watr\" is unknown. Did you mean \"water\"? Known phase: water.",
              "system/controlDict:3: wall \"flor\" is unknown. Did you mean \"floor\"? Known wall: floor.",
              "system/controlDict:4: max must be greater than min; in x it is 0 against 0"});
    Observed<Contour> cuts;
    expectIn(cuts.mistakesIn(particles, "wall floor;\ncut { point (0 0 2); normal (0 0 1); }\n"),
             {"system/controlDict:1: goes without `cut` alone",
              "system/controlDict:2: the plane through (0 0 2) does not meet the box from (0 0 0) to (1 1 1)"});
    Observed<Contour> vectors;
    expectIn(vectors.mistakesIn(particles, "value \"vector(1, 2, 3)\"; level 3; wall floor;\ncentre (0 0 0);"),
             {"system/controlDict:1: value \"vector(1, 2, 3)\": it gives a vector: take a component, or mag() of it",
              "system/controlDict:2: goes without `wall` alone"});
    Observed<Contour> fields;
    expectIn(fields.refusalOf(particles, "value \"$T\"; level 300;"),
             {"system/controlDict:1: \"$T\": \"$T\" is unknown. Did you mean \"t\"? Known names: U, "});
    expectIn(fields.refusalOf(particles, "value \"2*$U\"; level 300;"), {"it gives a vector"});
    Observed<Reduction> numbers;
    expectIn(numbers.mistakesIn(particles, "numbers { a { operation contour; gives angle; } b { operation contour; gives angel; } }"),
             {"the angle is that with a wall: name it, `wall floor;`", "gives \"angel\" is unknown. Did you mean \"angle\"?"});
}
