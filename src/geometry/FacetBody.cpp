#include "FacetBody.hpp"
#include "components.hpp"
#include "facetAngles.hpp"
#include <algorithm>
#include <numbers>
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
/// In hollows as tight as the support only facets below a spacing stand for the curve: others, for themselves, fill what lies behind its centre.
constexpr double widestInHollow = 1;

/// Facets within so many spacings know together how deep they have no rivals.
constexpr double grainSize = 0.4;
/// Largest distance of a particle over a hollow's radius for which its image has the volume factor of eq. (18).
constexpr double mostCurved = 0.6;

/// Of the coordinates of a facet: what lies over the joint of two lies over both.
constexpr double onJoint = 1e-10;

/// Whether what lies `way` from the middle of a facet may lie in its prism.
bool mayLieOver(const FacetBody::Facet& f, const Vector<3>& way)
{
    const double height = dot(f.normal, way), aside2 = dot(way, way) - height * height, widest = f.radius + std::abs(height) * f.lean;
    return aside2 < 1.001 * widest * widest;
}

double angleBetween(const Vector<3>& a, const Vector<3>& b) { return std::atan2(mag(cross(a, b)), dot(a, b)); }

int cornerAt(const FacetBody::Facet& f, int point) { return int(std::ranges::find(f.points, point) - f.points.begin()); }

/// Whether what a strip has been asked for lies in it.
bool holds(const auto& strip) { return strip.s >= -onJoint && strip.s <= 1 + onJoint && strip.a > 0; }

/// The volume factor has no curvature beyond which an image would stand for any volume.
double boundedCurvature(double k, double distance, double spacing) { return std::min(k, mostCurved / std::max(distance, 1e-9 * spacing)); }

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

/// As the facets follow one another, so that what is near lies near in memory, too.
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

/// Who is across each edge.
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
    // What a patch surrounds is no edge of it: hollows about as tight as the limit.
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
                    at = cornerAt(facets_[std::size_t(t)], point);
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

            // As far beyond either edge as beyond the other.
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

Foot FacetBody::foot(const Vector<3>& x, double within) const
{
    int facet;
    return foot(x, within, facet);
}

Foot FacetBody::foot(const Vector<3>& x, double within, int& facet) const
{
    const auto on = [&](int t)
    {
        const auto& f = facets_[std::size_t(t)];
        return nearestOnTriangle(x, corner(f, 0), corner(f, 1), corner(f, 2));
    };
    const auto [distance, t] = tree_.nearest(
        x, within, 0, [&](int k) { return mag(x - on(k).point); }, [](const auto&, double) { return false; });
    facet = t;
    Foot result;
    if (t < 0)
    {
        result.distance = std::isnan(x.x + x.y + x.z) ? std::numeric_limits<double>::quiet_NaN() : Box::infinity;
        return result;
    }
    const auto& f = facets_[std::size_t(t)];
    const auto [point, part] = on(t);
    result.region = f.region;
    auto normal = f.normal;
    auto kind = EdgeKind::flat;
    if (part >= TrianglePart::corner0)
    {
        const auto k = std::size_t(part) - std::size_t(TrianglePart::corner0);
        normal = pointNormals_[std::size_t(f.points[k])];
        for (const std::size_t side : {(k + 1) % 3, (k + 2) % 3}) kind = std::max(kind, f.edges[side]);
        result.on = Foot::On::vertex;
    }
    else if (part != TrianglePart::face)
    {
        const auto k = std::size_t(part) - std::size_t(TrianglePart::edge0);
        normal = unitVector(f.normal + facets_[std::size_t(f.across[k])].normal);
        kind = f.edges[k];
        result.on = Foot::On::edge;
    }
    result.smooth = kind <= EdgeKind::smooth;
    if (result.smooth) result.on = Foot::On::face;
    const double sign = dot(x - point, normal) < 0 ? -1 : 1;
    result.distance = sign * distance;
    result.normal = distance > 1e-9 * scale_.spacing ? (sign / distance) * (x - point) : normal;
    if (const auto over = result.smooth ? prism(t, x) : std::nullopt)
    {
        result.k1 = over->foot.k1;
        result.k2 = over->foot.k2;
    }
    return result;
}

bool FacetBody::isBeyond(const Vector<3>& x, double least) const
{
    if (volume_ > 0 && distanceTo(bounds(), x) > least) return true;
    return clearance_.atLeast(x, [&](const Vector<3>& middle) { return distance(middle); }) > least;
}

std::optional<FacetBody::Prism> FacetBody::prism(int facet, const Vector<3>& x) const
{
    const auto& f = facets_[std::size_t(facet)];
    if (f.planar) { return plane(facet, x); }
    const auto N = [&](std::size_t k) -> const Vector<3>& { return cornerNormals_[std::size_t(f.cornerNormals[k])]; };
    const auto &P0 = corner(f, 0), N0 = N(0);
    const auto e1 = corner(f, 1) - P0, e2 = corner(f, 2) - P0, m1 = N(1) - N0, m2 = N(2) - N0, w = x - P0;
    const auto c0 = cross(e1, e2), c1 = cross(e1, m2) + cross(m1, e2), c2 = cross(m1, m2);
    // The plane through the corners moved by d along their normals goes through x: (w - d N0).(c0 + d c1 + d^2 c2) = 0.
    double d = dot(w, c0) / dot(N0, c0);
    for (int turn = 0; turn < 8; ++turn)
    {
        const auto C = c0 + d * c1 + d * d * c2, v = w - d * N0;
        const double slope = -dot(N0, C) + dot(v, c1 + 2 * d * c2), step = dot(v, C) / slope;
        if (!std::isfinite(step)) return {};
        d -= step;
        if (std::abs(step) < 1e-13 * (std::abs(d) + scale_.spacing)) break;
    }
    const auto C = c0 + d * c1 + d * d * c2, v = w - d * N0;
    if (!(dot(C, c0) > 0)) return {};
    const double l1 = dot(cross(v, e2 + d * m2), C) / dot(C, C), l2 = dot(cross(e1 + d * m1, v), C) / dot(C, C);
    Prism p;
    p.l = {1 - l1 - l2, l1, l2};
    p.inside = std::ranges::all_of(p.l, [](double l) { return l >= -onJoint; });
    const auto normal = N0 + l1 * m1 + l2 * m2;
    const double length = mag(normal);
    p.foot.distance = d * length;
    p.foot.region = f.region;
    p.foot.normal = normal / length;
    // J(d)/J(0) = 1 - (k1 + k2) d + k1 k2 d^2
    const double J0 = dot(c0, normal), sum = -dot(c1, normal) / J0 / length, product = dot(c2, normal) / J0 / (length * length);
    const double root = std::sqrt(std::max(0.0, 0.25 * sum * sum - product));
    p.foot.k1 = boundedCurvature(0.5 * sum + root, p.foot.distance, scale_.spacing);
    p.foot.k2 = boundedCurvature(0.5 * sum - root, p.foot.distance, scale_.spacing);
    return p;
}

FacetBody::Prism FacetBody::plane(int facet, const Vector<3>& x) const
{
    const auto& f = facets_[std::size_t(facet)];
    const auto& P0 = corner(f, 0);
    const auto e1 = corner(f, 1) - P0, e2 = corner(f, 2) - P0, v = x - P0, C = cross(e1, e2);
    Prism p;
    const double l1 = dot(cross(v, e2), C) / dot(C, C), l2 = dot(cross(e1, v), C) / dot(C, C);
    p.l = {1 - l1 - l2, l1, l2};
    p.inside = std::ranges::all_of(p.l, [](double l) { return l >= -onJoint; });
    p.foot.distance = dot(f.normal, v);
    p.foot.normal = f.normal;
    p.foot.region = f.region;
    return p;
}

std::optional<FacetBody::Strip> FacetBody::strip(int facet, int edge, const Vector<3>& x) const
{
    const auto& f = facets_[std::size_t(facet)];
    const int start = (edge + 1) % 3, end = (edge + 2) % 3;
    const auto N = [&](int k) -> const Vector<3>& { return cornerNormals_[std::size_t(f.cornerNormals[std::size_t(k)])]; };
    const auto out = [&](int k) -> const Vector<3>& { return outward_[std::size_t(f.cornerNormals[std::size_t(k)])]; };
    const auto e = corner(f, end) - corner(f, start), turn = N(end) - N(start), spread = out(end) - out(start), w = x - corner(f, start);
    // x lies in the plane of b and N at s: (w - s e).(b x N) = 0.
    double s = dot(w, e) / dot(e, e);
    for (int k = 0; k < 8; ++k)
    {
        const auto b = out(start) + s * spread, n = N(start) + s * turn, C = cross(b, n), v = w - s * e;
        const double step = dot(v, C) / (dot(v, cross(spread, n) + cross(b, turn)) - dot(e, C));
        if (!std::isfinite(step)) return {};
        s -= step;
        if (std::abs(step) < 1e-13 * (1 + std::abs(s))) break;
    }
    const auto b = out(start) + s * spread, n = N(start) + s * turn, C = cross(b, n), v = w - s * e;
    const double d = dot(cross(b, v), C) / dot(C, C), a = dot(cross(v, n), C) / dot(C, C), length = mag(n);
    // J(d)/J(0) = 1 - k d, J = (e + a b' + d N').(b x N)
    const double J0 = dot(e + a * spread, C), J = J0 + d * dot(turn, C);
    if (!(J0 * J > 0)) return {};
    Strip strip{{}, s, a};
    strip.foot.distance = d * length;
    strip.foot.normal = n / length;
    strip.foot.region = f.region;
    strip.foot.k1 = boundedCurvature(-dot(turn, C) / J0 / length, strip.foot.distance, scale_.spacing);
    return strip;
}

void FacetBody::goAlongBorder(int& facet, int& edge, int turn) const
{
    const int point = facets_[std::size_t(facet)].points[std::size_t((edge + turn) % 3)], facetBefore = facet;
    int at = (edge + turn) % 3;
    do {
        const auto& f = facets_[std::size_t(facet)];
        edge = (at + turn) % 3;
        if (f.edges[std::size_t(edge)] > EdgeKind::smooth) return;
        facet = f.across[std::size_t(edge)];
        at = cornerAt(facets_[std::size_t(facet)], point);
    } while (facet != facetBefore && at < 3);
}

/// Over the facet, or beyond an edge of its patch's border, and the image not far beyond where that of the face across begins.
FacetBody::Place FacetBody::placeOf(int facet, const Vector<3>& x, Hidden hidden) const
{
    const auto& f = facets_[std::size_t(facet)];
    if (mayLieOver(f, x - f.middle))
        if (const auto p = prism(facet, x); p && p->inside) return {facet, Lies::over, p->foot};
    if (!f.isCreased()) return {facet};
    const auto ownsMore = [&](const Foot& foot, auto isBeyond)
    {
        const auto y = mirrorImage(x, foot);
        const double own = claim(facet, y).t;
        for (std::size_t k = 0; k < 3; ++k)
            if (isBeyond(k) && !isHidden(hidden, f.across[k]) && claim(f.across[k], y).t < own - scale_.spacing) return false;
        return true;
    };
    if (flatPatch_[std::size_t(f.patch)])
    {
        const auto p = plane(facet, x);
        for (std::size_t k = 0; k < 3; ++k)
            if (p.l[k] < 0 && f.edges[k] <= EdgeKind::smooth) return {facet};
        if (ownsMore(p.foot, [&](std::size_t k) { return p.l[k] < 0; })) return {facet, Lies::beside, p.foot};
        return {facet};
    }
    for (int edge = 0; edge < 3; ++edge)
        if (f.edges[std::size_t(edge)] > EdgeKind::smooth)
            if (const auto p = strip(facet, edge, x); p && holds(*p))
                if (ownsMore(p->foot, [&](std::size_t k) { return int(k) == edge; })) return {facet, Lies::beside, p->foot};
    return {facet};
}

void FacetBody::findMirrors(const Vector<3>& x, double reach, double behind, Hidden hidden, std::vector<Place>& found) const
{
    const double below = behind + reach * sunk_;
    tree_.visit(
        [&](const FacetTree::Node& node)
        {
            if (distanceTo(node.box, x) > reach) return false;
            return node.creased || node.mayHaveNormalThrough(x, behind);
        },
        [&](int t)
        {
            const auto& f = facets_[std::size_t(t)];
            const auto way = x - f.middle;
            const double depth = dot(f.normal, way), near = reach + f.radius;
            if (depth < -below || depth > reach || dot(way, way) > near * near || isHidden(hidden, t)) return;
            if (!f.isCreased() && !mayLieOver(f, way)) return;
            if (mag(x - nearestOnTriangle(x, corner(f, 0), corner(f, 1), corner(f, 2)).point) > reach) return;
            const auto place = placeOf(t, x, hidden);
            if (place.lies == Lies::elsewhere) return;
            // Facets of one patch, over whose joint x lies or whose planes go on over one another, give the same image: that which x lies over sees it.
            const auto y = mirrorImage(x, place.foot);
            for (auto& other : found)
            {
                if (facets_[std::size_t(other.facet)].patch != f.patch || mag(mirrorImage(x, other.foot) - y) > 2e-3 * scale_.spacing ||
                    dot(other.foot.normal, place.foot.normal) < 1 - 1e-6)
                    continue;
                if (place.lies > other.lies) other = place;
                return;
            }
            found.push_back(place);
        });
}

Foot FacetBody::withMargin(const Place& place, const Vector<3>& x, Hidden hidden) const
{
    Foot foot = place.foot;
    const auto y = mirrorImage(x, foot);
    if (place.lies == Lies::over) foot.margin = margin(place.facet, y, {foot.distance, foot.distance}, false, hidden);
    else if (foot.distance < 0) foot.margin = -Box::infinity; // beside an edge and behind the face: in front of the next one
    else if (const auto& f = facets_[std::size_t(place.facet)]; flatPatch_[std::size_t(f.patch)])
        foot.margin = margin(place.facet, y, claimOfPlane(place.facet, y), true, hidden);
    else
    {
        const Claim own = claim(place.facet, y);
        foot.margin = margin(place.facet, y, own, true, hidden);
        if (foot.margin > -0.5 * scale_.spacing) foot.margin = std::min(foot.margin, marginInPatch(f, y, own.D));
    }
    return foot;
}

Foot FacetBody::mirror(int& facet, const Vector<3>& x, Hidden hidden) const
{
    const int mostMoves = 100;
    std::optional<Prism> over;
    for (int from = -1, move = 0; move < mostMoves; ++move)
    {
        over = prism(facet, x);
        if (over && over->inside) return withMargin({facet, Lies::over, over->foot}, x, hidden);
        // Round the end of an edge the patch goes on to the far side, which x may be over as well: there it has another image.
        const auto& f = facets_[std::size_t(facet)];
        if (f.isCreased() && !flatPatch_[std::size_t(f.patch)])
            for (int edge = 0; edge < 3; ++edge)
                if (f.edges[std::size_t(edge)] > EdgeKind::smooth)
                    if (const auto p = strip(facet, edge, x); p && holds(*p)) return withMargin({facet, Lies::beside, p->foot}, x, hidden);
        // Over the neighbour that x has gone furthest to, where no edge is between.
        const auto l = over ? over->l : plane(facet, x).l;
        int next = -1;
        double furthest = 0;
        for (std::size_t k = 0; k < 3; ++k)
            if (l[k] < furthest && f.edges[k] <= EdgeKind::smooth && f.across[k] != from)
            {
                furthest = l[k];
                next = f.across[k];
            }
        if (next < 0) break;
        from = facet;
        facet = next;
    }
    const auto& f = facets_[std::size_t(facet)];
    if (flatPatch_[std::size_t(f.patch)]) return withMargin({facet, Lies::beside, plane(facet, x).foot}, x, hidden);
    if (!f.isCreased()) return withMargin({facet, Lies::over, (over ? *over : plane(facet, x)).foot}, x, hidden);
    // Beyond the border of a curved patch: along it to the edge whose strip x lies in.
    const auto l = over ? over->l : plane(facet, x).l;
    int edge = -1;
    for (int k = 0; k < 3; ++k)
        if (f.edges[std::size_t(k)] > EdgeKind::smooth && (edge < 0 || l[std::size_t(k)] < l[std::size_t(edge)])) edge = k;
    Foot foot = plane(facet, x).foot;
    for (int turn = 0, move = 0; move < mostMoves; ++move)
    {
        const auto p = strip(facet, edge, x);
        if (!p) break;
        foot = p->foot;
        const int way = p->s > 1 ? 2 : p->s < 0 ? 1 : 0;
        if (way == 0 || (turn != 0 && way != turn)) break;
        turn = way;
        goAlongBorder(facet, edge, turn);
    }
    return withMargin({facet, Lies::beside, foot}, x, hidden);
}

bool FacetBody::sees(const Vector<3>& x, int facet) const
{
    const auto& f = facets_[std::size_t(facet)];
    const auto to = nearestOnTriangle(x, corner(f, 0), corner(f, 1), corner(f, 2)).point;
    const auto way = to - x;
    const double length = mag(way);
    if (length < 1e-3 * scale_.spacing) return true;
    bool hidden = false;
    tree_.visit(
        [&](const FacetTree::Node& node)
        {
            if (hidden) return false;
            // Slabs (Kay & Kajiya 1986).
            double in = 0, out = 1;
            for (const auto c : coordinates)
            {
                const double a = (node.box.low.*c - x.*c) / (way.*c), b = (node.box.high.*c - x.*c) / (way.*c);
                if (way.*c == 0)
                {
                    if (x.*c < node.box.low.*c || x.*c > node.box.high.*c) return false;
                    continue;
                }
                in = std::max(in, std::min(a, b));
                out = std::min(out, std::max(a, b));
            }
            return in <= out + 1e-9;
        },
        [&](int t)
        {
            const auto& g = facets_[std::size_t(t)];
            const double towards = dot(g.normal, way);
            if (towards >= 0) return; // from behind
            const double at = dot(g.normal, corner(g, 0) - x) / towards;
            // What is met beside the end is the face itself, or a neighbour.
            if (at <= 0 || at * length > length - 1e-2 * scale_.spacing) return;
            const auto p = plane(t, x + at * way);
            hidden = hidden || p.inside;
        });
    return !hidden;
}

}
