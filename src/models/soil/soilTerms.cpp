#include "soilTerms.hpp"
#include "ActingStress.hpp"
#include "SoilViscosity.hpp"
#include "StressDivergence.hpp"
#include "StressNoise.hpp"
#include "VelocityGradient.hpp"

namespace sph
{

namespace
{
/// D = sym(grad v) [1/s]
struct StrainRateOfGradient
{
    static constexpr auto name = "strainRate";
    using Provides = StrainRate;
    using ReadsOwn = Fields<VelocityGradient>;
    auto operator()(const auto& i) const { return symm(i.L); }
};

/// The symmetric form: StressDivergence.hpp.
struct SoilStressDivergence : DivergenceOf<ActingStress>
{
    static constexpr auto name = "soilStressDivergence";
};
struct SoilStressDifference : DifferenceDivergenceOf<ActingStress>
{
    static constexpr auto name = "soilStressDifference";
    using DifferenceDivergenceOf::DifferenceDivergenceOf;
};
struct SoilStressAtSurface : SurfaceDivergenceOf<ActingStress>
{
    static constexpr auto name = "soilStressAtSurface";
    using SurfaceDivergenceOf::SurfaceDivergenceOf;
};
}

template<int dim> Catalogue<dim> soilTerms()
{
    return catalogue<dim, StressOnNeighbours, MeanPressure, SoilStressDivergence, SoilStressDifference, SoilStressAtSurface, SoilViscosity,
                     StressOffLine, StrainRateOfGradient>();
}

template Catalogue<2> soilTerms<2>();
template Catalogue<3> soilTerms<3>();

}
