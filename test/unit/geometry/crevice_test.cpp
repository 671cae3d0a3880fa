/// Crevices between walls, and particles that are put out of them.
#include "geometry/Plane.hpp"
#include "geometry/Sphere.hpp"
#include "geometry/TriangleMesh.hpp"
#include "geometry/crevice.hpp"
#include "geometry/offWalls.hpp"
#include "meshes.hpp"
#include "wallsByHand.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test
{
namespace
{

constexpr FacetScale facetScale{0.4, 1};

Geometry scene(const std::vector<std::shared_ptr<const Shape>>& shapes)
{
    Geometry g;
    g.low = {-10, -10, -10};
    g.high = {10, 10, 10};
    g.facetScale = facetScale;
    for (const auto& shape : shapes) g.originals.push_back({shape, 0});
    g.walls.resize(1);
    repeatPeriodically(g, 1.2);
    return g;
}

auto sphere(const Vector<3>& centre, double R) { return std::make_shared<Sphere>(centre, R, FluidSide::outside); }

// Two spheres of radius R that touch: at a distance r from the contact, in the middle, the width is 2 (sqrt(R^2 + r^2) - R), and it grows outwards.
TEST(Crevice, OfTwoSpheresThatTouch)
{
    const double R = 3;
    const auto g = scene({sphere({-R, 0, 0}, R), sphere({R, 0, 0}, R)});
    const NearWalls walls(g, 1);
    for (const double r : {0.2, 0.5, 0.9})
    {
        const double width = 2 * (std::hypot(R, r) - R);
        const auto crevice = walls.crevice({0, r, 0}, 1);
        EXPECT_NEAR(crevice.width, width, 1e-12);
        EXPECT_NEAR(crevice.wider.y, 2 * r / std::hypot(R, r), 1e-12);
        EXPECT_NEAR(crevice.wider.x, 0, 1e-12);
        EXPECT_EQ(walls.crevice({0, r, 0}, (1 - 1e-9) * width).width, Box::infinity);
    }
    // Nothing of a single wall, of a corner of a box, or beyond the spheres.
    EXPECT_EQ(walls.crevice({-R, R + 0.05, 0}, 1).width, Box::infinity);
    const auto corner =
        scene({std::make_shared<Plane>(Vector<3>{}, Vector<3>{1, 0, 0}), std::make_shared<Plane>(Vector<3>{}, Vector<3>{0, 1, 0})});
    EXPECT_EQ(NearWalls(corner, 1).crevice({0.1, 0.1, 0}, 1).width, Box::infinity);
}

// The wedge of a mesh on a plane, and the groove of one mesh, are crevices as well: at r from the edge, on the bisector, 2 r sin(a/2) wide.
TEST(Crevice, OfAWedge)
{
    const double a = std::numbers::pi / 6, r = 0.8;
    const TriangleSurface block = prism({{0, 0, 0}, {8 * std::cos(a), 8 * std::sin(a), 0}, {-1, 8, 0}, {-4, 4, 0}}, -5, 5);
    std::vector<std::shared_ptr<const Shape>> shapes{std::make_shared<Plane>(Vector<3>{}, Vector<3>{0, 1, 0})};
    for (const auto& body : bodiesOf(ofOneRegion(block), facetScale)) shapes.push_back(std::make_shared<TriangleMesh>(body));
    std::vector<Vector<3>> around{{0, 0, 0}};
    for (int k = 0; k <= 8; ++k)
    {
        const double angle = a + k * (2 * std::numbers::pi - a) / 8;
        around.push_back({8 * std::cos(angle), 8 * std::sin(angle), 0});
    }
    const auto groove = bodiesOf(ofOneRegion(prism(around, -5, 5)), facetScale);
    for (const auto& g : {scene(shapes), scene({std::make_shared<TriangleMesh>(groove.at(0))})})
    {
        const auto crevice = NearWalls(g, 1).crevice({r * std::cos(a / 2), r * std::sin(a / 2), 0}, 1);
        EXPECT_NEAR(crevice.width, 2 * r * std::sin(a / 2), 1e-6);
        EXPECT_NEAR(mag(crevice.wider), 2 * std::sin(a / 2), 1e-6);
    }
}

// From anywhere in the crevice a particle is put towards where it is half a spacing wide, as far as half of that in one go, and loses its velocity inwards; in a slit it stays where it is.
TEST(Crevice, IsLeft)
{
    const double R = 3, narrowest = 0.3, least = std::sqrt(std::pow(R + narrowest / 2, 2) - R * R);
    const auto g = scene({sphere({-R, 0, 0}, R), sphere({R, 0, 0}, R)});
    const NearWalls walls(g, 1);
    const auto outwards = [](const Vector<3>& a) { return a.y * std::cos(0.4) + a.z * std::sin(0.4); };
    for (const double r : {0.15, 0.4, 0.6, 0.9, 1.2})
        for (const double off : {-0.3, 0.0, 0.3})
        {
            const double half = std::hypot(R, r) - R;
            HeldVelocity<3> velocity({0, -1, 0.5});
            Vector<3> x{off * half, r * std::cos(0.4), r * std::sin(0.4)};
            const auto before = outwards(x);
            x = offWalls(walls, x, {0.02, narrowest}, 1, [&](const Vector<3>& n, int) { velocity.touch(n, 0); });
            EXPECT_GT(g.distance(x), -1e-3);
            EXPECT_NEAR(std::atan2(x.z, x.y), 0.4, 1e-9);
            EXPECT_NEAR(outwards(x), std::max(before, std::min(before + 0.5 * narrowest, least)), 0.02) << r << " " << off;
            if (before < least) { EXPECT_GT(outwards(velocity), -0.05); }
            for (int again = 0; again < 8; ++again) x = offWalls(walls, x, {0.02, narrowest}, 1, [](const Vector<3>&, int) {});
            EXPECT_GT(g.distance(x), 0.019);
            EXPECT_EQ(walls.crevice(x, 0.99 * narrowest).width, Box::infinity) << r << " " << off;
            EXPECT_NEAR(outwards(x), std::max(before, least), 0.05 * least);
        }
    const auto slit = scene(
        {std::make_shared<Plane>(Vector<3>{}, Vector<3>{1, 0, 0}), std::make_shared<Plane>(Vector<3>{0.2, 0, 0}, Vector<3>{-1, 0, 0})});
    const Vector<3> x{0.08, 1, 2};
    EXPECT_EQ(offWalls(NearWalls(slit, 1), x, {0.02, narrowest}, 1, [](const Vector<3>&, int) { ADD_FAILURE(); }), x);
}

}
}
