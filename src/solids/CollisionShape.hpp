/// Collision shape of a solid in Bullet.
#pragma once
#include "solids/Bed.hpp"
#include <btBulletDynamicsCommon.h>
#include <memory>

namespace sph
{

/// A shape of size 1 about its centroid, along its principal axes.
struct CollisionShape
{
    bool isSphere = true;
    std::vector<std::vector<btVector3>> parts;     ///< corners of convex bodies
    std::vector<btVector3> corners;                ///< of the convex hull: what touches walls
    btMatrix3x3 axes = btMatrix3x3::getIdentity(); ///< columns: the principal axes in the coordinates of SolidShape
    btVector3 inertia{0.1, 0.1, 0.1};              ///< over m d^2; of a sphere 2/5 (d/2)^2
    std::string description;                       ///< "2 convex parts, 1.3 % more volume than the shape"
};

/// Principal axes of a mesh, the columns of a rotation, and the moments of inertia about them, over m d^2.
std::pair<btMatrix3x3, btVector3> principalAxes(const SolidShape&);
CollisionShape makeCollisionShape(const SolidShape&);

/// A Bullet shape and what it refers to.
struct BulletShape
{
    std::vector<std::unique_ptr<btConvexHullShape>> hulls;
    std::unique_ptr<btCollisionShape> whole;
    btCollisionShape* get() const { return whole ? whole.get() : hulls.front().get(); }
};

/// Bullet rounds a hull by a margin: faces are set back by as much, so that surfaces touch; corners stay short of the shape's by at most
/// half the margin or so at right angles.
BulletShape makeBulletShape(const CollisionShape&, double size);
/// Over the size.
inline constexpr double collisionMargin = 0.002;

}
