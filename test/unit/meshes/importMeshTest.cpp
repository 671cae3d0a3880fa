#include "Prepared.hpp"
#include "meshes/orientShells.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test::importMeshTest
{

namespace
{

std::string regionsIn(const PreparedMesh& p)
{
    std::string text;
    for (std::size_t r = 0; r < p.surface.regions.size(); ++r) text += fmt::format("{} {} ", p.surface.regions[r], p.prepared.inRegion[r]);
    return text;
}

}

// Each format gives the same closed box: 8 points, 12 facets, volume 1 x 1.5 x 0.5, numbers that single precision holds exactly.
TEST(ImportMesh, readsEveryFormat)
{
    const auto m = box({-0.5, -0.5, 0}, {0.5, 1, 0.5});
    for (const auto& [file, text] : {std::pair<std::string, std::string>{"a.stl", solid(m)},
                                     {"b.stl", binaryStl(m)},
                                     {"c.stlb", binaryStl(m)},
                                     {"A.STL", solid(m)},
                                     {"d.obj", obj(m, 2)},
                                     {"e.ply", ply(m)},
                                     {"f.ply", binaryPly(m)},
                                     {"g.off", off(m)},
                                     {"h.gltf", gltf(m, 2, {0, 0, 0})}})
    {
        const Prepared p(file, text);
        ASSERT_EQ(p.errors, "") << file;
        EXPECT_EQ(p.mesh.surface.points.size(), 8u) << file;
        EXPECT_EQ(p.mesh.surface.triangles.size(), 12u) << file;
        EXPECT_DOUBLE_EQ(p.mesh.prepared.volume, 0.75) << file;
    }
}

// Decimal numbers stay what they are, also where a file keeps them in single precision.
TEST(ImportMesh, keepsDecimals)
{
    for (const auto& [file, text] : {std::pair<std::string, std::string>{"a.stl", solid(box({0.1, -0.2, 1e-7}, {0.7, 0.123456, 1.7}))},
                                     {"b.stl", binaryStl(box({0.1, -0.2, 1e-7}, {0.7, 0.123456, 1.7}))}})
    {
        const Prepared p(file, text);
        EXPECT_EQ(p.mesh.prepared.box.low, (Vector<3>{0.1, -0.2, 1e-7}));
        EXPECT_EQ(p.mesh.prepared.box.high, (Vector<3>{0.7, 0.123456, 1.7}));
    }
}

// Regions have the names of the file, as words of a dictionary; what names none has patch0.
TEST(ImportMesh, namesRegions)
{
    const auto m = box();
    const Prepared solids("a.stl", solid(m, "lid", 0, 2) + solid(m, "shell", 2));
    EXPECT_EQ(regionsIn(solids.mesh), "lid 2 shell 10 ");
    const Prepared groups("a.obj", obj(m, 4));
    EXPECT_EQ(regionsIn(groups.mesh), "lid_1 4 shell 8 ");
    EXPECT_EQ(groups.mesh.notes, std::vector<std::string>{"region \"lid/1\" is called lid_1"});
    const Prepared materials("a.gltf", gltf(m, 6, {0.5, 0, 0}));
    EXPECT_EQ(regionsIn(materials.mesh), "steel 6 rest 6 ");
    EXPECT_EQ(materials.mesh.prepared.box.low.x, 0.5); // its node's translation
    EXPECT_EQ(regionsIn(Prepared("a.stl", binaryStl(m)).mesh), "patch0 12 ");
    EXPECT_EQ(regionsIn(Prepared("a.off", off(m)).mesh), "patch0 12 ");
    EXPECT_EQ(regionsIn(Prepared("a.ply", ply(m)).mesh), "patch0 12 ");
    EXPECT_EQ(regionsIn(Prepared("a.stl", solid(m, "lid", 0, 2) + solid(m, "2nd", 2)).mesh), "lid 2 _2nd 10 ");
}

// Scaled, then turned, then shifted: (x y z) -> (-2 y, 2 x, 2 z) + (0.5 0.25 -1) by a quarter about z, exactly.
TEST(ImportMesh, placesTheMesh)
{
    const Prepared p("a.stl", solid(box({0, 0, 0}, {0.25, 0.5, 0.75})),
                     "scale 2; rotation { axis (0 0 3); angle 90; } translation (0.5 0.25 -1);");
    ASSERT_EQ(p.errors, "");
    EXPECT_EQ(p.mesh.prepared.box.low, (Vector<3>{-0.5, 0.25, -1}));
    EXPECT_EQ(p.mesh.prepared.box.high, (Vector<3>{0.5, 0.75, 0.5}));
    // A turn by 45 degrees about an edge along z: the far corner comes to lie on the y axis, at sqrt 2.
    const Prepared q("a.stl", solid(box()), "rotation { axis (0 0 1); angle 45; }");
    EXPECT_NEAR(q.mesh.prepared.box.high.y, std::numbers::sqrt2, 1e-15);
    EXPECT_NEAR(q.mesh.prepared.volume, 1, 1e-15);
}

// What is no mesh, or not all of one: each with file and line of constant/geometry, and what is wrong.
TEST(ImportMesh, refusesWhatIsNoWholeFile)
{
    const auto m = box();
    const auto cut = [](const std::string& text, double share = 0.7) { return text.substr(0, std::size_t(share * double(text.size()))); };
    const auto replaced = [](std::string text, const std::string& what, const std::string& with)
    { return text.replace(text.find(what), what.size(), with); };
    for (const auto& [file, text, message] :
         {std::array<std::string, 3>{"a.stl", "", "a.stl: it is empty"},
          {"a.stl", "hello\n", "this is no STL file"},
          {"a.stl", off(m), "this is no STL file"},
          {"a.off", solid(m), "this is no OFF file"},
          {"a.ply", solid(m), "this is no PLY file"},
          {"a.obj", solid(m), "this is no OBJ file"},
          {"a.gltf", solid(m), "this is no glTF file"},
          {"a.step", solid(m), "\".step\" is no format that is known by its name. Known: .stl"},
          {"a.stl", "solid a\nendsolid a\n", "it has no facets"},
          {"a.stl", std::string(84, '\0'), "it has no facets"},
          {"a.off", "OFF\n0 0 0\n", "it has no facets"},
          {"a.off", off(m) + '\1', "line 23: its header tells of 8 vertices and 12 facets, and more follows: \"?\""},
          {"a.stl", cut(solid(m)), "a.stl: line 60: expected three coordinates, and the line ends"},
          {"a.stl", cut(binaryStl(m)), "its header tells of 12 facets, 7 are there: it is truncated"},
          {"a.ply", cut(ply(m)), "face 0 of 12 is not whole: it is truncated"},
          {"a.ply", cut(binaryPly(m), 0.9), "face 7 of 12 is not whole: it is truncated"},
          {"a.ply", replaced(ply(m), "\n3 0 2 3", "\n3 0 2 9"), "face 0 of 12 has the vertex 9, and there are 8"},
          {"a.ply", replaced(ply(m), "\n3 0 2 3", "\n2 0 2"), "face 0 of 12 has 2 corners"},
          {"a.ply", replaced(ply(m), "float y", "floaty"), "its header has the line \"property floaty\""},
          {"a.ply", replaced(ply(m), "float y", "float yy"), "its vertices have no x, y and z"},
          {"a.off", cut(off(m)), "line 17: facet 6 of 12 has the vertex "},
          {"a.gltf", cut(gltf(m, 2, {0, 0, 0})), "a.gltf: it is no JSON: it is truncated or damaged at line 1, column "},
          {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", "facet 0 of 1 has the vertex \"7\", and there are 3"},
          {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "facet 0 of 1 has 2 corners"},
          {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "a.obj: line 4: the face has the vertex 9, and there are 3"},
          {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj: it has no facets"}})
    {
        const Prepared p(file, text);
        EXPECT_TRUE(has(p.errors, "constant/geometry:4: constant/triSurface/a.")) << p.errors;
        EXPECT_TRUE(has(p.errors, message)) << message << " in " << p.errors;
        EXPECT_FALSE(p.mesh.usable);
    }
    const Prepared missing("b.stl", solid(m), "file \"no.stl\";");
    EXPECT_TRUE(has(missing.errors, "constant/triSurface/no.stl: it cannot be read: No such file or directory")) << missing.errors;
}

// A region of the dictionary that the file has not.
TEST(ImportMesh, knowsTheRegionsOfTheDictionary)
{
    const Prepared p("a.stl", solid(box(), "shell"), "regions { shel {} }");
    EXPECT_TRUE(has(p.errors, "has no region \"shel\". Did you mean \"shell\"?")) << p.errors;
    EXPECT_EQ(Prepared("a.stl", solid(box(), "shell"), "regions { shell {} }").errors, "");
}

}
