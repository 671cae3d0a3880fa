/// The smooth part of a vector field on scattered particles: its mean over each box of a fixed grid, weighed by mass.
#pragma once
#include "base/values.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace sph
{

/// u_i = sum_b m_j u_j/sum_b m_j over the particles j of the box b that holds x_i; boxes of `size` [m] begin at the origin. The sum of m u over each
/// box stays, and what is uniform stays as it is. Where ranks share the particles, each averages over its own.
template<int dim>
void averageInBoxes(const std::array<double*, dim>& u, const std::array<const double*, dim>& x, const double* mass, std::size_t n,
                    double size)
{
    struct Sums
    {
        double mass = 0;
        Vector<dim> momentum;
    };
    // Particles that follow one another in memory mostly lie in one box: all threads find such runs, whose sums are then taken in the order of the particles.
    using BoxNumber = std::array<long, dim>;
    struct Run
    {
        std::size_t begin, end;
        BoxNumber box;
        Sums* sums = nullptr;
    };
    constexpr std::size_t block = 1024;
    std::vector<std::vector<Run>> runs((n + block - 1) / block);
#pragma omp parallel for schedule(static)
    for (std::size_t b = 0; b < runs.size(); ++b)
        for (std::size_t i = b * block; i < std::min(n, (b + 1) * block); ++i)
        {
            BoxNumber box;
            for (std::size_t c = 0; c < dim; ++c) box[c] = long(std::floor(x[c][i] / size));
            if (runs[b].empty() || runs[b].back().box != box) runs[b].push_back({i, i, box});
            runs[b].back().end = i + 1;
        }
    std::map<BoxNumber, Sums> boxes;
    for (auto& ofBlock : runs)
        for (auto& run : ofBlock)
        {
            run.sums = &boxes[run.box];
            for (std::size_t i = run.begin; i < run.end; ++i)
            {
                run.sums->mass += mass[i];
                run.sums->momentum += mass[i] * valueAt<Vector<dim>>(u, i);
            }
        }
#pragma omp parallel for schedule(static)
    for (std::size_t b = 0; b < runs.size(); ++b)
        for (const auto& run : runs[b])
        {
            const auto mean = 1 / run.sums->mass * run.sums->momentum;
            for (std::size_t i = run.begin; i < run.end; ++i) store(mean, [&](int c, double value) { u[std::size_t(c)][i] = value; });
        }
}

}
