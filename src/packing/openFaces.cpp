#include "openFaces.hpp"
#include "Plane.hpp"
#include "components.hpp"
#include "wallLayers.hpp"
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

Geometry withOpenFacesClosed(const Geometry& geometry, double H, double spacing)
{
    auto closed = geometry;
    const int wall = int(closed.walls.size());
    for (int axis = 0; axis < closed.dimension; ++axis)
        for (const bool upper : {false, true})
        {
            const auto c = component(axis);
            const double at = (upper ? geometry.high : geometry.low).*c;
            if (geometry.periodic[std::size_t(axis)] || !isOpen(geometry, axis, at, spacing)) continue;
            Vector<3> point, normal;
            point.*c = at;
            normal.*c = upper ? -1 : 1;
            closed.originals.push_back({std::make_shared<Plane>(point, normal), wall});
        }
    if (closed.originals.size() == geometry.originals.size()) return closed;
    closed.walls.emplace_back().name = "openFaces";
    repeatPeriodically(closed, geometry.reach);
    if (!geometry.layers.empty())
    {
        Diagnostics ofPlanes; // of which all can be layers
        closed.layers = makeWallLayers(closed, H, spacing, ofPlanes);
    }
    return closed;
}

}
