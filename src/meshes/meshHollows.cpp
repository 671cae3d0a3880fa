#include "meshes/meshStatistics.hpp"
#include <cmath>
#include <map>
#include <numbers>

namespace sph
{

MeshHollows meshHollows(const NumberedMesh& m, const std::vector<DihedralEdge>& edges, double featureAngle, double support)
{
    constexpr double degree = std::numbers::pi / 180, flat = 0.05;
    struct Joint
    {
        int facet;
        double length, tightness; ///< [m], and the turn over the way from centroid to centroid [1/m]
        Vector<3> x, n;           ///< its middle, and the normal there
    };
    std::vector<Joint> joints;
    std::vector<char> isCurved(m.triangles.size(), 0);
    const auto halfEdges = sortedHalfEdges(m);
    std::size_t next = 0; // edges come in the same order
    forEachEdge(halfEdges,
                [&](std::span<const HalfEdge> edge)
                {
                    const auto& [a, b, angle] = edges[next++];
                    if (angle > 180 - flat || angle < 180 - featureAngle) return;
                    const auto &p = m.points[std::size_t(a)], &q = m.points[std::size_t(b)];
                    const auto first = areaVector(m, edge[0].facet), second = areaVector(m, edge[1].facet);
                    const double length = mag(q - p), tightness = (180 - angle) * degree * 3 * length / (mag(first) + mag(second));
                    if (tightness * support <= 1) return;
                    joints.push_back({edge[0].facet, length, tightness, 0.5 * (p + q), unitVector(unitVector(first) + unitVector(second))});
                    for (const auto& h : edge) isCurved[std::size_t(h.facet)] = 1;
                });
    DisjointSets parts(m.triangles.size());
    next = 0;
    forEachEdge(halfEdges,
                [&](std::span<const HalfEdge> edge)
                {
                    const double angle = edges[next++].angle;
                    if (angle < 180 + flat && angle >= 180 - featureAngle && isCurved[std::size_t(edge[0].facet)] &&
                        isCurved[std::size_t(edge[1].facet)])
                        parts.join(edge[0].facet, edge[1].facet);
                });

    struct Sums
    {
        const Joint* tightest;
        double length = 0, xn = 0;
        Vector<3> x, n;
    };
    std::map<int, Sums> hollows;
    for (const auto& j : joints)
    {
        auto& s = hollows.try_emplace(parts.find(j.facet), Sums{&j, 0, 0, {}, {}}).first->second;
        if (j.tightness > s.tightest->tightness) s.tightest = &j;
        s.length += j.length;
        s.x += j.length * j.x;
        s.n += j.length * j.n;
        s.xn += j.length * dot(j.x, j.n);
    }
    MeshHollows result;
    for (const auto& [_, s] : hollows)
    {
        const auto n = s.n / s.length;
        const double variance = 1 - dot(n, n), radius = -(s.xn / s.length - dot(s.x / s.length, n)) / variance;
        // Normals spread evenly over an arc have a variance of its angle squared over 12.
        if (std::sqrt(12 * variance) <= featureAngle * degree || !(radius > 0 && radius < support)) continue;
        ++result.count;
        if (radius < result.radius) result = {result.count, radius, nameOfFacet(m, s.tightest->facet), s.tightest->x};
    }
    return result;
}

}
