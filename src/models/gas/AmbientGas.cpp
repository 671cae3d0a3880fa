#include "models/gas/AmbientGas.hpp"
#include "kernels/Kernel.hpp"

namespace sph
{

namespace
{
template<int dim> double momentOnLattice(const Kernel<dim>& kernel, double dx)
{
    const int n = int(kernel.support() / dx) + 1;
    double sum = 0;
    for (int i = -n; i <= n; ++i)
        for (int k = -n; k <= n; ++k)
            for (int l = dim == 3 ? -n : 0; l <= (dim == 3 ? n : 0); ++l)
            {
                const double square = sqr(dx) * (i * i + k * k + l * l);
                sum -= kernel.dWdrOverR(std::sqrt(square)) * square / dim;
            }
    return sum;
}
}

GasAtRest GasAtRest::of(double density, const std::string& kernel, int dimension, double H, double spacing)
{
    return {density, dimension == 2 ? momentOnLattice(Kernel<2>(kernel, H), spacing) : momentOnLattice(Kernel<3>(kernel, H), spacing)};
}

}
