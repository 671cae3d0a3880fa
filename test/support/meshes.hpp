/// Closed surfaces of triangles, made by hand.
#pragma once
#include "FacetSurface.hpp"
#include <cmath>
#include <map>

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
    const double g = (1 + std::sqrt(5.0)) / 2;
    TriangleSurface m{{{-1, g, 0},
                       {1, g, 0},
                       {-1, -g, 0},
                       {1, -g, 0},
                       {0, -1, g},
                       {0, 1, g},
                       {0, -1, -g},
                       {0, 1, -g},
                       {g, 0, -1},
                       {g, 0, 1},
                       {-g, 0, -1},
                       {-g, 0, 1}},
                      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (int level = 0; level < n; ++level)
    {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b)
        {
            const auto [entry, isNew] = middles.try_emplace({std::min(a, b), std::max(a, b)}, int(m.points.size()));
            if (isNew) m.points.push_back(0.5 * (m.points[std::size_t(a)] + m.points[std::size_t(b)]));
            return entry->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : m.triangles)
        {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        m.triangles = finer;
    }
    for (auto& p : m.points) p = centre + radius / mag(p) * p;
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
