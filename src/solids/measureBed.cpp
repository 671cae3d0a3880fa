#include "solids/BedReport.hpp"
#include "solids/SolidIndicator.hpp"
#include <algorithm>

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
    const SolidIndicator isSolid(c, bed);
    constexpr int mostPoints = 200'000;
    const int points = std::clamp(int(5e8 / double(isSolid.mostFacets())), 10'000, mostPoints);
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
        inside += isSolid(x);
    }
    const double share = double(inside) / points;
    result.corePorosity = 1 - share;
    result.coreError = std::sqrt(share * (1 - share) / points);
}

}

double heightOf(const SolidsPlan& plan, const Bed& bed)
{
    if (plan.randomClose) return plan.container.height;
    std::vector<double> tops;
    for (const auto& b : bed.bodies)
    {
        double top = bed.shapeOf(b).isSphere() ? 0.5 : 0;
        for (const auto& p : bed.shapeOf(b).mesh.points) top = std::max(top, b.rotation(p).z);
        tops.push_back(b.centre.z + b.size * top);
    }
    std::ranges::sort(tops);
    return tops[std::size_t(0.9 * double(tops.size()))];
}

double porosityOfMiddle(const SolidsPlan& plan, const Bed& bed)
{
    const double height = heightOf(plan, bed);
    return Slices(plan.container, bed).porosity(0.25 * height, 0.75 * height);
}

BedMeasures measure(const SolidsPlan& plan, const Bed& bed)
{
    const auto& c = plan.container;
    BedMeasures result;
    const Slices slices(c, bed);
    result.height = heightOf(plan, bed);
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
    if (c.isCylinder) result.shells = radialPorosity(c, bed, low, high);
    for (const auto& b : bed.bodies) result.shrunk += b.shrunk / double(bed.bodies.size());
    result.coordination = 2 * double(bed.contacts.size()) / double(bed.bodies.size());
    measureGrains(c, bed, low, high, result);
    return result;
}

}
