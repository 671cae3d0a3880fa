/// A plane at which a scene ends and fluid passes: a part of it, or all of the duct across it. constant/openings describes one by a dictionary; what
/// comes in and what drives it is read by src/models/openings.
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Geometry.hpp"
#include <optional>
#include <string>
#include <vector>

namespace sph
{

struct OpenPlane
{
    std::string name;
    bool inlet = true;
    bool isPart = false;            ///< of a plane that is open beside it: of a drip or a flux
    Vector<3> point, normal;        ///< of the plane [m]; unit, into the scene
    Box extent;                     ///< the plane is open within it alone
    double margin = 0;              ///< beside the extent, where what passes the plane leaves all the same [m]
    std::optional<double> radius;   ///< and this near to `point` [m]
    std::vector<OpenPlane> without; ///< others in the same plane, which have their parts of it
    Location where;

    /// Distance from the plane [m], > 0 in the scene.
    double distance(const Vector<3>& x) const { return dot(x - point, normal); }
    /// Whether the plane is open at a point of it, or at a point so far beside its extent [m].
    bool opensAt(const Vector<3>& x, int dimension, double beside = 0) const;
    /// Whether the plane is open where a point stands before or behind it, or as near beside that as its margin.
    bool faces(const Vector<3>& x, int dimension) const { return opensAt(x - distance(x) * normal, dimension, margin); }
    /// Whether the plane is in sight along its normal from a point of the duct beyond it.
    bool inSight(const Geometry&, const Vector<3>& x, double spacing) const;
    /// Whether another one is cut out of the plane.
    bool leavesOut(const OpenPlane& part) const;
};

/// The dictionaries of constant/openings, one an opening. What else stands there is a mistake.
std::vector<Dictionary> openingDictionaries(const Dictionary& file);
/// Reads one of them: its plane, or one for each point of a drip; none where its type is unknown.
std::vector<OpenPlane> readOpenPlanes(const Dictionary&, const Geometry&, double spacing);

/// Cuts parts of planes (isPart) out of the planes that they are in, to round-off.
template<class Plane> void cutOutParts(std::vector<Plane>& planes, double spacing)
{
    const std::vector<OpenPlane> all(planes.begin(), planes.end());
    for (auto& plane : planes)
        for (const auto& part : all)
            if (!plane.isPart && part.isPart && mag(plane.normal - part.normal) < 1e-9 &&
                std::abs(plane.distance(part.point)) < 1e-6 * spacing)
                plane.without.push_back(part);
}

/// Entries of constant/openings: those of planes, and beside them these of each type.
struct EntriesBeside
{
    EntryList ofInlet, ofOutlet, ofDrip, ofFlux;
};
EntryList openPlaneEntries(const EntriesBeside&);

}
