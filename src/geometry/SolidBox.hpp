/// A box-shaped body in the fluid, with faces along x, y and z. One shape, not six planes: foot() is the nearest point of its
/// surface.
///
/// Faces have no curvature. Foot::smooth is false where an image would be wrong: for a point nearest to an edge or a vertex, and
/// for one whose mirror image would lie nearer to another face than to its own, so that the solid behind a convex edge is filled
/// once and not by the images of both faces (case (i) of fig. 4, Barker et al. 2012); Foot::margin says by how much, for whoever lets the
/// images of two faces fade into one another there. A body thinner than two reaches is filled from both sides up to its middle.
/// Infinite along directions in which low and high are infinite (2-D, or a bar through a periodic domain).
#pragma once
#include "geometry/Shape.hpp"

namespace sph
{

class SolidBox : public Shape
{
    Vector<3> low_, high_;

public:
    SolidBox(const Vector<3>& low, const Vector<3>& high) : low_(low), high_(high) {}

    Foot foot(const Vector<3>& x) const override;
    Foot footOnFace(const Vector<3>& x, const Vector<3>& normal, const Vector<3>& source, const Covered&) const override;
    std::vector<Foot> feetFromInside(const Vector<3>& x) const override;
    Box bounds() const override { return {low_, high_}; }
    /// The radius is that of the faces; edges are not smooth.
    double smallestRadius() const override { return Box::infinity; }
    bool hasEdges() const override { return true; }
    std::unique_ptr<Shape> shifted(const Vector<3>& by) const override;
    ShapeDescription description() const override;
    bool invariantAlong(int direction) const override;
    bool enclosesFluid() const override { return false; }
    TriangleSurface triangles(const Box& within, double size) const override;
};

}
