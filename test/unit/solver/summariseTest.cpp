/// What the log and the checks of a run see: nothing that is not finite gets lost on the way, in whichever particle and field it is.
#include "solver/summarise.hpp"
#include "periodicSquare.hpp"
#include "solver/models.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace sph::test
{
namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// 40 x 40 particles at rest on their lattice.
Cloud lattice()
{
    Cloud cloud;
    for (int i = 0; i < 40; ++i)
        for (int k = 0; k < 40; ++k)
        {
            cloud.x.push_back((i + 0.5) / 40);
            cloud.y.push_back((k + 0.5) / 40);
            cloud.z.push_back(0);
        }
    return cloud;
}

Settings settingsOfLattice(const std::string& integrator)
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.025; support 2.6; kernel wendlandC2; }\nintegration { scheme " + integrator + "; maxSubSteps 3; }\n";
    files["constant/phaseProperties"] =
        "phases (water oil);\nwater { rho 1000; mu 10; soundSpeed 15; }\noil { rho 900; mu 10; soundSpeed 15; }\nsigma ( (water oil) 1 );\n";
    return settingsOf(files);
}

TEST(Summary, IsNotFiniteWhereOneNumberIsNot)
{
    const auto settings = settingsOfLattice("symplecticEuler");
    const auto g = periodicSquare();
    auto cloud = lattice();
    auto& phase = cloud.fields["phase"].component;
    phase.resize(1);
    for (const double y : cloud.y) phase[0].push_back(y > 0.5);
    Particles<2> particles(settings, g, allTerms<2>(), cloud, {});
    ASSERT_TRUE(summarise(particles).finite);
    for (const char* field : {"U", "m", "rho", "dUdt", "dUdtSlow"})
        for (const std::size_t at : {std::size_t(0), particles.size() / 2, particles.size() - 1})
            for (const double value : {nan, std::numeric_limits<double>::infinity()})
            {
                double& number = particles.store().component(field, 0)[at];
                const double sound = std::exchange(number, value);
                EXPECT_FALSE(summarise(particles).finite) << field << " of " << at << " is " << value;
                number = sound;
            }
    EXPECT_TRUE(summarise(particles).finite);
}

// At a restart the largest acceleration is that which is seen now, be it no number.
TEST(Summary, OfARestartHasTheAccelerationThatIsSeen)
{
    auto settings = settingsOfLattice("symplecticEuler");
    settings.coefficients.g = {nan, 0, 0};
    const auto g = periodicSquare();
    auto cloud = lattice();
    auto& phase = cloud.fields["phase"].component;
    phase.assign(1, std::vector<double>(cloud.size(), 0));
    const auto simulation =
        makeSimulation(settings, g, cloud, {{"densityScale", 1.0}, {"lastObservedAcceleration", 1.0}, {"lastMaxAcceleration", 1.0}});
    EXPECT_TRUE(std::isnan(simulation->state().at("lastObservedAcceleration")));
    EXPECT_TRUE(std::isnan(simulation->summary().maxAcceleration));
}

}
}
