/// The feet of a point on a body, and its mirror images in it.
#include "geometry/FacetBody.hpp"
#include "geometry/components.hpp"
#include <algorithm>

namespace sph
{

namespace
{

/// Largest distance of a particle over a hollow's radius for which its image has the volume factor of eq. (18).
constexpr double mostCurved = 0.6;

/// Tolerance of the coordinates on a facet: a point over the joint of two facets lies over both.
constexpr double onJoint = 1e-10;

/// Whether what lies `way` from the middle of a facet may lie in its prism.
bool mayLieOver(const FacetBody::Facet& f, const Vector<3>& way)
{
    const double height = dot(f.normal, way), aside2 = dot(way, way) - height * height, widest = f.radius + std::abs(height) * f.lean;
    return aside2 < 1.001 * widest * widest;
}

/// Whether what a strip has been asked for lies in it.
bool holds(const auto& strip) { return strip.s >= -onJoint && strip.s <= 1 + onJoint && strip.a > 0; }

/// The volume factor has no curvature beyond which an image would stand for any volume.
double boundedCurvature(double k, double distance, double spacing) { return std::min(k, mostCurved / std::max(distance, 1e-9 * spacing)); }

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
        at = facets_[std::size_t(facet)].cornerAt(point);
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

FacetBody::Place FacetBody::findFace(int& facet, const Vector<3>& x) const
{
    const int mostMoves = 100;
    std::optional<Prism> over;
    for (int from = -1, move = 0; move < mostMoves; ++move)
    {
        over = prism(facet, x);
        if (over && over->inside) return {facet, Lies::over, over->foot};
        // Round the end of an edge the patch goes on to the far side, which x may be over as well: there it has another image.
        const auto& f = facets_[std::size_t(facet)];
        if (f.isCreased() && !flatPatch_[std::size_t(f.patch)])
            for (int edge = 0; edge < 3; ++edge)
                if (f.edges[std::size_t(edge)] > EdgeKind::smooth)
                    if (const auto p = strip(facet, edge, x); p && holds(*p)) return {facet, Lies::beside, p->foot};
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
    if (flatPatch_[std::size_t(f.patch)]) return {facet, Lies::beside, plane(facet, x).foot};
    if (!f.isCreased()) return {facet, Lies::over, (over ? *over : plane(facet, x)).foot};
    // A point beyond the border of a curved patch: the search goes along the border to the edge whose strip x lies in.
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
    return {facet, Lies::beside, foot};
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
            // A facet met beside the end is the face itself, or a neighbour.
            if (at <= 0 || at * length > length - 1e-2 * scale_.spacing) return;
            const auto p = plane(t, x + at * way);
            hidden = hidden || p.inside;
        });
    return !hidden;
}

}
