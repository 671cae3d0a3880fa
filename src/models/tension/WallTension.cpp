#include "models/tension/WallTension.hpp"
#include "kernels/Kernel.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

namespace
{
template<int dim> std::vector<double> marginalIn(const Kernel<dim>& kernel, double H)
{
    std::vector<double> w(257);
    const int panels = 400;
    for (std::size_t k = 0; k < w.size(); ++k)
    {
        const double d = H * double(k) / double(w.size() - 1), reach = std::sqrt(std::max(0.0, H * H - d * d)), step = reach / panels;
        for (int q = 0; q < panels; ++q)
        {
            const double t = (q + 0.5) * step, element = dim == 2 ? 2 : 2 * std::numbers::pi * t;
            w[k] += kernel.W(std::hypot(d, t)) * element * step;
        }
    }
    return w;
}
}

KernelMarginal KernelMarginal::of(const std::string& kernel, int dimension, double H)
{
    return {dimension == 2 ? marginalIn(Kernel<2>(kernel, H), H) : marginalIn(Kernel<3>(kernel, H), H)};
}

}
