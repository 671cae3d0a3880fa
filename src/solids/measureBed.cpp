#include "solids/BedReport.hpp"
#include "solids/meshDistance.hpp"
#include <algorithm>
#include <map>

namespace sph
{

namespace
{

/// Volume of a body below a height z [m] of the container, from the unit mesh, turned as the body is, or the sphere; for a mesh by the divergence theorem,
///
///   V(z) = int x n_x dA over the facets below z, since the cut itself has n_x = 0.
double volumeBelow(const Bed& bed, const Body& b, const TriangleSurface& turned, double z)
{
    const double h = (z - b.centre.z) / b.size;
    const auto& shape = bed.shapeOf(b);
    const double scale = b.size * b.size * b.size;
    if (shape.isSphere())
    {
        const double depth = std::clamp(h + 0.5, 0.0, 1.0); // of a cap: pi t^2 (3 R - t)/3
        return scale * std::numbers::pi / 3 * depth * depth * (1.5 - depth);
    }
    double sum = 0;
    for (const auto& [i, j, k] : turned.triangles)
    {
        std::array<Vector<3>, 3> p{turned.points[std::size_t(i)], turned.points[std::size_t(j)], turned.points[std::size_t(k)]};
        const auto n = cross(p[1] - p[0], p[2] - p[0]);
        if (n.x == 0) continue;
        const double lowest = std::min({p[0].z, p[1].z, p[2].z}), highest = std::max({p[0].z, p[1].z, p[2].z});
        if (lowest >= h) continue;
        const auto part = [&](const Vector<3>& a, const Vector<3>& u, const Vector<3>& v)
        { return (a.x + u.x + v.x) / 3 * 0.5 * cross(u - a, v - a).x; };
        if (highest <= h)
        {
            sum += part(p[0], p[1], p[2]);
            continue;
        }
        // Turned so that the first point is alone on its side
        const auto isBelow = [&](const Vector<3>& q) { return q.z < h; };
        while (isBelow(p[0]) == isBelow(p[1]) || isBelow(p[0]) == isBelow(p[2])) std::rotate(p.begin(), p.begin() + 1, p.end());
        const auto cutTo = [&](const Vector<3>& q) { return p[0] + (h - p[0].z) / (q.z - p[0].z) * (q - p[0]); };
        const auto u = cutTo(p[1]), v = cutTo(p[2]);
        sum += isBelow(p[0]) ? part(p[0], u, v) : part(u, p[1], p[2]) + part(u, p[2], v);
    }
    return scale * sum;
}

struct Slices
{
    const SolidContainer& container;
    const Bed& bed;
    std::vector<TriangleSurface> turned;

    Slices(const SolidContainer& c, const Bed& b) : container(c), bed(b)
    {
        for (const auto& body : bed.bodies)
        {
            turned.push_back(bed.shapeOf(body).mesh);
            for (auto& p : turned.back().points) p = body.rotation(p);
        }
    }
    double porosity(double low, double high) const
    {
        double solid = 0;
        for (std::size_t i = 0; i < bed.bodies.size(); ++i)
            for (int k = container.periodic[2] ? -1 : 0; k <= (container.periodic[2] ? 1 : 0); ++k)
            {
                const auto& b = bed.bodies[i];
                const double shift = k * container.height, reach = bed.reachOf(b);
                if (b.centre.z + shift + reach <= low || b.centre.z + shift - reach >= high) continue;
                solid += volumeBelow(bed, b, turned[i], high - shift) - volumeBelow(bed, b, turned[i], low - shift);
            }
        return 1 - solid / (container.area() * (high - low));
    }
};

/// Share of the points of the core that lie in a solid, and its standard error.
void measureCore(const SolidContainer& c, const Bed& bed, double low, double high, BedMeasures& result)
{
    const double margin = bed.meanSize;
    const double mx = c.periodic[0] ? 0 : margin, my = c.periodic[1] ? 0 : margin;
    if (c.isCylinder ? c.radius < 1.5 * margin : c.length - 2 * mx < margin || c.width - 2 * my < margin) return;
    // Bodies by the columns of a grid that they reach into
    const double cell = bed.meanSize;
    std::map<std::array<int, 3>, std::vector<int>> near;
    std::size_t facets = 1;
    for (std::size_t i = 0; i < bed.bodies.size(); ++i) facets = std::max(facets, bed.shapeOf(bed.bodies[i]).mesh.triangles.size());
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        const double reach = bed.reachOf(b);
        for (int kx = c.periodic[0] ? -1 : 0; kx <= (c.periodic[0] ? 1 : 0); ++kx)
            for (int ky = c.periodic[1] ? -1 : 0; ky <= (c.periodic[1] ? 1 : 0); ++ky)
                for (int kz = c.periodic[2] ? -1 : 0; kz <= (c.periodic[2] ? 1 : 0); ++kz)
                {
                    const auto x = b.centre + Vector<3>{kx * c.length, ky * c.width, kz * c.height};
                    const auto from = [&](double a) { return int(std::floor((a - reach) / cell)); };
                    const auto to = [&](double a) { return int(std::floor((a + reach) / cell)); };
                    for (int p = from(x.x); p <= to(x.x); ++p)
                        for (int q = from(x.y); q <= to(x.y); ++q)
                            for (int r = from(x.z); r <= to(x.z); ++r) near[{p, q, r}].push_back(int(i));
                }
    }
    constexpr int mostPoints = 200'000;
    const int points = std::clamp(int(5e8 / double(facets)), 10'000, mostPoints);
    Noise noise(0);
    int inside = 0;
    for (int k = 0; k < points; ++k)
    {
        Vector<3> x{noise.between(mx, c.length - mx), noise.between(my, c.width - my), noise.between(low, high)};
        if (c.isCylinder)
        {
            const double r = (c.radius - margin) * std::sqrt(noise()), angle = 2 * std::numbers::pi * noise();
            x.x = r * std::cos(angle);
            x.y = r * std::sin(angle);
        }
        const auto at = near.find({int(std::floor(x.x / cell)), int(std::floor(x.y / cell)), int(std::floor(x.z / cell))});
        if (at == near.end()) continue;
        inside += std::ranges::any_of(at->second,
                                      [&](int i)
                                      {
                                          const auto& b = bed.bodies[std::size_t(i)];
                                          const auto d = shortest(c, x - b.centre);
                                          if (mag(d) > bed.reachOf(b)) return false;
                                          const Rotation back{b.rotation.w, -b.rotation.v};
                                          return bed.shapeOf(b).isSphere() || isInside(bed.shapeOf(b).mesh, back(d) / b.size);
                                      });
    }
    const double share = double(inside) / points;
    result.corePorosity = 1 - share;
    result.coreError = std::sqrt(share * (1 - share) / points);
}

}

BedMeasures measure(const SolidsPlan& plan, const Bed& bed)
{
    const auto& c = plan.container;
    BedMeasures result;
    std::vector<double> tops;
    const Slices slices(c, bed);
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        double top = bed.shapeOf(b).isSphere() ? 0.5 : 0;
        for (const auto& p : slices.turned[i].points) top = std::max(top, p.z);
        tops.push_back(b.centre.z + b.size * top);
    }
    std::ranges::sort(tops);
    result.height = plan.randomClose ? c.height : tops[std::size_t(0.9 * double(tops.size()))];
    constexpr int perSize = 8, mostLayers = 400;
    const int layers = std::clamp(int(perSize * result.height / bed.meanSize), 1, mostLayers);
    for (int k = 0; k < layers; ++k)
    {
        const double low = result.height * k / layers, high = result.height * (k + 1) / layers;
        result.layerMiddle.push_back(0.5 * (low + high));
        result.layerPorosity.push_back(slices.porosity(low, high));
    }
    const double low = 0.25 * result.height, high = 0.75 * result.height;
    result.porosity = slices.porosity(low, high);
    measureCore(c, bed, low, high, result);
    result.coordination = 2 * double(bed.contacts.size()) / double(bed.bodies.size());
    return result;
}

}
