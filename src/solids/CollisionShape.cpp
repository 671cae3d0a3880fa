#include "solids/CollisionShape.hpp"
#include "solids/rocks/closedSurface.hpp"
#include <HACD/hacdHACD.h>
#include <LinearMath/btConvexHullComputer.h>
#include <algorithm>
#include <fmt/format.h>
#include <tuple>

namespace sph
{

namespace
{

std::vector<btVector3> hullOf(const std::vector<btVector3>& points, double setBack = 0)
{
    btConvexHullComputer hull;
    constexpr double mostOfInnerRadius = 0.5;
    hull.compute(&points[0].x(), sizeof(btVector3), int(points.size()), setBack, mostOfInnerRadius);
    std::vector<btVector3> corners;
    for (int k = 0; k < hull.vertices.size(); ++k) corners.push_back(hull.vertices[k]);
    return corners;
}

/// Faces of the hull as three of their corners, counter-clockwise as seen from outside.
std::vector<std::array<btVector3, 3>> hullFacets(const std::vector<btVector3>& points)
{
    btConvexHullComputer hull;
    hull.compute(&points[0].x(), sizeof(btVector3), int(points.size()), 0, 0);
    btVector3 middle(0, 0, 0);
    for (int k = 0; k < hull.vertices.size(); ++k) middle += hull.vertices[k] / hull.vertices.size();
    std::vector<std::array<btVector3, 3>> facets;
    for (int f = 0; f < hull.faces.size(); ++f)
    {
        const auto* first = &hull.edges[hull.faces[f]];
        const auto& a = hull.vertices[first->getSourceVertex()];
        for (const auto* e = first->getNextEdgeOfFace(); e->getTargetVertex() != first->getSourceVertex(); e = e->getNextEdgeOfFace())
        {
            const auto &b = hull.vertices[e->getSourceVertex()], &c = hull.vertices[e->getTargetVertex()];
            if ((b - a).cross(c - a).dot(a - middle) > 0) facets.push_back({a, b, c});
            else facets.push_back({a, c, b});
        }
    }
    return facets;
}

double hullVolume(const std::vector<btVector3>& points)
{
    double sum = 0;
    for (const auto& [a, b, c] : hullFacets(points)) sum += a.dot(b.cross(c)) / 6;
    return sum;
}

/// True where each facet of the mesh lies within a part.
bool cover(const std::vector<std::vector<btVector3>>& parts, const std::vector<btVector3>& points, const TriangleSurface& mesh)
{
    constexpr double tolerance = 1e-3; // of the size
    std::vector<char> covered(mesh.triangles.size(), 0);
    for (const auto& part : parts)
    {
        std::vector<char> inside(points.size(), 1);
        for (const auto& [a, b, c] : hullFacets(part))
            if (const auto n = (b - a).cross(c - a); n.length() > 0)
                for (std::size_t i = 0; i < points.size(); ++i) inside[i] &= n.dot(points[i] - a) < tolerance * n.length();
        for (std::size_t f = 0; f < covered.size(); ++f)
            covered[f] |= std::ranges::all_of(mesh.triangles[f], [&](int i) { return bool(inside[std::size_t(i)]); });
    }
    return std::ranges::all_of(covered, [](char c) { return bool(c); });
}

/// Hierarchical approximate convex decomposition (Mamou & Ghorbel 2009): clusters of facets, the hulls of which cover them.
std::vector<std::vector<btVector3>> convexParts(const std::vector<btVector3>& points, const TriangleSurface& mesh)
{
    std::vector<HACD::Vec3<HACD::Real>> x;
    for (const auto& p : points) x.emplace_back(p.x(), p.y(), p.z());
    std::vector<HACD::Vec3<long>> facets;
    for (const auto& [a, b, c] : mesh.triangles) facets.emplace_back(a, b, c);
    HACD::HACD hacd;
    hacd.SetPoints(x.data());
    hacd.SetNPoints(x.size());
    hacd.SetTriangles(facets.data());
    hacd.SetNTriangles(facets.size());
    // A cluster may be as concave as 2 % of the size: HACD scales the shape to 1000.
    hacd.SetConcavity(20);
    hacd.SetNClusters(2);
    hacd.SetNVerticesPerCH(points.size());
    hacd.SetCompacityWeight(0.1);
    hacd.SetVolumeWeight(0);
    hacd.SetAddExtraDistPoints(true);
    hacd.SetAddFacesPoints(true);
    hacd.Compute();
    std::vector<std::vector<btVector3>> parts;
    for (std::size_t c = 0; c < hacd.GetNClusters(); ++c)
    {
        std::vector<HACD::Vec3<HACD::Real>> corner(hacd.GetNPointsCH(c));
        std::vector<HACD::Vec3<long>> face(hacd.GetNTrianglesCH(c));
        if (corner.size() < 4) continue;
        hacd.GetCH(c, corner.data(), face.data());
        std::vector<btVector3> part;
        for (const auto& p : corner) part.emplace_back(p.X(), p.Y(), p.Z());
        parts.push_back(hullOf(part));
    }
    return parts;
}

}

std::pair<btMatrix3x3, btVector3> principalAxes(const SolidShape& shape)
{
    const auto moments = volumeMoments(shape.mesh);
    const auto& s = moments.second;
    const double trace = s.xx + s.yy + s.zz;
    btMatrix3x3 inertia(trace - s.xx, -s.xy, -s.xz, -s.xy, trace - s.yy, -s.yz, -s.xz, -s.yz, trace - s.zz), axes;
    inertia.diagonalize(axes, 1e-12, 100);
    return {axes, btVector3(inertia[0][0], inertia[1][1], inertia[2][2]) / moments.volume};
}

CollisionShape makeCollisionShape(const SolidShape& shape)
{
    CollisionShape c;
    c.isSphere = shape.isSphere();
    c.description = "sphere";
    if (c.isSphere) return c;
    const double shapeVolume = volumeMoments(shape.mesh).volume;
    std::tie(c.axes, c.inertia) = principalAxes(shape);
    const auto pointsOf = [&](const TriangleSurface& mesh)
    {
        std::vector<btVector3> points;
        for (const auto& p : mesh.points) points.push_back(btVector3(p.x, p.y, p.z) * c.axes);
        return points;
    };
    const auto points = pointsOf(shape.mesh);
    c.corners = hullOf(points);

    const double excess = std::max(0.0, hullVolume(points) / shapeVolume - 1);
    constexpr double nearlyConvex = 0.02;
    bool isCovered = true;
    if (shape.form == CollisionForm::parts || (shape.form == CollisionForm::automatic && excess > nearlyConvex))
        // The grain and the fines of an agglomerate are known, and as a rule convex.
        for (const auto& piece : shape.isAgglomerate() ? shape.pieces : std::vector{shape.mesh})
        {
            const auto corners = pointsOf(piece);
            std::vector<std::vector<btVector3>> parts{hullOf(corners)};
            if (!shape.isAgglomerate() || hullVolume(corners) > (1 + nearlyConvex) * volumeMoments(piece).volume)
                parts = convexParts(corners, piece);
            isCovered = isCovered && (parts.empty() || cover(parts, corners, piece));
            c.parts.insert(c.parts.end(), parts.begin(), parts.end());
        }
    const bool isWhole = c.parts.size() < 2 || !isCovered;
    if (isWhole) c.parts = {c.corners};
    double volume = 0;
    for (const auto& part : c.parts) volume += hullVolume(part);
    c.description = isWhole ? fmt::format("convex hull, {:.2g} % more volume than the shape{}", 100 * excess,
                                          isCovered ? "" : "; its convex parts would not cover it")
                            : fmt::format("{} convex parts, volumes together {:.3g} of the shape's (its hull: {:.3g})", c.parts.size(),
                                          volume / shapeVolume, 1 + excess);
    return c;
}

BulletShape makeBulletShape(const CollisionShape& c, double size)
{
    BulletShape shape;
    if (c.isSphere)
    {
        shape.whole = std::make_unique<btSphereShape>(0.5 * size);
        return shape;
    }
    for (const auto& part : c.parts)
    {
        auto hull = std::make_unique<btConvexHullShape>();
        for (const auto& p : hullOf(part, collisionMargin)) hull->addPoint(size * p, false);
        hull->recalcLocalAabb();
        hull->setMargin(collisionMargin * size);
        shape.hulls.push_back(std::move(hull));
    }
    if (shape.hulls.size() > 1)
    {
        auto compound = std::make_unique<btCompoundShape>();
        for (const auto& hull : shape.hulls) compound->addChildShape(btTransform::getIdentity(), hull.get());
        shape.whole = std::move(compound);
    }
    return shape;
}

}
