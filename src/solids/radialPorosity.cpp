#include "solids/BedReport.hpp"
#include "solids/SolidIndicator.hpp"
#include <algorithm>

namespace sph
{

namespace
{

/// Area of a sphere of radius R on the cylinder of radius r between two heights; the centre lies at the distance c from the axis and at the height z.
double areaOnCylinder(double R, double c, double z, double r, double low, double high)
{
    const auto height = [&](double theta)
    {
        const double square = R * R - c * c - r * r + 2 * c * r * std::cos(theta), half = std::sqrt(std::max(0.0, square));
        return std::max(0.0, std::min(high, z + half) - std::max(low, z - half));
    };
    if (std::abs(c - r) >= R) return 0;
    constexpr int n = 32;
    double sum = 0;
    if (c + r <= R) // all round the axis
    {
        for (int k = 0; k < n; ++k) sum += height((k + 0.5) * std::numbers::pi / n);
        return 2 * r * sum * std::numbers::pi / n;
    }
    // theta = largest sin u: the root at the end becomes smooth, and the rule of midpoints converges as for a periodic function.
    const double largest = std::acos(std::clamp((c * c + r * r - R * R) / (2 * c * r), -1.0, 1.0)), du = 0.5 * std::numbers::pi / n;
    for (int k = 0; k < n; ++k)
    {
        const double u = (k + 0.5) * du;
        sum += height(largest * std::sin(u)) * largest * std::cos(u);
    }
    return 2 * r * sum * du;
}

void ofSpheres(const Bed& bed, double low, double high, double thickness, std::vector<RadialShell>& shells)
{
    // Gauss's rule of four points, over a shell
    constexpr std::array<double, 4> place{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526},
        weight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
    for (auto& shell : shells)
    {
        double solid = 0;
        for (const auto& b : bed.bodies)
        {
            const double R = 0.5 * b.size, c = std::hypot(b.centre.x, b.centre.y);
            if (std::abs(c - shell.radius) >= R + 0.5 * thickness || b.centre.z + R <= low || b.centre.z - R >= high) continue;
            // The area grows from nothing at the sphere's least distance from the axis and falls to nothing at its largest.
            const double from = std::max(shell.radius - 0.5 * thickness, c - R), to = std::min(shell.radius + 0.5 * thickness, c + R);
            const double half = 0.5 * (to - from);
            for (std::size_t k = 0; k < place.size(); ++k)
                solid += half * weight[k] * areaOnCylinder(R, c, b.centre.z, 0.5 * (from + to) + half * place[k], low, high);
        }
        shell.porosity = 1 - solid / (2 * std::numbers::pi * shell.radius * thickness * (high - low));
    }
}

void bySampling(const SolidContainer& c, const Bed& bed, double low, double high, double thickness, std::vector<RadialShell>& shells)
{
    const SolidIndicator isSolid(c, bed);
    const int points = std::clamp(int(2e8 / double(isSolid.mostFacets() * shells.size())), 1'000, 10'000);
    Noise noise(0);
    for (auto& shell : shells)
    {
        int inside = 0;
        const double inner = shell.radius - 0.5 * thickness, outer = shell.radius + 0.5 * thickness;
        for (int k = 0; k < points; ++k)
        {
            const double r = std::sqrt(noise.between(inner * inner, outer * outer)), angle = 2 * std::numbers::pi * noise();
            inside += isSolid({r * std::cos(angle), r * std::sin(angle), noise.between(low, high)});
        }
        const double share = double(inside) / points;
        shell.porosity = 1 - share;
        shell.error = std::sqrt(share * (1 - share) / points);
    }
}

}

std::vector<RadialShell> radialPorosity(const SolidContainer& c, const Bed& bed, double low, double high)
{
    const bool allSpheres = std::ranges::all_of(bed.shapes, &SolidShape::isSphere);
    const int perSize = allSpheres ? 20 : 8;
    const int n = std::max(1, int(std::lround(perSize * c.radius / bed.meanSize)));
    const double thickness = c.radius / n;
    std::vector<RadialShell> shells;
    for (int k = 0; k < n; ++k) shells.push_back({.radius = (k + 0.5) * thickness});
    if (allSpheres) ofSpheres(bed, low, high, thickness, shells);
    else bySampling(c, bed, low, high, thickness, shells);
    return shells;
}

}
