/// The smooth part of a vector field on scattered particles: its mean over each box of a fixed grid, weighed by mass.
#pragma once
#include "base/values.hpp"
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

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
    using BoxNumber = std::array<long, dim>;
    std::map<BoxNumber, Sums> boxes;
    // Particles that lie beside one another in memory mostly lie in one box.
    auto last = boxes.end();
    const auto sumsAt = [&](std::size_t i) -> Sums&
    {
        BoxNumber box;
        for (std::size_t c = 0; c < dim; ++c) box[c] = long(std::floor(x[c][i] / size));
        if (last == boxes.end() || last->first != box) last = boxes.try_emplace(box).first;
        return last->second;
    };
    for (std::size_t i = 0; i < n; ++i)
    {
        Vector<dim> u_i;
        fetch(u_i, [&](int c) { return u[std::size_t(c)][i]; });
        auto& sums = sumsAt(i);
        sums.mass += mass[i];
        sums.momentum += mass[i] * u_i;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        const auto& sums = sumsAt(i);
        store(1 / sums.mass * sums.momentum, [&](int c, double value) { u[std::size_t(c)][i] = value; });
    }
}

}
