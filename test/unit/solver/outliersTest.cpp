/// The particle that a run's error names: the one with the number that no solution has.
#include "solver/outliers.hpp"
#include "periodicSquare.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>

namespace sph::test
{
namespace
{

/// 20 x 20 particles off their lattice, at rest.
Cloud disordered()
{
    Cloud cloud;
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 20; ++k)
        {
            cloud.x.push_back((i + 0.5 + 0.1 * std::sin(i + 3 * k)) / 20);
            cloud.y.push_back((k + 0.5 + 0.1 * std::cos(2 * i - k)) / 20);
            cloud.z.push_back(0);
        }
    return cloud;
}

struct Scene
{
    Geometry geometry = periodicSquare();
    Settings settings = settingsOf(channelCase());
    std::unique_ptr<AnySimulation> simulation;
    explicit Scene(double gravity = 1)
    {
        settings.coefficients.g = {gravity, 0, 0};
        simulation = makeSimulation(settings, geometry, disordered(), {});
    }
};

TEST(Outliers, AreNoneInASoundState)
{
    const Scene s;
    EXPECT_FALSE(notFinite(*s.simulation));
    EXPECT_FALSE(impossibleDensity(*s.simulation, {1000}));
}

// The one of the largest acceleration, where that sets the limit; nobody, where constants of the scene do.
TEST(Outliers, NameTheParticleThatTheStepWaitsFor)
{
    const Scene s;
    const auto a = s.simulation->field("dUdt").component;
    std::size_t most = 0;
    const auto size = [&](std::size_t i) { return std::hypot(a[0][i], a[1][i]); };
    for (std::size_t i = 0; i < 400; ++i)
        if (size(i) > size(most)) most = i;
    const auto found = binding(*s.simulation, {1, "force", true, &Acceleration::info});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->particle, most);
    EXPECT_DOUBLE_EQ(found->value, size(most));
    EXPECT_EQ(found->inWords().find(fmt::format("particle {} at (", most)), 0u) << found->inWords();
    EXPECT_FALSE(binding(*s.simulation, {1, "capillary"}));
    const auto limits = s.simulation->stepLimits();
    EXPECT_TRUE(
        std::ranges::any_of(limits, [](const StepLimit& limit) { return limit.by == "force" && limit.field == &Acceleration::info; }));
    EXPECT_TRUE(std::ranges::any_of(limits, [](const StepLimit& limit) { return limit.by == "sound" && !limit.field; }));
}

// Against another density at rest all are impossible: the furthest is the densest, or the least dense.
TEST(Outliers, AreTheFurthestDensities)
{
    const Scene s;
    const auto rho = s.simulation->field("rho").component[0], x = s.simulation->positions().component[0];
    const auto most = std::size_t(std::max_element(rho, rho + 400) - rho), least = std::size_t(std::min_element(rho, rho + 400) - rho);
    ASSERT_NE(most, least);
    const auto dense = impossibleDensity(*s.simulation, {200}), thin = impossibleDensity(*s.simulation, {2e6});
    ASSERT_TRUE(dense && thin);
    EXPECT_EQ(dense->particle, most);
    EXPECT_EQ(dense->value, rho[most]);
    EXPECT_EQ(dense->position.x, x[most]);
    EXPECT_EQ(dense->inWords().find(fmt::format("particle {} at (0.", most)), 0u) << dense->inWords();
    EXPECT_EQ(thin->particle, least);
    for (const double rest : {std::numeric_limits<double>::quiet_NaN(), -1000.0})
        EXPECT_TRUE(impossibleDensity(*s.simulation, {rest})) << rest;
}

TEST(Outliers, AreNotFinite)
{
    const Scene s(std::numeric_limits<double>::quiet_NaN());
    s.simulation->step(0, 1e-4);
    const auto found = notFinite(*s.simulation);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->particle, 0u);
    EXPECT_TRUE(std::isnan(found->value));
    EXPECT_FALSE(s.simulation->summary().finite);
}

}
}
