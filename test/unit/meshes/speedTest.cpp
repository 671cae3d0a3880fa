#include "Prepared.hpp"
#include <chrono>
#include <gtest/gtest.h>

using namespace sph;
using namespace sph::test;

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
