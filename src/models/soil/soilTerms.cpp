#include "models/soil/soilTerms.hpp"
#include "models/soil/ActingStress.hpp"
#include "models/soil/Hourglass.hpp"
#include "models/soil/OuterWater.hpp"
#include "models/soil/Seepage.hpp"
#include "models/soil/SoilViscosity.hpp"
#include "models/soil/StressNoise.hpp"
#include "operators/BalancedGradient.hpp"
#include "operators/StressDivergence.hpp"
#include "operators/VelocityGradient.hpp"

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
struct BalancedSoilStress : BalancedDivergenceOf<ActingStress>
{
    static constexpr auto name = "balancedSoilStress";
};
/// The same forms of -p I, for a change of p.
struct PoreStressDivergence : DivergenceOf<PoreStress>
{
    static constexpr auto name = "poreStressDivergence";
};
struct PoreStressDifference : DifferenceDivergenceOf<PoreStress>
{
    static constexpr auto name = "poreStressDifference";
    using DifferenceDivergenceOf::DifferenceDivergenceOf;
};
struct PoreStressAtSurface : SurfaceDivergenceOf<PoreStress>
{
    static constexpr auto name = "poreStressAtSurface";
    using SurfaceDivergenceOf::SurfaceDivergenceOf;
};
struct BalancedPoreStress : BalancedDivergenceOf<PoreStress>
{
    static constexpr auto name = "balancedPoreStress";
};
}

template<int dim> Catalogue<dim> soilTerms()
{
    return catalogue<dim, StressOnNeighbours, TotalStressOnNeighbours, MeanPressure, SoilStressDivergence, SoilStressDifference,
                     SoilStressAtSurface, BalancedSoilStress, FitOfUnstrained, HourglassForce, OffFitOfUnstrained, AdvanceUnstrained,
                     SoilViscosity, SoilNoiseViscosity, StressOffLine, StrainRateOfGradient, PoreStressDivergence, PoreStressDifference,
                     PoreStressAtSurface, BalancedPoreStress, SurfaceOfSoil, LiftOfOuterWater, PermeabilityOfSaturation, Seepage,
                     SeepageOfChange, UnsaturatedSeepage, UnsaturatedSeepageOfChange, DarcyVelocity>();
}

template Catalogue<2> soilTerms<2>();
template Catalogue<3> soilTerms<3>();

}
