#include "models/pressure/stableSound.hpp"
#include "kernels/Kernel.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

namespace sph
{

namespace
{
constexpr int waves = 40;     ///< along a direction, up to the shortest that the lattice has
constexpr double longest = 2; ///< c dt/h
constexpr double finest = 1e-3;

struct Neighbour
{
    std::array<double, 3> x;
    double r, slope; ///< (dW/dr)/r
};

template<int dim> std::vector<Neighbour> latticeAround(const DampedSound& s)
{
    const Kernel<dim> kernel(s.kernel, s.support);
    const int reach = int(s.support), deep = dim == 3 ? reach : 0;
    std::vector<Neighbour> all;
    for (int k = -deep; k <= deep; ++k)
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i)
                if (const double r = std::sqrt(double(i * i + j * j + k * k)); r > 0 && r < s.support)
                    all.push_back({{double(i), double(j), double(k)}, r, kernel.dWdrOverR(r)});
    return all;
}

/// Rates of a wave over c/h.
struct Rates
{
    double w, D, A;
};

Rates ratesOf(const DampedSound& s, const std::vector<Neighbour>& lattice, const std::array<double, 3>& along, double k)
{
    const double h = 0.5 * s.support, small = 0.01 * sqr(h);
    const auto dot = [&](const Neighbour& n) { return n.x[0] * along[0] + n.x[1] * along[1] + n.x[2] * along[2]; };
    double slope = 0, moment = 0;
    for (const auto& n : lattice)
    {
        slope -= n.slope * dot(n) * std::sin(k * dot(n));
        moment -= n.slope * sqr(dot(n));
    }
    Rates rates{h * std::fabs(slope), 0, 0};
    const double g = s.renormalised ? slope / moment : 0;
    for (const auto& n : lattice)
    {
        const double F = -2 * n.slope * sqr(n.r) / (sqr(n.r) + small), phase = k * dot(n);
        rates.D += s.delta * sqr(h) * F * (1 - std::cos(phase) - 0.5 * g * dot(n) * std::sin(phase));
        rates.A += 0.5 * s.alpha * sqr(h) * F * (1 - std::cos(phase)) * sqr(dot(n) / n.r);
    }
    return rates;
}

/// The factor of q a step at dq/dt = z q, in steps: that of the larger root.
double growth(std::complex<double> z, bool extrapolates)
{
    if (!extrapolates) return std::abs(1.0 + z + 0.5 * z * z);
    const auto b = 1.0 + 1.5 * z, root = std::sqrt(b * b - 2.0 * z);
    return 0.5 * std::max(std::abs(b + root), std::abs(b - root));
}

double stableStep(const Rates& rates, bool extrapolates)
{
    const double mean = -0.5 * (rates.D + rates.A);
    const auto root = std::sqrt(std::complex<double>(sqr(0.5 * (rates.D - rates.A)) - sqr(rates.w)));
    const auto grows = [&](double step)
    { return std::max(growth(step * (mean + root), extrapolates), growth(step * (mean - root), extrapolates)) > 1 + 1e-12; };
    double step = finest;
    while (step < longest && !grows(step)) step *= 1.01;
    return step / 1.01;
}
}

double stableSoundStep(const DampedSound& s)
{
    const auto lattice = s.dimension == 3 ? latticeAround<3>(s) : latticeAround<2>(s);
    double least = longest;
    for (int directions = 1; directions <= s.dimension; ++directions)
    {
        // along an edge of the lattice's cell, the diagonal of its face and that of the cell
        const double component = 1 / std::sqrt(double(directions));
        const std::array along{component, directions > 1 ? component : 0, directions > 2 ? component : 0};
        for (int wave = 1; wave <= waves; ++wave)
            least = std::min(least, stableStep(ratesOf(s, lattice, along, std::numbers::pi / component * wave / waves), s.extrapolates));
    }
    return least < longest / 1.02 ? least : std::numeric_limits<double>::infinity();
}

}
