/// The scene's space: its domain, which directions are periodic, and its walls as smooth patches with their properties.
#pragma once
#include "Dictionary.hpp"
#include "Shape.hpp"
#include <array>
#include <string>
#include <vector>

namespace sph
{

/// What the physics needs to know of a wall besides its shape.
struct WallProperties
{
    std::string name;
    double contactAngle = 90;              ///< [degrees], through the first-named phase of each pair
    bool wets = false;                     ///< true where the dictionary gives a contact angle
    Vector<3> velocity;                    ///< [m/s] of the wall as a rigid body
    Vector<3> origin, omega;               ///< rotation about `origin` [rad/s]
    Location where;
};

/// One smooth surface of a wall.
struct Patch
{
    std::shared_ptr<const Shape> shape;
    int wall;                              ///< index into Geometry::walls
};

struct Geometry
{
    int dimension = 3;
    Vector<3> low, high;                   ///< the domain; z from -0.5 to 0.5 times anything in 2-D is not used
    std::array<bool, 3> periodic{};
    std::vector<WallProperties> walls;
    std::vector<Patch> patches;            ///< all periodic copies that lie within `reach` of the domain

    /// Smallest signed distance to any patch, > 0 in the fluid; +infinity without walls.
    double distance(const Vector<3>& x) const;
};

/// Reads constant/geometry:
///
///     dimension  3;
///     domain     { min (0 0 0); max (1e-3 1e-3 1e-3); periodic (x y z); }
///     walls
///     {
///         floor   { type plane; point (0 0 0); normal (0 1 0); contactAngle 30; }
///         grains  { type sphereBed; lattice bcc; radius 1e-3; period 2.393e-3; contactAngle 30; }
///         lid     { type plane; point (0 1 0); normal (0 -1 0); velocity (1 0 0); }
///     }
///
/// Types: plane, box, sphere, cylinder, cone, torus, ellipsoid, sphereBed; those with a choice take `fluid inside|outside;`.
/// Patches are repeated over the periodic directions as far as `reach` [m] outside the domain.
Geometry readGeometry(const Dictionary&, double reach);

/// Centres of the spheres of one period cell, sc, bcc, fcc or hcp, and the extent of that cell.
struct SphereLattice
{
    std::vector<Vector<3>> centres;
    Vector<3> period;
};
SphereLattice sphereLattice(const std::string& lattice, double period);

}
