#include "geometry/TriangleSurface.hpp"
#include "geometry/Shape.hpp"
#include "geometry/components.hpp"
#include <algorithm>

namespace sph
{

TriangleSurface parametricSurface(int nu, int nv, const std::function<Vector<3>(double, double)>& point)
{
    TriangleSurface surface;
    for (int k = 0; k <= nv; ++k)
        for (int i = 0; i <= nu; ++i) surface.points.push_back(point(double(i) / nu, double(k) / nv));
    const auto hasArea = [&](int a, int b, int c)
    {
        const auto& p = surface.points;
        const auto ab = p[b] - p[a], ac = p[c] - p[a];
        return mag(cross(ab, ac)) > 1e-12 * (dot(ab, ab) + dot(ac, ac));
    };
    const auto add = [&](int a, int b, int c)
    {
        if (hasArea(a, b, c)) surface.triangles.push_back({a, b, c});
    };
    for (int k = 0; k < nv; ++k)
        for (int i = 0; i < nu; ++i)
        {
            const int a = k * (nu + 1) + i, b = a + 1, c = a + nu + 1, d = c + 1;
            add(a, b, d);
            add(a, d, c);
        }
    return surface;
}

int segments(double length, double size) { return std::clamp(int(std::ceil(length / size)), 8, 96); }

namespace
{

/// Part of a convex polygon on the side of a coordinate plane where sign*(component - bound) <= 0 (Sutherland & Hodgman 1974).
std::vector<Vector<3>> clipped(const std::vector<Vector<3>>& polygon, double Vector<3>::*component, double bound, double sign)
{
    std::vector<Vector<3>> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double beyondA = sign * (a.*component - bound), beyondB = sign * (b.*component - bound);
        if (beyondA <= 0) kept.push_back(a);
        if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0))
        {
            auto crossing = a + (beyondA / (beyondA - beyondB)) * (b - a);
            crossing.*component = bound;
            kept.push_back(crossing);
        }
    }
    return kept;
}

}

TriangleSurface cropped(const TriangleSurface& surface, const Box& box)
{
    TriangleSurface result;
    std::vector<int> newIndex(surface.points.size(), -1);
    const auto inside = [&](const Vector<3>& p)
    { return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p.z >= box.low.z && p.z <= box.high.z; };
    const auto kept = [&](int i)
    {
        if (newIndex[i] < 0)
        {
            newIndex[i] = int(result.points.size());
            result.points.push_back(surface.points[i]);
        }
        return newIndex[i];
    };
    for (const auto& [a, b, c] : surface.triangles)
    {
        std::vector<Vector<3>> polygon{surface.points[a], surface.points[b], surface.points[c]};
        if (std::all_of(polygon.begin(), polygon.end(), inside))
        {
            result.triangles.push_back({kept(a), kept(b), kept(c)});
            continue;
        }
        for (const auto axis : coordinates)
        {
            polygon = clipped(polygon, axis, box.low.*axis, -1);
            polygon = clipped(polygon, axis, box.high.*axis, 1);
        }
        const int first = int(result.points.size());
        if (polygon.size() > 2) result.points.insert(result.points.end(), polygon.begin(), polygon.end());
        for (int i = 2; i < int(polygon.size()); ++i)
            if (mag(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0])) > 0)
                result.triangles.push_back({first, first + i - 1, first + i});
    }
    return result;
}

void append(TriangleSurface& to, const TriangleSurface& more)
{
    const int offset = int(to.points.size());
    to.points.insert(to.points.end(), more.points.begin(), more.points.end());
    for (const auto& [a, b, c] : more.triangles) to.triangles.push_back({a + offset, b + offset, c + offset});
}

std::array<Vector<3>, 2> crossSection(const Vector<3>& axis)
{
    const double ax = std::abs(axis.x), ay = std::abs(axis.y), az = std::abs(axis.z);
    const Vector<3> least = ax <= ay && ax <= az ? Vector<3>{1, 0, 0} : ay <= az ? Vector<3>{0, 1, 0} : Vector<3>{0, 0, 1};
    const auto e = cross(least, axis);
    const auto e1 = e / mag(e);
    return {e1, cross(axis, e1)};
}

std::array<Vector<3>, 8> corners(const Box& b)
{
    std::array<Vector<3>, 8> all;
    for (int i = 0; i < 8; ++i) all[i] = {i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y, i & 4 ? b.high.z : b.low.z};
    return all;
}

}
