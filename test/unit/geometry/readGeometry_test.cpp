#include "reading.hpp"
#include <gtest/gtest.h>

using namespace sph;
using namespace sph::test;

// The example of the documentation, entry by entry.
TEST(ReadGeometry, readsWallsAndTheirProperties)
{
    const auto [g, errors] =
        read("dimension 3;\ndomain { min (0 0 0); max (1 2 3); periodic (x z); }\nwalls\n{\n"
             "    floor { type plane; point (0 0 0); normal (0 2 0); contactAngle 30; }\n"
             "    lid { type plane; point (0 2 0); normal (0 -1 0); velocity (1 0 0); omega (0 3 0); origin (0.5 0 0.5); }\n}\n");
    EXPECT_EQ(errors, "");
    EXPECT_EQ(g.dimension, 3);
    EXPECT_EQ(g.periodic, (std::array<bool, 3>{true, false, true}));
    ASSERT_EQ(g.walls.size(), 2u);
    EXPECT_EQ(g.walls[0].name, "floor");
    EXPECT_TRUE(g.walls[0].wets);
    EXPECT_EQ(g.walls[0].contactAngle, 30);
    EXPECT_FALSE(g.walls[1].wets);
    EXPECT_EQ(g.walls[1].contactAngle, 90);
    EXPECT_EQ(toString(g.walls[1].where), "constant/geometry:6");
    ASSERT_EQ(g.patches.size(), 2u);
    EXPECT_DOUBLE_EQ(g.distance({0.3, 0.7, 0.2}), 0.7);
    EXPECT_NEAR(g.distance({0.3, 1.9, 0.2}), 0.1, 1e-15);
    // v + omega x r = (1 0 0) + (0 3 0) x (0.5 0 0) = (1 0 -1.5)
    EXPECT_EQ(g.wallVelocity(1, {1, 0, 0.5}), (Vector<3>{1, 0, -1.5}));
}

// Pairs of words, whatever the phases are called.
TEST(ReadGeometry, readsContactAnglesOfPairs)
{
    const std::string plane = square + "walls { floor { type plane; point (0 0 0); normal (0 1 0);\n";
    const auto [g, errors] = read(plane + "contactAngles ( (water air) 30 (oil air) 60 ); } }");
    EXPECT_EQ(errors, "");
    EXPECT_TRUE(g.walls[0].wets);
    ASSERT_EQ(g.walls[0].contactAngles.size(), 2u);
    EXPECT_EQ(g.walls[0].angleOf("oil", "air"), 60);
    EXPECT_EQ(g.walls[0].angleOf("air", "water"), 150);
    EXPECT_FALSE(g.walls[0].angleOf("oil", "water"));
    EXPECT_EQ(toString(g.walls[0].anglesAt), "constant/geometry:3");
    const auto expect = [&](const std::string& words, const std::string& what)
    {
        const auto found = read(plane + words + " } }").errors;
        EXPECT_NE(found.find("constant/geometry:3: " + what), std::string::npos) << found;
    };
    expect("contactAngles ( (water air) 190 );", "a contact angle must be between 0 and 180 degrees, not 190");
    expect("contactAngles ( (water water) 90 );", "\"water\" has no contact angle with itself");
    expect("contactAngles ( (water air) 30 (air water) 150 );",
           "the contact angle of air and water is there twice, (water air) 30 and (air water) 150: each pair has one");
    expect("contactAngles ( (water air) 30 ); contactAngle 30;", "contactAngle and contactAngles say the same of a wall");
}

// No walls at all is a scene too.
TEST(ReadGeometry, withoutWallsTheFluidIsEverywhere)
{
    const auto [g, errors] = read("dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x y); }");
    EXPECT_EQ(errors, "");
    EXPECT_EQ(g.distance({0.5, 0.5, 0}), std::numeric_limits<double>::infinity());
}

// Every mistake of a file is reported at once, with its line.
TEST(ReadGeometry, reportsEveryMistakeWithFileAndLine)
{
    const auto [g, errors] = read("dimension 2;\n"
                                  "domain { min (0 0 0); max (1 0 0);\n"
                                  "  periodic (z); }\n"
                                  "walls\n{\n"
                                  "  a { type plan; point (0 0 0); }\n"
                                  "  b { type sphere; centre (0 0 0);\n radius -1; fluid inside; }\n"
                                  "  c { type plane; point (0 0 0);\n normal (0 0 0); }\n"
                                  "  d { type plane; point (0 0 0);\n normal (0 1 1); }\n"
                                  "  e { type sphere; centre (0 0 0); radius 1; fluid inside;\n contactAngle 190; }\n"
                                  "  f { type torus; centre (0 0 0); axis (0 0 1); ringRadius 2; tubeRadius 1; fluid inside; }\n"
                                  "  g { type sphere; centre (0 0 0); radius 0; fluid inside; }\n"
                                  "  h { type sphere; centre (0 0 0); radius 1; fluid inside; raduis 2; }\n"
                                  "}\n");
    const auto has = [&, &all = errors](const std::string& what) { return all.find(what) != std::string::npos; };
    EXPECT_TRUE(has("constant/geometry:2: max must be greater than min; in y it is 0 against 0")) << errors;
    EXPECT_TRUE(has("constant/geometry:3: a 2-D scene does not vary with z: it cannot be periodic there")) << errors;
    EXPECT_TRUE(has("constant/geometry:6: ")) << errors;
    EXPECT_TRUE(has("Did you mean \"plane\"?")) << errors;
    EXPECT_TRUE(has("constant/geometry:8: ")) << errors;
    EXPECT_TRUE(has("constant/geometry:10: normal must have a direction, not (0 0 0)")) << errors;
    EXPECT_TRUE(has("constant/geometry:12: in 2-D the z component of \"normal\" must be 0, found 1")) << errors;
    EXPECT_TRUE(has("constant/geometry:14: contactAngle must be between 0 and 180 degrees, not 190")) << errors;
    EXPECT_TRUE(has("constant/geometry:15: a torus varies with z, a 2-D scene does not: use circles (type sphere)")) << errors;
    EXPECT_TRUE(has("constant/geometry:16: ")) << errors;
    EXPECT_TRUE(has("constant/geometry:17: ")) << errors;
    EXPECT_TRUE(has("raduis")) << errors;
    EXPECT_TRUE(has("\n10 errors")) << errors;
}

// Walls that end the fluid contradict a periodic direction across them; those along it do not.
TEST(ReadGeometry, refusesWallsAcrossPeriodicDirections)
{
    const auto channel = "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x); }\nwalls { w { type ";
    EXPECT_NE(read(channel + std::string("plane; point (0 0 0); normal (1 0 0); } }"))
                  .errors.find("constant/geometry:2: the fluid ends at this wall, so that the domain cannot be periodic in x"),
              std::string::npos);
    EXPECT_NE(read(channel + std::string("sphere; centre (0.5 0.5 0.5); radius 0.4; fluid inside; } }")).errors, "");
    EXPECT_NE(read(channel + std::string("cylinder; point (0 0 0); axis (1 1 0); radius 0.1; fluid outside; } }"))
                  .errors.find("oblique to the periodic direction x"),
              std::string::npos);
    EXPECT_EQ(read(channel + std::string("plane; point (0 0 0); normal (0 1 1); } }")).errors, "");
    EXPECT_EQ(read(channel + std::string("cylinder; point (0 0.5 0.5); axis (1 0 0); radius 0.4; fluid inside; } }")).errors, "");
}

// A box around the fluid is planes where the domain does not repeat; a bar through a periodic domain has no ends.
TEST(ReadGeometry, boxesFollowThePeriodicDirections)
{
    const std::string domain = "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (z); }\n";
    const auto tank = read(domain + "walls { tank { type box; min (0 0 0); max (1 1 1); fluid inside; } }");
    EXPECT_EQ(tank.errors, "");
    EXPECT_EQ(tank.geometry.patches.size(), 4u);
    const auto bar = read(domain + "walls { bar { type box; min (0.4 0.4 0); max (0.6 0.6 1); fluid outside; } }");
    ASSERT_EQ(bar.geometry.patches.size(), 1u) << bar.errors;
    EXPECT_NEAR(bar.geometry.distance({0.7, 0.5, 0.999}), 0.1, 1e-15);
    EXPECT_EQ(read(square + "walls { tank { type box; min (0 0 0); max (1 1 0); fluid inside; } }").geometry.patches.size(), 4u);
    EXPECT_NE(read(domain + "walls { tank { type box; min (0 0 0.2); max (1 1 1); fluid inside; } }").errors, "");
}

// What a wall does along z, or by turning about x and y, would come to nothing.
TEST(ReadGeometry, wallsOfA2DSceneMoveInItsPlane)
{
    const auto errorsOf = [](const std::string& dimension, const std::string& motion)
    { return read(dimension + "walls { w { type sphere; centre (0.5 0.5 0); radius 0.1; fluid outside; " + motion + " } }").errors; };
    EXPECT_EQ(errorsOf(square, "velocity (1 2 0); omega (0 0 3);"), "");
    EXPECT_EQ(errorsOf("dimension 3; domain { min (0 0 0); max (1 1 1); }\n", "velocity (1 2 3); omega (1 2 3);"), "");
    EXPECT_EQ(errorsOf(square, "velocity (1 2 3);"), "constant/geometry:2: in 2-D the z component of \"velocity\" must be 0, found 3");
    EXPECT_EQ(errorsOf(square, "omega (1 2 3);"),
              "constant/geometry:2: in 2-D a wall turns about z: the x and y components of \"omega\" must be 0, found 1 and 2");
}

// A sphere is a circle, an ellipsoid an ellipse: nothing depends on z.
TEST(ReadGeometry, shapesOfA2DSceneDoNotVaryWithZ)
{
    const auto [g, errors] = read(square + "walls { a { type sphere; centre (0.3 0.3 5); radius 0.1; fluid outside; }"
                                           " b { type ellipsoid; centre (0.7 0.7 0); semiAxes (0.2 0.1 0); fluid outside; }"
                                           " c { type cylinder; point (0.1 0.9 0); radius 0.05; fluid outside; } }");
    EXPECT_EQ(errors, "");
    ASSERT_EQ(g.patches.size(), 3u);
    for (const auto& p : g.patches)
    {
        EXPECT_TRUE(p.shape->invariantAlong(2));
        EXPECT_EQ(p.shape->foot({0.2, 0.5, 0}).distance, p.shape->foot({0.2, 0.5, 7}).distance);
        EXPECT_EQ(p.shape->foot({0.2, 0.5, 0}).k2, 0);
    }
}
