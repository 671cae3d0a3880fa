#include "packing/openFaces.hpp"
#include "geometry/Plane.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
/// Whether fluid lies further than half a spacing from the walls at some of the middles of the squares, a spacing wide, of a face.
bool isOpen(const Geometry& g, int axis, double at, double spacing)
{
    int across[2], directions = 0;
    for (int k = 0; k < g.dimension; ++k)
        if (k != axis) across[directions++] = k;
    long n[2] = {1, 1};
    for (int d = 0; d < directions; ++d) n[d] = std::max(1L, std::lround(g.length(across[d]) / spacing));
    for (long i = 0; i < n[0]; ++i)
        for (long k = 0; k < n[1]; ++k)
        {
            const long of[2] = {i, k};
            Vector<3> x;
            x.*component(axis) = at;
            for (int d = 0; d < directions; ++d)
                x.*component(across[d]) = g.low.*component(across[d]) + (double(of[d]) + 0.5) / double(n[d]) * g.length(across[d]);
            if (g.distance(x) > 0.5 * spacing) return true;
        }
    return false;
}
}

Geometry closedBy(const std::vector<ClosingPlane>& planes, const Geometry& geometry)
{
    auto closed = geometry;
    if (planes.empty()) return closed;
    const int wall = int(closed.walls.size());
    closed.walls.emplace_back().name = "openFaces";
    for (const auto& [point, normal] : planes) closed.originals.push_back({std::make_shared<Plane>(point, normal), wall});
    repeatPeriodically(closed, geometry.reach);
    return closed;
}

std::vector<ClosingPlane> openFaces(const Geometry& g, double spacing)
{
    std::vector<ClosingPlane> faces;
    for (int axis = 0; axis < g.dimension; ++axis)
        for (const bool upper : {false, true})
        {
            const auto c = component(axis);
            const double at = (upper ? g.high : g.low).*c;
            if (g.periodic[std::size_t(axis)] || !isOpen(g, axis, at, spacing)) continue;
            ClosingPlane face;
            face.point.*c = at;
            face.normal.*c = upper ? -1 : 1;
            faces.push_back(face);
        }
    return faces;
}

}
