/// Smooth wall surfaces by their mathematics: signed distance, foot point and principal curvatures (Barker et al. 2012, eqs. 15-18).
///
/// Points have three components always; a 2-D scene lives in the plane z = 0 and its shapes do not vary with z (a sphere becomes a
/// circle). Signs: `distance` is positive on the fluid side, `normal` points into the fluid, and a principal curvature is positive
/// where its centre lies on the FLUID side (fluid inside a sphere: +1/R), negative for fluid outside (erratum HL6).
#pragma once
#include "Vector.hpp"
#include <limits>
#include <memory>

namespace sph
{

/// What a point sees of the nearest place of a surface.
struct Foot
{
    double distance = 0;       ///< [m] > 0 in the fluid
    Vector<3> normal;          ///< unit, into the fluid, at the foot point x - distance*normal
    double k1 = 0, k2 = 0;     ///< principal curvatures at the foot point [1/m]
};

/// V'/V of the mirror image of a particle at distance d: prod_i (1 + k_i d)/(1 - k_i d), eq. (18) with signed curvatures.
/// At most 0 where the image does not exist (d beyond a centre of curvature).
constexpr double volumeFactor(const Foot& f)
{
    const double d = f.distance;
    return (1 + f.k1*d)*(1 + f.k2*d)/((1 - f.k1*d)*(1 - f.k2*d));
}

/// x' = x - 2 d n
constexpr Vector<3> mirrorImage(const Vector<3>& x, const Foot& f) { return x - 2*f.distance*f.normal; }

struct Box
{
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Vector<3> low{-infinity, -infinity, -infinity}, high{infinity, infinity, infinity};
};

/// A smooth surface with a unique nearest point for every x within the reach of a kernel. A shape with corners (box) is several.
class Shape
{
public:
    virtual ~Shape() = default;
    virtual Foot foot(const Vector<3>& x) const = 0;
    /// Encloses the surface; infinite along directions in which it does not end.
    virtual Box bounds() const = 0;
    /// 1/max|k| over the surface as far as the fluid can see it [m]; infinite for a plane.
    virtual double smallestRadius() const = 0;
    virtual std::unique_ptr<Shape> shifted(const Vector<3>& by) const = 0;
};

}
