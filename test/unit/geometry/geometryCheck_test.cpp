#include "geometry/GeometryCheck.hpp"
#include "reading.hpp"
#include <gtest/gtest.h>
#include <numbers>

using namespace sph;
using namespace sph::test;

namespace
{

struct Checked
{
    GeometryReport report;
    std::string errors, warnings;
};

Checked check(const std::string& text, double H)
{
    const auto [g, errors] = read(text, H);
    EXPECT_EQ(errors, "");
    Diagnostics diagnostics;
    Checked result{checkGeometry(g, H, diagnostics), "", ""};
    for (const auto& w : diagnostics.warnings()) result.warnings += w + "\n";
    result.errors = messages(diagnostics);
    return result;
}

const std::string open = "dimension 3; domain { min (-1 -1 -1); max (1 1 1); }\nwalls {\n";

}

// Touching spheres, sc and bcc, radius as typed with ten digits: 3 and 8 contacts a cell (6 and 2*8 halves), no error, and
// the solid fraction of the lattice within its sampling error.
TEST(GeometryCheck, countsTheContactsOfTouchingSpheres)
{
    const auto sc = check(cube + "walls { grains { type sphereBed; lattice sc; radius 0.5; period 1; } }", 0.1);
    EXPECT_EQ(sc.errors, "");
    EXPECT_EQ(sc.report.contacts, 3);
    EXPECT_NEAR(sc.report.fluidFraction, 1 - std::numbers::pi / 6, 3 * sc.report.fluidFractionError);
    const auto bcc = check(cube + "walls { grains { type sphereBed; lattice bcc; radius 0.4330127019; period 1; } }", 0.1);
    EXPECT_EQ(bcc.errors, "");
    EXPECT_EQ(bcc.report.contacts, 8);
    EXPECT_EQ(bcc.report.walls[0].contacts, 8);
    EXPECT_NEAR(bcc.report.fluidFraction, 1 - std::sqrt(3.0) * std::numbers::pi / 8, 3 * bcc.report.fluidFractionError);
    const auto shifted =
        check(cube + "walls { grains { type sphereBed; lattice bcc; radius 0.25; period 0.5; origin (0.1 0.07 0.33); } }", 0.1);
    EXPECT_TRUE(contains(shifted.errors, "overlap in 64 places, most sharply near")) << shifted.errors;
}

// The narrowest gap and its place: between neighbours of a bcc bed, sqrt(3)/2 - 2 R.
TEST(GeometryCheck, reportsTheNarrowestGap)
{
    const auto [report, errors, warnings] = check(cube + "walls { grains { type sphereBed; lattice bcc; radius 0.4; period 1; } }", 0.1);
    EXPECT_EQ(errors, "");
    EXPECT_EQ(report.contacts, 0);
    EXPECT_NEAR(report.walls[0].narrowest.width, std::sqrt(0.75) - 0.8, 1e-14);
    EXPECT_TRUE(contains(warnings,
                         "constant/geometry:2: the gap between \"grains\" and \"grains\" narrows to 0.06603 m, 0.66 of the kernel "
                         "support, at ("))
        << warnings;
    EXPECT_EQ(check(cube + "walls { grains { type sphereBed; lattice bcc; radius 0.4; period 1; } }", 0.05).warnings, "");
}

// Gaps without a formula of their own: ellipsoids with facing tips, tori side by side, planes, cylinder and plane.
TEST(GeometryCheck, findsGapsOfGeneralShapes)
{
    const auto gap = [](const std::string& walls) { return check(open + walls + "\n}", 0.05).report.walls[0].narrowest; };
    const auto tips = gap("a { type ellipsoid; centre (-0.5 0.013 0); semiAxes (0.46 0.2 0.3); fluid outside; }\n"
                          "b { type ellipsoid; centre (0.5 0.013 0); semiAxes (0.5 0.2 0.3); fluid outside; }");
    EXPECT_NEAR(tips.width, 0.04, 1e-8);
    EXPECT_NEAR(mag(tips.at - Vector<3>{-0.02, 0.013, 0}), 0, 1e-5);
    const auto rings = gap("a { type torus; centre (-0.4 0 0); axis (0 0 1); ringRadius 0.25; tubeRadius 0.1; fluid outside; }\n"
                           "b { type torus; centre (0.4 0 0); axis (0 0 1); ringRadius 0.3; tubeRadius 0.1; fluid outside; }");
    EXPECT_NEAR(rings.width, 0.05, 1e-8);
    EXPECT_NEAR(gap("a { type plane; point (0 0.02 0); normal (0 -1 0); } b { type plane; point (0 -0.02 0); normal (0 1 0); }").width,
                0.04, 1e-14);
    EXPECT_NEAR(gap("a { type plane; point (0 -0.5 0); normal (0 1 0); }"
                    "b { type cylinder; point (0.3 -0.16 0); axis (0 0 1); radius 0.3; fluid outside; }")
                    .width,
                0.04, 1e-9);
}

// Curvature against the support, inside and outside, with place and remedy; the ring of a torus and the tip of an ellipsoid
// count.
TEST(GeometryCheck, refusesCurvesTighterThanTheSupport)
{
    const auto errors = [](const std::string& wall, double H) { return check(open + wall + "\n}", H).errors; };
    EXPECT_TRUE(contains(errors("a { type sphere; centre (0 0 0); radius 0.2; fluid outside; }", 0.25),
                         "constant/geometry:3: wall \"a\" curves with a radius of 0.2 m at ("));
    EXPECT_EQ(errors("a { type sphere; centre (0 0 0); radius 0.2; fluid outside; }", 0.19), "");
    EXPECT_NE(errors("a { type sphere; centre (0 0 0); radius 0.2; fluid inside; }", 0.25), "");
    EXPECT_NE(errors("a { type torus; centre (0 0 0); axis (0 0 1); ringRadius 0.5; tubeRadius 0.4; fluid outside; }", 0.15), "");
    EXPECT_EQ(errors("a { type torus; centre (0 0 0); axis (0 0 1); ringRadius 0.5; tubeRadius 0.3; fluid outside; }", 0.15), "");
    EXPECT_NE(errors("a { type ellipsoid; centre (0 0 0); semiAxes (0.8 0.3 0.3); fluid outside; }", 0.15), "");
    EXPECT_EQ(errors("a { type ellipsoid; centre (0 0 0); semiAxes (0.8 0.3 0.3); fluid outside; }", 0.1), "");
    // A hopper: the apex lies below the domain, where no fluid sees it. At y = -1 the cone has curvature 1/(s tan al) = 0.76.
    EXPECT_EQ(errors("a { type cone; apex (0 -3 0); axis (0 1 0); halfAngle 30; fluid inside; }", 0.2), "");
    EXPECT_NE(errors("a { type cone; apex (0 -0.9 0); axis (0 1 0); halfAngle 30; fluid inside; }", 0.2), "");
}

// Shapes may meet: corners of a tank, ends of a tube, a hemisphere and a step on the floor, a ball at rest on it; balls may overlap as packers leave them,
// by a tenth of a diameter. More they may not, nor other bodies at all.
TEST(GeometryCheck, tellsCornersFromOverlaps)
{
    const auto errors = [](const std::string& walls) { return check(open + walls + "\n}", 0.1).errors; };
    const std::string floor = "f { type plane; point (0 -0.5 0); normal (0 1 0); }\n";
    EXPECT_EQ(errors("t { type box; min (-0.9 -0.9 -0.9); max (0.9 0.9 0.9); fluid inside; }"), "");
    EXPECT_EQ(errors(floor + "t { type cylinder; point (0 0 0); axis (0 1 0); radius 0.5; fluid inside; }"), "");
    EXPECT_EQ(errors(floor + "h { type sphere; centre (0 -0.5 0); radius 0.4; fluid outside; }"), "");
    EXPECT_EQ(errors(floor + "s { type box; min (-0.3 -0.7 -0.3); max (0.3 -0.2 0.3); fluid outside; }"), "");
    EXPECT_EQ(errors(floor + "b { type sphere; centre (0 -0.1 0); radius 0.4; fluid outside; }"), "");
    EXPECT_EQ(check(open + floor + "b { type sphere; centre (0 -0.1 0); radius 0.4; fluid outside; }\n}", 0.1).report.contacts, 1);
    const auto sunk = check(open + floor + "b { type sphere; centre (0 -0.11 0); radius 0.4; fluid outside; }\n}", 0.1);
    EXPECT_EQ(sunk.errors, "");
    EXPECT_EQ(sunk.report.contacts, 1);
    EXPECT_NEAR(sunk.report.overlap, 0.01 / 0.8, 1e-12);
    EXPECT_NEAR(sunk.report.overlapAt.y, -0.505, 1e-12);
    const auto deep = errors(floor + "b { type sphere; centre (0 -0.19 0); radius 0.4; fluid outside; }");
    EXPECT_TRUE(contains(deep, "constant/geometry:4: wall \"f\" and wall \"b\" overlap near")) << deep;
    EXPECT_TRUE(contains(deep, "by 0.11 of the smaller diameter (0.1 is the most that counts as a contact)")) << deep;
    const auto pair = [&](const std::string& x)
    {
        return errors("a { type sphere; centre (-0.39 0 0); radius 0.4; fluid outside; } b { type sphere; centre (" + x +
                      " 0 0); radius 0.4; fluid outside; }");
    };
    EXPECT_EQ(pair("0.39"), "");
    EXPECT_NE(pair("0.32"), "");
    EXPECT_NE(errors("a { type ellipsoid; centre (-0.39 0 0); semiAxes (0.4 0.3 0.3); fluid outside; }"
                     " b { type ellipsoid; centre (0.399 0 0); semiAxes (0.4 0.3 0.3); fluid outside; }"),
              "");
}

// The sign of a normal is the commonest mistake.
TEST(GeometryCheck, saysWhenThereIsNoFluid)
{
    EXPECT_TRUE(contains(check(open + "a { type plane; point (0 -1 0); normal (0 -1 0); } }", 0.1).errors,
                         "the walls leave no fluid in the domain"));
}

// A 2-D bed: two touching circles of a square array, fluid fraction 1 - pi/4.
TEST(GeometryCheck, worksIn2D)
{
    const auto [report, errors, warnings] = check("dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x y); }\n"
                                                  "walls { g { type sphereBed; lattice sc; radius 0.5; period 1; } }",
                                                  0.1);
    EXPECT_EQ(errors, "");
    EXPECT_EQ(report.contacts, 2);
    EXPECT_NEAR(report.fluidFraction, 1 - std::numbers::pi / 4, 3 * report.fluidFractionError);
}
