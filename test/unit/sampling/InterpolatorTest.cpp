#include "sampling/Interpolator.hpp"
#include "Particles.hpp"
#include <gtest/gtest.h>
#include <random>

using namespace sph;

namespace
{

/// A lattice disturbed by up to a fifth of its spacing.
Particles disturbed(int dimension, double dx)
{
    Particles particles(dimension, {0, 0, 0}, {1, 1, 1}, dx);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shift(-0.2 * dx, 0.2 * dx);
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        particles.x[i] += shift(random);
        particles.y[i] += shift(random);
        if (dimension == 3) particles.z[i] += shift(random);
    }
    return particles;
}

}

TEST(Interpolator, linearFieldsAreExactAlsoAtBoundaries)
{
    // On disturbed lattices, in the interior, at a face and in a corner: the moment condition holds to round-off times the
    // condition of the moment matrix, at most 1/2e-3.
    for (const int dimension : {2, 3})
        for (const char* kernel : {"wendlandC2", "cubicSpline", "quinticSpline"})
        {
            auto particles = disturbed(dimension, 0.1);
            particles.kernel = kernel;
            const auto field = [&](Vector<3> x) { return 3 + 2 * x.x - 5 * x.y + (dimension == 3 ? 7 * x.z : 0); };
            particles.setP(field);
            const Interpolator interpolator(particles.view());
            for (const Vector<3> x : {Vector<3>{0.52, 0.47, 0.51}, {0.01, 0.5, 0.5}, {0.02, 0.98, 0.03}})
            {
                const Vector<3> at{x.x, x.y, dimension == 3 ? x.z : 0};
                EXPECT_NEAR(interpolator.weights(at)(particles.p.data()), field(at), 1e-12) << kernel << dimension;
            }
        }
}

TEST(Interpolator, shepardKeepsConstantsAndBounds)
{
    auto particles = disturbed(2, 0.1);
    particles.setP([](Vector<3> x) { return x.x < 0.5 ? 0.0 : 1.0; });
    const Interpolator interpolator(particles.view());
    for (double x = 0.3; x < 0.7; x += 0.01)
    {
        const auto weights = interpolator.weights({x, 0.5, 0}, Interpolation::shepard);
        const double value = weights(particles.p.data());
        EXPECT_GE(value, 0);
        EXPECT_LE(value, 1 + 1e-14);
        double sum = 0;
        for (const double w : weights.weight) sum += w;
        EXPECT_NEAR(sum, 1, 1e-14);
    }
}

TEST(Interpolator, isSecondOrder)
{
    // sin(3 x) at a point that is no lattice point; halving the spacing divides the error by about 4.
    const auto error = [](double dx)
    {
        Particles particles(2, {0, 0, 0}, {1, 1, 1}, dx);
        particles.setP([](Vector<3> x) { return std::sin(3 * x.x); });
        return std::abs(Interpolator(particles.view()).weights({0.5, 0.5, 0})(particles.p.data()) - std::sin(1.5));
    };
    EXPECT_NEAR(std::log2(error(0.05) / error(0.025)), 2, 0.1);
}

TEST(Interpolator, wrapsPeriodicDirections)
{
    // cos(2 pi x) has period 1: the value at the boundary, from either side and from a period away, is that of a lattice shifted
    // by 1/2.
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.geometry.periodic = {true, false, false};
    const auto wave = [](double x) { return std::cos(2 * M_PI * x); };
    particles.setP([&](Vector<3> x) { return wave(x.x); });
    const Interpolator interpolator(particles.view());
    const auto at = [&](double x) { return interpolator.weights({x, 0.5, 0})(particles.p.data()); };
    auto shifted = particles;
    shifted.setP([&](Vector<3> x) { return wave(x.x - 0.5); });
    const double inside = Interpolator(shifted.view()).weights({0.5, 0.5, 0})(shifted.p.data());
    EXPECT_NEAR(at(0), inside, 1e-13);
    EXPECT_NEAR(at(1), inside, 1e-13);
    EXPECT_NEAR(at(-3), inside, 1e-13);
    EXPECT_LT(std::abs(inside - 1), 0.1);
}

TEST(Interpolator, aPeriodShorterThanTheSupportHasSeveralCopies)
{
    // One column of particles, period one spacing: inside, the kernel sum is that of the full lattice, 1 to about a percent.
    Particles particles(2, {0, 0, 0}, {0.1, 2, 0}, 0.1);
    particles.geometry.periodic = {true, false, false};
    EXPECT_NEAR(Interpolator(particles.view()).weights({0.05, 1, 0}).coverage, 1, 0.02);
}

TEST(Interpolator, coverageTellsInsideFromOutside)
{
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    const Interpolator interpolator(particles.view());
    EXPECT_NEAR(interpolator.weights({0.5, 0.5, 0}).coverage, 1, 0.02);
    EXPECT_NEAR(interpolator.weights({0.5, 1, 0}).coverage, 0.5, 0.02);
    const auto outside = interpolator.weights({0.5, 1.3, 0});
    EXPECT_TRUE(outside.empty());
    EXPECT_TRUE(std::isnan(outside(particles.p.data())));
}

TEST(Interpolator, leavesOutWhatIsNotAdmitted)
{
    // Two values on two sides: those of one side alone give its own, and the way to each particle is told, over the face of a period too.
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.1);
    particles.geometry.periodic = {true, false, false};
    particles.setP([](Vector<3> x) { return x.x < 0.5 ? 3.0 : 7.0; });
    const Interpolator interpolator(particles.view());
    const auto left = [&](std::size_t j, const Vector<3>& offset)
    {
        EXPECT_LT(mag(offset), 0.3);
        return particles.p[j] == 3;
    };
    for (const double x : {0.45, 0.55, 0.01, 0.99})
        EXPECT_NEAR(interpolator.weights({x, 0.5, 0}, Interpolation::shepard, left)(particles.p.data()), 3, 1e-14) << x;
    EXPECT_TRUE(interpolator.weights({0.5, 0.5, 0}, Interpolation::linear, [](std::size_t, const Vector<3>&) { return false; }).empty());
}

TEST(Interpolator, survivesLostParticles)
{
    // One particle at NaN, one a million domains away: the others are interpolated as if these were not there.
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.1);
    particles.setP([](Vector<3> x) { return x.y; });
    particles.add({1e6, -1e6, 0});
    particles.add({std::nan(""), 0, 0});
    EXPECT_NEAR(Interpolator(particles.view()).weights({0.5, 0.33, 0})(particles.p.data()), 0.33, 1e-9);
}

TEST(Interpolator, aSingleRowOfParticlesGivesAMean)
{
    Particles particles(2, {0, 0, 0}, {1, 0.1, 0}, 0.1);
    particles.setP([](Vector<3>) { return 4.0; });
    EXPECT_NEAR(Interpolator(particles.view()).weights({0.5, 0.1, 0})(particles.p.data()), 4, 1e-14);
}
