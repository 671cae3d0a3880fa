#include "geometry/Geometry.hpp"
#include "geometry/PatchGrid.hpp"
#include "geometry/PatchTree.hpp"
#include "geometry/TriangleMesh.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{

bool same(const ShapeDescription& a, const ShapeDescription& b, double tolerance)
{
    if (a.type != b.type || a.fluid != b.fluid) return false;
    const auto equal = [&](double p, double q) { return p == q || std::abs(p - q) <= tolerance; };
    for (std::size_t i = 0; i < a.scalars.size(); ++i)
        if (!equal(a.scalars[i].second, b.scalars[i].second)) return false;
    for (std::size_t i = 0; i < a.vectors.size(); ++i)
        for (const auto c : coordinates)
            if (!equal(a.vectors[i].second.*c, b.vectors[i].second.*c)) return false;
    return true;
}

/// Whether a shape that is longer than the domain and `reach` on both sides goes on through it, as what has been continued does (src/meshes, continuePeriodically): its surface repeats after a period. That of a bed of grains
/// which were united to one mesh does not, although it sticks out of both faces. Shapes of formulas, and what encloses the fluid, are taken to.
bool goesOnThrough(const Geometry& g, const Shape& shape, int direction, double reach)
{
    const auto* mesh = asMesh(shape);
    if (!mesh || shape.enclosesFluid()) return true;
    const auto c = component(direction);
    const double misfit = 0.01 * reach;
    Vector<3> period;
    period.*c = g.length(direction);
    const auto& body = mesh->body();
    const auto offset = -mesh->local({});
    for (const double plane : {g.low.*c - 0.5 * reach, g.low.*c + 0.5 * reach}) // beside the joints of what has been continued
        for (const auto& f : body.facets())
            for (std::size_t k = 0; k < 3; ++k)
            {
                const auto p = body.points()[std::size_t(f.points[k])] + offset,
                           q = body.points()[std::size_t(f.points[(k + 1) % 3])] + offset;
                if ((p.*c < plane) == (q.*c < plane)) continue;
                const auto on = p + (plane - p.*c) / (q.*c - p.*c) * (q - p);
                if (std::fabs(shape.foot(on + period).distance) > misfit) return false;
            }
    return true;
}

/// Numbers of periods by which a shape is shifted along one direction to come within reach of the domain.
std::array<int, 2> shifts(const Geometry& g, const Shape& shape, int direction, double reach)
{
    if (!g.periodic[direction] || shape.invariantAlong(direction)) return {0, 0};
    const auto c = component(direction);
    const auto b = shape.bounds();
    if (std::isinf(b.low.*c) || std::isinf(b.high.*c)) return {0, 0};
    if (b.low.*c <= g.low.*c - reach && b.high.*c >= g.high.*c + reach && goesOnThrough(g, shape, direction, reach)) return {0, 0};
    const double L = g.length(direction);
    return {int(std::ceil((g.low.*c - reach - b.high.*c) / L - 1e-9)), int(std::floor((g.high.*c + reach - b.low.*c) / L + 1e-9))};
}

/// Copies of two originals may coincide: spheres given on both sides of a periodic domain.
std::vector<Patch> withoutTwins(std::vector<Patch> patches, double tolerance)
{
    struct Key
    {
        double x;
        int patch;
        ShapeDescription description;
    };
    std::vector<Key> keys;
    for (int i = 0; i < int(patches.size()); ++i)
    {
        auto d = patches[i].shape->description();
        keys.push_back({d.vectors.front().second.x, i, std::move(d)});
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) { return a.x < b.x; });
    std::vector<bool> dropped(patches.size(), false);
    for (std::size_t i = 0; i < keys.size(); ++i)
        for (std::size_t k = i + 1; k < keys.size() && keys[k].x - keys[i].x <= tolerance; ++k)
            if (same(keys[i].description, keys[k].description, tolerance)) dropped[std::max(keys[i].patch, keys[k].patch)] = true;
    std::vector<Patch> kept;
    for (std::size_t i = 0; i < patches.size(); ++i)
        if (!dropped[i]) kept.push_back(std::move(patches[i]));
    return kept;
}

}

namespace
{

/// Facets of a mesh that lie in other solids as a whole.
std::vector<char> facetsInOthers(const Geometry& g, int patch)
{
    const auto& mesh = *g.patches[std::size_t(patch)].mesh;
    const auto& body = mesh.body();
    const auto offset = -mesh.local({});
    std::vector<char> covered, hidden;
    for (const auto& x : body.points()) covered.push_back(g.isCovered(patch, x + offset));
    for (const auto& f : body.facets())
        hidden.push_back(std::ranges::all_of(f.points, [&](int p) { return covered[std::size_t(p)]; }) &&
                         g.isCovered(patch, (body.points()[std::size_t(f.points[0])] + body.points()[std::size_t(f.points[1])] +
                                             body.points()[std::size_t(f.points[2])]) /
                                                    3 +
                                                offset));
    return hidden;
}

}

void repeatPeriodically(Geometry& g, double reach)
{
    const Box domain{g.low, g.high};
    Box flat = domain;
    if (g.dimension == 2)
    {
        flat.low.z = 0;
        flat.high.z = 0;
    }
    std::vector<Patch> copies;
    for (const auto& original : g.originals)
    {
        const auto x = shifts(g, *original.shape, 0, reach), y = shifts(g, *original.shape, 1, reach),
                   z = shifts(g, *original.shape, 2, reach);
        for (int l = z[0]; l <= z[1]; ++l)
            for (int k = y[0]; k <= y[1]; ++k)
                for (int i = x[0]; i <= x[1]; ++i)
                {
                    const bool moved = i != 0 || k != 0 || l != 0;
                    const Vector<3> by{i * g.length(0), k * g.length(1), l * g.length(2)};
                    auto shape = moved ? std::shared_ptr<const Shape>(original.shape->shifted(by)) : original.shape;
                    const bool isRepeated = g.periodic[0] || g.periodic[1] || g.periodic[2];
                    if (!isRepeated || shape->distanceTo(flat) <= reach)
                        copies.push_back({std::move(shape), original.wall, original.walls});
                }
    }
    const double size = std::max({g.length(0), g.length(1), g.dimension == 3 ? g.length(2) : 0.0});
    g.patches = withoutTwins(std::move(copies), 1e-9 * size);
    for (auto& patch : g.patches) patch.mesh = asMesh(*patch.shape);
    g.reach = reach;
    sinkIntoPlanes(g);
    g.grid = std::make_shared<PatchGrid>(g, reach);
    g.tree = std::make_shared<PatchTree>(g.patches);
    g.coverers = findCoverers(g);
    for (int p = 0; p < int(g.patches.size()); ++p)
    {
        auto& patch = g.patches[std::size_t(p)];
        if (!patch.mesh || !g.mayBeCovered(p)) continue;
        auto mesh = patch.mesh->withHidden(facetsInOthers(g, p));
        patch.mesh = mesh.get();
        patch.shape = std::move(mesh);
    }
}

}
