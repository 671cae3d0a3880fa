#include "models/gas/AmbientGas.hpp"
#include "kernels/overLattice.hpp"

namespace sph
{

GasAtRest GasAtRest::of(double density, const std::string& kernel, int dimension, double H, double spacing)
{
    return {density, dimension == 2 ? momentOnLattice(Kernel<2>(kernel, H), spacing) : momentOnLattice(Kernel<3>(kernel, H), spacing)};
}

}
