#include "Regions.hpp"
#include "components.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
/// The vector from `to` to x by the shortest way round the periodic directions.
Vector<3> shortest(const Geometry& g, const Vector<3>& x, const Vector<3>& to)
{
    Vector<3> d = x - to;
    for (int k = 0; k < g.dimension; ++k)
        if (g.periodic[k]) d.*component(k) -= g.length(k)*std::round(d.*component(k)/g.length(k));
    return d;
}

Vector<3> unit(const Dictionary& dict, const std::string& key)
{
    const auto v = dict.get<Vector<3>>(key);
    const double length = mag(v);
    if (length > 0) return v/length;
    if (dict.found(key)) dict.error(key, key + " has no length, and so no direction");
    return {0, 1, 0};
}

Region sphere(const Dictionary& dict, const Geometry& g)
{
    auto centre = dict.get<Vector<3>>("centre");
    if (g.dimension == 2) centre.z = 0;
    const double R2 = sqr(dict.getPositive("radius", units::m));
    // by value: regions outlive the reading
    Geometry space;
    space.dimension = g.dimension;
    space.low = g.low;
    space.high = g.high;
    space.periodic = g.periodic;
    return [=](const Vector<3>& x)
    {
        const Vector<3> d = shortest(space, x, centre);
        return dot(d, d) < R2;
    };
}

Region box(const Dictionary& dict, const Geometry& g)
{
    const auto low = dict.get<Vector<3>>("min"), high = dict.get<Vector<3>>("max");
    for (int k = 0; k < g.dimension; ++k)
        if (low.*component(k) > high.*component(k)) dict.error("max", "max lies below min: the box is inside out");
    const bool hasDepth = g.dimension == 3;
    return [=](const Vector<3>& x)
    { return x.x >= low.x && x.x < high.x && x.y >= low.y && x.y < high.y && (!hasDepth || (x.z >= low.z && x.z < high.z)); };
}

Region cylinder(const Dictionary& dict)
{
    const auto centre = dict.get<Vector<3>>("centre");
    const auto axis = unit(dict, "axis");
    const double R2 = sqr(dict.getPositive("radius", units::m));
    const double half = dict.getPositive("length", units::m, 2*Box::infinity)/2;
    return [=](const Vector<3>& x)
    {
        const Vector<3> d = x - centre;
        const double along = dot(d, axis);
        return std::fabs(along) < half && dot(d, d) - along*along < R2;
    };
}

Region combined(const Dictionary& dict, const std::string& type, const Geometry& g)
{
    std::vector<Region> parts;
    for (const auto& part : dict.dictionaries("of")) parts.push_back(readRegion(part, g));
    if (parts.empty() && dict.found("of")) dict.error("of", "the " + type + " is of no regions");
    const auto contains = [](const Vector<3>& x) { return [&x](const Region& r) { return r(x); }; };
    if (type == "union") return [=](const Vector<3>& x) { return std::any_of(parts.begin(), parts.end(), contains(x)); };
    if (type == "intersection")
        return [=](const Vector<3>& x) { return !parts.empty() && std::all_of(parts.begin(), parts.end(), contains(x)); };
    return [=](const Vector<3>& x)
    { return !parts.empty() && parts[0](x) && std::none_of(parts.begin() + 1, parts.end(), contains(x)); };
}
}

const std::vector<std::string>& regionNames()
{
    static const std::vector<std::string> names{"all",      "none",  "sphere",       "box",       "halfSpace",
                                                "cylinder", "union", "intersection", "difference"};
    return names;
}

Region readRegion(const Dictionary& dict, const Geometry& g)
{
    const std::string type = dict.choose("region", regionNames());
    if (type == "all") return [](const Vector<3>&) { return true; };
    if (type == "sphere") return sphere(dict, g);
    if (type == "box") return box(dict, g);
    if (type == "cylinder") return cylinder(dict);
    if (type == "halfSpace")
    {
        const auto point = dict.get<Vector<3>>("point");
        const auto normal = unit(dict, "normal");
        return [=](const Vector<3>& x) { return dot(x - point, normal) >= 0; };
    }
    if (type == "union" || type == "intersection" || type == "difference") return combined(dict, type, g);
    return [](const Vector<3>&) { return false; };
}

}
