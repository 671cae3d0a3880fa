/// Lists hold every pair within the kernel's support, also where images move faster than any particle.
#include "geometry/Cylinder.hpp"
#include "integrators/moves.hpp"
#include "periodicSquare.hpp"
#include "scene/Particles.hpp"
#include "solver/models.hpp"
#include <gtest/gtest.h>

namespace sph::test::skinTest
{
namespace
{

constexpr double spacing = 0.05, support = 2.6 * spacing, skin = 0.3 * spacing;

Geometry disc(double R)
{
    Geometry g;
    g.dimension = 2;
    g.low = {-1, -1, 0};
    g.high = {1, 1, 1};
    WallProperties wall;
    wall.name = "pipe";
    g.walls.push_back(wall);
    g.originals.push_back({std::make_shared<Cylinder>(Vector<3>{}, Vector<3>{0, 0, 1}, R, FluidSide::inside), 0});
    repeatPeriodically(g, 1.5 * support);
    return g;
}

/// A pair within the support, or so far, that its list lacks.
bool isMissed(Particles<2>& particles, double reach = support)
{
    const auto x = particles.store().pointers(Position{});
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (std::size_t j = 0; j < particles.images().nullParticle(); ++j)
        {
            NeighbourLists<2>::Room room;
            const auto list = particles.lists().of(i, room);
            if (std::hypot(x[0][i] - x[0][j], x[1][i] - x[1][j]) < reach && std::find(list.begin(), list.end(), int(j)) == list.end())
                return true;
        }
    return false;
}

// In a pipe of 5 spacings a radius a particle 2 spacings off the wall has its image 7 from the axis, 7/3 as fast along the wall. Another particle
// at the wall, just out of sight of that image, flies towards it as the image flies towards the particle. The particles' own ways, 0.15 spacings
// each before lists used to be built anew, bring them 0.09 spacings nearer than the skin allows.
TEST(Skin, HoldsWhereImagesMoveFasterThanTheirSources)
{
    const double R = 5 * spacing, d = 2 * spacing, beside = 0.1 * spacing;
    const auto g = disc(R);
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\nwallVelocity reflected;\nintegration { scheme symplecticEuler; }\n";
    files.erase("constant/g");
    const TestCase folder(files);
    const Case theCase(folder.folder());
    const auto settings = readSettings(theCase, g);
    theCase.diagnostics().throwIfAny();

    const Vector<2> b{R - beside, 0};
    const double seen = support + 1.02 * skin, r = R + d; // of the image
    const double cosine = (r * r + b.x * b.x - seen * seen) / (2 * r * b.x), sine = std::sqrt(1 - cosine * cosine);
    const Vector<2> outward{cosine, sine}, along{-sine, cosine}, image = r * outward, way = 1 / mag(image - b) * (image - b);
    const double factor = (R + d) / (R - d);
    const auto v = dot(way, outward) * outward - factor * dot(way, along) * along;
    const Vector<2> a = (R - d) * outward, velocity = 1 / mag(v) * v;
    Cloud cloud;
    auto& U = cloud.fields["U"];
    U.type = FieldClass::vector;
    U.component.resize(3);
    for (const auto& [at, u] : {std::pair{a, velocity}, std::pair{b, way}})
    {
        cloud.x.push_back(at.x);
        cloud.y.push_back(at.y);
        cloud.z.push_back(0);
        U.component[0].push_back(u.x);
        U.component[1].push_back(u.y);
        U.component[2].push_back(0);
    }
    Particles<2> particles(settings, g, allTerms<2>(), cloud, {});
    const long built = particles.rebuilds();
    const double step = 0.01 * spacing;
    for (int k = 0; k < 20; ++k)
    {
        drift(particles, step);
        particles.moved(step);
        particles.evaluate();
        ASSERT_FALSE(isMissed(particles)) << k;
    }
    EXPECT_GT(particles.rebuilds(), built);
}

// Lists and images reach as far as a group's own kernel; without such a group they do not. The moment of a kernel twice as wide is the nearer to its continuum
// value, 1/V: N of the scene's kernel is 0.975 to 0.99 on a lattice (KernelMoment.hpp).
TEST(Skin, HoldsWhatTheOwnKernelOfAGroupReaches)
{
    const auto g = periodicSquare();
    auto files = channelCase();
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\n";
    auto settings = settingsOf(files);
    const auto lattice = vortexOf(0);
    Particles<2> narrow(settings, g, allTerms<2>(), lattice, {});
    EXPECT_TRUE(isMissed(narrow, 2 * support));
    settings.groups.push_back({.name = "wide", .terms = {"secondMoment"}, .kernel = OwnKernel{"wendlandC2", 2 * support}});
    Particles<2> particles(settings, g, allTerms<2>(), lattice, {});
    EXPECT_FALSE(isMissed(particles, 2 * support));
    const double* const M = particles.store().component(KernelMoment::info.name, 0);
    const double volume = sqr(spacing), ofScene = M[0] * volume;
    EXPECT_NEAR(ofScene, 0.982, 0.01);
    particles.evaluate("wide");
    EXPECT_NEAR(M[0] * volume, 1, 0.2 * (1 - ofScene));
    particles.evaluate();
    EXPECT_EQ(M[0] * volume, ofScene);
}

}
}
