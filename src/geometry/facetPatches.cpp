/// A body made of triangles: the facet across each edge, smooth and sharp edges, patches, and the normals of the corners.
#include "geometry/FacetBody.hpp"
#include "geometry/facetAngles.hpp"
#include <algorithm>
#include <cmath>
#include <ranges>
#include <unordered_map>

namespace sph
{

namespace
{

/// A patch whose facets all turn by less is one plane.
constexpr double onePlane = 0.5 * degree;
/// Small facets that turn by more than this against one another make an edge.
constexpr double sharpAngle = 30 * degree;
/// Facets wider than this many spacings stand for themselves.
constexpr double widestSmooth = 3;
/// Limit in hollows as tight as the support: only facets below a spacing stand for the curve; wider ones, by themselves, fill the space behind its centre.
constexpr double widestInHollow = 1;

/// Facets within so many spacings know together how deep they have no rivals.
constexpr double grainSize = 0.4;

double angleBetween(const Vector<3>& a, const Vector<3>& b) { return std::atan2(mag(cross(a, b)), dot(a, b)); }

}

FacetBody::FacetBody(const FacetSurface& surface, std::span<const int> chosen, const FacetScale& scale) : scale_(scale)
{
    std::unordered_map<int, int> pointOf;
    std::vector<std::array<int, 3>> triangles;
    for (const int f : chosen)
    {
        std::array<int, 3> t{};
        for (int k = 0; k < 3; ++k)
        {
            const int p = surface.triangles[std::size_t(f)][std::size_t(k)];
            const auto [at, isNew] = pointOf.try_emplace(p, int(points_.size()));
            if (isNew) points_.push_back(surface.points[std::size_t(p)]);
            t[std::size_t(k)] = at->second;
        }
        triangles.push_back(t);
    }
    tree_ = FacetTree(points_, triangles);
    renumberPoints(triangles);
    for (const int t : tree_.order())
    {
        Facet f{};
        f.points = triangles[std::size_t(t)];
        f.region = surface.region[std::size_t(chosen[std::size_t(t)])];
        const auto &a = corner(f, 0), &b = corner(f, 1), &c = corner(f, 2);
        f.normal = unitVector(cross(b - a, c - a));
        f.middle = (a + b + c) / 3;
        f.radius = std::max({mag(a - f.middle), mag(b - f.middle), mag(c - f.middle)});
        volume_ += dot(a, cross(b, c)) / 6;
        facets_.push_back(f);
    }
    join();
    classify();
    numberPatches();
    averageNormals();
    std::vector<Vector<3>> normals;
    std::vector<int> patch;
    std::vector<char> creased;
    for (const auto& f : facets_)
    {
        normals.push_back(f.normal);
        patch.push_back(f.patch);
        creased.push_back(f.isCreased());
    }
    tree_.annotate(normals, patch, creased, mostTurned_);
    clearance_ = DistanceGrid(bounds(), scale_.spacing);
    sunk_ = 1 - std::cos(mostTurned_);

    for (auto& f : facets_) f.grain = -1;
    for (int n = 0; n < int(tree_.nodes().size()); ++n) // parents come first
    {
        const auto& node = tree_.nodes()[std::size_t(n)];
        if (facets_[std::size_t(node.first)].grain < 0 && (node.isLeaf() || mag(node.box.high - node.box.low) < grainSize * scale_.spacing))
            for (int t = node.first; t < node.last; ++t) facets_[std::size_t(t)].grain = n;
    }
    safeLayers_ = std::vector<std::atomic<unsigned char>>(tree_.nodes().size());
}

/// Numbers the points as the facets follow one another, so that those near in space lie near in memory, too.
void FacetBody::renumberPoints(std::vector<std::array<int, 3>>& triangles)
{
    std::vector<int> numberOf(points_.size(), -1);
    std::vector<Vector<3>> points;
    points.reserve(points_.size());
    for (const int t : tree_.order())
        for (int& p : triangles[std::size_t(t)])
        {
            int& number = numberOf[std::size_t(p)];
            if (number < 0)
            {
                number = int(points.size());
                points.push_back(points_[std::size_t(p)]);
            }
            p = number;
        }
    points_.swap(points);
}

/// Finds the facet across each edge.
void FacetBody::join()
{
    std::unordered_map<std::uint64_t, std::pair<int, int>> open;
    const auto key = [](int a, int b) { return std::uint64_t(unsigned(a)) << 32 | unsigned(b); };
    for (int t = 0; t < int(facets_.size()); ++t)
        for (int k = 0; k < 3; ++k)
        {
            auto& f = facets_[std::size_t(t)];
            const int from = f.points[std::size_t((k + 1) % 3)], to = f.points[std::size_t((k + 2) % 3)];
            f.across[std::size_t(k)] = t;
            if (const auto other = open.find(key(to, from)); other != open.end())
            {
                const auto [u, l] = other->second;
                f.across[std::size_t(k)] = u;
                facets_[std::size_t(u)].across[std::size_t(l)] = t;
                open.erase(other);
            }
            else open.emplace(key(from, to), std::pair{t, k});
        }
}

void FacetBody::classify()
{
    pointNormals_.assign(points_.size(), {});
    const auto altitude = [&](const Facet& f, int k)
    {
        const auto along = corner(f, (k + 2) % 3) - corner(f, (k + 1) % 3);
        return mag(cross(along, corner(f, k) - corner(f, (k + 1) % 3))) / mag(along);
    };
    for (auto& f : facets_)
        for (int k = 0; k < 3; ++k)
        {
            const auto &p = corner(f, k), &q = corner(f, (k + 1) % 3), &r = corner(f, (k + 2) % 3);
            pointNormals_[std::size_t(f.points[std::size_t(k)])] += angleBetween(q - p, r - p) * f.normal;

            const Facet& g = facets_[std::size_t(f.across[std::size_t(k)])];
            const auto isOfBoth = [&](int point) { return std::ranges::find(f.points, point) != f.points.end(); };
            const int opposite = std::min(int(std::ranges::find_if_not(g.points, isOfBoth) - g.points.begin()), 2);
            const double turn = angleBetween(f.normal, g.normal);
            const bool convex = dot(f.normal, corner(g, opposite) - q) < 0;
            auto& kind = f.edges[std::size_t(k)];
            kind = EdgeKind::flat;
            if (turn < flatAngle) continue;
            const double first = altitude(f, k), second = altitude(g, opposite), curvature = 3 * turn / (first + second);
            const bool tight = !convex && curvature * scale_.support > 1;
            const bool smooth = turn < sharpAngle && std::max(first, second) < (tight ? widestInHollow : widestSmooth) * scale_.spacing;
            kind = smooth ? EdgeKind::smooth : convex ? EdgeKind::convex : EdgeKind::concave;
            if (smooth) smallestRadius_ = std::min(smallestRadius_, 1 / curvature);
        }
    for (auto& n : pointNormals_) n = mag(n) > 0 ? unitVector(n) : n;
}

/// Facets joined by flat and smooth edges.
void FacetBody::numberPatches()
{
    for (auto& f : facets_) f.patch = -1;
    std::vector<int> waiting;
    for (int seed = 0; seed < int(facets_.size()); ++seed)
    {
        if (facets_[std::size_t(seed)].patch >= 0) continue;
        waiting.assign(1, seed);
        facets_[std::size_t(seed)].patch = patches_;
        while (!waiting.empty())
        {
            const Facet& f = facets_[std::size_t(waiting.back())];
            waiting.pop_back();
            for (int k = 0; k < 3; ++k)
                if (Facet& g = facets_[std::size_t(f.across[std::size_t(k)])]; f.edges[std::size_t(k)] <= EdgeKind::smooth && g.patch < 0)
                {
                    g.patch = patches_;
                    waiting.push_back(f.across[std::size_t(k)]);
                }
        }
        ++patches_;
    }
    // An edge with the same patch on both sides is no edge of the patch: hollows about as tight as the limit.
    for (auto& f : facets_)
        for (std::size_t k = 0; k < 3; ++k)
            if (const auto& g = facets_[std::size_t(f.across[k])];
                f.edges[k] > EdgeKind::smooth && g.patch == f.patch && angleBetween(f.normal, g.normal) < sharpAngle)
                f.edges[k] = EdgeKind::smooth;
}

/// The normals N_k of the corners: of those facets around each that flat and smooth edges join, weighted with their angles, and as long as a mean plane's
/// distance of 1 wants. Where they do not close around the corner, the way out of the patch there.
void FacetBody::averageNormals()
{
    for (auto& f : facets_) f.cornerNormals.fill(-1);
    std::vector<std::pair<int, int>> fan; // facet, corner
    for (int seed = 0; seed < int(facets_.size()); ++seed)
        for (int k = 0; k < 3; ++k)
        {
            if (facets_[std::size_t(seed)].cornerNormals[std::size_t(k)] >= 0) continue;
            const int point = facets_[std::size_t(seed)].points[std::size_t(k)], index = int(cornerNormals_.size());
            fan.clear();
            const auto add = [&](int t, int at)
            {
                facets_[std::size_t(t)].cornerNormals[std::size_t(at)] = index;
                fan.emplace_back(t, at);
            };
            add(seed, k);
            std::vector<Vector<3>> border; // the edges where it ends, in the direction of their facets
            for (const int turn : {1, 2})
                for (int t = seed, at = k;;)
                {
                    const std::size_t side = std::size_t((at + turn) % 3);
                    if (const auto& f = facets_[std::size_t(t)]; f.edges[side] > EdgeKind::smooth)
                    {
                        border.push_back(corner(f, int(side + 2) % 3) - corner(f, int(side + 1) % 3));
                        break;
                    }
                    t = facets_[std::size_t(t)].across[side];
                    at = facets_[std::size_t(t)].cornerAt(point);
                    if (at == 3 || facets_[std::size_t(t)].cornerNormals[std::size_t(at)] >= 0) break;
                    add(t, at);
                }
            Vector<3> sum;
            double angles = 0;
            const auto angle = [&](const std::pair<int, int>& c)
            {
                const auto& f = facets_[std::size_t(c.first)];
                const auto& p = corner(f, c.second);
                return angleBetween(corner(f, (c.second + 1) % 3) - p, corner(f, (c.second + 2) % 3) - p);
            };
            for (const auto& c : fan)
            {
                sum += angle(c) * facets_[std::size_t(c.first)].normal;
                angles += angle(c);
            }
            auto n = mag(sum) > 0 ? sum / mag(sum) : facets_[std::size_t(seed)].normal;
            double height = 0;
            for (const auto& c : fan) height += angle(c) / angles * dot(n, facets_[std::size_t(c.first)].normal);
            for (const auto& c : fan) mostTurned_ = std::max(mostTurned_, angleBetween(n, facets_[std::size_t(c.first)].normal));
            cornerNormals_.push_back(n / std::max(height, 0.5));

            // The outward direction reaches as far beyond either edge as beyond the other.
            Vector<3> way;
            for (const auto& edge : border) way += unitVector(cross(edge, n));
            const auto out = mag(way) > 0.1 ? unitVector(way) : border.empty() ? n : unitVector(cross(border[0], n));
            outward_.push_back(out / (border.empty() ? 1 : std::max(dot(out, unitVector(cross(border[0], n))), 0.3)));
        }
    flatPatch_.assign(std::size_t(patches_), 1);
    std::vector<const Facet*> first(std::size_t(patches_), nullptr);
    for (auto& f : facets_)
    {
        const auto normals = f.cornerNormals | std::views::transform([&](int c) { return cornerNormals_[std::size_t(c)]; });
        f.planar = std::ranges::all_of(normals, [&](const auto& N) { return mag(N - f.normal) < flatAngle; });
        f.lean = 0;
        if (!f.planar)
            for (const auto& N : normals) f.lean = std::max(f.lean, mag(cross(N, f.normal)) / std::max(dot(N, f.normal), 0.1));
        const Facet*& one = first[std::size_t(f.patch)];
        if (!one) one = &f;
        if (!f.planar || angleBetween(f.normal, one->normal) > onePlane) flatPatch_[std::size_t(f.patch)] = 0;
    }
}

}
