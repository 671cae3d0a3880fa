/// Solids that touch or overlap act as one: what lies of a surface in another solid does not mirror, push, wet or count.
///
/// Two things follow from it. A foot in another solid has an exposure of 0; where two surfaces meet at an angle a of more than 90 degrees of
/// fluid, it falls from 1 at the line where they meet to 0 as far into the other solid as mirror images of both would fill it twice: at half of
/// that the image lies on the bisector of the solid. And an edge in another solid is none: the faces of a block that stands on a floor go on
/// into it, so that the fluid beside the block has the images of the corner of a box.
#include "geometry/Geometry.hpp"
#include "geometry/Plane.hpp"
#include "geometry/SolidBox.hpp"
#include "geometry/TriangleMesh.hpp"
#include "geometry/closestApproach.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{

/// Cosine between normals beyond which two surfaces are taken for parallel.
constexpr double parallel = 1 - 1e-6;

bool overlaps(const Box& a, const Box& b, double slack)
{
    return std::all_of(std::begin(coordinates), std::end(coordinates),
                       [&](auto c) { return a.low.*c <= b.high.*c + slack && b.low.*c <= a.high.*c + slack; });
}

/// Whether a body touches or overlaps another solid. Balls have to overlap it; `points` are of the body's surface otherwise.
bool meets(const Shape& body, const Shape& other, const std::vector<Vector<3>>& points, bool isBall, double tolerance)
{
    if (isBall)
    {
        const auto b = body.bounds();
        auto centre = 0.5 * (b.low + b.high);
        if (!std::isfinite(centre.z)) centre.z = 0;
        return other.foot(centre).distance < 0.5 * (b.high.x - b.low.x) - tolerance;
    }
    return std::any_of(points.begin(), points.end(), [&](const auto& x) { return other.foot(x).distance <= tolerance; });
}

}

void sinkIntoPlanes(Geometry& g)
{
    for (auto& patch : g.patches)
    {
        if (!dynamic_cast<const SolidBox*>(patch.shape.get())) continue;
        const Box given = patch.shape->bounds();
        Box box = given;
        for (const auto c : coordinates)
            for (const double side : {-1.0, 1.0})
            {
                const double level = side < 0 ? given.low.*c : given.high.*c;
                if (!std::isfinite(level)) continue;
                Box face = given;
                face.low.*c = face.high.*c = level;
                for (const auto d : coordinates)
                    if (std::isinf(face.low.*d)) face.low.*d = face.high.*d = 0;
                const auto points = corners(face);
                const bool isBehind =
                    std::any_of(g.patches.begin(), g.patches.end(),
                                [&](const Patch& q)
                                {
                                    if (!dynamic_cast<const Plane*>(q.shape.get()) || side * (q.shape->foot(points[0]).normal.*c) > -0.5)
                                        return false;
                                    return std::all_of(points.begin(), points.end(),
                                                       [&](const auto& x) { return q.shape->foot(x).distance <= g.tolerance(); });
                                });
                auto& end = side < 0 ? box.low : box.high;
                if (isBehind) end.*c += side * 2 * g.reach;
            }
        if (box.low != given.low || box.high != given.high) patch.shape = std::make_shared<SolidBox>(box.low, box.high);
    }
}

std::vector<std::vector<int>> findCoverers(const Geometry& g)
{
    const int n = int(g.patches.size());
    const double tolerance = g.tolerance();
    const auto shape = [&](int p) -> const Shape& { return *g.patches[std::size_t(p)].shape; };
    std::vector<int> bodies, others;
    for (int p = 0; p < n; ++p) (shape(p).enclosesFluid() ? others : bodies).push_back(p);
    if (bodies.empty() || n < 2) return {};

    Box within{g.low, g.high};
    for (int k = 0; k < 3; ++k)
    {
        const auto c = component(k);
        const bool flat = k == 2 && g.dimension == 2;
        within.low.*c -= flat ? within.low.*c : g.reach;
        within.high.*c -= flat ? within.high.*c : -g.reach;
    }
    std::vector<Box> bounds(static_cast<std::size_t>(n));
    for (const int p : bodies) bounds[std::size_t(p)] = shape(p).bounds();
    std::vector<std::vector<Vector<3>>> points(static_cast<std::size_t>(n));
    const auto pointsOf = [&](int p) -> const std::vector<Vector<3>>&
    {
        auto& of = points[std::size_t(p)];
        if (of.empty())
        {
            auto box = within;
            if (g.dimension == 2)
            {
                box.low.z = -0.5 * g.reach;
                box.high.z = 0.5 * g.reach;
            }
            of = triangulate(shape(p), box, 0.5 * g.reach).points;
            if (g.dimension == 2)
                for (auto& x : of) x.z = 0;
            if (of.empty()) of.push_back({Box::infinity, 0, 0});
        }
        return of;
    };

    std::vector<std::vector<int>> coverers(static_cast<std::size_t>(n));
    bool any = false;
    const auto consider = [&](int p, int q)
    {
        const bool ballP = isBall(shape(p), g.dimension), ballQ = isBall(shape(q), g.dimension), both = !shape(q).enclosesFluid();
        static const std::vector<Vector<3>> none;
        const bool meet = ballP   ? meets(shape(p), shape(q), none, true, tolerance)
                          : ballQ ? meets(shape(q), shape(p), none, true, tolerance)
                                  : meets(shape(p), shape(q), pointsOf(p), false, tolerance) ||
                                        (both && meets(shape(q), shape(p), pointsOf(q), false, tolerance));
        if (!meet) return;
        coverers[std::size_t(p)].push_back(q);
        coverers[std::size_t(q)].push_back(p);
        any = true;
    };
    for (const int p : bodies)
        for (const int q : others) consider(p, q);
    std::sort(bodies.begin(), bodies.end(), [&](int p, int q) { return bounds[std::size_t(p)].low.x < bounds[std::size_t(q)].low.x; });
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t k = i + 1; k < bodies.size(); ++k)
        {
            const auto &a = bounds[std::size_t(bodies[i])], &b = bounds[std::size_t(bodies[k])];
            if (b.low.x > a.high.x + tolerance) break;
            if (overlaps(a, b, tolerance)) consider(bodies[i], bodies[k]);
        }
    if (!any) return {};
    for (auto& of : coverers) std::sort(of.begin(), of.end());
    return coverers;
}

bool Geometry::isCovered(int patch, const Vector<3>& x) const
{
    const auto& of = coverers[std::size_t(patch)];
    return std::any_of(of.begin(), of.end(),
                       [&](int q)
                       {
                           const auto& solid = patches[std::size_t(q)];
                           return !isBeyond(solid.mesh, x, tolerance()) && solid.shape->foot(x).distance <= tolerance();
                       });
}

double Geometry::exposure(int patch, const Vector<3>& x, const Foot& f) const
{
    const auto y = x - f.distance * f.normal;
    const double touching = tolerance();
    if (f.on != Foot::On::face) return isCovered(patch, y) ? 0 : 1;
    double share = 1;
    for (const int q : coverers[std::size_t(patch)])
    {
        if (isBeyond(patches[std::size_t(q)].mesh, y, touching)) continue;
        const auto& solid = *patches[std::size_t(q)].shape;
        double depth = -solid.foot(y).distance;
        if (depth < -touching) continue;
        // The side of the other solid that x sees. What has got a little into it sees this surface as it does in the corner of a box.
        const Foot seen = solid.foot(x);
        const double alongside = dot(f.normal, seen.normal);
        if (depth > touching) depth = std::min(depth, depth + seen.distance);
        if (depth <= touching)
        {
            // Surfaces on one another: back to back there is no fluid between them; flush the first of them is the wall.
            if (alongside < -parallel || (alongside > parallel && q < patch)) return 0;
            continue;
        }
        const double twice = 2 * f.distance * (1 - alongside);
        if (alongside < 0 || !(twice > 0)) return 0;
        share *= smoothStep(1 - depth / twice);
    }
    return share;
}

Foot Geometry::footInUnion(int patch, const Vector<3>& x) const
{
    const auto& shape = *patches[std::size_t(patch)].shape;
    Foot f = shape.foot(x);
    if (f.distance <= 0)
    {
        // Out of a solid the way leads through a face that bounds the fluid.
        f.exposure = exposure(patch, x, f);
        if (f.exposure > 0) return f;
        Foot free = f;
        for (Foot each : shape.feetFromInside(x))
        {
            each.exposure = exposure(patch, x, each);
            if (each.exposure > 0 && (free.exposure == 0 || each.distance > free.distance)) free = each;
        }
        return free;
    }
    if (f.on == Foot::On::face && std::isfinite(f.margin))
        f = shape.footOnFace(x, f.normal, x, [&](const Vector<3>& y) { return isCovered(patch, y); });
    f.exposure = exposure(patch, x, f);
    return f;
}

Foot Geometry::footOfGhostInUnion(int patch, const Vector<3>& x, const Vector<3>& source) const
{
    const auto& shape = *patches[std::size_t(patch)].shape;
    const Foot seen = footInUnion(patch, source);
    Foot f = seen.on == Foot::On::face ? shape.footOnFace(x, seen.normal, source, [&](const Vector<3>& y) { return isCovered(patch, y); })
                                       : shape.foot(x);
    f.exposure = seen.exposure;
    return f;
}

}
