/// Closed surfaces of triangles, made by hand.
#pragma once
#include "FacetSurface.hpp"
#include <cmath>
#include <map>

namespace sph::test
{

inline FacetSurface ofOneRegion(FacetSurface s)
{
    s.regions = {"all"};
    s.region.assign(s.triangles.size(), 0);
    return s;
}

/// Triangles of an outline, counter-clockwise around its first point and star-shaped around it, drawn along z.
inline FacetSurface prism(const std::vector<Vector<3>>& outline, double from, double to)
{
    FacetSurface s;
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
    return ofOneRegion(s);
}

inline FacetSurface block(const Vector<3>& low, const Vector<3>& high)
{
    return prism({{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}}, low.z, high.z);
}

/// The fluid on the other side.
inline FacetSurface turned(FacetSurface s)
{
    for (auto& t : s.triangles) std::swap(t[1], t[2]);
    return s;
}

inline FacetSurface together(FacetSurface a, const FacetSurface& b)
{
    append(a, b);
    return ofOneRegion(a);
}

/// An icosahedron whose facets are quartered and moved out to the radius.
inline FacetSurface icosphere(double R, int halvings)
{
    FacetSurface s;
    const double t = 0.5 * (1 + std::sqrt(5));
    s.points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    s.triangles = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                   {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int k = 0; k < halvings; ++k)
    {
        std::map<std::pair<int, int>, int> middle;
        const auto between = [&](int a, int b)
        {
            const auto [at, isNew] = middle.try_emplace(std::minmax(a, b), int(s.points.size()));
            if (isNew) s.points.push_back(0.5 * (s.points[std::size_t(a)] + s.points[std::size_t(b)]));
            return at->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : s.triangles)
        {
            const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
            for (const auto& f : {std::array{a, ab, ca}, std::array{b, bc, ab}, std::array{c, ca, bc}, std::array{ab, bc, ca}})
                finer.push_back(f);
        }
        s.triangles = finer;
    }
    for (auto& p : s.points) p = R / mag(p) * p;
    return ofOneRegion(s);
}

}
