#include "Largest.hpp"
#include "shapes.hpp"
#include <gtest/gtest.h>

namespace sph::test::shapesTest
{

namespace
{
constexpr auto inside = FluidSide::inside, outside = FluidSide::outside;
}

// The foot point lies on the surface, and the normal there and here is the same: round-off of coordinates of size 2.
TEST(Shapes, footPointLiesOnTheSurface)
{
    for (const auto& [name, shape] : allShapes())
        for (const auto& x : pointsNear(*shape, 1, 300))
        {
            const auto f = shape->foot(x);
            EXPECT_NEAR(mag(f.normal), 1, 1e-14) << name;
            const auto onSurface = shape->foot(x - f.distance * f.normal);
            EXPECT_NEAR(onSurface.distance, 0, 5e-15) << name;
            EXPECT_NEAR(mag(onSurface.normal - f.normal), 0, 1e-13) << name;
        }
}

// The normal is the gradient of the distance (differences of step 1e-5: 1e-9); the distance has slope 1 (eikonal equation).
TEST(Shapes, normalIsTheGradientOfTheDistance)
{
    const double h = 1e-5;
    for (const auto& [name, shape] : allShapes())
        for (const auto& x : pointsNear(*shape, 0.4, 100))
        {
            const auto slope = [&](const Vector<3>& e)
            { return (shape->foot(x + h * e).distance - shape->foot(x - h * e).distance) / (2 * h); };
            const Vector<3> gradient{slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
            EXPECT_NEAR(mag(gradient - shape->foot(x).normal), 0, 1e-8) << name;
        }
}

// -div n on the surface is the sum of the principal curvatures with the signs of this suite (differences of step 1e-4: 1e-6).
TEST(Shapes, curvaturesAreMinusTheDivergenceOfTheNormal)
{
    const double h = 1e-4;
    for (const auto& [name, shape] : allShapes())
        for (const auto& x : pointsNear(*shape, 0.4, 100))
        {
            const auto f = shape->foot(x);
            const auto p = x - f.distance * f.normal;
            const auto slope = [&](const Vector<3>& e)
            { return dot(e, shape->foot(p + h * e).normal - shape->foot(p - h * e).normal) / (2 * h); };
            EXPECT_NEAR(-(slope({1, 0, 0}) + slope({0, 1, 0}) + slope({0, 0, 1})), f.k1 + f.k2, 1e-5) << name;
        }
}

// No curvature exceeds that of smallestRadius, and it is come near: 2 % with 3000 random points.
TEST(Shapes, smallestRadiusBoundsTheCurvature)
{
    for (const auto& [name, shape] : allShapes())
    {
        Largest largest;
        for (const auto& x : pointsNear(*shape, 0.1, 3000))
        {
            const auto f = shape->foot(x);
            largest(f.k1);
            largest(f.k2);
        }
        const double bound = 1 / shape->smallestRadius();
        EXPECT_LE(largest.value(), bound * (1 + 1e-12)) << name;
        EXPECT_TRUE(largest.value() >= 0.98 * bound || std::isinf(bound)) << name; // the apex of a cone is not reached
    }
}

// The distance of an ellipsoid against 160,000 points of its surface, refined: a search that knows nothing of the equation
// solved. Points inside, outside, near the middle plane (1e-9 off) and far along each axis; 1e-9 is what the refinement reaches.
TEST(Ellipsoid, distanceAgreesWithSearch)
{
    const Vector<3> a{1.5, 0.4, 1};
    const Ellipsoid ellipsoid({}, a, outside);
    const auto surface = [&](double theta, double phi) {
        return Vector<3>{a.x * std::sin(theta) * std::cos(phi), a.y * std::sin(theta) * std::sin(phi), a.z * std::cos(theta)};
    };
    const auto search = [&](const Vector<3>& x)
    {
        double theta = 0, phi = 0, best = 1e9;
        // The half of the surface on the side of x: just off the middle plane the other half is as near to 2e-9.
        double low1 = 0, high1 = 3.15, low2 = x.y < 0 ? 3.1416 : 0, high2 = low2 + 3.1416;
        for (int level = 0; level < 8; ++level)
        {
            for (int i = 0; i <= 100; ++i)
                for (int k = 0; k <= 100; ++k)
                {
                    const double t = low1 + i * (high1 - low1) / 100, p = low2 + k * (high2 - low2) / 100;
                    if (const double r = mag(surface(t, p) - x); r < best) best = r, theta = t, phi = p;
                }
            const double w1 = (high1 - low1) / 20, w2 = (high2 - low2) / 20;
            low1 = theta - w1, high1 = theta + w1, low2 = phi - w2, high2 = phi + w2;
        }
        return best;
    };
    std::vector<Vector<3>> points{{0.3, 1e-9, 0.1}, {0.3, -1e-9, 0.1},    {1, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1e-12, 0.2, 1e-12},
                                  {1.4, 1e-14, 0},  {1.499, 0.001, 0.001}};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-1.6, 1.6);
    for (int i = 0; i < 20; ++i) points.push_back({u(random), u(random), u(random)});
    for (const auto& x : points) EXPECT_NEAR(std::abs(ellipsoid.foot(x).distance), search(x), 1e-9) << x.x << " " << x.y << " " << x.z;
}

// Needle and disc: a thousand to one. The foot lies on the surface and the residual is parallel to its normal.
TEST(Ellipsoid, extremeRatiosStayExact)
{
    for (const Vector<3> a : {Vector<3>{1, 1e-3, 1e-3}, Vector<3>{1, 1, 1e-3}, Vector<3>{1, 1, 1}})
    {
        const Ellipsoid e({}, a, outside);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> u(-1.5, 1.5);
        for (int i = 0; i < 1000; ++i)
        {
            const Vector<3> x{u(random), u(random), u(random)};
            const auto f = e.foot(x);
            const auto p = x - f.distance * f.normal;
            EXPECT_NEAR(sqr(p.x / a.x) + sqr(p.y / a.y) + sqr(p.z / a.z), 1, 1e-9);
        }
    }
}

// Where the nearest point is not unique, or has no normal, there is no image.
TEST(Shapes, sayWhereThereIsNoImage)
{
    EXPECT_FALSE(Sphere({}, 1, inside).foot({0, 0, 0}).smooth);
    EXPECT_FALSE(Cylinder({}, {0, 0, 1}, 1, inside).foot({0, 0, 0.3}).smooth);
    EXPECT_FALSE(Torus({}, {0, 0, 1}, 2, 0.5, inside).foot({2, 0, 0}).smooth);
    EXPECT_FALSE(Torus({}, {0, 0, 1}, 2, 0.5, outside).foot({0, 0, 0.3}).smooth);
    EXPECT_FALSE(Cone({}, {0, 0, 1}, 30, outside).foot({0, 0.1, -1}).smooth);
    EXPECT_DOUBLE_EQ(Cone({}, {0, 0, 1}, 30, outside).foot({0, 0, -1}).distance, 1);
    EXPECT_FALSE(Cone({}, {0, 0, 1}, 30, inside).foot({0, 0, 1}).smooth);
    EXPECT_FALSE(Ellipsoid({}, {2, 1, 0.5}, inside).foot({0.2, 0.1, 0}).smooth);
    EXPECT_TRUE(Ellipsoid({}, {2, 1, 0.5}, inside).foot({1.99, 0, 0}).smooth);
    EXPECT_TRUE(Ellipsoid({}, {2, 1, 0.5}, outside).foot({3, 0, 0}).smooth);
}

// Distances to faces, edges and corners by Pythagoras; images only where one face alone is nearest, to the point and to its
// image.
TEST(SolidBox, hasImagesOnlyBehindFaces)
{
    const SolidBox box({0, 0, 0}, {1, 1, 1});
    EXPECT_DOUBLE_EQ(box.foot({0.5, 1.25, 0.5}).distance, 0.25);
    EXPECT_EQ(box.foot({0.5, 1.25, 0.5}).normal, (Vector<3>{0, 1, 0}));
    EXPECT_TRUE(box.foot({0.5, 1.25, 0.5}).smooth);
    EXPECT_DOUBLE_EQ(box.foot({1.3, 1.4, 0.5}).distance, 0.5);
    EXPECT_FALSE(box.foot({1.3, 1.4, 0.5}).smooth);
    EXPECT_FALSE(box.foot({1.3, 1.4, -2}).smooth);
    EXPECT_DOUBLE_EQ(box.foot({0.5, 0.8, 0.5}).distance, -0.2);
    // The image (0.9, 0.8) would be nearer to the face x = 1 than to y = 1; (0.9, 0.95) is not.
    EXPECT_FALSE(box.foot({0.9, 1.2, 0.5}).smooth);
    EXPECT_TRUE(box.foot({0.9, 1.05, 0.5}).smooth);
}

// Every triangle has its corners on the surface and its normal into the fluid, and the area of a closed shape is right to the
// error of chords (0.3 % with 96 segments).
TEST(Triangles, coverTheSurfaceAndFaceTheFluid)
{
    const Box around{{-2, -2, -2}, {2, 2, 2}};
    const auto area = [](const TriangleSurface& s)
    {
        double sum = 0;
        for (const auto& [a, b, c] : s.triangles) sum += 0.5 * mag(cross(s.points[b] - s.points[a], s.points[c] - s.points[a]));
        return sum;
    };
    for (const auto& [name, shape] : allShapes())
    {
        const auto surface = triangulate(*shape, around, 0.05);
        ASSERT_GT(surface.triangles.size(), 100u) << name;
        for (const auto& [a, b, c] : surface.triangles)
        {
            const auto &p = surface.points[a], &q = surface.points[b], &r = surface.points[c];
            EXPECT_GT(dot(cross(q - p, r - p), shape->foot((p + q + r) / 3).normal), 0) << name;
        }
    }
    constexpr double pi = 3.14159265358979;
    EXPECT_NEAR(area(triangulate(Sphere({}, 1, outside), around, 0.05)), 4 * pi, 0.003 * 4 * pi);
    EXPECT_NEAR(area(triangulate(Torus({}, {1, 2, 3}, 1, 0.5, outside), around, 0.05)), 2 * pi * pi, 0.003 * 2 * pi * pi);
    EXPECT_NEAR(area(triangulate(SolidBox({-1, -1, -1}, {1, 1, 1}), around, 0.05)), 24, 1e-10);
    EXPECT_NEAR(area(triangulate(Plane({}, {0, 0, 1}), around, 0.05)), 16, 1e-10);
    EXPECT_NEAR(area(triangulate(Cylinder({}, {0, 0, 1}, 1, inside), around, 0.05)), 8 * pi, 0.003 * 8 * pi);
}

}
