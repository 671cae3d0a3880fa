#include "soilTerms.hpp"
#include "ActingStress.hpp"
#include "SoilViscosity.hpp"
#include "StressDivergence.hpp"
#include "StressNoise.hpp"

namespace sph
{

namespace
{
/// The symmetric form: StressDivergence.hpp.
struct SoilStressDivergence : DivergenceOf<ActingStress>
{
    static constexpr auto name = "soilStressDivergence";
};
}

template<int dim> Catalogue<dim> soilTerms()
{
    return catalogue<dim, StressOnNeighbours, MeanPressure, SoilStressDivergence, SoilViscosity, StressOffLine>();
}

template Catalogue<2> soilTerms<2>();
template Catalogue<3> soilTerms<3>();

}
