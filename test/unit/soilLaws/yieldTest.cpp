/// Laws with edges and caps: the return map by Koiter's conditions, rates as its slope, steps of any size against small ones; the yield surface of clay.
#include "Largest.hpp"
#include "soilTesting.hpp"

using namespace sph;
using namespace sph::test;

namespace
{

SymmTensor<3> randomTensor(std::mt19937& generator)
{
    std::normal_distribution<double> any;
    return {any(generator), any(generator), any(generator), any(generator), any(generator), any(generator)};
}

Tensor<3> randomRotation(std::mt19937& generator)
{
    std::normal_distribution<double> any;
    const double x = any(generator), y = any(generator), z = any(generator);
    return rotationOf({0, -z, y, z, 0, -x, -y, x, 0});
}

// Axes give the tensor back, are orthogonal and sorted, also where values are equal.
TEST(PrincipalAxes, giveTheTensorBack)
{
    std::mt19937 generator(1);
    for (int k = 0; k < 1000; ++k)
    {
        auto S = randomTensor(generator);
        if (k % 4 == 0) S = rotated(principal(2, 2, -1), randomRotation(generator));
        if (k % 4 == 1) S = rotated(principal(3, 3, 3), randomRotation(generator));
        const auto [values, axes] = principalAxes(S);
        EXPECT_LT(norm(inAxes(values, axes) - S), 1e-14 * (1 + norm(S)));
        EXPECT_LT(std::abs(determinant(axes) * determinant(axes) - 1), 1e-13);
        EXPECT_TRUE(values[0] >= values[1] && values[1] >= values[2]);
    }
}

const auto elastic = ElasticLaw::of(1e7, 0.3);

std::vector<MohrCoulomb> soils()
{
    auto cut = MohrCoulomb::of(elastic, 30, 10, 5e3);
    cut.strength.cutOff = 1e3;
    return {MohrCoulomb::of(elastic, 30, 0, 5e3), MohrCoulomb::of(elastic, 30, 30, 0), MohrCoulomb::of(elastic, 0, 0, 5e3),
            MohrCoulomb::of(elastic, 45, 15, 2e3), cut};
}

// A return ends on the surface, is a fixed point, keeps the axes, and its plastic strain makes no work of nothing: sigma:e_p >= 0 for psi <= phi, and the sum of the strains is whole.
TEST(MohrCoulomb, returnKeepsKoitersConditions)
{
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> share(-1, 1);
    for (const auto& law : soils())
    {
        int returned = 0;
        for (int k = 0; k < 4000; ++k)
        {
            const auto trial = 2e4 * share(generator) * identity(SymmTensor<3>{}) + 1e4 * randomTensor(generator);
            const auto at = principalAxes(trial);
            const auto end = flow(law.strength.planes(elastic), at.values);
            ASSERT_TRUE(std::isfinite(end.stress[0]));
            const auto stress = inAxes(end.stress, at.axes), plastic = inAxes(end.strain, at.axes);
            ASSERT_TRUE(law.admits(stress)) << k;
            EXPECT_LT(norm(trial - elastic.rate({}, plastic) - stress), 1e-9 * norm(trial));
            EXPECT_LT(norm(law.returned(stress) - stress), 1e-9 * norm(trial));
            if (norm(plastic) == 0) continue;
            ++returned;
            EXPECT_TRUE(law.yields(stress));
            EXPECT_GE(doubleDot(stress, plastic), -1e-12 * norm(trial) * norm(plastic));
        }
        EXPECT_GT(returned, 500);
    }
}

// Face, both edges and the apex by hand, for one trial stress each: phi 30, psi 0, c 5 kPa. Flow at constant volume keeps the trace, and with it, on an edge, all is known: q = 6 (p sin + c
// cos)/(3 -+ sin).
TEST(MohrCoulomb, returnByHand)
{
    const auto law = MohrCoulomb::of(elastic, 30, 0, 5e3);
    const double p = 2e4, s = 0.5, c = 5e3 * std::sqrt(0.75);
    const auto compression = law.returned(principal(0, 0, -3 * p)); // two equal largest: an edge
    EXPECT_LT(relative(compression.xx - compression.zz, 6 * (p * s + c) / (3 - s)), 1e-12);
    EXPECT_LT(std::abs(compression.xx - compression.yy), 1e-9);
    const auto extension = law.returned(principal(-p - 3e4, -p - 3e4, -p + 6e4));
    EXPECT_LT(relative(extension.zz - extension.xx, 6 * (p * s + c) / (3 + s)), 1e-12);
    const auto face = law.returned(principal(-p + 3e4, -p, -p - 3e4)); // the middle one stays
    EXPECT_LT(relative(0.5 * (face.xx - face.zz), p * s + c), 1e-12);
    EXPECT_LT(relative(face.yy, -p), 1e-12);
    const auto apex = law.returned(principal(4e4, 3e4, 2e4));
    EXPECT_LT(norm(apex - 5e3 / std::tan(std::numbers::pi / 6) * identity(apex)), 1e-8);
}

// Objective: turned with the stress and the strain.
TEST(MohrCoulomb, turnsWithTheAxes)
{
    std::mt19937 generator(3);
    for (const auto& law : soils())
        for (int k = 0; k < 100; ++k)
        {
            const auto sigma = law.returned(-1e4 * identity(SymmTensor<3>{}) + 1e4 * randomTensor(generator)), D = randomTensor(generator);
            const auto Q = randomRotation(generator);
            EXPECT_LT(norm(law.rate(rotated(sigma, Q), rotated(D, Q)) - rotated(law.rate(sigma, D), Q)), 1e-6 * norm(elastic.rate({}, D)));
        }
}

// The rate is the slope of the return map.
TEST(MohrCoulomb, rateIsTheSlopeOfTheReturn)
{
    std::mt19937 generator(4);
    for (const auto& law : soils())
    {
        Largest error;
        for (int k = 0; k < 1000; ++k)
        {
            const auto sigma = law.returned(-1e4 * identity(SymmTensor<3>{}) + 1e4 * randomTensor(generator)), D = randomTensor(generator);
            if (!law.yields(sigma)) continue;
            constexpr double h = 1e-11;
            const auto slope = 1 / h * (law.returned(sigma + h * elastic.rate({}, D)) - sigma);
            error(norm(slope - law.rate(sigma, D)) / norm(elastic.rate({}, D)));
        }
        EXPECT_LT(error.value(), 1e-4); // h over the distance of the next edge
    }
}

// One step of any size at the default tolerance against one at 1e-8: strains that move the stress by a tenth to ten times of itself, and turn its axes.
TEST(MohrCoulomb, stepsOfAnySize)
{
    std::mt19937 generator(5);
    for (const auto& law : soils())
        for (const double size : {1e-4, 1e-3, 1e-2})
        {
            Largest error;
            for (int k = 0; k < 8; ++k)
            {
                const auto start = law.returned(-1e4 * identity(SymmTensor<3>{}) + 5e3 * randomTensor(generator));
                const auto D = randomTensor(generator);
                const auto strain = full(size / norm(D) * D);
                const auto step = integrateStress(law, start, strain, {}), exact = integrateStress(law, start, strain, tight(1e-8));
                EXPECT_EQ(step.state, StressState::regular);
                EXPECT_TRUE(law.admits(step.stress));
                error(norm(step.stress - exact.stress) / std::max(norm(exact.stress), 1e4));
            }
            EXPECT_LT(error.value(), 1e-4) << size;
        }
}

// Softening takes the stress along: it stays on the surface of its own kappa, which grows by the plastic shear strain.
TEST(MohrCoulomb, softens)
{
    MohrCoulombSoftening law{elastic, std::numeric_limits<double>::infinity(), {{0, 30, 10, 1e4}, {0.02, 25, 0, 2e3}}};
    SoilState<SofteningStrain> now(principal(-2e4, -2e4, -2e4), {});
    double plasticShear = 0;
    for (int k = 0; k < 100; ++k)
    {
        const auto L = full(SymmTensor<3>{2e-4, 1e-4, 0, 0, 0, -4e-4});
        const auto step = integrateStress(law, now, L, {});
        ASSERT_EQ(step.state, StressState::regular);
        plasticShear += std::sqrt(2.0) * norm(deviator(plasticStrain(law, now.stress, step.stress, L)));
        now = step;
    }
    EXPECT_TRUE(law.yields(now));
    EXPECT_GT(now.variables.kappa, 0.02);
    EXPECT_NEAR(now.variables.kappa, plasticShear, 2e-4);
    // Back: elastic, kappa stays.
    const auto back = integrateStress(law, now, full(SymmTensor<3>{-5e-5, 0, 0, -5e-5, 0, 1e-4}), {});
    EXPECT_EQ(back.variables.kappa, now.variables.kappa);
    EXPECT_FALSE(law.yields(back));
}

const ModifiedCamClay clay{0.888, 0.161, 0.062, 0.3, 0};

// Unloading in steps as small as those of particles leaves the yield surface and keeps p_c; reloading comes back to it.
TEST(ModifiedCamClay, smallStepsLeaveTheYieldSurface)
{
    SoilState<ClayState> now(principal(-1e5, -1e5, -1e5), {{1}, 1e5});
    const auto steps = [&](Tensor<3> L, int n)
    {
        for (int k = 0; k < n; ++k) now = integrateStress(clay, now, L, {});
    };
    steps(diagonal(-1e-6, -1e-6, -3e-6), 1000);
    const double p_c = now.variables.p_c;
    EXPECT_GT(p_c, 1e5);
    EXPECT_TRUE(clay.yields(now));
    steps(diagonal(1e-6, 1e-6, 3e-6), 500);
    EXPECT_FALSE(clay.yields(now));
    EXPECT_EQ(now.variables.p_c, p_c);
    steps(diagonal(-1e-6, -1e-6, -3e-6), 1000);
    EXPECT_TRUE(clay.yields(now));
    EXPECT_GT(now.variables.p_c, p_c);
}

// No modulus of a plane wave is above `stiffness`, within the yield surface and on it.
TEST(ModifiedCamClay, stiffnessIsABound)
{
    std::mt19937 generator(7);
    std::normal_distribution<double> any;
    for (int k = 0; k < 5000; ++k)
    {
        const auto sigma = -1e5 * identity(SymmTensor<3>{}) + 2e4 * randomTensor(generator);
        if (!(clay.pressure(sigma) > 0)) continue;
        const SoilState<ClayState> state(sigma, {{1}, (k % 2 ? 1 : 2) * clay.surfaceOf(sigma)});
        const Vector<3> n{any(generator), any(generator), any(generator)};
        const auto rate = clay.rate(state, 1 / dot(n, n) * outer(n)).stress;
        ASSERT_LE(dot(n, rate * n) / dot(n, n), clay.stiffness(state) * (1 + 1e-9));
    }
}

// Pulled apart in one step clay is free of stress, and its void ratio grows.
TEST(ModifiedCamClay, apart)
{
    const auto step = integrateStress(clay, SoilState<ClayState>(principal(-1e3, -1e3, -1e3), {{1}, 2e3}), diagonal(0.3, 0.3, 0.3), {});
    EXPECT_EQ(step.state, StressState::stressFree);
    EXPECT_GT(step.variables.voidRatio.e, 1.5);
}

}
