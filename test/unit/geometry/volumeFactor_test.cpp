#include "shapes.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test::volumeFactorTest
{

namespace
{

constexpr double d = 0.2;
constexpr auto inside = FluidSide::inside, outside = FluidSide::outside;

struct Row
{
    std::string name;
    double factor;
    std::shared_ptr<const Shape> shape;
    Vector<3> foot; ///< a point of the surface; the particle is d away along the normal
};

/// Jacobians of the mirror image by central differences, computed without this code (column numeric_jacobian, d = 0.2; rounded to
/// their accuracy of 1e-9). The circle is the cylinder along z, the torus has R1 = 2, R2 = 0.8 and theta = 0 on the inner ring.
std::vector<Row> table()
{
    const auto cylinder = [](FluidSide side) { return std::make_shared<Cylinder>(Vector<3>{}, Vector<3>{0, 0, 1}, 1, side); };
    const auto sphere = [](FluidSide side) { return std::make_shared<Sphere>(Vector<3>{}, 1, side); };
    const auto torus = [](FluidSide side) { return std::make_shared<Torus>(Vector<3>{}, Vector<3>{0, 0, 1}, 2, 0.8, side); };
    const auto cone = [](FluidSide side) { return std::make_shared<Cone>(Vector<3>{}, Vector<3>{0, 0, 1}, 30, side); };
    const auto onTorus = [](double degrees)
    {
        const double theta = degrees * std::numbers::pi / 180;
        return Vector<3>{2 - 0.8 * std::cos(theta), 0, 0.8 * std::sin(theta)};
    };
    const Vector<3> unit{1, 0, 0}, onCone{1.5 * 0.5, 0, 1.5 * std::sqrt(0.75)};
    return {{"cylinder inside", 1.5, cylinder(inside), unit},
            {"sphere inside", 2.25, sphere(inside), unit},
            {"torus 0 inside", 1.190476190, torus(inside), onTorus(0)},
            {"torus 60 inside", 1.470588235, torus(inside), onTorus(60)},
            {"torus 90 inside", 1.666666667, torus(inside), onTorus(90)},
            {"torus 120 inside", 1.811594203, torus(inside), onTorus(120)},
            {"torus 180 inside", 1.923076923, torus(inside), onTorus(180)},
            {"cone inside", 1.600577692, cone(inside), onCone},
            {"cylinder outside", 0.666666667, cylinder(outside), unit},
            {"sphere outside", 0.444444444, sphere(outside), unit},
            {"torus 0 outside", 0.84, torus(outside), onTorus(0)},
            {"torus 60 outside", 0.68, torus(outside), onTorus(60)},
            {"torus 90 outside", 0.6, torus(outside), onTorus(90)},
            {"torus 120 outside", 0.552, torus(outside), onTorus(120)},
            {"torus 180 outside", 0.52, torus(outside), onTorus(180)},
            {"cone outside", 0.624774420, cone(outside), onCone}};
}

/// |det dx'/dx| by central differences.
double jacobian(const Shape& shape, const Vector<3>& x)
{
    const double h = 1e-5;
    const auto column = [&](const Vector<3>& e)
    {
        const auto image = [&](const Vector<3>& y) { return mirrorImage(y, shape.foot(y)); };
        return (image(x + h * e) - image(x - h * e)) / (2 * h);
    };
    return std::abs(dot(column({1, 0, 0}), cross(column({0, 1, 0}), column({0, 0, 1}))));
}

}

// Equation (18) with signed curvatures against reference values; 1e-8 is ten times their rounding.
TEST(VolumeFactor, agreesWithReferenceJacobians)
{
    for (const auto& row : table())
    {
        const auto normal = row.shape->foot(row.foot).normal;
        const auto foot = row.shape->foot(row.foot + d * normal);
        EXPECT_NEAR(foot.distance, d, 1e-14) << row.name;
        EXPECT_NEAR(volumeFactor(foot), row.factor, 1e-8) << row.name;
    }
}

// The two ellipsoid rows of the same reference: its foot point is not recorded, so the factor must lie between those of the
// extreme curvatures and be reached somewhere on the surface (to 1e-3, the spacing of the samples).
TEST(VolumeFactor, ofTheReferenceEllipsoidIsReached)
{
    for (const auto& [side, expected] : {std::pair{inside, 1.7352330}, std::pair{outside, 0.5762915}})
    {
        const Ellipsoid e({}, {1.5, 1.2, 1}, side);
        double nearest = 1;
        for (double theta = 0.005; theta < 1.57; theta += 0.005)
            for (double phi = 0.005; phi < 1.57; phi += 0.005)
            {
                const Vector<3> p{1.5 * std::sin(theta) * std::cos(phi), 1.2 * std::sin(theta) * std::sin(phi), std::cos(theta)};
                const auto f = e.foot(p + d * e.foot(p).normal);
                nearest = std::min(nearest, std::abs(volumeFactor(f) - expected));
            }
        EXPECT_LT(nearest, 1e-3);
    }
}

// The volume factor is the Jacobian of the mirror image, for every shape on both sides; central differences of step 1e-5 are
// good to 1e-10 relative times the largest higher derivative (curvatures up to 2, kd up to 0.8: factor 1e3), hence 1e-6.
TEST(VolumeFactor, isTheJacobianOfTheMirrorImage)
{
    for (const auto& [name, shape] : allShapes())
        for (const auto& x : pointsNear(*shape, 0.4, 200))
        {
            const double factor = volumeFactor(shape->foot(x));
            EXPECT_NEAR(jacobian(*shape, x) / factor, 1, 1e-6) << name << " at " << x.x << " " << x.y << " " << x.z;
        }
}

// Signs: images behind a wall that curves around the fluid are larger, behind one that curves away smaller.
TEST(VolumeFactor, exceedsOneOnlyWhereTheCentreOfCurvatureIsOnTheFluidSide)
{
    const Vector<3> x{0.9, 0, 0}, y{1.1, 0, 0};
    EXPECT_GT(volumeFactor(Sphere({}, 1, inside).foot(x)), 1);
    EXPECT_LT(volumeFactor(Sphere({}, 1, outside).foot(y)), 1);
    EXPECT_GT(Sphere({}, 1, inside).foot(x).k1, 0);
    EXPECT_LT(Sphere({}, 1, outside).foot(y).k1, 0);
    EXPECT_EQ(volumeFactor(Plane({}, {1, 0, 0}).foot(x)), 1);
    // No image beyond the centre of curvature.
    EXPECT_LE(volumeFactor(Sphere({}, 1, outside).foot({2, 0, 0})), 0);
}

}
