/// One of each shape in general position, on both sides, for tests that hold for all of them.
#pragma once
#include "geometry/Cone.hpp"
#include "geometry/Cylinder.hpp"
#include "geometry/Ellipsoid.hpp"
#include "geometry/Plane.hpp"
#include "geometry/SolidBox.hpp"
#include "geometry/Sphere.hpp"
#include "geometry/Torus.hpp"
#include <random>
#include <string>
#include <vector>

namespace sph::test
{

struct NamedShape
{
    std::string name;
    std::shared_ptr<const Shape> shape;
};

inline std::vector<NamedShape> allShapes()
{
    const Vector<3> a{0.1, -0.2, 0.3}, axis{1, 2, -0.5};
    std::vector<NamedShape> all{{"plane", std::make_shared<Plane>(a, axis)},
                                {"solidBox", std::make_shared<SolidBox>(Vector<3>{-1, -0.8, -0.6}, Vector<3>{1.1, 0.9, 0.7})}};
    for (const auto fluid : {FluidSide::inside, FluidSide::outside})
    {
        const std::string side = fluid == FluidSide::inside ? " fluid inside" : " fluid outside";
        all.push_back({"sphere" + side, std::make_shared<Sphere>(a, 1.1, fluid)});
        all.push_back({"cylinder" + side, std::make_shared<Cylinder>(a, axis, 1.1, fluid)});
        all.push_back({"cone" + side, std::make_shared<Cone>(Vector<3>{-0.5, -1, 0.2}, axis, 30, fluid)});
        all.push_back({"torus" + side, std::make_shared<Torus>(a, axis, 1.2, 0.5, fluid)});
        all.push_back({"ellipsoid" + side, std::make_shared<Ellipsoid>(a, Vector<3>{1.5, 1.2, 1}, fluid)});
        all.push_back({"ellipse" + side, std::make_shared<Ellipsoid>(Vector<3>{}, Vector<3>{1.5, 1, Box::infinity}, fluid)});
    }
    return all;
}

/// Random points that lie within `reach` of the surface on the fluid side and have a mirror image.
inline std::vector<Vector<3>> pointsNear(const Shape& shape, double reach, int count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(-2, 2);
    std::vector<Vector<3>> points;
    while (int(points.size()) < count)
    {
        const Vector<3> x{u(random), u(random), u(random)};
        const auto f = shape.foot(x);
        const double largest = std::max(std::abs(f.k1), std::abs(f.k2));
        if (f.smooth && f.distance > 0 && f.distance < reach && largest * f.distance < 0.8) points.push_back(x);
    }
    return points;
}

}
