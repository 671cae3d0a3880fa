/// Coordinates of a survey, (5e5 5.2e6 300) m: those of text and doubles keep their digits, those of single precision cannot, and it is
/// told.
#include "Imported.hpp"
#include "Prepared.hpp"
#include "geometry/Shape.hpp"
#include <gtest/gtest.h>

namespace sph::test::farCoordinatesTest
{

namespace
{

constexpr Vector<3> place{512345.678, 5212345.678, 312.5};

PolygonMesh surveyed()
{
    auto m = prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
    for (auto& x : m.points) x = 0.1 * x + place;
    return m;
}

/// A box of 0.2 x 0.1 x 0.3 = 0.006 m3.
Mesh surveyedBox() { return box(place, place + Vector<3>{0.2, 0.1, 0.3}); }

}

// A prism over an L of 0.003 m3 in each format of text and doubles, in its place and moved back to the origin: doubles are 1e-9 m apart
// there, 1e-8 of the body.
TEST(FarCoordinates, DoublesKeepTheirDigits)
{
    const auto m = surveyed();
    for (const auto& [file, text, volume] : {std::tuple<std::string, std::string, double>{"a.obj", obj(m), 0.003},
                                             {"a.off", off(m), 0.003},
                                             {"a.ply", ply(m), 0.003},
                                             {"a.ply", binaryPly<double, std::int32_t>(m, "double", "int"), 0.003},
                                             // The digits stand in the text, whatever the header calls them.
                                             {"a.ply", replacedAll(ply(m), "double", "float"), 0.003},
                                             {"a.stl", solid(surveyedBox()), 0.006}})
    {
        const Imported i(file, text);
        EXPECT_EQ(i.refusal, "");
        EXPECT_NEAR(i.volume() / volume, 1, 1e-7) << file;
        EXPECT_EQ(i.allNotes(), "") << file;
        const Prepared p(file, text, "translation (-512345.678 -5212345.678 -312.5);");
        ASSERT_EQ(p.errors, "") << file;
        EXPECT_FALSE(has(p.warnings, "single precision")) << file;
        EXPECT_NEAR(p.mesh.prepared.volume / volume, 1, 1e-7) << file;
        EXPECT_LT(mag(p.mesh.prepared.box.low), 1e-9) << file;
    }
}

// Single precision there is 0.5 m apart: binary STL, float PLY and glTF are told of with what is lost, before anything is made of the
// mesh; near the origin they are not, nor are floats that a node of glTF puts there.
TEST(FarCoordinates, SinglePrecisionIsToldOf)
{
    const auto m = box({500000, 5200000, 300}, {500010, 5200010, 310});
    const std::string note =
        "its coordinates are in single precision, seven digits: rounded by up to 0.25, where an edge is 11 long in the mean. Write it in "
        "double precision (ascii STL, OBJ, OFF, PLY), or nearer to its origin";
    auto polygons = prism({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 10);
    for (auto& x : polygons.points) x += Vector<3>{500000, 5200000, 300};
    EXPECT_EQ(Imported("a.stl", binaryStl(m)).allNotes(), note);
    EXPECT_EQ(Imported("a.ply", binaryPly<float, std::int32_t>(polygons, "float", "int")).allNotes(), note);
    EXPECT_EQ(Imported("a.gltf", gltf(m, 6, {0, 0, 0})).allNotes(), note);
    const Imported moved("a.gltf", gltf(box({0, 0, 0}, {10, 10, 10}), 6, {500000, 5200000, 300}));
    EXPECT_EQ(moved.allNotes(), "");
    EXPECT_EQ(boundingBox(moved.mesh).high, (Vector<3>{500010, 5200010, 310}));
    EXPECT_EQ(Imported("a.stl", binaryStl(box())).allNotes(), "");
}

}
