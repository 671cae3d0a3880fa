/// Images: what values they carry.
#include "Imaged.hpp"
#include <gtest/gtest.h>
#include <omp.h>

namespace sph
{
namespace
{

using namespace test;

// 1 + the wall that an image lies behind, 0 for the fluid, its periodic images and the null particle; the corner's image lies behind both
// walls and has the one that it was mirrored in last. A refresh, which would copy the source's value, leaves it alone; without the field
// in the store nothing is written.
TEST(Images, KnowTheWallTheyLieBehind)
{
    Geometry g = domain(2, {1, 1, 0}, {true, false, false});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    addWall(g, Plane({0, 1, 0}, {0, -1, 0}));
    Imaged<2> scene(g, 0.3, {{0.1, 0.15}, {0.5, 0.8}, {0.5, 0.5}});
    EXPECT_FALSE(scene.store.has(GhostWall{}));
    scene.store.allocate(GhostWall{});
    scene.images.move(scene.store);
    Images<2>::refresh<GhostWall>(scene.images, scene.store);
    const double* const wall = scene.store.component("ghostWall", 0);
    int ghosts[3] = {};
    for (std::size_t j = 0; j <= scene.images.nullParticle(); ++j)
    {
        const auto x = positionOf(scene.store, j);
        const bool null = j == scene.images.nullParticle();
        EXPECT_EQ(wall[j], null || (x.y > 0 && x.y < 1) ? 0 : x.y < 0 ? 1 : 2) << j;
        ++ghosts[int(wall[j])];
    }
    EXPECT_EQ(ghosts[1], 2); // of the first particle and of its periodic image
    EXPECT_EQ(ghosts[2], 1);

    Imaged<2> corner(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    corner.store.allocate(GhostWall{});
    corner.images.move(corner.store);
    for (std::size_t j = 1; j < corner.images.nullParticle(); ++j)
    {
        const auto x = positionOf(corner.store, j);
        const double found = corner.store.component("ghostWall", 0)[j];
        if (x.x > 0) EXPECT_EQ(found, 2);
        else if (x.y > 0) EXPECT_EQ(found, 1);
        else EXPECT_TRUE(found == 1 || found == 2);
    }
}

// Wall ghosts carry the stress of the solid where the scene has one; periodic images carry their sources'.
TEST(Images, TakeTheStressOfTheSolidBehindWalls)
{
    Geometry g = domain(2, {1, 1, 0}, {true, false, false});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    Imaged<2> scene(g, 0.3, {{0.1, 0.15}});
    scene.store.allocate(Stress{});
    const auto fill = [&](auto tag, std::array<double, 3> q)
    {
        for (int c = 0; c < 3; ++c) scene.store.component(tag.info.name, c)[0] = q[std::size_t(c)];
    };
    const auto values = [&](bool behind)
    {
        Images<2>::refresh<Stress>(scene.images, scene.store);
        for (std::size_t j = 1; j < scene.images.nullParticle(); ++j)
            if ((positionOf(scene.store, j).y < 0) == behind)
                return std::array{scene.store.component("S", 0)[j], scene.store.component("S", 1)[j], scene.store.component("S", 2)[j]};
        return std::array<double, 3>{};
    };
    fill(Stress{}, {1, 2, 3});
    EXPECT_EQ(values(true), (std::array<double, 3>{1, -2, 3}));
    scene.store.allocate(SolidStress{});
    fill(SolidStress{}, {5, 6, 7});
    EXPECT_EQ(values(true), (std::array<double, 3>{5, -6, 7}));
    EXPECT_EQ(values(false), (std::array<double, 3>{1, 2, 3}));
}

// Scalars are copied; vectors and tensors are mirrored as the plane x = 0 mirrors them: the x-component and the xy-component
// change sign. Twice mirrored in a corner: both components change sign, xy is itself again. Velocity follows the wall's rule
// (here -v, twice in the corner).
TEST(Images, CarryValuesByTheRuleOfTheField)
{
    Imaged<2> scene(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    auto& store = scene.store;
    store.allocate(Density{});
    store.allocate(ColourGradient{});
    store.allocate(Stress{});
    store.allocate(Velocity{});
    store.component("rho", 0)[0] = 7;
    const double gradient[] = {1, 2}, stress[] = {3, 4, 5}, velocity[] = {6, 8};
    for (int c = 0; c < 2; ++c) store.component("gradC", c)[0] = gradient[c];
    for (int c = 0; c < 3; ++c) store.component("S", c)[0] = stress[c];
    for (int c = 0; c < 2; ++c) store.component("U", c)[0] = velocity[c];
    Images<2>::refresh<Density>(scene.images, store);
    Images<2>::refresh<ColourGradient>(scene.images, store);
    Images<2>::refresh<Stress>(scene.images, store);
    Images<2>::refresh<Velocity>(scene.images, store);
    for (std::size_t k = 1; k < 4; ++k)
    {
        const auto x = positionOf(store, k);
        const double a = x.x < 0 ? -1 : 1, b = x.y < 0 ? -1 : 1;
        EXPECT_EQ(store.component("rho", 0)[k], 7);
        EXPECT_EQ(store.component("gradC", 0)[k], a * 1);
        EXPECT_EQ(store.component("gradC", 1)[k], b * 2);
        EXPECT_EQ(store.component("S", 0)[k], 3);
        EXPECT_EQ(store.component("S", 1)[k], a * b * 4);
        EXPECT_EQ(store.component("S", 2)[k], 5);
        EXPECT_EQ(store.component("U", 0)[k], a * b * 6);
        EXPECT_EQ(store.component("U", 1)[k], a * b * 8);
    }
    // The null particle's values are computed with, times W = 0: they must be finite.
    EXPECT_EQ(store.component("rho", 0)[scene.images.nullParticle()], 7);
}

// Vectors and tensors at a sphere are mirrored in the tangent plane of the foot point: the ghost of (n, t) components has (-n,
// t).
TEST(Images, MirrorVectorsInTheTangentPlaneOfASphere)
{
    Geometry ball = domain(3, {2, 2, 2});
    ball.low = {-2, -2, -2};
    addWall(ball, Sphere({0, 0, 0}, 1, FluidSide::outside));
    const Vector<3> n{2.0 / 3, -1.0 / 3, 2.0 / 3};
    Imaged<3> scene(ball, 0.3, {1.1 * n});
    auto& store = scene.store;
    store.allocate(ColourGradient{});
    store.allocate(Stress{});
    const Vector<3> v{0.3, 0.5, -0.7};
    sph::store(v, [&](int c, double q) { store.component("gradC", c)[0] = q; });
    sph::store(outer(v), [&](int c, double q) { store.component("S", c)[0] = q; });
    Images<3>::refresh<ColourGradient>(scene.images, store);
    Images<3>::refresh<Stress>(scene.images, store);
    const auto expected = v - 2 * dot(v, n) * n;
    sph::store(expected, [&](int c, double q) { EXPECT_NEAR(store.component("gradC", c)[1], q, 1e-15); });
    // R (v v) R = (R v)(R v)
    sph::store(outer(expected), [&](int c, double q) { EXPECT_NEAR(store.component("S", c)[1], q, 1e-15); });
}

/// Keeps the foot points that it is told.
class Listening : public GhostVelocity<2>
{
public:
    mutable std::vector<Vector<3>> feet;
    Vector<2> operator()(Vector<2> v, std::size_t, const Reflection<2>& r) const override
    {
        feet.push_back(r.foot);
        return v;
    }
    Vector<2> change(Vector<2> dv, const Reflection<2>&) const override { return dv; }
};

// The velocity rule is told the foot point of each reflection, on the wall it is mirrored in: the second one is that of the
// ghost, not that of the source. (A wall that turns has another velocity at each place.)
TEST(Images, TellTheFootPointOfEveryReflection)
{
    Imaged<2> scene(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    auto owned = std::make_unique<Listening>();
    const auto& rule = *owned;
    scene.images.rules().set(Velocity{}, std::move(owned));
    scene.store.allocate(Velocity{});
    omp_set_num_threads(1); // the listener's notebook is not shared
    Images<2>::refresh<Velocity>(scene.images, scene.store);
    const auto told = [&](Vector<3> foot)
    { return std::count_if(rule.feet.begin(), rule.feet.end(), [&](Vector<3> f) { return mag(f - foot) < 1e-14; }); };
    EXPECT_EQ(rule.feet.size(), 4u);
    EXPECT_EQ(told({0, 0.15, 0}), 2);
    EXPECT_EQ(told({0.1, 0, 0}), 1);
    EXPECT_EQ(told({-0.1, 0, 0}), 1);
}

}
}
