#include "Lattice.hpp"
#include "noise.hpp"
#include <cassert>
#include <cmath>

namespace sph
{

namespace
{
/// A lattice is a stack of layers along each direction with every second site empty in some pattern.
struct Pattern
{
    Vector<3> layerSpacing; ///< for a spacing of 1
    int period;             ///< layers a cell
    bool (*occupied)(long i, long j, long k);
};

Pattern pattern(const std::string& type)
{
    const double root3 = std::sqrt(3.0);
    if (type == "hexagonal")
    {
        // a^2 sqrt(3)/2 = 1; columns a/2 apart, rows a sqrt(3)/2
        const double a = std::sqrt(2 / root3);
        return {{a / 2, a * root3 / 2, 1}, 2, [](long i, long j, long) { return (i + j) % 2 == 0; }};
    }
    if (type == "fcc")
    {
        const double half = std::cbrt(4.0) / 2;
        return {{half, half, half}, 2, [](long i, long j, long k) { return (i + j + k) % 2 == 0; }};
    }
    if (type == "bcc")
    {
        const double half = std::cbrt(2.0) / 2;
        return {{half, half, half}, 2, [](long i, long j, long k) { return i % 2 == j % 2 && j % 2 == k % 2; }};
    }
    assert(type == "cubic");
    return {{1, 1, 1}, 1, [](long, long, long) { return true; }};
}

long layersIn(double length, double layerSpacing, int period, bool periodic)
{
    if (periodic) return period * std::lround(length / (period * layerSpacing));
    return std::lround(length / layerSpacing);
}
}

const std::vector<std::string>& latticeNames(int dimension)
{
    static const std::vector<std::string> plane{"cubic", "hexagonal"}, space{"cubic", "fcc", "bcc"};
    return dimension == 2 ? plane : space;
}

Lattice makeLattice(const LatticeSpec& spec, int dimension, const Box& box, const std::array<bool, 3>& periodic)
{
    const Pattern p = pattern(spec.type);
    const Vector<3> length = box.high - box.low, step = spec.spacing * p.layerSpacing;

    Lattice lattice;
    lattice.layers = {layersIn(length.x, step.x, p.period, periodic[0]), layersIn(length.y, step.y, p.period, periodic[1]),
                      dimension == 2 ? 1 : layersIn(length.z, step.z, p.period, periodic[2])};
    const auto [nx, ny, nz] = lattice.layers;
    if (nx < 1 || ny < 1 || nz < 1) return lattice;

    const Vector<3> h{length.x / nx, length.y / ny, dimension == 2 ? 0 : length.z / nz};
    lattice.fittedSpacing = {h.x / p.layerSpacing.x, h.y / p.layerSpacing.y, h.z / p.layerSpacing.z};

    std::uint64_t counter = 0;
    const auto displacement = [&](double along) { return along * spec.jitter * (2 * noise(spec.seed, counter++) - 1); };
    for (long k = 0; k < nz; ++k)
        for (long j = 0; j < ny; ++j)
            for (long i = 0; i < nx; ++i)
            {
                if (!p.occupied(i, j, k)) continue;
                Vector<3> x = box.low + Vector<3>{(i + 0.5) * h.x, (j + 0.5) * h.y, (k + 0.5) * h.z};
                if (dimension == 2) x.z = 0;
                if (spec.jitter > 0)
                {
                    // one by one: the order in which arguments are evaluated is the compiler's
                    x.x += displacement(lattice.fittedSpacing.x);
                    x.y += displacement(lattice.fittedSpacing.y);
                    x.z += displacement(lattice.fittedSpacing.z);
                }
                lattice.points.add(x);
            }
    return lattice;
}

}
