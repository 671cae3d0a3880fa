/// A torus of ring radius R1 and tube radius R2 < R1. With q the distance from the ring and theta = 0 on the inner ring:
///
///   d = e (R2 - q),  k1 = e/R2,  k2 = -e cos(theta)/(R1 - R2 cos(theta)),  e = +1 with fluid inside the tube, -1 outside
///
/// Erratum of Barker et al. (2012), Table 1, torus: the cosine is misplaced, and the volume factor right at theta = 0 alone; printed, it is 0 at 90 degrees and
/// negative beyond.
#pragma once
#include "geometry/Shape.hpp"

namespace sph
{

class Torus : public Shape
{
    Vector<3> centre_, axis_;
    double R1_, R2_;
    FluidSide fluid_;

public:
    Torus(const Vector<3>& centre, const Vector<3>& axis, double ringRadius, double tubeRadius, FluidSide);

    Foot foot(const Vector<3>& x) const override;
    Box bounds() const override;
    double smallestRadius() const override;
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override;
    ShapeDescription description() const override;
    bool invariantAlong(int) const override { return false; }
    bool enclosesFluid() const override { return fluid_ == FluidSide::inside; }
    TriangleSurface triangles(const Box& within, double size) const override;
};

}
