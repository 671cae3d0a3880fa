/// An ellipsoid with axes along x, y and z; an infinite semi-axis makes it an elliptic cylinder, the ellipse of a 2-D scene.
///
///   p_i (1 + t/a_i^2) = x_i,    sum_i p_i^2/a_i^2 = 1,    k = e eig[P diag(1/a^2) P]/|p/a^2| in the tangent plane
///
/// p is the foot point of x, for the largest root t; e = +1 with fluid inside, -1 outside. With tau = t + a_min^2, which keeps every denominator free of cancellation, Newton's method on 1/sqrt(sum) = 1 converges from below without a
/// safeguard, since that function of tau is concave (as in trust-region methods: Conn, Gould & Toint 2000, section 7.3.3).
/// Not smooth on the part of the middle plane inside from which two points of the surface are equally near.
#pragma once
#include "geometry/Shape.hpp"

namespace sph
{

class Ellipsoid : public Shape
{
    Vector<3> centre_, semiAxes_, weight_; ///< weight = 1/semiAxis^2
    double least_, largest_;               ///< finite semi-axes
    FluidSide fluid_;

    struct Nearest
    {
        Vector<3> p;
        bool unique;
    };
    Nearest nearest(const Vector<3>& x) const;

public:
    Ellipsoid(const Vector<3>& centre, const Vector<3>& semiAxes, FluidSide);

    Foot foot(const Vector<3>& x) const override;
    Box bounds() const override;
    double smallestRadius() const override { return sqr(least_) / largest_; }
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override;
    ShapeDescription description() const override;
    bool invariantAlong(int direction) const override;
    bool enclosesFluid() const override { return fluid_ == FluidSide::inside; }
    TriangleSurface triangles(const Box& within, double size) const override;
};

}
