/// An infinite circular cylinder (upper sign: fluid inside):
///
///   d = +-(R - r),    k1 = +-1/R,  k2 = 0
///
/// r is measured from the axis. With its axis along z it is the circle of a 2-D scene.
#pragma once
#include "geometry/Shape.hpp"

namespace sph
{

class Cylinder : public Shape
{
    Vector<3> point_, axis_;
    double R_;
    FluidSide fluid_;

public:
    /// `point` is any point of the axis; the length of `axis` is of no account.
    Cylinder(const Vector<3>& point, const Vector<3>& axis, double radius, FluidSide);

    Foot foot(const Vector<3>& x) const override;
    Box bounds() const override;
    double smallestRadius() const override { return R_; }
    bool uniformlyCurved() const override { return true; }
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override;
    ShapeDescription description() const override;
    bool invariantAlong(int direction) const override;
    bool enclosesFluid() const override { return fluid_ == FluidSide::inside; }
    TriangleSurface triangles(const Box& within, double size) const override;
};

}
