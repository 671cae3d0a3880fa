/// A sphere (upper sign: fluid inside):
///
///   d = +-(R - r),    k1 = k2 = +-1/R
#pragma once
#include "geometry/Shape.hpp"

namespace sph
{

class Sphere : public Shape
{
    Vector<3> centre_;
    double R_;
    FluidSide fluid_;

public:
    Sphere(const Vector<3>& centre, double radius, FluidSide);

    Foot foot(const Vector<3>& x) const override;
    Box bounds() const override;
    double smallestRadius() const override { return R_; }
    bool uniformlyCurved() const override { return true; }
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override;
    ShapeDescription description() const override;
    bool invariantAlong(int) const override { return false; }
    bool enclosesFluid() const override { return fluid_ == FluidSide::inside; }
    TriangleSurface triangles(const Box& within, double size) const override;
    double distanceTo(const Box&) const override;

    const Vector<3>& centre() const { return centre_; }
    double radius() const { return R_; }
};

}
