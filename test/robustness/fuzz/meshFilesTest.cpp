/// Mesh files damaged at random: reading ends, within ten seconds, in an UnusableMesh or in a mesh, and that has the faces and the volume
/// of a second reading that shares no code with it.
#include "Mutator.hpp"
#include "NaiveMesh.hpp"
#include "gltfTexts.hpp"
#include "meshTexts.hpp"
#include "meshes/readers/importMesh.hpp"
#include "smallCases.hpp"

namespace sph::test
{
namespace
{

const PolygonMesh prismOverAnL = prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);

/// Of two terms of the sum: of single precision, which the reader takes for the decimal number it stands for.
constexpr double rounding = 1e-6;

/// What is read is read alike. A file whose polygons are not plane has the notes' word for it that its volume is
/// one of several.
void compare(const NumberedMesh& mesh, const std::vector<std::string>& notes, const NaiveMesh& naive)
{
    const auto volume = naive.volume();
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += dot(mesh.points[std::size_t(a)], cross(mesh.points[std::size_t(b)], mesh.points[std::size_t(c)]));
    const bool bent = std::ranges::any_of(notes, [](const auto& note) { return note.find("not plane") != note.npos; });
    EXPECT_EQ(std::size_t(mesh.number.back()) + 1, naive.faces.size());
    const bool isFinite = std::isfinite(volume.magnitudes + volume.bend); // coordinates of 1e200 leave nothing to compare
    if (bent || !isFinite) return;
    EXPECT_NEAR(six / 6, volume.value, rounding * volume.magnitudes + volume.bend);
}

void fuzzMesh(const std::string& name, const std::vector<std::string>& seeds, NaiveMesh (*naive)(const std::string&))
{
    const TestCase c(Files{});
    long accepted = 0, all = 0;
    fuzz(2000,
         [&](Mutator& mutator)
         {
             const auto bytes = mutator.of(mutator.oneOf(seeds), seeds);
             std::filesystem::remove(c.folder() / name); // emptied in its place it would wait for the disk on some systems
             c.write(name, bytes);
             NumberedMesh mesh;
             std::vector<std::string> notes;
             ++all;
             try
             {
                 mesh = importMesh(c.folder() / name, notes);
             }
             catch (const UnusableMesh&)
             {
                 return;
             }
             ++accepted;
             SCOPED_TRACE(bytes);
             try
             {
                 compare(mesh, notes, naive(bytes));
             }
             catch (const std::exception& e)
             {
                 ADD_FAILURE() << "accepted, but a second reading fails: " << e.what();
             }
         });
    if (all < 100) return;
    EXPECT_GT(accepted, all / 50) << "hardly any is read: the comparison says little";
}

}

TEST(Fuzz, StlText)
{
    fuzzMesh("a.stl",
             {solid(box(), "lid", 0, 2) + solid(box(), "two words", 2), "\xEF\xBB\xBF" + solid(box({-1.5, 0, 1e-3}, {0.25, 2, 1e3}), "")},
             [](const std::string& bytes) { return naiveStl(bytes); });
}

TEST(Fuzz, StlBinary)
{
    auto coloured = binaryStl(box({-1.5, 0, 1e-3}, {0.25, 2, 1e3}));
    coloured.replace(0, 16, "solid COLOR=abcd");
    fuzzMesh("a.stl", {binaryStl(box()), coloured}, [](const std::string& bytes) { return naiveStl(bytes); });
}

TEST(Fuzz, Obj)
{
    const auto text = obj(prismOverAnL);
    fuzzMesh("a.obj",
             {text, "mtllib a.mtl\no body\nusemtl a\n" + text + "vt 0 0\nvn 1 0 0\n" + "g lid # x\nf -1 -2/1 -3/1/1 \\\n -4//1\n",
              obj(box(), 2)},
             naiveObj);
}

TEST(Fuzz, PlyText)
{
    auto edges = ply(prismOverAnL);
    edges.insert(edges.find("element face"), "element edge 1\nproperty int a\nproperty list uchar float b\n");
    edges.insert(edges.size() - faceRows(prismOverAnL).size(), "7 2 .5 +1e3\n");
    fuzzMesh("a.ply", {ply(prismOverAnL), edges, ply(box())}, naivePly);
}

TEST(Fuzz, PlyBinary)
{
    fuzzMesh("a.ply",
             {binaryPly(box()), binaryPly<float, std::uint8_t>(prismOverAnL, "float", "uchar"),
              binaryPly<double, std::int16_t>(prismOverAnL, "double", "short", true)},
             naivePly);
}

TEST(Fuzz, Off)
{
    fuzzMesh("a.off", {off(prismOverAnL), off(box()), "# comment\nCOFF 3 1\n0 0 0 255 0 0\n\n1 0 0 0 1 2\n0 1 0 0 0 0\n3 0 1 2 0.5\n"},
             naiveOff);
}

TEST(Fuzz, Gltf) { fuzzMesh("a.gltf", {gltf(box(), 2, {1, 2, 3}), gltf(box({-1.5, 0, 1e-3}, {0.25, 2, 1e3}), 12, {0, 0, 0})}, naiveGltf); }

TEST(Fuzz, Glb)
{
    const auto m = box({-1000, 0, 500}, {1000, 2000, 3000});
    const auto shorts = data<std::int16_t, std::uint16_t>(m), floats = data<float, std::uint8_t>(m);
    fuzzMesh("a.glb",
             {glb(document("", shorts.size(), 5122, 2, 5123, "", R"(,"scale":[0.001,0.001,0.001])", quantization), shorts),
              glb(document("", floats.size(), 5126, 4, 5121), floats)},
             naiveGltf);
}

}
