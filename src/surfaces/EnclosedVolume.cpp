#include "surfaces/EnclosedVolume.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace sph
{

namespace
{

/// A corner of a simplex in a cell's own coordinates (0 to 1), with the two functions that must both be positive.
struct Corner
{
    Vector<3> x;
    double colour, wall;
};

/// Point at which `colour` vanishes between two corners of opposite sign.
Corner crossing(const Corner& a, const Corner& b)
{
    const double t = a.colour / (a.colour - b.colour);
    return {a.x + t * (b.x - a.x), 0, a.wall + t * (b.wall - a.wall)};
}

double volume(const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
    return std::fabs(dot(cross(b.x - a.x, c.x - a.x), d.x - a.x)) / 6;
}

using Tetrahedron = std::array<Corner, 4>;

/// The volume of a tetrahedron where `colour` > 0, as a sum of `part` over tetrahedra.
template<class Part> double wherePositive(const Tetrahedron& t, const Part& part)
{
    std::array<Corner, 4> inside, outside;
    int in = 0, out = 0;
    for (const auto& corner : t) (corner.colour > 0 ? inside[in++] : outside[out++]) = corner;
    const auto cut = [&](int i, int o) { return crossing(inside[i], outside[o]); };
    switch (in)
    {
    case 0:
        return 0;
    case 1:
        return part({inside[0], cut(0, 0), cut(0, 1), cut(0, 2)});
    case 3:
        return part(t) - part({outside[0], cut(0, 0), cut(1, 0), cut(2, 0)});
    case 4:
        return part(t);
    }
    // A prism between the triangles at the two inside corners.
    const Corner a1 = cut(0, 0), a2 = cut(0, 1), b1 = cut(1, 0), b2 = cut(1, 1);
    return part({inside[0], a1, a2, b2}) + part({inside[0], a1, b1, b2}) + part({inside[0], inside[1], b1, b2});
}

double fluidVolume(const Tetrahedron& t)
{
    const auto whole = [](const Tetrahedron& s) { return volume(s[0], s[1], s[2], s[3]); };
    return wherePositive(t,
                         [&](Tetrahedron s)
                         {
                             for (auto& corner : s) corner.colour = corner.wall;
                             return wherePositive(s, whole);
                         });
}

/// The corners of a polygon's part where `value(corner)` > 0 (Sutherland and Hodgman).
std::vector<Corner> clippedPolygon(const std::vector<Corner>& polygon, const auto& value)
{
    std::vector<Corner> result;
    for (std::size_t c = 0; c < polygon.size(); ++c)
    {
        const auto &a = polygon[c], &b = polygon[(c + 1) % polygon.size()];
        const double va = value(a), vb = value(b);
        if (va > 0) result.push_back(a);
        if ((va > 0) != (vb > 0))
        {
            const double t = va / (va - vb);
            result.push_back({a.x + t * (b.x - a.x), a.colour + t * (b.colour - a.colour), a.wall + t * (b.wall - a.wall)});
        }
    }
    return result;
}

double fluidArea(const Corner& a, const Corner& b, const Corner& c)
{
    const auto inPhase = clippedPolygon({a, b, c}, [](const Corner& p) { return p.colour; });
    const auto polygon = clippedPolygon(inPhase, [](const Corner& p) { return p.wall; });
    double twice = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k) twice += cross(polygon[k - 1].x - polygon[0].x, polygon[k].x - polygon[0].x).z;
    return std::fabs(twice) / 2;
}

/// The part of the cell whose lowest node is (i, j, k) that is in the region, in cells.
class Cells
{
    const RegularGrid& grid_;
    const std::vector<double>& colour_;
    const std::vector<double>& wall_;
    double iso_, noWall_;

    Corner corner(int i, int j, int k, int a, int b, int c) const
    {
        const auto node = grid_.index(i + a, j + b, k + c);
        return {{double(a), double(b), double(c)}, colour_[node] - iso_, wall_.empty() ? noWall_ : wall_[node]};
    }

public:
    Cells(const RegularGrid& grid, const std::vector<double>& colour, double iso, const std::vector<double>& wall)
        : grid_(grid), colour_(colour), wall_(wall), iso_(iso), noWall_(grid.largestStep())
    {}

    bool inRegion(std::size_t node) const { return colour_[node] > iso_ && (wall_.empty() || wall_[node] > 0); }

    double part(int i, int j, int k) const
    {
        const int deep = grid_.dimension == 3 ? 1 : 0;
        std::array<Corner, 8> at;
        int corners = 0, inside = 0;
        bool anyColour = false, anyWall = false;
        for (int c = 0; c <= deep; ++c)
            for (int b = 0; b <= 1; ++b)
                for (int a = 0; a <= 1; ++a)
                {
                    const auto& p = at[corners++] = corner(i, j, k, a, b, c);
                    inside += p.colour > 0 && p.wall > 0;
                    anyColour = anyColour || p.colour > 0;
                    anyWall = anyWall || p.wall > 0;
                }
        if (!anyColour || !anyWall) return 0;
        if (inside == corners) return 1;
        if (!deep) return fluidArea(at[0], at[1], at[3]) + fluidArea(at[0], at[3], at[2]);
        // Kuhn's division: the paths from corner 0 to corner 7 along the edges.
        constexpr int paths[6][2] = {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}};
        double sum = 0;
        for (const auto& [first, second] : paths) sum += fluidVolume({at[0], at[first], at[second], at[7]});
        return sum;
    }
};

class Sets
{
    std::vector<std::uint32_t> parent_;

public:
    explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    std::uint32_t root(std::uint32_t a)
    {
        while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
        return a;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }
};

int pieces(const RegularGrid& grid, const Cells& cells)
{
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(grid.size(), none);
    std::uint32_t count = 0;
    for (std::size_t node = 0; node < grid.size(); ++node)
        if (cells.inRegion(node)) number[node] = count++;

    Sets sets(count);
    const auto& n = grid.nodes;
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
            {
                const auto here = number[grid.index(i, j, k)];
                if (here == none) continue;
                const auto joinWith = [&](int a, int b, int c)
                {
                    if (const auto there = number[grid.index(a, b, c)]; there != none) sets.join(here, there);
                };
                if (i > 0) joinWith(i - 1, j, k);
                if (j > 0) joinWith(i, j - 1, k);
                if (k > 0) joinWith(i, j, k - 1);
                if (i == n[0] - 1 && grid.periodic[0]) joinWith(0, j, k);
                if (j == n[1] - 1 && grid.periodic[1]) joinWith(i, 0, k);
                if (k == n[2] - 1 && grid.periodic[2]) joinWith(i, j, 0);
            }
    int result = 0;
    for (std::uint32_t c = 0; c < count; ++c) result += sets.root(c) == c;
    return result;
}

}

Enclosed enclosedVolume(const RegularGrid& grid, const std::vector<double>& colour, double iso, const std::vector<double>& wallDistance)
{
    const Cells cells(grid, colour, iso, wallDistance);
    const int columns = grid.nodes[1] - 1, layers = grid.dimension == 3 ? grid.nodes[2] - 1 : 1;
    std::vector<double> rowSum(std::size_t(columns) * layers);
#pragma omp parallel for schedule(dynamic, 16)
    for (std::size_t row = 0; row < rowSum.size(); ++row)
        for (int i = 0; i + 1 < grid.nodes[0]; ++i) rowSum[row] += cells.part(i, row % columns, row / columns);
    return {std::accumulate(rowSum.begin(), rowSum.end(), 0.0) * grid.cellVolume(), pieces(grid, cells)};
}

double levelEnclosing(double volume, const std::function<double(double level)>& enclosed)
{
    double low = 0.01, high = 0.99;
    while (high - low > 1e-4)
    {
        const double level = 0.5 * (low + high);
        (enclosed(level) > volume ? low : high) = level;
    }
    return 0.5 * (low + high);
}

}
