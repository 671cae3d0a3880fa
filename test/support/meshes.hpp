/// Closed surfaces of triangles, made by hand.
#pragma once
#include "geometry/FacetSurface.hpp"
#include "geometry/geodesicSphere.hpp"

namespace sph::test
{

inline FacetSurface ofOneRegion(TriangleSurface surface)
{
    FacetSurface s{std::move(surface), {}, {}};
    s.regions = {"all"};
    s.region.assign(s.triangles.size(), 0);
    return s;
}

/// Triangles of an outline, counter-clockwise around its first point and star-shaped around it, drawn along z.
inline TriangleSurface prism(const std::vector<Vector<3>>& outline, double from, double to)
{
    TriangleSurface s;
    const int n = int(outline.size());
    for (const double z : {from, to})
        for (const auto& p : outline) s.points.push_back({p.x, p.y, z});
    for (int k = 1; k + 1 < n; ++k)
    {
        s.triangles.push_back({0, k + 1, k});
        s.triangles.push_back({n, n + k, n + k + 1});
    }
    for (int k = 0; k < n; ++k)
    {
        const int next = (k + 1) % n;
        s.triangles.push_back({k, next, n + next});
        s.triangles.push_back({k, n + next, n + k});
    }
    return s;
}

inline TriangleSurface block(const Vector<3>& low, const Vector<3>& high)
{
    return prism({{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}}, low.z, high.z);
}

/// 20 4^n facets on a sphere, normals outwards.
inline TriangleSurface icosphere(int n, double radius = 1, const Vector<3>& centre = {})
{
    auto m = geodesicSphere(1 << n);
    for (auto& p : m.points) p = centre + radius * p;
    return m;
}

inline TriangleSurface together(TriangleSurface a, const TriangleSurface& b)
{
    append(a, b);
    return a;
}

inline TriangleSurface inverted(TriangleSurface m)
{
    for (auto& t : m.triangles) std::swap(t[1], t[2]);
    return m;
}

}
