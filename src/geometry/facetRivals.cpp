/// Facets of a body that compete for a place behind its surface (rivals): which of them the place belongs to, and where there are no rivals.
#include "geometry/FacetBody.hpp"
#include "geometry/facetAngles.hpp"

namespace sph
{

namespace
{

/// Facets of one smooth patch that are turned by more than this against one another are rivals: both sides of a ridge that ends.
constexpr double rivalAngle = 35 * degree;
const double rivalCosine = std::cos(rivalAngle);
/// Depth below the whole patch over distance from an edge: a place beyond the edge belongs to the patch from `wholeBelow` on, and not at all below `noneBelow`.
constexpr double wholeBelow = 0.9, noneBelow = 0.5;
/// Rivals within so many spacings of one another count as one.
constexpr double finest = 0.1;
/// Depths down to which facets have no rivals are stored in layers of so many spacings,
constexpr double layerThickness = 0.25;
constexpr int mostLayers = 254;
/// and layers deeper than so many supports are never needed.
constexpr double deepest = 1.5;

/// Upper bound on the depth of y below the planes of the facets of a node, no more than the distance to the far end of the node.
double greatestDepth(const FacetTree::Node& node, const Vector<3>& y)
{
    const auto way = 0.5 * (node.box.low + node.box.high) - y;
    const double length = mag(way), along = dot(way, node.axis), radius = 0.5 * mag(node.box.high - node.box.low);
    if (along >= length * node.cosine) return length + radius;
    return radius + along * node.cosine + std::sqrt(std::max((length * length - along * along) * (1 - node.cosine * node.cosine), 0.0));
}

}

FacetBody::Claim FacetBody::claim(int facet, const Vector<3>& y) const
{
    const auto& f = facets_[std::size_t(facet)];
    const double D = mag(y - nearestOnTriangle(y, corner(f, 0), corner(f, 1), corner(f, 2)).point), depth = dot(f.normal, corner(f, 0) - y);
    return {D, depth < 0 ? Box::infinity : 2 * D - depth};
}

/// Claim of the face in whose plane y lies beyond an edge: that of its facet nearest to y.
FacetBody::Claim FacetBody::claimOfPlane(int facet, const Vector<3>& y) const
{
    const auto& f = facets_[std::size_t(facet)];
    Claim own = claim(facet, y);
    own.t = tree_
                .nearest(
                    y, own.t * (1 + 1e-12), finest * scale_.spacing,
                    [&](int t) { return areRivals(f, facets_[std::size_t(t)]) ? Box::infinity : claim(t, y).t; },
                    [&](const FacetTree::Node& node, double) { return node.patch >= 0 && node.patch != f.patch; })
                .first;
    return own;
}

bool FacetBody::areRivals(const Facet& a, const Facet& b) const { return a.patch != b.patch || dot(a.normal, b.normal) < rivalCosine; }

double FacetBody::margin(int facet, const Vector<3>& y, Claim own, bool extended, Hidden hidden) const
{
    const auto& f = facets_[std::size_t(facet)];
    if (!hasCreases() && tree_.nodes().front().halfAngle < 0.5 * rivalAngle) return Box::infinity;
    if (!extended && own.D < safeDepth(facet)) return Box::infinity;
    const double grain = finest * scale_.spacing;
    if (std::isinf(own.t)) return -Box::infinity; // in front of the face: no place of its
    double toFront = Box::infinity, toBack = own.D;
    const double faded = std::numbers::sqrt2 * scale_.spacing, whole = 0.5 * faded; // of margins of -1 and 0.5 spacings (faceShare)
    double least = own.t + whole;
    // The difference between two facets counts the more the less their normals differ; a share that has faded out is 0 whatever the difference is.
    const auto rival = [&](int t)
    {
        const auto& g = facets_[std::size_t(t)];
        if (isHidden(hidden, t) || !areRivals(f, g)) return Box::infinity;
        const double weight = 2 / std::max(mag(g.normal - f.normal), flatAngle), depth = dot(g.normal, corner(g, 0) - y);
        // No nearer than this: most need not be looked at.
        const double D = std::max(mag(g.middle - y) - g.radius, std::abs(depth));
        if (D > std::min(toFront, toBack) && (depth < 0 || own.t + weight * (2 * D - depth - own.t) > least)) return Box::infinity;
        const Claim c = claim(t, y);
        auto& nearest = std::isinf(c.t) ? toFront : toBack;
        nearest = std::min(nearest, c.D);
        const double value = own.t + weight * (c.t - own.t);
        least = std::min(least, value);
        return value;
    };
    for (const int t : f.across) rival(t); // the neighbours first: they are most of what competes
    if (least < own.t - faded) return (least - own.t) / std::numbers::sqrt2;
    tree_.nearest(y, least, grain, rival,
                  [&](const FacetTree::Node& node, double D)
                  {
                      const double cosine = node.mostTurned(f.normal);
                      if (node.patch == f.patch && cosine > rivalCosine) return true;
                      // The weight is 1/sin of half the angle.
                      const double weight = std::numbers::sqrt2 / std::sqrt(1 - cosine);
                      return D > std::min(toFront, toBack) && own.t + weight * (2 * D - greatestDepth(node, y) - own.t) > least;
                  });
    // A place that lies in the fluid belongs to no facet.
    if (toFront <= toBack * (1 + 1e-9))
        if (const double s = foot(y, toFront * (1 + 1e-9)).distance; s > 0) return -s - own.t;
    return (least - own.t) / std::numbers::sqrt2;
}

/// A place y beyond an edge, D from the facet, may lie below another part of the same curved patch, or in front of it, where the patch goes round the end of the
/// edge: that part is no rival, and has an image of its own there. The margin then follows from the depth of y below the whole patch over D.
double FacetBody::marginInPatch(const Facet& f, const Vector<3>& y, double D) const
{
    int nearest;
    const double depth = -foot(y, Box::infinity, nearest).distance;
    if (depth > 0 && areRivals(f, facets_[std::size_t(nearest)])) return Box::infinity;
    return ((depth / D - noneBelow) / (wholeBelow - noneBelow) - 0.5) * scale_.spacing;
}

double FacetBody::safeDepth(int facet) const
{
    const int n = facets_[std::size_t(facet)].grain;
    if (n < 0) return 0;
    const double thickness = layerThickness * scale_.spacing;
    auto& known = safeLayers_[std::size_t(n)]; // and one, so that 0 is not found yet
    int layers = known.load(std::memory_order_relaxed) - 1;
    if (layers < 0)
    {
        layers = 0;
        while (layers < mostLayers && layers * thickness < deepest * scale_.support &&
               isSafe(tree_.nodes()[std::size_t(n)], (layers + 1) * thickness))
            ++layers;
        known.store(static_cast<unsigned char>(layers + 1), std::memory_order_relaxed);
    }
    return layers * thickness;
}

/// Tests one place y, from which all P - depth N of these facets are no further than `off`. Further up D - d of any rival is greater, and t >= D.
bool FacetBody::isSafe(const FacetTree::Node& node, double depth) const
{
    if (node.patch < 0 || node.cosine < rivalCosine) return false;
    double lean = 0;
    for (int t = node.first; t < node.last; ++t) lean = std::max(lean, facets_[std::size_t(t)].lean);
    const double off = 0.5 * mag(node.box.high - node.box.low) + depth * (std::sin(node.halfAngle) + lean);
    const auto y = 0.5 * (node.box.low + node.box.high) - depth * node.axis;
    const double own = depth + off, whole = scale_.spacing / std::numbers::sqrt2; // of a margin of half a spacing
    const double rivalFromAxis = std::cos(rivalAngle - node.halfAngle);
    const auto [_, found] = tree_.nearest(
        y, own + whole, finest * scale_.spacing,
        [&](int t)
        {
            const auto& g = facets_[std::size_t(t)];
            const double cosine = node.mostTurned(g.normal);
            if (g.patch == node.patch && cosine > rivalCosine) return Box::infinity;
            const double D = mag(y - nearestOnTriangle(y, corner(g, 0), corner(g, 1), corner(g, 2)).point);
            return own + std::numbers::sqrt2 / std::sqrt(1 - cosine) * (D - own);
        },
        [&](const FacetTree::Node& other, double D)
        {
            const double turned = other.mostTurned(node.axis);
            if (other.patch == node.patch && turned > rivalFromAxis) return true;
            const double cosine = turned * node.cosine - std::sqrt((1 - turned * turned) * (1 - node.cosine * node.cosine));
            return D > own && std::numbers::sqrt2 / std::sqrt(1 - cosine) * (D - own) > whole;
        });
    return found < 0;
}

}
