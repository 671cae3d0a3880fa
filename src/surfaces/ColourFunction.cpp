#include "surfaces/ColourFunction.hpp"
#include "kernels/Kernel.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sph
{

double PhaseParticles::phaseVolume() const
{
    double sum = 0;
    for (std::size_t j = 0; j < size(); ++j)
        if (inPhase[j]) sum += volume[j];
    return sum;
}

bool PhaseParticles::hasOtherPhase() const { return std::find(inPhase.begin(), inPhase.end(), 0) != inPhase.end(); }

namespace
{

/// Part of a whole kernel below which the quotient of two small sums says little: the node takes its value from its neighbours.
constexpr double leastCover = 0.05;

struct Sample
{
    std::array<double, 3> x;
    double volume, phaseVolume;
};

/// Particles wrapped into the domain and their periodic images within `reach` of it, sorted by layers of the grid's last
/// direction.
struct Layers
{
    std::vector<Sample> samples;
    std::vector<std::size_t> begin; ///< of layer b, which holds the samples between nodes b - offset and b - offset + 1
    int offset;
};

std::array<double, 3> array(const Vector<3>& v) { return {v.x, v.y, v.z}; }

template<int dim> std::vector<Sample> withImages(const RegularGrid& grid, const PhaseParticles& particles, double reach)
{
    const auto low = array(grid.low), high = array(grid.high());
    std::array<int, 3> copies{};
    for (int d = 0; d < dim; ++d)
        if (grid.periodic[d]) copies[d] = int(std::ceil(reach / (high[d] - low[d])));

    std::vector<Sample> samples;
    samples.reserve(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
        auto x = array(particles.position[p]);
        if (dim == 2) x[2] = 0;
        for (int d = 0; d < dim; ++d)
            if (const double L = high[d] - low[d]; grid.periodic[d]) x[d] -= L * std::floor((x[d] - low[d]) / L);
        const double volume = particles.volume[p], phaseVolume = particles.inPhase[p] ? volume : 0;
        for (int a = -copies[0]; a <= copies[0]; ++a)
            for (int b = -copies[1]; b <= copies[1]; ++b)
                for (int c = -copies[2]; c <= copies[2]; ++c)
                {
                    const std::array<int, 3> shift{a, b, c};
                    auto y = x;
                    bool near = true;
                    for (int d = 0; d < dim; ++d)
                    {
                        y[d] += shift[d] * (high[d] - low[d]);
                        near = near && y[d] > low[d] - reach && y[d] < high[d] + reach;
                    }
                    if (near) samples.push_back({y, volume, phaseVolume});
                }
    }
    return samples;
}

template<int dim> Layers layers(const RegularGrid& grid, const PhaseParticles& particles, double reach)
{
    constexpr int last = dim - 1;
    const double step = array(grid.step)[last], low = array(grid.low)[last];
    const auto samples = withImages<dim>(grid, particles, reach);
    Layers result;
    result.offset = int(std::ceil(reach / step)) + 1;
    const int count = grid.nodes[last] + 2 * result.offset;
    const auto layer = [&](const Sample& s) { return std::clamp(int(std::floor((s.x[last] - low) / step)) + result.offset, 0, count - 1); };

    result.begin.assign(count + 1, 0);
    for (const auto& s : samples) ++result.begin[layer(s) + 1];
    std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
    result.samples.resize(samples.size());
    auto next = result.begin;
    for (const auto& s : samples) result.samples[next[layer(s)]++] = s;
    return result;
}

/// Adds W of one particle to the nodes of slab `s` of the last direction; `add(node, W)`.
template<int dim> void spread(const RegularGrid& grid, const auto& kernel, double reach, const Sample& p, int s, const auto& add)
{
    const auto low = array(grid.low), step = array(grid.step);
    constexpr int last = dim - 1;
    const auto range = [&](int axis, double half)
    {
        const int from = int(std::ceil((p.x[axis] - half - low[axis]) / step[axis]));
        const int to = int(std::floor((p.x[axis] + half - low[axis]) / step[axis]));
        return std::pair(std::max(from, 0), std::min(to, grid.nodes[axis] - 1));
    };
    const double inSlab = sqr(reach) - sqr(low[last] + s * step[last] - p.x[last]);
    if (inSlab <= 0) return;
    auto [fromJ, toJ] = dim == 3 ? range(1, std::sqrt(inSlab)) : std::pair(s, s);
    for (int j = fromJ; j <= toJ; ++j)
    {
        const double inRow = dim == 3 ? inSlab - sqr(low[1] + j * step[1] - p.x[1]) : inSlab;
        if (inRow <= 0) continue;
        const auto [fromI, toI] = range(0, std::sqrt(inRow));
        const std::size_t row = grid.index(0, j, dim == 3 ? s : 0);
        for (int i = fromI; i <= toI; ++i)
            add(row + i, kernel.W(std::sqrt(std::max(0.0, sqr(reach) - inRow + sqr(low[0] + i * step[0] - p.x[0])))));
    }
}

template<int dim>
void sums(const RegularGrid& grid, const PhaseParticles& particles, const Kernel<dim>& kernel, bool wantTotal, std::vector<double>& phase,
          std::vector<double>& total)
{
    const double reach = kernel.support();
    const auto sorted = layers<dim>(grid, particles, reach);
    phase.assign(grid.size(), 0);
    if (wantTotal) total.assign(grid.size(), 0);
    const auto sumWith = [&](const auto& chosen)
    {
#pragma omp parallel for schedule(dynamic)
        for (int s = 0; s < grid.nodes[dim - 1]; ++s)
        {
            const int from = std::max(0, s), to = std::min<int>(sorted.begin.size() - 1, s + 2 * sorted.offset);
            for (std::size_t p = sorted.begin[from]; p < sorted.begin[to]; ++p)
            {
                const auto& sample = sorted.samples[p];
                spread<dim>(grid, chosen, reach, sample, s,
                            [&](std::size_t node, double W)
                            {
                                phase[node] += sample.phaseVolume * W;
                                if (wantTotal) total[node] += sample.volume * W;
                            });
            }
        }
    };
    std::visit(sumWith, kernel.choice());
}

/// The part of the kernel around each node that lies in the domain and outside solids: the grid itself is the quadrature, each
/// node weighted by the part of its cell that is fluid.
template<int dim> std::vector<double> fluidPart(const RegularGrid& grid, const std::vector<double>& wallDistance, const Kernel<dim>& kernel)
{
    const double reach = kernel.support();
    const auto step = array(grid.step);
    struct Offset
    {
        std::array<int, 3> by;
        double W;
    };
    std::vector<Offset> stencil;
    std::array<int, 3> m{};
    for (int d = 0; d < dim; ++d) m[d] = int(reach / step[d]);
    double whole = 0;
    for (int k = -m[2]; k <= m[2]; ++k)
        for (int j = -m[1]; j <= m[1]; ++j)
            for (int i = -m[0]; i <= m[0]; ++i)
                if (const double W = kernel.W(std::sqrt(sqr(i * step[0]) + sqr(j * step[1]) + sqr(k * step[2]))); W > 0)
                {
                    stencil.push_back({{i, j, k}, W});
                    whole += W;
                }
    for (auto& offset : stencil) offset.W /= whole;

    const auto& n = grid.nodes;
    const double cell = grid.smallestStep();
    const auto nearFace = [&](int axis, int i) { return !grid.periodic[axis] && axis < dim && (i < m[axis] || i > n[axis] - 1 - m[axis]); };
    std::vector<double> part(grid.size(), 1);
#pragma omp parallel for schedule(dynamic, 16)
    for (int row = 0; row < n[1] * n[2]; ++row)
        for (int i = 0; i < n[0]; ++i)
        {
            const int j = row % n[1], k = row / n[1];
            const std::size_t here = grid.index(i, j, k);
            const bool nearWall = !wallDistance.empty() && wallDistance[here] < reach + cell;
            if (!nearWall && !nearFace(0, i) && !nearFace(1, j) && !nearFace(2, k)) continue;
            double sum = 0;
            for (const auto& [by, W] : stencil)
            {
                const std::array<int, 3> at{grid.wrapped(0, i + by[0]), grid.wrapped(1, j + by[1]), grid.wrapped(2, k + by[2])};
                if (at[0] < 0 || at[1] < 0 || at[2] < 0) continue;
                double fluid = wallDistance.empty() ? 1 : std::clamp(0.5 + wallDistance[grid.index(at[0], at[1], at[2])] / cell, 0.0, 1.0);
                for (int d = 0; d < dim; ++d)
                    if (!grid.periodic[d] && (at[d] == 0 || at[d] == n[d] - 1)) fluid *= 0.5;
                sum += W * fluid;
            }
            part[here] = sum;
        }
    return part;
}

/// Divides, and where `cover` is too small continues the quotient outwards, a layer of nodes at a time, by the mean of the known
/// neighbours: into solids and into clefts that no particle enters. Nodes deeper in a solid than `depth` stay 0.
void divideAndContinue(const RegularGrid& grid, const std::vector<double>& wallDistance, const std::vector<double>& cover, double depth,
                       std::vector<double>& value)
{
    std::vector<char> known(grid.size());
    std::vector<std::size_t> open;
    for (std::size_t node = 0; node < grid.size(); ++node)
    {
        known[node] = cover[node] >= leastCover;
        value[node] = known[node] ? value[node] / cover[node] : 0;
        if (!known[node] && (wallDistance.empty() || wallDistance[node] > -depth)) open.push_back(node);
    }
    const auto& n = grid.nodes;
    while (!open.empty())
    {
        std::vector<double> found(open.size(), -1);
#pragma omp parallel for
        for (std::size_t o = 0; o < open.size(); ++o)
        {
            const int i = open[o] % n[0], j = open[o] / n[0] % n[1], k = open[o] / n[0] / n[1];
            double sum = 0;
            int count = 0;
            for (int c = -1; c <= 1; ++c)
                for (int b = -1; b <= 1; ++b)
                    for (int a = -1; a <= 1; ++a)
                    {
                        const int ii = grid.wrapped(0, i + a), jj = grid.wrapped(1, j + b), kk = grid.wrapped(2, k + c);
                        if (ii < 0 || jj < 0 || kk < 0 || !known[grid.index(ii, jj, kk)]) continue;
                        sum += value[grid.index(ii, jj, kk)];
                        ++count;
                    }
            if (count > 0) found[o] = sum / count;
        }
        std::vector<std::size_t> rest;
        for (std::size_t o = 0; o < open.size(); ++o)
            if (found[o] >= 0)
            {
                value[open[o]] = found[o];
                known[open[o]] = 1;
            }
            else rest.push_back(open[o]);
        if (rest.size() == open.size()) break;
        open.swap(rest);
    }
}

template<int dim>
std::vector<double> evaluate(const RegularGrid& grid, const std::vector<double>& wallDistance, const PhaseParticles& particles,
                             const std::string& kernelName, double support, Normalisation normalisation)
{
    const Kernel<dim> kernel(kernelName, support);
    std::vector<double> phase, total;
    sums(grid, particles, kernel, normalisation == Normalisation::particles, phase, total);
    if (normalisation == Normalisation::none) return phase;
    if (normalisation == Normalisation::walls) total = fluidPart(grid, wallDistance, kernel);
    divideAndContinue(grid, wallDistance, total, 3 * grid.largestStep(), phase);
    return phase;
}

}

std::vector<double> colourFunction(const RegularGrid& grid, const std::vector<double>& wallDistance, const PhaseParticles& particles,
                                   const std::string& kernel, double support, Normalisation normalisation)
{
    return grid.dimension == 2 ? evaluate<2>(grid, wallDistance, particles, kernel, support, normalisation)
                               : evaluate<3>(grid, wallDistance, particles, kernel, support, normalisation);
}

}
