/// The scene's space: its domain, which directions are periodic, and its walls as smooth patches with their properties.
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Shape.hpp"
#include "kernels/Resolution.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

class Case;

/// Length scales of a mesh: the spacing, for facets that stand for a curved surface, and the support, for radii that reflection cannot represent.
struct FacetScale
{
    double spacing = 0; ///< of particles [m]
    double support = 0; ///< H [m]
};

/// A load that a wall is pushed with, and by which it goes: m dv/dt = F(t) + F_w.d - m c v along d, F_w the force of the fluid or soil on it (solver/WallForces.hpp).
struct WallLoad
{
    std::string force;   ///< F, an expression of `$t` [N], per metre of depth in 2-D
    Vector<3> direction; ///< d, a unit vector
    double mass = 1;     ///< m [kg], likewise
    double damping = 0;  ///< c [1/s]
    /// Throws ExpressionError where the expression gives no force.
    double at(double t) const;
};

/// Properties of a wall that the physics needs besides its shape.
struct WallProperties
{
    /// Contact angle of two phases, by their names, which geometry does not know.
    struct PhaseAngle
    {
        std::string first, second;
        double angle; ///< [degrees], through the first
    };

    std::string name;
    double contactAngle = 90;              ///< [degrees] of two phases, through that which the scene names first
    std::vector<PhaseAngle> contactAngles; ///< of any number of phases, in place of the one
    bool wets = false;                     ///< true where the dictionary gives a contact angle
    Location anglesAt;                     ///< in constant/geometry
    /// Through `first`, as the wall says of the two phases; none where it says nothing of them.
    std::optional<double> angleOf(const std::string& first, const std::string& second) const;
    Vector<3> velocity; ///< [m/s] of the wall as a rigid body; of one under load at present
    std::optional<WallLoad> load;
    Vector<3> origin, omega;             ///< rotation about `origin` [rad/s]
    bool slips = false;                  ///< the fluid slides along it freely
    std::optional<double> frictionAngle; ///< of soil at it [degrees]; without one it holds what touches it, or slips
    Location where;
    bool moves() const { return load || mag(velocity) > 0 || mag(omega) > 0; }
    /// Along which the wall goes, of any length; 0 where it stays.
    const Vector<3>& heading() const { return load ? load->direction : velocity; }
    /// tan of the friction angle
    double frictionCoefficient() const { return std::tan(frictionAngle.value_or(0) * std::numbers::pi / 180); }
};

class TriangleMesh;

/// One surface of a wall, smooth or a mesh.
struct Patch
{
    std::shared_ptr<const Shape> shape;
    int wall; ///< index into Geometry::walls
    /// Number of the wall of each region of a mesh; empty where all is one wall.
    std::vector<int> walls = {};
    const TriangleMesh* mesh = nullptr; ///< the shape, where it is one; from repeatPeriodically
    int wallAt(int region) const { return walls.empty() ? wall : walls[std::size_t(region)]; }
};

/// A particle that lies in the solid (makeWallLayers.hpp).
struct LayerParticle
{
    Vector<3> x;
    double volumeFactor = 1; ///< its volume over that of a particle of the fluid
    int wall = 0;            ///< index into Geometry::walls
};

class PatchGrid;
class PatchTree;

struct Geometry
{
    int dimension = 3;
    Vector<3> low, high; ///< the domain; z from -0.5 to 0.5 times anything in 2-D is not used
    std::array<bool, 3> periodic{};
    std::vector<WallProperties> walls;
    std::vector<Patch> originals;          ///< as given, before repetition
    std::vector<Patch> patches;            ///< all periodic copies that lie within `reach` of the domain
    double reach = 0;                      ///< [m]
    std::filesystem::path folder;          ///< of the case, where prepared meshes lie
    FacetScale facetScale{};               ///< for what is small in meshes
    std::vector<LayerParticle> layers;     ///< of one period, where walls are layers of particles; empty where they reflect
    std::shared_ptr<const PatchGrid> grid; ///< of `patches`, for what is within reach; without it every patch is asked
    std::shared_ptr<const PatchTree> tree; ///< of `patches`, for the nearest at any distance; likewise
    /// Patches whose solid may hold parts of a patch, by patch. Empty where no solids touch or overlap: nothing then asks (solidUnion.cpp).
    std::vector<std::vector<int>> coverers;

    /// Whether another solid may hold parts of a patch.
    bool mayBeCovered(int patch) const { return !coverers.empty() && !coverers[std::size_t(patch)].empty(); }
    /// The foot of x on a patch as a part of the union of all solids: `exposure` and the margins of faces whose edges other solids cover.
    Foot foot(int patch, const Vector<3>& x) const
    {
        return mayBeCovered(patch) ? footInUnion(patch, x) : patches[std::size_t(patch)].shape->foot(x);
    }
    /// The foot of a mirror image x of `source`: on the face that the source sees, continued into the solid that the image lies in, and as
    /// much of it as the source sees.
    Foot footOfGhost(int patch, const Vector<3>& x, const Vector<3>& source) const
    {
        return mayBeCovered(patch) ? footOfGhostInUnion(patch, x, source) : patches[std::size_t(patch)].shape->foot(x);
    }

    /// Share of a foot of `source` on a face of the patch that bounds the fluid; less where other solids cover it.
    double exposure(int patch, const Vector<3>& source, const Foot&) const;

    /// Smallest signed distance to any patch, > 0 in the fluid; +infinity without walls. Periodic copies beyond `reach` count
    /// too.
    double distance(const Vector<3>& x) const;
    /// True where no patch has x on its solid side, for x within the domain.
    bool inFluid(const Vector<3>& x) const;
    /// Velocity of a point of a wall as a rigid body: velocity + omega x (x - origin) [m/s].
    Vector<3> wallVelocity(int wall, const Vector<3>& x) const;
    /// True where some wall has a contact angle.
    bool wets() const
    {
        return std::any_of(walls.begin(), walls.end(), [](const WallProperties& w) { return w.wets; });
    }
    /// True where the fluid slides along some wall freely.
    bool slips() const { return std::ranges::any_of(walls, &WallProperties::slips); }
    /// The first wall of a given friction angle; null where there is none.
    const WallProperties* withFriction() const
    {
        const auto found = std::ranges::find_if(walls, [](const WallProperties& w) { return w.frictionAngle.has_value(); });
        return found == walls.end() ? nullptr : &*found;
    }
    /// True where some wall is curved or has edges: images behind it have other volumes than their sources.
    bool bends() const;
    /// Extent of the domain in a coordinate direction [m].
    double length(int direction) const;
    /// A vector from one point to another by the shortest way round the periodic directions.
    Vector<3> shortest(Vector<3> way) const;
    /// Lengths below which surfaces touch [m].
    double tolerance() const { return 1e-6 * std::max(length(0), length(1)); }

    /// Whether x lies in or on one of the patch's `coverers`.
    bool isCovered(int patch, const Vector<3>& x) const;

private:
    Foot footInUnion(int patch, const Vector<3>& x) const;
    Foot footOfGhostInUnion(int patch, const Vector<3>& x, const Vector<3>& source) const;
};

/// The domain as a box for the mesh that ParaView and OpenFOAM want to see; in 2-D with a hundredth of its longer side to either side of the plane.
struct BoundingBox
{
    double low[3], high[3]; ///< [m]
};
BoundingBox boundingBox(const Geometry&);

/// Fills `patches` from `originals`, each periodic copy once, `grid`, `tree` and `coverers`, for the given reach [m].
void repeatPeriodically(Geometry&, double reach);

/// Faces of boxes that lie on planes or behind them go on into the solid: a block that stands on a floor, or is let into it, is the same.
void sinkIntoPlanes(Geometry&);

/// Patches that may cover a patch, by patch, where a body (fluid outside) touches or overlaps another solid. Walls of a container among
/// themselves have none: their feet behind one another are outside the domain. Spheres that touch have none either.
std::vector<std::vector<int>> findCoverers(const Geometry&);

/// Reads constant/geometry:
///
///     dimension  3;
///     domain     { min (0 0 0); max (1e-3 1e-3 1e-3); periodic (x y z); }
///     walls
///     {
///         floor   { type plane; point (0 0 0); normal (0 1 0); contactAngle 30; }
///         grains  { type sphereBed; lattice bcc; radius 1e-3; period 2.393e-3; contactAngle 30; }
///         lid     { type plane; point (0 1 0); normal (0 -1 0); velocity (1 0 0); }
///         middle  { type plane; point (0 0 1); normal (0 0 -1); slip yes; }
///         plate   { type plane; point (1 0 0); normal (-1 0 0); contactAngles ( (water air) 30 (oil air) 60 ); }
///     }
///
/// Mistakes go to the dictionary's Diagnostics; unused entries are the caller's to report. Patches are repeated over the periodic
/// directions as far as `reach` [m] outside the domain.
///
/// Meshes (type triSurface) are read as meshToGhost has prepared them in `folder`, that of the case.
Geometry readGeometry(const Dictionary&, double reach);
/// The geometry as far as so many supports of the kernel, for particles that must fit the domain: throws CaseError where they do not.
Geometry readGeometry(const Dictionary&, const Resolution&, double supports, const std::filesystem::path& folder = {});
/// Dimension and domain alone, of constant/walls or, where meshToGhost has not been run, of constant/geometry.
Geometry readDomain(const Case&);
/// Reach of the solver's images in supports, skin included.
inline constexpr double supportsOfSolver = 1.5;
/// Period [m] of the first bed of spheres among the walls of constant/geometry, 0 where there is none.
double bedPeriod(const Dictionary& geometry);
/// All types of walls and their entries.
EntryList geometryEntries();

/// Centres of the spheres of one period cell, and the extent of that cell. The cells of sc (1 sphere), bcc (2) and fcc (4) are
/// cubes of edge `period`. hcp has `period` for the distance of neighbours in the close-packed layers normal to z, and a cell of
/// (1, sqrt 3, sqrt 8/3) periods with 4 spheres.
struct SphereLattice
{
    std::vector<Vector<3>> centres;
    Vector<3> period;
};
SphereLattice sphereLattice(const std::string& lattice, double period);

}
