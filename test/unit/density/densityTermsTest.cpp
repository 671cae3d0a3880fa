/// The continuity equation, its diffusion and relaxation against plain loops.
#include "PlainSums.hpp"
#include "models/density/DensityRelaxation.hpp"

namespace sph::test
{
namespace
{

template<int dim> void continuityEquation()
{
    onEveryGeometry<dim>(
        [](Geometry g)
        {
            auto c = coefficients<dim>(1);
            Scene<dim> s(std::move(g), c, with(integrated, {"densityDiffusion"}), true);
            s.refresh(Velocity{});
            s.refresh(Density{});
            s.refresh(Volume{});
            const double h = 0.5 * c.support;
            expectEqual(
                s, DensityRate{},
                [&](std::size_t i)
                {
                    double rate = 0;
                    const double rho_i = s.at(Density{}, i);
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double r, double, auto gradW)
                              {
                                  const double rho_j = s.at(Density{}, j), V_j = s.at(Volume{}, j);
                                  rate += rho_i * V_j * dot(s.at(Velocity{}, i) - s.at(Velocity{}, j), gradW);
                                  rate += 0.1 * h * c.soundSpeed[0] * 2 * (rho_i - rho_j) * dot(x, gradW) / (r * r + 0.01 * h * h) * V_j;
                              });
                    return rate;
                },
                1e-11);
            for (std::size_t i = 0; i < s.n; ++i) ASSERT_NEAR(s.at(Volume{}, i) * s.at(Density{}, i) / s.at(Mass{}, i), 1, 1e-14);
        });
}
TEST(DensityTerms, ContinuityWithDiffusionIn2D) { continuityEquation<2>(); }
TEST(DensityTerms, ContinuityWithDiffusionIn3D) { continuityEquation<3>(); }

template<int dim> void continuityByMass()
{
    onEveryGeometry<dim>(
        [](Geometry g)
        {
            Scene<dim> s(std::move(g), coefficients<dim>(1), {"integratedVolume", "massContinuity"}, true);
            s.refresh(Velocity{});
            s.refresh(Mass{});
            expectEqual(
                s, DensityRate{},
                [&](std::size_t i)
                {
                    double rate = 0;
                    overPairs(s, i,
                              [&](std::size_t j, auto, double, double, auto gradW)
                              { rate += s.at(Mass{}, j) * dot(s.at(Velocity{}, i) - s.at(Velocity{}, j), gradW); });
                    return rate;
                },
                1e-11);
        });
}
TEST(DensityTerms, ContinuityByMassIn2D) { continuityByMass<2>(); }
TEST(DensityTerms, ContinuityByMassIn3D) { continuityByMass<3>(); }

/// Inside, where the places of the particles make another density than the integrated one, and the fluid half of it; both signs and the surface occur.
template<int dim> void densityRelaxation()
{
    onEveryGeometry<dim>(
        [](Geometry g)
        {
            auto c = coefficients<dim>(1);
            c.set(RelaxationTime{50});
            Scene<dim> s(std::move(g), c, {"integratedVolume", "densityRelaxation"}, true);
            for (std::size_t i = 0; i < s.n; ++i) s.store.component("rho", 0)[i] *= 1 + 0.1 * std::sin(double(i));
            s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
            s.refresh(Volume{});
            const auto wall = wallsBehind(s);
            int thin = 0, dense = 0, even = 0;
            expectEqual(
                s, DensityRate{},
                [&](std::size_t i)
                {
                    const double rho = s.at(Density{}, i);
                    double number = 0, ofFluid = 0;
                    Vector<dim> slope;
                    overPairs(s, i,
                              [&](std::size_t j, auto, double, double W, auto gradW)
                              {
                                  number += W;
                                  if (wall[j] <= 0) ofFluid += W;
                                  slope += s.at(Volume{}, j) * gradW;
                              });
                    const double difference = s.at(Mass{}, i) * number - rho;
                    if (ofFluid <= 0.5 * number || mag(slope) * c.support >= 0.2 || difference <= -0.5 * rho ||
                        std::abs(difference) <= 0.02 * rho)
                        return ++even, 0.0;
                    ++(difference < 0 ? thin : dense);
                    return c.soundSpeed[0] / (50 * 0.5 * c.support) * (difference < 0 ? difference + 0.02 * rho : difference - 0.02 * rho);
                },
                1e-11);
            EXPECT_GT(thin, 0);
            EXPECT_GT(dense, 0);
            EXPECT_GT(even, 0);
        });
}
TEST(DensityTerms, DensityRelaxationIn2D) { densityRelaxation<2>(); }
TEST(DensityTerms, DensityRelaxationIn3D) { densityRelaxation<3>(); }

// Alone in a box of a spacing a particle lies between images of its own, which fill all that is around it: whatever its density, these do not change it.
TEST(DensityRelaxation, DoesNotFollowAParticlesOwnImages)
{
    auto c = coefficients<2>(1);
    c.set(RelaxationTime{50});
    const double L = c.spacing;
    Geometry g = domain(2, {L, L, 0});
    addWall(g, Plane({0, 0, 0}, {1, 0, 0}));
    addWall(g, Plane({L, 0, 0}, {-1, 0, 0}));
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    addWall(g, Plane({0, L, 0}, {0, -1, 0}));
    Scene<2> s(std::move(g), c, {"integratedVolume", "densityRelaxation"}, true);
    ASSERT_EQ(s.n, 1u);
    for (int d = 0; d < 2; ++d) s.store.component("positions", d)[0] = 0.5 * L;
    s.images.move(s.store);
    s.store.component("rho", 0)[0] *= 0.8;
    s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
    double number = 0;
    overPairs(s, 0, [&](std::size_t, auto, double, double W, auto) { number += W; });
    EXPECT_GT(s.at(Mass{}, 0) * number, 1.1 * s.at(Density{}, 0)); // they would
    EXPECT_EQ(s.at(DensityRate{}, 0), 0);
}

/// The renormalised gradient, over the fluid and its periodic images alone, and the diffusion of what it leaves.
template<int dim> void renormalisedDiffusion()
{
    onEveryGeometry<dim>(
        [](Geometry g)
        {
            auto c = coefficients<dim>(1);
            Scene<dim> s(std::move(g), c, {"integratedVolume", "renormalisedDiffusion"}, true);
            s.refresh(Density{});
            s.refresh(Volume{});
            const auto wall = wallsBehind(s);
            const auto rho = [&](std::size_t j) { return s.at(Density{}, j); };
            expectEqual(
                s, DensityGradient{},
                [&](std::size_t i)
                {
                    SymmTensor<dim> B{};
                    Vector<dim> sum;
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double, double, auto gradW)
                              {
                                  if (wall[j] > 0) return;
                                  B += -0.5 * s.at(Volume{}, j) * twiceSymm(x, gradW);
                                  sum += s.at(Volume{}, j) * (rho(j) - rho(i)) * gradW;
                              });
                    return 1 / determinant(B) * (adjugate(B) * sum);
                },
                1e-11);
            s.refresh(DensityGradient{});
            const double h = 0.5 * c.support;
            expectEqual(
                s, DensityRate{},
                [&](std::size_t i)
                {
                    double rate = 0;
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double r, double, auto gradW)
                              {
                                  if (wall[j] > 0) return;
                                  const auto mean = 0.5 * (s.at(DensityGradient{}, i) + s.at(DensityGradient{}, j));
                                  rate += 0.1 * h * c.soundSpeed[0] * 2 * (rho(i) - rho(j) - dot(mean, x)) * dot(x, gradW) /
                                          (r * r + 0.01 * h * h) * s.at(Volume{}, j);
                              });
                    return rate;
                },
                1e-11);
        });
}
TEST(DensityTerms, RenormalisedDiffusionIn2D) { renormalisedDiffusion<2>(); }
TEST(DensityTerms, RenormalisedDiffusionIn3D) { renormalisedDiffusion<3>(); }

/// Nothing diffuses in a linear density, on a floor and below a free surface: to round-off of what the form without a gradient does.
TEST(RenormalisedDiffusion, leavesALinearDensityAlone)
{
    Geometry g = domain(2, {1, 1, 0}, {true, false, false}); // no lid: the lattice ends in a free surface
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    const auto largestRate = [&](const char* term)
    {
        Scene<2> s(g, coefficients<2>(1), {"integratedVolume", term}, true);
        for (std::size_t i = 0; i < s.n; ++i) s.store.component("rho", 0)[i] = 1000 - 30 * positionOf(s.store, i).y;
        s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
        Largest most;
        for (std::size_t i = 0; i < s.n; ++i) most(s.at(DensityRate{}, i));
        return most.value();
    };
    EXPECT_LT(largestRate("renormalisedDiffusion"), 1e-11 * largestRate("densityDiffusion"));
}

}
}
