#include "models/tension/depthBias.hpp"
#include "base/Vector.hpp"
#include "kernels/overPlane.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

namespace
{
constexpr int strips = 2000;
constexpr double farther = 4; ///< radius of the ball over the support

/// int W cos(angle) dA over the surface of a disc or ball of radius R, the |g| of a particle at a depth z below it; that below a plane surface is integralOverPlane.
template<int dim> double belowBall(const Kernel<dim>& kernel, double R, double z)
{
    const double r = R - z, widest = std::numbers::pi / (2 * R);
    double sum = 0;
    for (int k = 0; k < strips; ++k)
    {
        const double angle = (k + 0.5) * widest / strips;
        const double distance = std::sqrt(R * R + r * r - 2 * R * r * std::cos(angle));
        const double dA = (dim == 3 ? 2 * std::numbers::pi * R * std::sin(angle) : 2) * R * widest / strips;
        sum += kernel.W(distance) * std::cos(angle) * dA;
    }
    return sum;
}

template<int dim> double bias(const Kernel<dim>& kernel)
{
    double sum = 0;
    const auto depths = {0.1, 0.2, 0.3, 0.4, 0.5};
    for (const double z : depths)
    {
        const double g = belowBall(kernel, farther, z);
        double low = 0, high = 1;
        for (int k = 0; k < 40; ++k)
        {
            const double middle = 0.5 * (low + high);
            (integralOverPlane(kernel, middle) > g ? low : high) = middle;
        }
        sum += (z - low) * farther;
    }
    return sum / double(depths.size());
}
}

double depthBias(const std::string& kernel, int dimension)
{
    return dimension == 2 ? bias(Kernel<2>(kernel, 1)) : bias(Kernel<3>(kernel, 1));
}

}
