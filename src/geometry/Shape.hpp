/// Smooth wall surfaces by their mathematics: signed distance, foot point and principal curvatures (Barker et al. 2012, eqs.
/// 15-18).
///
/// Points have three components always; a 2-D scene lives in the plane z = 0 and its shapes do not vary with z (a sphere
/// becomes a circle). Signs: `distance` is positive on the fluid side, `normal` points into the fluid, and a principal
/// curvature is positive where its centre lies on the FLUID side (fluid inside a sphere: +1/R), negative for fluid outside:
/// with this sign eqs. (16)-(18) of Barker et al. (2012) hold.
#pragma once
#include "base/Vector.hpp"
#include "geometry/TriangleSurface.hpp"
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace sph
{

/// The nearest place of a surface as a point sees it: distance, normal and curvatures.
struct Foot
{
    double distance = 0;   ///< [m] > 0 in the fluid
    Vector<3> normal;      ///< unit, into the fluid, at the foot point x - distance*normal
    double k1 = 0, k2 = 0; ///< principal curvatures at the foot point [1/m]

    /// False where x has no mirror image in this surface: the nearest point lies on an edge, a vertex or an apex, or is not
    /// unique (centre of a sphere, axis of a torus). Whoever makes images leaves such a point out.
    bool smooth = true;
    /// Margin by which the mirror image lies nearer to this face than to the next one of its body [m]: negative beyond the bisector of a convex edge,
    /// -infinite where the nearest place is an edge or a vertex.
    double margin = std::numeric_limits<double>::infinity();

    enum class On : unsigned char
    {
        face,
        edge,
        vertex
    };
    On on = On::face; ///< what the nearest place is a part of
    /// Share of the foot that bounds the fluid: 0 where it lies in another solid. From Geometry::foot; a shape knows no other solids.
    double exposure = 1;
    int region = 0; ///< of the mesh whose surface it lies on
};

/// Smooth step, from 0 at s = 0 to 1 at s = 1, flat beyond both.
constexpr double smoothStep(double s) { return s <= 0 ? 0 : s >= 1 ? 1 : s * s * (3 - 2 * s); }

/// Share of a mirror image that belongs to the face it was mirrored in. It fades from 1 to 0 over a width across the bisector of an edge, on
/// whose other side the image of the other face fades in: what is behind an edge is filled once, and nothing comes or goes at once. What is
/// hidden in another solid has none.
constexpr double faceShare(const Foot& f, double width) { return f.exposure * smoothStep(f.margin / width + 0.5); }

/// Volume factor of the mirror image of a particle at distance d, eq. (18) of Barker et al. (2012) with signed curvatures:
///
///   V'/V = prod_i (1 + k_i d)/(1 - k_i d)
///
/// Erratum of Barker et al. (2012), eqs. (16)-(18) and Table 1: curvatures have a sign; around spheres, where the fluid is outside, the factors of the table are
/// inverted, (R - d)/(R + d) for each curvature, and images spread out where the text has them closer. At most 0 where the image does not exist (d beyond a centre of curvature).
constexpr double volumeFactor(const Foot& f)
{
    const double d = f.distance;
    return (1 + f.k1 * d) * (1 + f.k2 * d) / ((1 - f.k1 * d) * (1 - f.k2 * d));
}

/// x' = x - 2 d n
constexpr Vector<3> mirrorImage(const Vector<3>& x, const Foot& f) { return x - 2 * f.distance * f.normal; }

struct Box
{
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Vector<3> low{-infinity, -infinity, -infinity}, high{infinity, infinity, infinity};
};

/// 0 within the box [m].
inline double distanceTo(const Box& b, const Vector<3>& x)
{
    const auto outside = [](double low, double q, double high) { return std::max({0.0, low - q, q - high}); };
    return mag(Vector<3>{outside(b.low.x, x.x, b.high.x), outside(b.low.y, x.y, b.high.y), outside(b.low.z, x.z, b.high.z)});
}

enum class FluidSide
{
    inside,
    outside
};

/// A shape in the words and numbers of its dictionary entry: enough to write it down and to make it again.
struct ShapeDescription
{
    std::string type;
    std::vector<std::pair<std::string, Vector<3>>> vectors; ///< may hold infinities, where the shape does not end
    std::vector<std::pair<std::string, double>> scalars;
    bool hasSide = true; ///< false for a plane, whose normal says where the fluid is
    FluidSide fluid = FluidSide::outside;
};

/// A smooth surface with a unique nearest point for every x within the reach of a kernel, except where Foot::smooth says
/// otherwise.
class Shape
{
public:
    virtual ~Shape() = default;
    virtual Foot foot(const Vector<3>& x) const = 0;
    /// Signed distance [m]; may be infinite where the surface is no nearer than `within`.
    virtual double distance(const Vector<3>& x, double /*within*/) const { return foot(x).distance; }
    /// Whether a point of the surface lies in or on another solid.
    using Covered = std::function<bool(const Vector<3>&)>;
    /// The foot on the face of the given normal, for a shape with faces. A face goes on beyond those of its edges that are covered at the place
    /// next to `source`, of which x may be an image: where a block stands on a floor there is no edge that the fluid could go round.
    virtual Foot footOnFace(const Vector<3>& x, const Vector<3>& /*normal*/, const Vector<3>& /*source*/, const Covered&) const
    {
        return foot(x);
    }
    /// The feet of an x in the solid: on each face of a shape with faces.
    virtual std::vector<Foot> feetFromInside(const Vector<3>& x) const { return {foot(x)}; }
    /// Encloses the surface; infinite along directions in which it does not end.
    virtual Box bounds() const = 0;
    /// 1/max|k| over the surface as far as the fluid can see it [m]; infinite for a plane.
    virtual double smallestRadius() const = 0;
    /// True where the principal curvatures are the same all over the surface.
    virtual bool uniformlyCurved() const { return false; }
    /// True where two faces meet in a convex edge.
    virtual bool hasEdges() const { return false; }
    virtual std::unique_ptr<Shape> shifted(const Vector<3>& by) const = 0;

    virtual ShapeDescription description() const = 0;
    /// True where a shift along coordinate 0, 1 or 2 changes nothing: the shape is its own periodic copy.
    virtual bool invariantAlong(int direction) const = 0;
    /// True where the solid does not end (plane, fluid inside): the shape cannot be repeated beside itself.
    virtual bool enclosesFluid() const = 0;
    /// Triangles, none longer than about `size`, that cover the surface within the box and may stick out of it.
    virtual TriangleSurface triangles(const Box& within, double size) const = 0;
    /// A lower bound on the distance between surface and box [m].
    virtual double distanceTo(const Box&) const;
};

/// a/|a|, and a itself where it is a unit vector already: numbers that were written down and read again stay the same.
inline Vector<3> unitVector(const Vector<3>& a) { return std::abs(dot(a, a) - 1) < 1e-15 ? a : a / mag(a); }

/// The triangles of a shape cut off at the box, with normals into the fluid.
TriangleSurface triangulate(const Shape&, const Box& within, double size);

}
