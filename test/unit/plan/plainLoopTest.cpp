/// Planned evaluation of the fields that all models read against plain loops; and the comparison itself.
#include "PlainSums.hpp"
#include <gtest/gtest-spi.h>
#include <limits>

namespace sph::test
{
namespace
{

// The comparison itself: a NaN shows, in the first particle, the last, or one that sound ones come after.
TEST(PlainLoop, ComparesWithNaN)
{
    Scene<2> s(periodicBox(2), firstPhases(threePhases(2, 0.05, 2.6), 1), {"numberDensity", "summedDensity"});
    double* const rho = s.store.component("rho", 0);
    const auto wanted = [&, sound = std::vector<double>(rho, rho + s.n)](std::size_t i) { return sound[i]; };
    expectEqual(s, Density{}, wanted);
    for (const std::size_t at : {std::size_t(0), s.n / 2, s.n - 1})
    {
        rho[at] = std::numeric_limits<double>::quiet_NaN();
        EXPECT_NONFATAL_FAILURE(expectEqual(s, Density{}, wanted), "worst at particle " + std::to_string(at));
        rho[at] = wanted(at);
    }
    expectEqual(s, Density{}, wanted);
}

template<int dim> void derivedFields()
{
    onEveryGeometry<dim>(
        [](Geometry g)
        {
            Scene<dim> s(std::move(g), coefficients<dim>(3), with(summed, {"secondMoment", "particleShifting"}));
            const Plain<dim> plain(s);
            expectEqual(s, Volume{}, [&](std::size_t i) { return plain.V[i]; });
            expectEqual(s, Density{}, [&](std::size_t i) { return plain.rho[i]; });
            // p = B ((rho/rho_0)^n - 1) takes a difference of near equals.
            expectEqual(
                s, Pressure{}, [&](std::size_t i) { return plain.p[i]; }, 1e-11);
            expectEqual(s, KernelMoment{}, [&](std::size_t i) { return plain.M[i]; });
            expectEqual(s, ShiftDirection{},
                        [&](std::size_t i)
                        {
                            Vector<dim> sum;
                            overPairs(s, i, [&](std::size_t, auto, double, double, auto gradW) { sum += gradW; });
                            return -2 * plain.V[i] * sum;
                        });
        });
}
TEST(PlainLoop, DerivedFieldsIn2D) { derivedFields<2>(); }
TEST(PlainLoop, DerivedFieldsIn3D) { derivedFields<3>(); }

}
}
