#include "sampling/WallTriangles.hpp"
#include "geometry/wallSurfaces.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace sph
{

namespace
{

/// Value of sum_j V_j W_j above which a point of a wall lies in the fluid, whatever the shape of the wall: of a plane it is 1/2, of a convex edge more.
constexpr double surelyFilled = 0.3;

/// Least gap between two solids, in spacings: a narrower one counts as contact. Triangles of a curved wall lie less than that below it.
constexpr double narrowestGap = 0.1;

/// Bisects longest edges until none is longer than `size` [m].
void refine(TriangleSurface& s, double size)
{
    std::map<std::array<int, 2>, int> middles;
    for (std::size_t f = 0; f < s.triangles.size();)
    {
        const auto t = s.triangles[f];
        const auto length = [&](std::size_t k) { return mag(s.points[std::size_t(t[(k + 1) % 3])] - s.points[std::size_t(t[k])]); };
        std::size_t longest = 0;
        for (const std::size_t k : {1u, 2u})
            if (length(k) > length(longest)) longest = k;
        if (length(longest) <= size)
        {
            ++f;
            continue;
        }
        const int a = t[longest], b = t[(longest + 1) % 3], c = t[(longest + 2) % 3];
        const auto [middle, isNew] = middles.try_emplace({std::min(a, b), std::max(a, b)}, int(s.points.size()));
        if (isNew) s.points.push_back(0.5 * (s.points[std::size_t(a)] + s.points[std::size_t(b)]));
        s.triangles[f] = {a, middle->second, c};
        s.triangles.push_back({middle->second, b, c});
    }
}

}

WallTriangles::WallTriangles(const ParticleView& view, const Box& region)
    : region_(region), spacing_(view.spacing), flat_(view.dimension == 2), fluidPart_(view)
{
    triangulate(*view.geometry);
}

void WallTriangles::follow(const Geometry& geometry)
{
    if (!std::ranges::equal(shapes_, geometry.patches, {}, {}, &Patch::shape)) triangulate(geometry);
}

double WallTriangles::filled(Wall& wall, std::size_t point, double coverage, const Geometry& geometry) const
{
    if (coverage >= surelyFilled) return 1;
    auto& part = wall.fluidParts[point];
    if (std::isnan(part)) part = fluidPart_(inScene(wall.surface.points[point]), geometry);
    return coverage / std::max(part, coverage);
}

Vector<3> WallTriangles::doubledNormal(const TriangleSurface& s, std::size_t f)
{
    const auto& [a, b, c] = s.triangles[f];
    const auto& p = s.points[std::size_t(a)];
    return cross(s.points[std::size_t(b)] - p, s.points[std::size_t(c)] - p);
}

void WallTriangles::triangulate(const Geometry& geometry)
{
    shapes_.clear();
    for (const auto& patch : geometry.patches) shapes_.push_back(patch.shape);
    auto within = region_;
    if (flat_)
    {
        within.low.z = -0.5 * size();
        within.high.z = 0.5 * size();
    }
    walls_.clear();
    for (const auto& surface : wallSurfaces(geometry, 0, size()))
    {
        Wall wall{cropped(surface, within), {}, {}};
        auto& s = wall.surface;
        refine(s, size());
        wall.fluidParts.assign(s.points.size(), std::numeric_limits<double>::quiet_NaN());
        wall.areas.assign(s.triangles.size(), 0);
#pragma omp parallel for schedule(dynamic, 64)
        for (std::size_t f = 0; f < s.triangles.size(); ++f)
        {
            const auto& [a, b, c] = s.triangles[f];
            const auto &p = s.points[std::size_t(a)], &q = s.points[std::size_t(b)], &r = s.points[std::size_t(c)];
            const auto n = doubledNormal(s, f);
            const double area = 0.5 * mag(n) / (flat_ ? size() : 1);
            // The place before the middle of the triangle is fluid, but where another solid stands or leaves no gap.
            if (area > 0 && geometry.inFluid(inScene((p + q + r) / 3 + narrowestGap * spacing_ * unitVector(n)))) wall.areas[f] = area;
        }
        walls_.push_back(std::move(wall));
    }
}

}
