#include "geometry/OpenPlane.hpp"
#include "geometry/components.hpp"
#include "geometry/contains.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const FreeName opening{"<opening>", "dictionary", "an opening of the case's own name"};
const Choice type{"type",
                  {{"inlet", "fluid comes in through a duct"},
                   {"outlet", "fluid leaves, and may come back with `backflow`"},
                   {"drip", "liquid comes in at points of a plane that is open to gas"},
                   {"flux", "liquid comes in through a part of a plane that is open to gas"}},
                  required,
                  "of the opening"};
const VectorParameter openPoint{"point", units::m, required, "a point of the plane"},
    openMin{"min", units::m, byScene("endless"),
            "the plane is open within this box alone; what leaves up to a spacing beside it leaves by it"},
    openMax{"max", units::m, byScene("endless"), "highest corner of that box"};
const ListOf<Vector<3>> points{"points", units::m, required, "of the plane, each an opening: <opening>1, <opening>2 ..."};
const Direction openNormal{"normal", required, "into the scene"};
const Scalar openRadius{"radius", units::m, required, positive, "of what falls from each point; in 2-D half of its width"};
}

bool OpenPlane::opensAt(const Vector<3>& x, int dimension, double beside) const
{
    const Vector<3> by = beside * Vector<3>{1, 1, 1};
    return contains({extent.low - by, extent.high + by}, x, dimension) && (!radius || mag(x - point) <= *radius) &&
           std::ranges::none_of(without, [&](const OpenPlane& other) { return other.opensAt(x, dimension); });
}

bool OpenPlane::inSight(const Geometry& geometry, const Vector<3>& x, double spacing) const
{
    const double s = distance(x);
    if (s > 0 || !faces(x, geometry.dimension)) return false;
    for (double by = 0; by < -s; by += spacing)
        if (!geometry.inFluid(x + by * normal)) return false;
    return true;
}

bool OpenPlane::leavesOut(const OpenPlane& part) const
{
    return std::ranges::any_of(without, [&](const OpenPlane& other) { return other.name == part.name; });
}

namespace
{
void readExtent(const Dictionary& d, int dimension, double spacing, OpenPlane& plane)
{
    plane.point = entry::openPoint(d);
    plane.extent.low = entry::openMin(d, plane.extent.low);
    plane.extent.high = entry::openMax(d, plane.extent.high);
    for (int k = 0; k < dimension; ++k)
        if (const auto a = component(k); plane.extent.high.*a < plane.extent.low.*a)
            entry::openMax.error(d, fmt::format("max must not be less than min; in {} it is {} against {}", coordinateNames[k],
                                                plane.extent.high.*a, plane.extent.low.*a));
    const auto roundOff = 1e-6 * spacing * Vector<3>{1, 1, 1};
    plane.extent.low -= roundOff;
    plane.extent.high += roundOff;
    if (!plane.inlet) plane.margin = spacing;
}
}

std::vector<Dictionary> openingDictionaries(const Dictionary& file)
{
    std::vector<Dictionary> all;
    for (const auto& name : file.keys())
        if (file.isDictionary(name)) all.push_back(file.subDict(name));
        else file.error(name, fmt::format("opening \"{0}\" must be a dictionary: {0} {{ type inlet; ... }}", name));
    return all;
}

std::vector<OpenPlane> readOpenPlanes(const Dictionary& d, const Geometry& geometry, double spacing)
{
    const auto known = entry::type.known(d);
    if (!known) return {};
    OpenPlane plane;
    plane.name = d.keyword();
    plane.where = d.location();
    plane.inlet = *known != "outlet";
    plane.isPart = *known == "drip" || *known == "flux";
    plane.normal = entry::openNormal(d);
    entry::openNormal.checkPlane(d, plane.normal, geometry.dimension);
    for (int k = 0; k < geometry.dimension; ++k)
        if (geometry.periodic[k] && plane.normal.*component(k) != 0)
            entry::openNormal.error(
                d, fmt::format("the domain is periodic in {}: what leaves it there comes in again, and no plane across is an opening",
                               coordinateNames[k]));
    if (*known != "drip")
    {
        readExtent(d, geometry.dimension, spacing, plane);
        return {plane};
    }
    plane.radius = entry::openRadius(d);
    std::vector<OpenPlane> drips;
    for (const auto& point : entry::points(d))
    {
        drips.push_back(plane);
        drips.back().name += std::to_string(drips.size());
        drips.back().point = point;
    }
    if (drips.empty()) entry::points.error(d, "there must be a point at least");
    return drips;
}

EntryList openPlaneEntries(const EntriesBeside& beside)
{
    using namespace entry;
    const EntryList ofPlane{openPoint, openMin, openMax};
    const Cases byType{{"inlet", ofPlane + beside.ofInlet},
                       {"outlet", ofPlane + beside.ofOutlet},
                       {"drip", EntryList{points, openRadius} + beside.ofDrip},
                       {"flux", ofPlane + beside.ofFlux}};
    return {{opening, {{type, byType}, openNormal}}};
}

}
