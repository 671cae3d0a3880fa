/// Section `solids` of system/packParticlesDict: which solids are packed, in what, and how. In a library of its own, so that what prints the
/// entries needs neither Bullet nor meshes.
#pragma once
#include "case/Case.hpp"
#include "dictionary/EntryList.hpp"
#include "solids/entries/SizeDistribution.hpp"
#include <array>

namespace sph
{

/// Shape as which a mesh collides.
enum class CollisionForm
{
    automatic, ///< hull where the shape is convex but for a little, else parts
    hull,
    parts ///< convex parts whose hulls cover the shape
};

/// Fines bound to a grain, which make an agglomerate of it.
struct FinesToBind
{
    double massShare = 0;             ///< of the agglomerate, where fines and grain overlap counted twice
    std::string file;                 ///< of a fine, relative to the case; empty: a sphere
    double smallest = 0, largest = 0; ///< sizes over that of the grain, evenly between
    double bond = 0;                  ///< depth to which a fine reaches into the grain, over its size
    int variant = 0;                  ///< number of the agglomerate among those of its grain, from 0
    Location where;

    /// As many as have the share of the mass, one at least.
    int count() const;
};

struct ShapeToPack
{
    std::string file; ///< relative to the case; empty: a sphere
    double share = 1; ///< of the number or mass of solids
    CollisionForm form = CollisionForm::automatic;
    std::optional<FinesToBind> fines; ///< the file or sphere is then that of the grain
    Location where;

    bool isSphere() const { return file.empty() && !fines; }
};

/// Upright, with an open top: `up` is against gravity.
struct SolidContainer
{
    bool isCylinder = false;
    Vector<3> base;               ///< lowest corner of the box as a body in it sees it, or the middle of the bottom [m]
    Vector<3> along, across, up;  ///< unit vectors, right-handed; the box has its edges along them
    double length = 1, width = 1; ///< of the box
    double radius = 0.5;          ///< of the cylinder
    double height = 1;
    std::array<bool, 3> periodic{}; ///< along, across, up
    Location where;

    double area() const;
    double volume() const { return area() * height; }
    /// The smallest extent across, infinite where both sides are periodic.
    double narrowest() const;
    Vector<3> toWorld(const Vector<3>& x) const { return base + x.x * along + x.y * across + x.z * up; }
};

struct SolidsPlan
{
    bool randomClose = false;
    SolidContainer container;
    std::vector<ShapeToPack> shapes;
    bool sharesOfMass = false; ///< those of shapes
    SizeDistribution size;
    int count = 0;                ///< 0: as many as `filled` takes
    std::optional<double> filled; ///< [m] height that the bed reaches, and no centre lies above
    std::uint64_t seed = 1;

    double friction = 0, restitution = 0;
    double restEnergy = 0; ///< of the mean kinetic energy of a body in m g d, at which it is at rest
    double longest = 0;    ///< time until then, in sqrt(d/g)
    bool level = false;
    std::optional<double> shrink;   ///< share of the size; none: as much as parts what overlaps
    std::optional<double> porosity; ///< none: of randomClose the least that is reached, of a bed that settles that of its fall
    Location countAt, filledAt, timeLimitAt, porosityAt, where;
};

/// Throws CaseError with all mistakes. Reads constant/g, without which up is z.
SolidsPlan readSolidsPlan(const Case&);
/// `solids { .. }`
EntryList solidsEntries();

}
