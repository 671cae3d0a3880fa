/// Sums over the neighbours of a particle on a cubic lattice.
#pragma once
#include "kernels/Kernel.hpp"
#include <cmath>

namespace sph
{

/// sum_j f(r_ij) over the places of a cubic lattice of spacing dx within the support of the kernel, j = i included.
template<int dim> double sumOverLattice(const Kernel<dim>& kernel, double dx, const auto& f)
{
    const int n = int(kernel.support() / dx) + 1;
    double sum = 0;
    for (int i = -n; i <= n; ++i)
        for (int k = -n; k <= n; ++k)
            for (int l = dim == 3 ? -n : 0; l <= (dim == 3 ? n : 0); ++l) sum += f(dx * std::sqrt(double(i * i + k * k + l * l)));
    return sum;
}

/// M = -1/d sum_j r_j W'(r_j) of a particle on it: what normalises gradients (operators/KernelMoment.hpp) [1/m^d].
template<int dim> double momentOnLattice(const Kernel<dim>& kernel, double spacing)
{
    return sumOverLattice(kernel, spacing, [&](double r) { return -kernel.dWdrOverR(r) * sqr(r) / dim; });
}

}
