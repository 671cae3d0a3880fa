/// A plane through `point`, without curvature:
///
///   d = n.(x - point)
#pragma once
#include "geometry/Shape.hpp"

namespace sph
{

class Plane : public Shape
{
    Vector<3> point_, normal_;

public:
    /// `normal` points into the fluid; its length is of no account.
    Plane(const Vector<3>& point, const Vector<3>& normal);

    Foot foot(const Vector<3>& x) const override { return {dot(normal_, x - point_), normal_}; }
    Box bounds() const override;
    double smallestRadius() const override { return Box::infinity; }
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override;
    ShapeDescription description() const override;
    bool invariantAlong(int direction) const override;
    bool enclosesFluid() const override { return true; }
    TriangleSurface triangles(const Box& within, double size) const override;
};

}
