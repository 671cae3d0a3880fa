#include "Prepared.hpp"
#include "meshes/readers/importMesh.hpp"
#include <chrono>
#include <ctime>
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test::speedTest
{

// A million facets are prepared within 60 s on one core (src/meshes/README.md: 6 to 15 s); a third of them within 20 s.
TEST(MeshSpeed, preparesManyFacets)
{
    const auto file = binaryStl(icosphere(7));
    const auto start = std::chrono::steady_clock::now();
    const Prepared p("rock.stl", file);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(p.mesh.surface.triangles.size(), 327680u);
    EXPECT_LT(seconds, 20);
}

// A binary STL of 10^6 facets is read within 3 s of processor time on one core (src/meshes/README.md: 0.45 s).
TEST(MeshSpeed, readsAMillionFacets)
{
    constexpr double turn = 2 * std::numbers::pi;
    const auto torus = parametricSurface(1000, 500,
                                         [](double u, double v)
                                         {
                                             const double r = 1 + 0.25 * std::cos(turn * v);
                                             return Vector<3>{r * std::cos(turn * u), r * std::sin(turn * u), 0.25 * std::sin(turn * v)};
                                         });
    const TemporaryCase folder;
    folder.write("torus.stl", binaryStl(torus));
    std::vector<std::string> notes;
    const auto start = std::clock();
    const auto mesh = importMesh(folder.folder() / "torus.stl", notes);
    EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 3);
    EXPECT_EQ(mesh.triangles.size(), 1000000u);
}

}
