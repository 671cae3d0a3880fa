/// Agglomerates: fines that a binder holds to a large grain, as one closed surface.
///
/// A fine is bound at a point of the grain's surface that is drawn evenly over its area, randomly turned, its lowest point a share `bond` of its size below the surface
/// there. Of ten such points the one is taken that is farthest from the fines bound before (Mitchell 1991), the largest fines first. Fines may overlap one another: the mesh is
/// the union of all (removeSelfIntersections of module meshes), and pores that they enclose are its cavities.
#include "meshes/orientShells.hpp"
#include "meshes/placeMesh.hpp"
#include "meshes/repairSurface.hpp"
#include "solids/Bed.hpp"
#include "solids/rocks/closedSurface.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Points of a surface, drawn evenly over its area, with the normal there.
class SurfacePoints
{
    const TriangleSurface& s_;
    std::vector<double> upTo_; ///< area of the triangles up to and with each

public:
    explicit SurfacePoints(const TriangleSurface& s) : s_(s)
    {
        double area = 0;
        for (std::size_t f = 0; f < s.triangles.size(); ++f) upTo_.push_back(area += 0.5 * mag(areaVector(s, int(f))));
    }
    std::pair<Vector<3>, Vector<3>> operator()(Noise& noise) const
    {
        const auto at = std::ranges::upper_bound(upTo_, noise() * upTo_.back());
        const auto f = std::size_t(std::min(at - upTo_.begin(), std::ptrdiff_t(upTo_.size()) - 1));
        const auto corner = [&](std::size_t k) { return s_.points[std::size_t(s_.triangles[f][k])]; };
        const double u = std::sqrt(noise()), v = noise();
        const auto n = areaVector(s_, int(f));
        return {(1 - u) * corner(0) + u * (1 - v) * corner(1) + u * v * corner(2), n / mag(n)};
    }
};

/// A fine of that size somewhere on the grain: its surface and its middle.
std::pair<TriangleSurface, Vector<3>> boundSomewhere(const SurfacePoints& points, TriangleSurface fine, double size, double bond,
                                                     Noise& noise)
{
    const auto [x, n] = points(noise);
    const auto turn = randomRotation(noise);
    for (auto& p : fine.points) p = size * turn(p);
    const auto lowest = *std::ranges::min_element(fine.points, {}, [&](const auto& p) { return dot(p, n); });
    const auto middle = x - bond * size * n - lowest;
    for (auto& p : fine.points) p = p + middle;
    return {std::move(fine), middle};
}

/// The surface of the solid that the pieces make together.
TriangleSurface united(const std::vector<TriangleSurface>& pieces, const Location& where)
{
    NumberedMesh m;
    m.regions = {"solid"};
    for (const auto& piece : pieces) append(m, piece);
    m.region.assign(m.triangles.size(), 0);
    m.number.assign(m.triangles.size(), -1);
    try
    {
        std::vector<std::string> repairs;
        removeSelfIntersections(m, weldOf(boundingBox(m)), repairs);
    }
    catch (const UnusableMesh& e)
    {
        throw CaseError(where,
                        fmt::format("grain and fines cannot be united: {}\nAnother seed, or another bond, binds them elsewhere", e.what()));
    }
    if (const auto shells = findShells(m); std::ranges::count_if(shells.volume, [](double v) { return v > 0; }) != 1)
        throw CaseError(where,
                        "a fine has come loose of its grain, which is too thin there: bind them deeper (bond), or choose smaller ones");
    return {m.points, m.triangles};
}

}

SolidShape agglomerate(const SolidShape& grain, const TriangleSurface& fine, const FinesToBind& fines, std::uint64_t seed)
{
    constexpr std::uint64_t apart = 7919; // seeds of one grain's agglomerates and those of the bed
    Noise noise(apart * seed + std::uint64_t(fines.variant));
    SolidShape shape = grain;
    shape.pieces = {grain.mesh};
    const SurfacePoints points(grain.mesh);
    const int count = fines.count();
    struct Ball
    {
        Vector<3> middle;
        double size;
    };
    std::vector<Ball> bound;
    double volumes = 1; // over that of the grain
    for (int k = 0; k < count; ++k)
    {
        const double size = std::lerp(fines.largest, fines.smallest, (k + 0.5) / count);
        std::pair<TriangleSurface, Vector<3>> best;
        double widest = -Box::infinity;
        constexpr int candidates = 10;
        for (int trial = 0; trial < candidates; ++trial)
        {
            auto candidate = boundSomewhere(points, fine, size, fines.bond, noise);
            double gap = Box::infinity;
            for (const auto& other : bound) gap = std::min(gap, mag(candidate.second - other.middle) - 0.5 * (size + other.size));
            if (gap <= widest) continue;
            widest = gap;
            best = std::move(candidate);
        }
        bound.push_back({best.second, size});
        shape.pieces.push_back(std::move(best.first));
        volumes += size * size * size;
    }
    shape.mesh = united(shape.pieces, fines.where);

    // As of any shape: its volume is that of a sphere of diameter 1, and its centroid at the origin.
    const auto moments = volumeMoments(shape.mesh);
    const double size = std::cbrt(6 / std::numbers::pi * moments.volume), kept = size * size * size / volumes;
    const auto toUnit = [&](TriangleSurface& s)
    {
        for (auto& p : s.points) p = (p - moments.centroid) / size;
    };
    toUnit(shape.mesh);
    for (auto& piece : shape.pieces) toUnit(piece);
    shape.reach = 0;
    for (const auto& p : shape.mesh.points) shape.reach = std::max(shape.reach, mag(p));
    shape.name = fmt::format("{}Fines{}", grain.name, fines.variant + 1);
    shape.file = fmt::format("constant/triSurface/{}.obj", shape.name);
    shape.centroid = {};
    shape.fileSize = 1;
    shape.note = fmt::format("{} fines, {:.3g} of the mass; as one surface {:.4g} of the volume of grain and fines, {} facets; ", count,
                             1 - 1 / volumes, kept, shape.mesh.triangles.size());
    return shape;
}

}
