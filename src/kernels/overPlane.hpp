/// Sums of a kernel over a plane.
#pragma once
#include "kernels/Kernel.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

/// int W dA over a plane at a distance z [m] from the particle, a line in 2-D [1/m], by strips of a 2000th of the support.
template<int dim> double integralOverPlane(const Kernel<dim>& kernel, double z = 0)
{
    constexpr int strips = 2000;
    const double width = kernel.support() / strips;
    double sum = 0;
    for (int k = 0; k < strips; ++k)
    {
        const double x = (k + 0.5) * width;
        sum += kernel.W(std::sqrt(x * x + z * z)) * (dim == 3 ? 2 * std::numbers::pi * x : 2) * width;
    }
    return sum;
}

}
