#include "geometry/TriangleMesh.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace sph
{

std::unique_ptr<Shape> TriangleMesh::shifted(const Vector<3>& by) const { return std::make_unique<TriangleMesh>(body_, offset_ + by); }

ShapeDescription TriangleMesh::description() const
{
    return {"triSurface",
            {{"at", body_->points().front() + offset_}},
            {{"volume", body_->volume()}},
            true,
            enclosesFluid() ? FluidSide::inside : FluidSide::outside};
}

TriangleSurface TriangleMesh::region(int number) const
{
    TriangleSurface surface;
    for (const auto& p : body_->points()) surface.points.push_back(p + offset_);
    for (const auto& f : body_->facets())
        if (f.region == number) surface.triangles.push_back(f.points);
    return surface;
}

TriangleSurface TriangleMesh::triangles(const Box& within, double size) const
{
    TriangleSurface surface;
    const auto add = [&](auto& self, Vector<3> a, Vector<3> b, Vector<3> c) -> void
    {
        // Halved along the longest edge, where it crosses the box. Lengths are computed once: those of a second time may round otherwise.
        const std::array lengths{mag(b - a), mag(c - b), mag(a - c)};
        const auto longest = std::ranges::max_element(lengths);
        const bool isNear =
            std::ranges::all_of(coordinates,
                                [&](auto k) {
                                    return std::max({a.*k, b.*k, c.*k}) >= within.low.*k && std::min({a.*k, b.*k, c.*k}) <= within.high.*k;
                                });
        if (*longest > 2 * size && isNear)
        {
            for (auto edge = lengths.begin(); edge != longest; ++edge) std::tie(a, b, c) = std::tuple(b, c, a);
            const auto middle = 0.5 * (a + b);
            self(self, a, middle, c);
            self(self, middle, b, c);
            return;
        }
        const int first = int(surface.points.size());
        surface.points.insert(surface.points.end(), {a, b, c});
        surface.triangles.push_back({first, first + 1, first + 2});
    };
    for (const auto& f : body_->facets())
    {
        const auto p = [&](int k) -> const Vector<3>& { return body_->points()[std::size_t(f.points[std::size_t(k)])]; };
        add(add, p(0) + offset_, p(1) + offset_, p(2) + offset_);
    }
    return surface;
}

namespace
{

/// Facets of each connected part: those that share points.
std::vector<std::vector<int>> connectedParts(const FacetSurface& s)
{
    std::vector<int> root(s.points.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int p)
    {
        while (root[std::size_t(p)] != p) p = root[std::size_t(p)] = root[std::size_t(root[std::size_t(p)])];
        return p;
    };
    for (const auto& t : s.triangles)
        for (const int k : {1, 2}) root[std::size_t(find(t[std::size_t(k)]))] = find(t[0]);
    std::vector<int> number(s.points.size(), -1);
    std::vector<std::vector<int>> parts;
    for (int f = 0; f < int(s.triangles.size()); ++f)
    {
        int& n = number[std::size_t(find(s.triangles[std::size_t(f)][0]))];
        if (n < 0)
        {
            n = int(parts.size());
            parts.emplace_back();
        }
        parts[std::size_t(n)].push_back(f);
    }
    return parts;
}

}

std::vector<std::shared_ptr<const FacetBody>> bodiesOf(const FacetSurface& surface, const FacetScale& scale)
{
    auto parts = connectedParts(surface);
    if (parts.size() == 1) return {std::make_shared<FacetBody>(surface, parts[0], scale)};
    std::vector<std::shared_ptr<const FacetBody>> bodies;
    for (const auto& part : parts) bodies.push_back(std::make_shared<FacetBody>(surface, part, scale));
    // A part that encloses fluid and lies in the solid of another is a cavity of the smallest such.
    std::vector<std::vector<int>> cavities(parts.size());
    std::vector<char> isCavity(parts.size(), 0);
    for (std::size_t c = 0; c < parts.size(); ++c)
    {
        if (bodies[c]->volume() >= 0) continue;
        const auto& x = bodies[c]->points().front();
        int around = -1;
        for (std::size_t b = 0; b < parts.size(); ++b)
            if (bodies[b]->volume() > 0 && distanceTo(bodies[b]->bounds(), x) == 0 && bodies[b]->distance(x) < 0 &&
                (around < 0 || bodies[b]->volume() < bodies[std::size_t(around)]->volume()))
                around = int(b);
        if (around < 0) continue;
        isCavity[c] = 1;
        cavities[std::size_t(around)].push_back(int(c));
    }
    std::vector<std::shared_ptr<const FacetBody>> result;
    for (std::size_t b = 0; b < parts.size(); ++b)
    {
        if (isCavity[b]) continue;
        if (cavities[b].empty()) result.push_back(bodies[b]);
        else
        {
            for (const int c : cavities[b]) parts[b].insert(parts[b].end(), parts[std::size_t(c)].begin(), parts[std::size_t(c)].end());
            result.push_back(std::make_shared<FacetBody>(surface, parts[b], scale));
        }
    }
    return result;
}

}
