/// A closed body of triangles as the fluid sees it: what is smooth, what is an edge, and how a point mirrors in it.
///
/// An edge is *flat* (neighbours in one plane), *smooth* (small facets that stand for a curved surface), *convex* (the solid sticks out: more than 180
/// degrees of fluid) or *concave*. Facets joined by flat and smooth edges are one smooth patch.
///
/// Mirror images. Within a patch the normals of the corners, the means of the facets around them, make a prism of each facet f,
///
///   x = P(l) + d N(l),    P = sum_k l_k P_k,  N = sum_k l_k N_k,  l_k >= 0,        image  x' = P - d N
///
/// The prisms of neighbours share their sides, so that a patch gives each particle one image, which moves continuously; the volume factor
/// J(-d)/J(d) of this map, J = (dP + d dN)x(dP + d dN).N, is that of eq. (18) of Barker et al. (2012) with curvatures from J. In flat faces x' is the
/// plain mirror image.
///
/// At convex and concave edges faces go on, flat ones in their planes, curved ones in strips: beyond each edge of the patch's border
///
///   x = q(s) + a b(s) + d N(s),    0 <= s <= 1 along the edge, a > 0,
///
/// with b(s) between the directions b_k perpendicular to N_k and to the border at its ends, so that neighbouring strips share their sides as prisms do.
/// Every place y behind the surface belongs to one face: that of the least
///
///   t_f(y) = 2 D_f - h_f        D_f distance to the face, h_f depth below its plane [m]
///
/// Behind a convex edge this is the face that is nearer: its border is the bisecting plane (case (i) of fig. 4 of the paper). Behind a concave one, where
/// the edge is as near from either, it is the one that y lies deeper below: its border is the bisecting plane too. What a face mirrors there is the
/// fluid in front of its plane, or an image that another face has made (so fills the corner of a box, and a groove of any angle by images of
/// images). Each place is filled once, at edges and vertices of any kind: the fluid around a wedge, in a corner and at a saddle needs no rule of its
/// own. `Foot::margin` is t of the next face less t of this, for two normals at right angles; for others as many times more as their difference is less,
/// so that images fade into one another over as much of the surface at blunt edges. The paper's reflection through the
/// concave edge, 2 x_np - x, is what two reflections give at 90 degrees; at other angles it leaves the lattice of the fluid broken at two planes in
/// place of one.
#pragma once
#include "geometry/DistanceGrid.hpp"
#include "geometry/FacetSurface.hpp"
#include "geometry/FacetTree.hpp"
#include "geometry/Geometry.hpp"
#include <algorithm>
#include <atomic>
#include <optional>

namespace sph
{

enum class EdgeKind : unsigned char
{
    flat,
    smooth,
    convex,
    concave
};

class FacetBody
{
public:
    struct Facet
    {
        std::array<int, 3> points, across, cornerNormals; ///< `across[k]`, `edges[k]`: of the edge opposite corner k
        std::array<EdgeKind, 3> edges;
        bool planar; ///< its corner normals are its own
        int patch, region;
        int grain;        ///< the largest node around it that counts as small
        Vector<3> normal; ///< unit, into the fluid
        Vector<3> middle;
        double radius; ///< of a sphere around `middle` that holds the facet [m]
        double lean;   ///< of the most oblique corner normal: how far it goes along the facet for each unit along the normal

        /// Number of the corner that this point is, 3 if none.
        int cornerAt(int point) const { return int(std::ranges::find(points, point) - points.begin()); }
        bool isCreased() const
        {
            return std::ranges::any_of(edges, [](EdgeKind k) { return k > EdgeKind::smooth; });
        }
    };

    /// Facets of `surface` with these indices, which must be closed: every edge joins two facets that run along it in opposite directions.
    FacetBody(const FacetSurface& surface, std::span<const int> facets, const FacetScale&);

    /// The nearest place of the surface: signed distance by angle-weighted normals (Baerentzen & Aanaes 2005). Infinitely far where none is as near as
    /// `within`.
    Foot foot(const Vector<3>& x, double within = Box::infinity) const;
    double distance(const Vector<3>& x) const { return foot(x).distance; }
    /// Whether x is known to lie in the fluid and further than `least` from the surface, without a search for most places; false where only one can tell.
    bool isBeyond(const Vector<3>& x, double least) const;

    /// Facets that lie in other solids, one flag each, none where there are no such: what they would own is left to the faces beside them, which go on
    /// across their edges.
    using Hidden = std::span<const char>;

    /// Calls f(facet, foot) for each face that x, up to `reach` in front of it or `behind` in the solid, may have an image in, also one that fades
    /// in soon (foot.margin > -fade). The foot of `image = x - 2 distance normal`.
    template<class F> void forEachMirror(const Vector<3>& x, double reach, double behind, double fade, Hidden hidden, const F& f) const
    {
        std::vector<Place> found;
        findMirrors(x, reach, behind, hidden, found);
        for (const auto& place : found)
        {
            if (place.foot.distance < -behind || place.foot.distance > reach) continue;
            if (const Foot foot = withMargin(place, x, hidden); foot.margin > -fade) f(place.facet, foot);
        }
    }
    /// The foot of the mirror image of x in that face of the body that `facet`, which becomes the one that x is over, is a part of.
    Foot mirror(int& facet, const Vector<3>& x, Hidden hidden = {}) const { return withMargin(findFace(facet, x), x, hidden); }
    /// The same without its margin.
    Foot footOnFace(int facet, const Vector<3>& x) const { return findFace(facet, x).foot; }
    /// Ahead of mirror(), of a body too large for any cache: the facet, and once that is there its corners.
    [[gnu::always_inline]] void prefetchFacet(int facet) const
    {
        const auto& f = facets_[std::size_t(facet)];
        __builtin_prefetch(&f);
        __builtin_prefetch(&f.grain);
    }
    [[gnu::always_inline]] void prefetchCorners(int facet) const
    {
        const auto& f = facets_[std::size_t(facet)];
        for (std::size_t k = 0; k < 3; ++k)
        {
            __builtin_prefetch(&points_[std::size_t(f.points[k])]);
            __builtin_prefetch(&cornerNormals_[std::size_t(f.cornerNormals[k])]);
        }
        if (f.grain >= 0) __builtin_prefetch(&safeLayers_[std::size_t(f.grain)]);
    }
    /// Whether the way from x to the surface at a facet meets nothing else of the surface.
    bool sees(const Vector<3>& x, int facet) const;

    /// Calls f(foot) for each face that x lies over, within reach, and for the nearest edge or vertex where it lies over none.
    template<class F> void forEachFoot(const Vector<3>& x, double reach, const F& f) const
    {
        if (distanceTo(bounds(), x) > reach) return;
        std::vector<Place> found;
        findMirrors(x, reach, 0.5 * scale_.spacing, {}, found);
        bool any = false;
        for (const auto& place : found)
            if (place.lies == Lies::over && sees(x, place.facet))
            {
                f(place.foot);
                any = true;
            }
        if (any) return;
        if (const Foot nearest = foot(x, reach); nearest.distance <= reach) f(nearest);
    }

    const std::vector<Facet>& facets() const { return facets_; }
    const std::vector<Vector<3>>& points() const { return points_; }
    const Box& bounds() const { return tree_.nodes().front().box; }
    /// Signed: positive for a body in the fluid, negative for one around it [m^3].
    double volume() const { return volume_; }
    /// Smallest radius of curvature of its smooth edges, convex and concave [m]; infinite where there are none.
    double smallestRadius() const { return smallestRadius_; }
    bool hasCreases() const { return tree_.nodes().front().creased; }
    int patches() const { return patches_; }
    /// Largest angle between a facet and the smooth surface that it stands for [rad].
    double mostTurned() const { return mostTurned_; }

private:
    /// Position of a point relative to a facet; `beside` means across its edges alone.
    enum class Lies : unsigned char
    {
        elsewhere,
        beside,
        over
    };
    struct Place
    {
        int facet;
        Lies lies = Lies::elsewhere;
        Foot foot = {}; ///< without margin
    };
    struct Prism
    {
        Foot foot;
        std::array<double, 3> l; ///< coordinates of the facet
        bool inside;
    };
    struct Strip
    {
        Foot foot;
        double s, a;
    };

    std::vector<Vector<3>> points_, pointNormals_, cornerNormals_;
    std::vector<Vector<3>> outward_;                             ///< b_k of each corner normal on the border of its patch
    std::vector<char> flatPatch_;                                ///< one plane
    mutable std::vector<std::atomic<unsigned char>> safeLayers_; ///< of each node, and one; 0 until asked for
    std::vector<Facet> facets_;
    FacetTree tree_;
    DistanceGrid clearance_;
    FacetScale scale_;
    double volume_ = 0, smallestRadius_ = Box::infinity, mostTurned_ = 0;
    double sunk_ = 0; ///< 1 - cos(mostTurned)
    int patches_ = 0;

    /// `facet` becomes the nearest, -1 where none is as near.
    Foot foot(const Vector<3>& x, double within, int& facet) const;
    void renumberPoints(std::vector<std::array<int, 3>>& triangles);
    void join();
    void classify();
    void averageNormals();
    void numberPatches();

    const Vector<3>& corner(const Facet& f, int k) const { return points_[std::size_t(f.points[std::size_t(k)])]; }
    std::optional<Prism> prism(int facet, const Vector<3>& x) const;
    Prism plane(int facet, const Vector<3>& x) const;
    std::optional<Strip> strip(int facet, int edge, const Vector<3>& x) const;
    /// Round the end of an edge of a patch's border (the one where the corner (edge + turn) % 3 is), within the patch, to the next edge of its border.
    void goAlongBorder(int& facet, int& edge, int turn) const;
    void findMirrors(const Vector<3>& x, double reach, double behind, Hidden hidden, std::vector<Place>& found) const;
    Place placeOf(int facet, const Vector<3>& x, Hidden hidden) const;
    /// Goes from facet to facet, and along the border of their patch, to where x is over the face.
    Place findFace(int& facet, const Vector<3>& x) const;
    Foot withMargin(const Place&, const Vector<3>& x, Hidden hidden) const;
    /// Distance of y to a facet, and t_f(y), see above: infinite where y is in front of it.
    struct Claim
    {
        double D, t;
    };
    Claim claim(int facet, const Vector<3>& y) const;
    bool areRivals(const Facet& a, const Facet& b) const;
    Claim claimOfPlane(int facet, const Vector<3>& y) const;
    double margin(int facet, const Vector<3>& y, Claim own, bool extended, Hidden hidden) const;
    double marginInPatch(const Facet&, const Vector<3>& y, double D) const;
    /// Down to which depth below a facet no place has a rival that its share would know of: for all facets of a small node together, found when first asked
    /// for. Of fine facets on a thick body most places need no search.
    double safeDepth(int facet) const;
    bool isSafe(const FacetTree::Node&, double depth) const;
    static bool isHidden(Hidden hidden, int facet) { return !hidden.empty() && hidden[std::size_t(facet)]; }
};

}
