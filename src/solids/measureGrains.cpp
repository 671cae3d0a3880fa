#include "solids/BedReport.hpp"
#include "solids/CollisionShape.hpp"
#include <algorithm>

namespace sph
{

namespace
{

/// Axis of a shape about which its inertia is least.
Vector<3> longestAxis(const SolidShape& shape)
{
    const auto [axes, inertia] = principalAxes(shape);
    const auto axis = axes.getColumn(inertia.minAxis());
    return {axis.x(), axis.y(), axis.z()};
}

/// Each sphere gets the gap to its nearest neighbour.
void findGaps(const SolidContainer& c, const Bed& bed, std::vector<GrainMeasures>& grains)
{
    std::vector<Vector<3>> centres;
    std::vector<double> reach;
    std::vector<std::size_t> body;
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        if (!bed.shapeOf(b).isSphere()) continue;
        centres.push_back(b.centre);
        reach.push_back(0.5 * b.size);
        body.push_back(i);
    }
    for (const auto& [i, j] : nearPairs(c, centres, reach, bed.meanSize))
    {
        const auto a = std::size_t(i), b = std::size_t(j);
        const double gap = mag(shortest(c, centres[a] - centres[b])) - reach[a] - reach[b];
        for (const auto k : {a, b})
        {
            auto& least = grains[body[k]].gap;
            least = std::min(least.value_or(gap), gap);
        }
    }
}

}

void measureGrains(const SolidContainer& c, const Bed& bed, double low, double high, BedMeasures& result)
{
    result.grains.resize(bed.bodies.size());
    for (const auto& contact : bed.contacts)
        for (const int i : {contact.i, contact.j}) ++result.grains[std::size_t(i)].contacts;
    findGaps(c, bed, result.grains);

    std::vector<Vector<3>> longest;
    for (const auto& shape : bed.shapes) longest.push_back(shape.isSphere() ? Vector<3>{} : longestAxis(shape));
    int meshes = 0, core = 0, contactsOfCore = 0;
    double order = 0;
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        const auto& x = b.centre;
        const double margin = 1.5 * bed.meanSize;
        const auto within = [&](double a, double extent, bool isPeriodic) { return isPeriodic || (a > margin && a < extent - margin); };
        const bool isAway = c.isCylinder ? std::hypot(x.x, x.y) < c.radius - margin
                                         : within(x.x, c.length, c.periodic[0]) && within(x.y, c.width, c.periodic[1]);
        if (isAway && (c.periodic[2] || (x.z > low && x.z < high)))
        {
            ++core;
            contactsOfCore += result.grains[i].contacts;
        }
        if (bed.shapeOf(b).isSphere()) continue;
        const double cosine = std::min(1.0, std::abs(b.rotation(longest[std::size_t(b.shape)]).z));
        result.grains[i].tilt = std::acos(cosine) * 180 / std::numbers::pi;
        order += 1.5 * cosine * cosine - 0.5;
        ++meshes;
    }
    if (core > 0) result.coreCoordination = double(contactsOfCore) / core;
    if (meshes == 0) return;
    result.orientation = order / meshes;
    result.orientationError = 1 / std::sqrt(5.0 * meshes);
}

}
