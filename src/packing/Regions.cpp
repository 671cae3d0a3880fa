#include "packing/Regions.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <cmath>
#include <span>

namespace sph
{

namespace entry
{
const VectorParameter centre{"centre", units::m, required, "of the region"}, min{"min", units::m, required, "lowest corner"},
    max{"max", units::m, required, "highest corner"}, regionPoint{"point", units::m, required, "a point of the plane"};
const Scalar radius{"radius", units::m, required, positive, "of the region"},
    length{"length", units::m, byScene("endless"), positive, "half of it to either side of the centre"};
const Direction axis{"axis", required, "along the axis"}, regionNormal{"normal", required, "to the side that is meant"};
const DictionaryList of{"of", required, "regions, each with its own entries"};

/// The types of regions, with what each needs.
static const Cases& regions()
{
    static const Cases all{{"all", {}},
                           {"none", {}},
                           {{"sphere", "with its periodic copies; in 2-D a circle"}, {centre, radius}},
                           {{"box", "min <= x < max: boxes side by side share no particle; z does not count in 2-D"}, {min, max}},
                           {{"halfSpace", "what lies on one side of a plane"}, {regionPoint, regionNormal}},
                           {"cylinder", {centre, axis, radius, length}},
                           {"union", {of}},
                           {"intersection", {of}},
                           {{"difference", "the first without the others"}, {of}}};
    return all;
}
static const Choice& region()
{
    static const Choice choice{"region", wordsOf(regions()), required, "type of the region"};
    return choice;
}
}

namespace
{
Region sphere(const Dictionary& dict, const Geometry& g)
{
    auto centre = entry::centre(dict);
    if (g.dimension == 2) centre.z = 0;
    const double R = entry::radius(dict);
    // by value: regions outlive the reading
    Geometry space;
    space.dimension = g.dimension;
    space.low = g.low;
    space.high = g.high;
    space.periodic = g.periodic;
    Box within;
    for (const auto c : coordinates)
    {
        within.low.*c = centre.*c - R;
        within.high.*c = centre.*c + R;
    }
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        if (!g.periodic[k] || (within.low.*c >= g.low.*c && within.high.*c <= g.high.*c)) continue;
        within.low.*c = -Box::infinity;
        within.high.*c = Box::infinity;
    }
    const auto contains = [=](const Vector<3>& x)
    {
        const Vector<3> d = space.shortest(x - centre);
        return dot(d, d) < sqr(R);
    };
    return {contains, {within}};
}

Region box(const Dictionary& dict, const Geometry& g)
{
    const auto low = entry::min(dict), high = entry::max(dict);
    for (int k = 0; k < g.dimension; ++k)
        if (low.*component(k) > high.*component(k)) entry::max.error(dict, "max lies below min: the box is inside out");
    const bool hasDepth = g.dimension == 3;
    const auto contains = [=](const Vector<3>& x)
    { return x.x >= low.x && x.x < high.x && x.y >= low.y && x.y < high.y && (!hasDepth || (x.z >= low.z && x.z < high.z)); };
    return {contains, {{low, high}}};
}

Region cylinder(const Dictionary& dict)
{
    const auto centre = entry::centre(dict), axis = entry::axis(dict);
    const double R = entry::radius(dict), half = entry::length(dict, 2 * Box::infinity) / 2;
    Box within;
    for (const auto c : coordinates)
    {
        const double a = std::fabs(axis.*c), reach = (a > 0 ? a * half : 0) + std::sqrt(std::max(0.0, 1 - a * a)) * R;
        within.low.*c = centre.*c - reach;
        within.high.*c = centre.*c + reach;
    }
    const auto contains = [=](const Vector<3>& x)
    {
        const Vector<3> d = x - centre;
        const double along = dot(d, axis);
        return std::fabs(along) < half && dot(d, d) - along * along < sqr(R);
    };
    return {contains, {within}};
}

Region halfSpace(const Dictionary& dict)
{
    const auto point = entry::regionPoint(dict), normal = entry::regionNormal(dict);
    Box within;
    for (const auto c : coordinates)
    {
        if (normal.*c == 1) within.low.*c = point.*c;
        if (normal.*c == -1) within.high.*c = point.*c;
    }
    return {[=](const Vector<3>& x) { return dot(x - point, normal) >= 0; }, {within}};
}

std::vector<Box> inBoth(const std::vector<Box>& some, const std::vector<Box>& others)
{
    std::vector<Box> both;
    for (const auto& a : some)
        for (const auto& b : others)
        {
            Box shared;
            bool any = true;
            for (const auto c : coordinates)
            {
                shared.low.*c = std::max(a.low.*c, b.low.*c);
                shared.high.*c = std::min(a.high.*c, b.high.*c);
                any &= shared.low.*c <= shared.high.*c;
            }
            if (any) both.push_back(shared);
        }
    return both;
}

Region combined(const Dictionary& dict, const std::string& type, const Geometry& g)
{
    std::vector<Region> parts;
    for (const auto& part : entry::of(dict)) parts.push_back(readRegion(part, g));
    if (parts.empty() && entry::of.given(dict)) entry::of.error(dict, "the " + type + " is of no regions");
    const auto contains = [](const Vector<3>& x) { return [&x](const Region& r) { return r(x); }; };
    if (parts.empty()) return {[](const Vector<3>&) { return false; }, {}};
    auto within = parts[0].within;
    for (const auto& part : std::span(parts).subspan(1))
    {
        if (type == "union") within.insert(within.end(), part.within.begin(), part.within.end());
        if (type == "intersection") within = inBoth(within, part.within);
    }
    if (type == "union") return {[=](const Vector<3>& x) { return std::any_of(parts.begin(), parts.end(), contains(x)); }, within};
    if (type == "intersection") return {[=](const Vector<3>& x) { return std::all_of(parts.begin(), parts.end(), contains(x)); }, within};
    return {[=](const Vector<3>& x) { return parts[0](x) && std::none_of(parts.begin() + 1, parts.end(), contains(x)); }, within};
}
}

EntryList regionEntries() { return {{entry::region(), entry::regions()}}; }

Region readRegion(const Dictionary& dict, const Geometry& g)
{
    const std::string type = entry::region()(dict);
    if (type == "all") return {[](const Vector<3>&) { return true; }, {Box{}}};
    if (type == "sphere") return sphere(dict, g);
    if (type == "box") return box(dict, g);
    if (type == "cylinder") return cylinder(dict);
    if (type == "halfSpace") return halfSpace(dict);
    if (type == "union" || type == "intersection" || type == "difference") return combined(dict, type, g);
    return {[](const Vector<3>&) { return false; }, {}};
}

}
