#include "solids/rocks/makeRock.hpp"
#include "base/noise.hpp"
#include "geometry/Shape.hpp"
#include "geometry/geodesicSphere.hpp"
#include "solids/rocks/closedSurface.hpp"
#include <algorithm>
#include <cassert>
#include <map>

namespace sph
{

namespace
{

Vector<3> unit(const Vector<3>& a) { return a / mag(a); }

Vector<3> direction(Noise& noise)
{
    const double x = noise.normal(), y = noise.normal();
    return unit({x, y, noise.normal()});
}

/// A convex polyhedron: faces as polygons, counter-clockwise as seen from outside.
struct Polyhedron
{
    std::vector<Vector<3>> points;
    std::vector<std::vector<int>> faces;

    Vector<3> normal(const std::vector<int>& face) const
    {
        Vector<3> sum;
        for (std::size_t k = 2; k < face.size(); ++k) sum += cross(at(face[k - 1]) - at(face[0]), at(face[k]) - at(face[0]));
        return unit(sum);
    }
    const Vector<3>& at(int i) const { return points[std::size_t(i)]; }
};

Polyhedron box(const Vector<3>& half)
{
    Polyhedron p;
    for (const auto& c : corners(Box{-half, half})) p.points.push_back(c);
    p.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    return p;
}

/// The part where n.x <= d; the same polyhedron where the plane does not cut it, or passes so close to a point that a sliver would be left.
Polyhedron cut(const Polyhedron& p, const Vector<3>& n, double d)
{
    std::vector<double> beyond;
    for (const auto& x : p.points) beyond.push_back(dot(n, x) - d);
    constexpr double sliver = 1e-4;
    if (std::ranges::any_of(beyond, [](double b) { return std::abs(b) < sliver; })) return p;
    Polyhedron kept;
    std::map<std::pair<int, int>, int> number; // of an old point (i, i), of the cut of an edge (i, j)
    const auto point = [&](int i, int j, const Vector<3>& x)
    {
        const auto [at, isNew] = number.try_emplace(std::minmax(i, j), int(kept.points.size()));
        if (isNew) kept.points.push_back(x);
        return at->second;
    };
    std::map<int, int> next; // along the rim of the new face
    for (const auto& face : p.faces)
    {
        std::vector<int> polygon;
        int leaves = -1, enters = -1;
        for (std::size_t k = 0; k < face.size(); ++k)
        {
            const int i = face[k], j = face[(k + 1) % face.size()];
            const double bi = beyond[std::size_t(i)], bj = beyond[std::size_t(j)];
            if (bi <= 0) polygon.push_back(point(i, i, p.at(i)));
            if ((bi <= 0) == (bj <= 0)) continue;
            const int low = std::min(i, j), high = std::max(i, j);
            const double bl = beyond[std::size_t(low)], bh = beyond[std::size_t(high)];
            polygon.push_back(point(i, j, p.at(low) + bl / (bl - bh) * (p.at(high) - p.at(low))));
            (bi <= 0 ? leaves : enters) = polygon.back();
        }
        if (polygon.size() > 2) kept.faces.push_back(polygon);
        if (leaves >= 0) next[enters] = leaves;
    }
    if (next.empty()) return p;
    std::vector<int> rim{next.begin()->first};
    for (int i = next.at(rim[0]); i != rim[0]; i = next.at(i)) rim.push_back(i);
    kept.faces.push_back(rim);
    return kept;
}

/// Takes off what stands out most in a random direction, a corner or an edge: sharp ones do so in most directions.
Polyhedron chamfered(const Polyhedron& p, Noise& noise)
{
    const auto n = direction(noise);
    std::vector<double> height;
    for (const auto& x : p.points) height.push_back(dot(n, x));
    std::ranges::sort(height, std::greater());
    std::size_t last = 0; // of the points that are taken off
    for (std::size_t k = 1; k < 4; ++k)
        if (height[k] - height[k + 1] > height[last] - height[last + 1]) last = k;
    constexpr double deepest = 0.1;
    return cut(p, n, height[last] - noise.between(0.3, 0.7) * std::min(deepest, height[last] - height[last + 1]));
}

/// A box of random sides, cut by planes in directions far from one another, the edges then chamfered.
TriangleSurface angular(int facets, std::uint64_t seed)
{
    // With three edges at each corner, F faces have 4 F - 12 triangles (Euler's formula).
    const auto faces = std::size_t(std::max(8, (facets + 14) / 4));
    constexpr std::size_t mainFaces = 16;
    Noise noise(seed);
    const double a = noise.between(0.8, 1), b = noise.between(0.8, 1);
    auto p = box({a, b, noise.between(0.8, 1)});
    std::vector<Vector<3>> taken{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    while (p.faces.size() < std::min(faces, mainFaces))
    {
        // The best of ten candidates (Mitchell 1991)
        Vector<3> best;
        double least = 2;
        for (int k = 0; k < 10; ++k)
        {
            const auto candidate = direction(noise);
            double nearest = -1;
            for (const auto& t : taken) nearest = std::max(nearest, dot(t, candidate));
            if (nearest < least)
            {
                least = nearest;
                best = candidate;
            }
        }
        taken.push_back(best);
        p = cut(p, best, noise.between(0.85, 1.05));
    }
    while (p.faces.size() < faces) p = chamfered(p, noise);
    TriangleSurface s{p.points, {}};
    for (const auto& f : p.faces)
        for (std::size_t k = 2; k < f.size(); ++k) s.triangles.push_back({f[0], f[k - 1], f[k]});
    return s;
}

TriangleSurface stretched(TriangleSurface s, const Vector<3>& by)
{
    for (auto& p : s.points) p = {by.x * p.x, by.y * p.y, by.z * p.z};
    return s;
}

/// Axes as of Zingg's (1935) rods and discs: intermediate over longest and shortest over intermediate are below and above 2/3.
TriangleSurface elongated(int facets, std::uint64_t seed) { return stretched(angular(facets, seed), {1.8, 0.9, 0.8}); }
TriangleSurface flat(int facets, std::uint64_t seed) { return stretched(angular(facets, seed), {1.3, 1.15, 0.55}); }

/// r = 1 + sum_k a_k cos(w_k.n + phi_k) on the unit sphere: seen from the middle each point is there once, so that no facets cross.
TriangleSurface wavy(int facets, Noise& noise, double amplitude)
{
    auto s = geodesicSphere(std::max(1, int(std::lround(std::sqrt(facets / 20.0)))));
    struct Wave
    {
        Vector<3> w;
        double phase, a;
    };
    std::vector<Wave> waves;
    for (int k = 0; k < 12; ++k)
    {
        const double length = noise.between(1.5, 5);
        const auto w = length * direction(noise);
        waves.push_back({w, noise.between(0, 2 * std::numbers::pi), amplitude / length});
    }
    for (auto& p : s.points)
    {
        double r = 1;
        for (const auto& wave : waves) r += wave.a * std::cos(dot(wave.w, p) + wave.phase);
        p *= r;
    }
    return s;
}

TriangleSurface rounded(int facets, std::uint64_t seed)
{
    Noise noise(seed);
    return wavy(facets, noise, 0.12);
}

/// A rounded rock with a bite: at one of its points a ball of 0.75 of the radius is taken out of it, so that r is the near side of the ball there.
TriangleSurface concave(int facets, std::uint64_t seed)
{
    Noise noise(seed);
    auto s = wavy(facets, noise, 0.06);
    constexpr double ball = 0.75;
    const auto centre = unit(s.points[std::size_t(noise.below(int(s.points.size())))]);
    for (auto& p : s.points)
    {
        const double along = dot(unit(p), centre), root = sqr(ball) - (1 - sqr(along));
        if (along > 0 && root > 0) p *= std::min(1.0, (along - std::sqrt(root)) / mag(p));
    }
    return s;
}

}

const std::vector<RockKind>& rockKinds()
{
    static const std::vector<RockKind> kinds{{"angular", "a polyhedron cut by planes, its edges chamfered", angular},
                                             {"rounded", "a wavy sphere", rounded},
                                             {"elongated", "an angular one, a rod", elongated},
                                             {"flat", "an angular one, a disc", flat},
                                             {"concave", "a rounded one with a bite taken out of it", concave}};
    return kinds;
}

TriangleSurface makeRock(const RockKind& kind, int facets, double diameter, std::uint64_t seed)
{
    assert(facets >= fewestFacets);
    auto rock = kind.make(facets, seed);
    const auto moments = volumeMoments(rock);
    const double scale = diameter / std::cbrt(6 / std::numbers::pi * moments.volume);
    for (auto& p : rock.points) p = scale * (p - moments.centroid);
    return rock;
}

TriangleSurface makeScan(int facets, double diameter, std::uint64_t seed)
{
    auto rock = makeRock(rockKinds()[1], facets, diameter, seed);
    Noise noise(seed + 1);
    const auto whole = rock;
    for (auto& p : rock.points) p += 0.005 * diameter * noise.normal() * unit(p);

    // A point moved along the surface by several facets and to half the height of the tangent there: its facets dive and come out.
    const double edge = 2 * std::sqrt(4 * std::numbers::pi / double(rock.triangles.size())); // of the unit sphere
    for (int k = 0; k < 2; ++k)
    {
        auto& p = rock.points[std::size_t(noise.below(int(rock.points.size())))];
        const double angle = 3 * edge;
        const auto n = unit(p), along = crossSection(n)[0];
        p = mag(p) * (1 + sqr(angle) / 4) * (std::cos(angle) * n + std::sin(angle) * along);
    }

    std::vector<std::array<int, 3>> kept;
    std::array<Vector<3>, 4> holes;
    for (auto& h : holes) h = direction(noise);
    for (const auto& t : rock.triangles)
    {
        const auto n = unit(whole.points[std::size_t(t[0])]);
        if (std::ranges::none_of(holes, [&](const auto& h) { return dot(n, h) > std::cos(1.5 * edge); })) kept.push_back(t);
    }
    rock.triangles = kept;
    for (std::size_t k = 0; k < kept.size() / 50 + 1; ++k)
    {
        auto& t = rock.triangles[std::size_t(noise.below(int(kept.size())))];
        std::swap(t[0], t[1]);
    }
    for (std::size_t k = 0; k < kept.size() / 100 + 1; ++k)
        rock.triangles.push_back(rock.triangles[std::size_t(noise.below(int(kept.size())))]);
    return rock;
}

}
