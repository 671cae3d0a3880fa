/// One nappe of an infinite circular cone, opening from its apex along `axis` with half angle al.
///
///   d = e (t sin al - rho cos al),  k = e/(s tan al),  s = t cos al + rho sin al
///
/// with t along and rho from the axis, s the slant distance of the foot point from the apex, e = +1 with fluid inside, -1
/// outside; the other curvature is 0. Points with s <= 0 are nearest to the apex, where there is no normal: not smooth.
#pragma once
#include "geometry/Shape.hpp"

namespace sph
{

class Cone : public Shape
{
    Vector<3> apex_, axis_;
    double halfAngle_, sine_, cosine_;
    FluidSide fluid_;

public:
    /// `halfAngle` in degrees, between 0 and 90.
    Cone(const Vector<3>& apex, const Vector<3>& axis, double halfAngle, FluidSide);

    Foot foot(const Vector<3>& x) const override;
    Box bounds() const override;
    /// The apex has none.
    double smallestRadius() const override { return 0; }
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override;
    ShapeDescription description() const override;
    bool invariantAlong(int) const override { return false; }
    bool enclosesFluid() const override { return fluid_ == FluidSide::inside; }
    TriangleSurface triangles(const Box& within, double size) const override;
};

}
