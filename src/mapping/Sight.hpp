/// Sight between two points of the fluid: whether a wall parts them.
#pragma once
#include "geometry/Geometry.hpp"

namespace sph
{

/// A point, and its distance from the walls [m], > 0 in the fluid.
struct PlacedPoint
{
    Vector<3> x;
    double toWall;
};

/// Whether the straight way between two points lies in the fluid.
///
/// Around a point at the distance d from the walls a ball of radius d is fluid. The way is free where the balls of its ends meet; otherwise the middle of what
/// they leave open is looked at, and then both of its halves, until what is left open is shorter than `finest`.
///
/// A way that passes through solid no deeper than `tolerance` counts as free: along a convex wall the chord between two particles beside it does so. A
/// wall thinner than twice the tolerance parts nothing. Verified by test/unit/mapping (Sight).
class Sight
{
    const Geometry& geometry_;
    double finest_, tolerance_;

public:
    /// `spacing` [m] of the particles that see one another. The geometry must outlive this.
    Sight(const Geometry& geometry, double spacing) : geometry_(geometry), finest_(0.1 * spacing), tolerance_(0.05 * spacing) {}

    /// Infinite without walls. The point may lie outside a periodic domain.
    double toWall(Vector<3> x) const;
    bool isFree(const PlacedPoint& a, const PlacedPoint& b) const;
};

}
