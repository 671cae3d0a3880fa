#include "meshes/meshStatistics.hpp"
#include "meshes/orientShells.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph
{

namespace
{

/// Area over that of the circumcircle, 1 for the equilateral triangle; 0 for one that has collapsed.
double quality(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r)
{
    const double a = mag(q - p), b = mag(r - q), c = mag(p - r), area = 0.5 * mag(cross(q - p, r - p));
    if (!(a * b * c > 0)) return 0;
    // Radius of the circumcircle a b c / (4 area); of the equilateral triangle area/(pi R^2) = 3 sqrt 3/(4 pi).
    const double R = a * b * c / (4 * area);
    return area > 0 ? area / (R * R) / (0.75 * std::sqrt(3.0)) : 0;
}

}

MeshStatistics meshStatistics(const NumberedMesh& m)
{
    MeshStatistics s;
    s.triangles = m.triangles.size();
    s.points = m.points.size();
    s.inRegion.assign(m.regions.size(), 0);
    s.box = boundingBox(m);
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
    {
        ++s.inRegion[std::size_t(m.region[f])];
        const auto& [a, b, c] = m.triangles[f];
        const double q = std::min(1.0, quality(m.points[std::size_t(a)], m.points[std::size_t(b)], m.points[std::size_t(c)]));
        s.illegal += q == 0;
        ++s.quality[std::min<std::size_t>(19, std::size_t(20 * q))];
        s.leastQuality = std::min(s.leastQuality, q);
        s.greatestQuality = std::max(s.greatestQuality, q);
    }

    DisjointSets parts(m.triangles.size()), zones(m.triangles.size());
    s.shortest.length = Box::infinity;
    forEachEdge(sortedHalfEdges(m),
                [&](std::span<const HalfEdge> edge)
                {
                    const auto &a = m.points[std::size_t(edge[0].low)], &b = m.points[std::size_t(edge[0].high)];
                    const double l = mag(b - a);
                    if (l < s.shortest.length) s.shortest = {l, a, b};
                    if (l > s.longest.length) s.longest = {l, a, b};
                    s.open += edge.size() == 1;
                    s.multiple += edge.size() > 2;
                    for (const auto& h : edge) parts.join(edge[0].facet, h.facet);
                    if (edge.size() == 2 && edge[0].forward != edge[1].forward) zones.join(edge[0].facet, edge[1].facet);
                });
    s.parts = parts.numbered().second;
    s.zones = zones.numbered().second;
    s.volume = enclosedVolume(m);
    return s;
}

std::vector<DihedralEdge> dihedralEdges(const FacetSurface& s)
{
    std::vector<DihedralEdge> all;
    all.reserve(3 * s.triangles.size() / 2);
    forEachEdge(sortedHalfEdges(s),
                [&](std::span<const HalfEdge> edge)
                {
                    const auto n = areaVector(s, edge[0].facet), m = areaVector(s, edge[1].facet);
                    const auto along = s.points[std::size_t(edge[0].high)] - s.points[std::size_t(edge[0].low)];
                    // The first facet goes along the edge or against it; n x m points along it where the solid is convex.
                    const auto turn = cross(n, m);
                    const double sign = (dot(turn, along) > 0) == edge[0].forward ? 1 : -1;
                    const double between = std::atan2(mag(turn), dot(n, m)) * 180 / std::numbers::pi;
                    all.push_back({edge[0].low, edge[0].high, 180 + sign * between});
                });
    return all;
}

MeshFeatures meshFeatures(const FacetSurface& s, const std::vector<DihedralEdge>& edges, double featureAngle)
{
    MeshFeatures result;
    DisjointSets faces(s.triangles.size());
    std::size_t next = 0;
    forEachEdge(sortedHalfEdges(s),
                [&](std::span<const HalfEdge> edge)
                {
                    const auto& [a, b, angle] = edges[next++]; // in the same order
                    const auto middle = 0.5 * (s.points[std::size_t(a)] + s.points[std::size_t(b)]);
                    if (angle > result.most)
                    {
                        result.most = angle;
                        result.mostAt = middle;
                    }
                    if (angle < result.least)
                    {
                        result.least = angle;
                        result.leastAt = middle;
                    }
                    result.grooves += angle < leastFilled;
                    if (std::abs(angle - 180) <= featureAngle) faces.join(edge[0].facet, edge[1].facet);
                    else ++(angle > 180 ? result.convex : result.concave);
                });
    const auto [face, count] = faces.numbered();
    std::vector<double> area(std::size_t(count), 0);
    std::vector<int> first(std::size_t(count), -1);
    for (std::size_t f = 0; f < face.size(); ++f)
    {
        const auto k = std::size_t(face[f]);
        area[k] += 0.5 * mag(areaVector(s, int(f)));
        if (first[k] < 0) first[k] = int(f);
    }
    const auto least = std::min_element(area.begin(), area.end());
    result.smallest = std::sqrt(*least);
    result.smallestAt = centroid(s, first[std::size_t(least - area.begin())]);
    return result;
}

}
