/// Points in the solid that a file bounds, found by rays of CGAL.
#include "meshes/SolidOfFile.hpp"
#include "meshTexts.hpp"
#include "meshes/readers/NumberedMesh.hpp"
#include "temporaryCase.hpp"
#include <gtest/gtest.h>

namespace sph::test::solidOfFileTest
{

namespace
{

struct OfFile
{
    TemporaryCase scene;
    TriSurface wall;
    OfFile(const std::string& text, FluidSide fluid, const std::string& file = "rock.off")
    {
        scene.write("constant/triSurface/" + file, text);
        wall.file = file;
        wall.fluid = fluid;
    }
    SolidOfFile solid() const { return {scene.folder(), wall, {.low = {-2, -2, -2}, .high = {2, 2, 2}, .spacing = 0.01, .H = 0.026}}; }
};

}

// A cube of 0.5 m in mm, turned and moved: its corner (0.5 0.5 0.5) comes to (0.5, 1.5, 0.5). Right behind each face a point is found, right before it
// none, nor on it. Which way the file turns its facets does not matter.
TEST(SolidOfFile, containsWhatLiesWithin)
{
    for (const auto& m : {box({0, 0, 0}, {500, 500, 500}), inverted(box({0, 0, 0}, {500, 500, 500}))})
    {
        OfFile cube(off(m), FluidSide::outside);
        cube.wall.scale = 1e-3;
        cube.wall.angle = 90;
        cube.wall.translation = {1, 1, 0};
        const auto solid = cube.solid(); // (0.5 1 0) to (1 1.5 0.5)
        const Vector<3> middle{0.75, 1.25, 0.25};
        EXPECT_TRUE(solid.contains(middle));
        for (const Vector<3>& n : {Vector<3>{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
        {
            EXPECT_TRUE(solid.contains(middle + 0.2499999 * n));
            EXPECT_FALSE(solid.contains(middle + 0.25 * n));
            EXPECT_FALSE(solid.contains(middle + 0.2500001 * n));
        }
    }
}

// Outside of a vessel all is solid, and so is what stands in it; in a hollow body there is fluid; where two bodies overlap there is solid.
TEST(SolidOfFile, knowsVesselsCavitiesAndOverlaps)
{
    const auto vessel = OfFile(off(together(box({0, 0, 0}, {1, 1, 1}), box({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}))), FluidSide::inside).solid();
    EXPECT_TRUE(vessel.contains({-0.1, 0.5, 0.5}));
    EXPECT_FALSE(vessel.contains({0.1, 0.5, 0.5}));
    EXPECT_TRUE(vessel.contains({0.5, 0.5, 0.5}));

    const auto hollow = OfFile(off(together(box({0, 0, 0}, {1, 1, 1}), box({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}))), FluidSide::outside).solid();
    EXPECT_FALSE(hollow.contains({-0.1, 0.5, 0.5}));
    EXPECT_TRUE(hollow.contains({0.1, 0.5, 0.5}));
    EXPECT_FALSE(hollow.contains({0.5, 0.5, 0.5}));

    const auto two = OfFile(off(together(box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {2, 2, 2}))), FluidSide::outside).solid();
    for (const double x : {0.25, 0.75, 1.5}) EXPECT_TRUE(two.contains({x, x, x}));
    EXPECT_FALSE(two.contains({1.5, 0.25, 0.25}));
}

TEST(SolidOfFile, ofAnOpenMeshIsRefused)
{
    auto m = box();
    m.triangles.pop_back();
    EXPECT_THROW(OfFile(off(m), FluidSide::outside).solid(), UnusableMesh);
    OfFile scan(off(box()), FluidSide::outside);
    scan.wall.wrap = {0.1, 0.5};
    EXPECT_THROW(scan.solid(), UnusableMesh);
}

// Blocks that share a face with other diagonals, which the entry unites: solid on both sides of it and on it, fluid beside them.
TEST(SolidOfFile, knowsBodiesThatShareAFace)
{
    OfFile stack(off(together(box(), otherDiagonals(box({0, 0, 1}, {1, 1, 2})))), FluidSide::outside);
    EXPECT_THROW(stack.solid(), UnusableMesh);
    stack.wall.removeSelfIntersections = true;
    const auto solid = stack.solid();
    for (const double z : {0.5, 0.999, 1., 1.001, 1.5}) EXPECT_TRUE(solid.contains({0.4, 0.3, z})) << z;
    EXPECT_FALSE(solid.contains({0.4, 0.3, 2.001}));
    EXPECT_FALSE(solid.contains({1.001, 0.3, 1}));
}

}
