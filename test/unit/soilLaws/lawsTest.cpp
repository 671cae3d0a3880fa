/// The laws by hand: rates, stiffness, strength, and their constants in constant/soilProperties.
#include "Largest.hpp"
#include "soilTesting.hpp"
#include <numbers>

using namespace sph;
using namespace sph::test;

namespace
{

// Eq. (17) term by term, r and deviator written out, for D = diag(0, 0, -1) at K: tr = -(1 + 2 K).
TEST(WuBauer, byHand)
{
    const double K = 0.4, t = 1 + 2 * K;
    const auto rate = karlsruhe.rate(principal(-K, -K, -1), principal(0, 0, -1));
    const double rx = K / t, rz = 1 / t, dx = rx - 1. / 3, dz = rz - 1. / 3;
    EXPECT_NEAR(rate.xx, -t * (-673.1 * -rz * rx + (-655.9 * rx * rx + 699.6 * dx * dx)), 1e-10);
    EXPECT_NEAR(rate.zz, -t * (69.4 + -673.1 * -rz * rz + (-655.9 * rz * rz + 699.6 * dz * dz)), 1e-10);
    EXPECT_EQ(rate.xy, 0);
}

// Odd in the stress, of degree one in both, objective.
TEST(WuBauer, symmetries)
{
    const SymmTensor<3> s{-3, 0.5, -0.2, -2, 0.1, -5}, D{0.1, 0.3, -0.2, -0.4, 0.2, 0.05};
    const auto rate = karlsruhe.rate(s, D);
    EXPECT_LT(norm(karlsruhe.rate(-1.0 * s, D) + rate), 1e-12 * norm(rate));
    EXPECT_LT(norm(karlsruhe.rate(7.0 * s, 3.0 * D) - 21.0 * rate), 1e-12 * norm(21.0 * rate));
    const auto Q = rotationOf({0, -1, 2, 1, 0, 0.5, -2, -0.5, 0});
    EXPECT_LT(norm(karlsruhe.rate(rotated(s, Q), rotated(D, Q)) - rotated(rate, Q)), 1e-12 * norm(rate));
    // Whatever the size, to the smallest numbers.
    EXPECT_LT(norm(1e200 * karlsruhe.rate(1e-200 * s, D) - rate), 1e-12 * norm(rate));
}

TEST(WuBauer, earthPressureAtRest)
{
    const double K = karlsruhe.K0().value();
    EXPECT_NEAR(K, 0.51013396, 5e-9);
    // It is where K does not change, and moduli there: loading 185.653 and unloading 761.107 of sigma_zz.
    const auto at = [&](double D) { return karlsruhe.rate(principal(-K, -K, -1), principal(0, 0, D)); };
    EXPECT_NEAR(at(-1).xx / at(-1).zz, K, 1e-9);
    EXPECT_NEAR(-at(-1).zz, 185.653, 5e-4);
    EXPECT_NEAR(at(1).zz, 761.107, 5e-4);
}

// No modulus, in any direction, of any state, is above `stiffness`, and at K_0 it is 5 % above the largest.
TEST(WuBauer, stiffnessIsABound)
{
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> share(0, 1);
    std::normal_distribution<double> any;
    for (int k = 0; k < 20000; ++k)
    {
        const auto s = principal(-share(generator), -share(generator), -1);
        Vector<3> n{any(generator), any(generator), any(generator)};
        const auto D = 1 / dot(n, n) * outer(n); // a plane wave along n
        const double normal = dot(n, karlsruhe.rate(s, D) * n) / dot(n, n);
        ASSERT_LE(normal, karlsruhe.stiffness(s) * (1 + 1e-6));
    }
    const double K = 0.51013396;
    EXPECT_NEAR(karlsruhe.stiffness(principal(-K, -K, -1)) / 761.107, 1.05, 0.01);
    EXPECT_EQ(karlsruhe.stiffness({}), 0);
}

/// The symmetric tensor of columns <letter>11 ... of a table.
SymmTensor<3> tensorIn(const std::map<std::string, std::vector<double>>& t, const std::string& letter, std::size_t row)
{
    const auto c = [&](const char* place) { return t.at(letter + place)[row]; };
    return {c("11"), c("12"), c("13"), c("22"), c("23"), c("33")};
}
Tensor<3> gradientIn(const std::map<std::string, std::vector<double>>& t, std::size_t row)
{
    const auto c = [&](const char* place) { return t.at(std::string("L") + place)[row]; };
    return {c("11"), c("12"), c("13"), c("21"), c("22"), c("23"), c("31"), c("32"), c("33")};
}

// The largest difference of rates, those by spin with them, of random states, over the largest rate. The table has ten digits.
template<class Law> double rateError(const Law& law, const std::string& only, const auto& variables)
{
    const auto t = table("triaxialSands/states", only);
    Largest error;
    for (std::size_t k = 0; k < t.at("e").size(); ++k)
    {
        const auto L = gradientIn(t, k);
        const StateOf<Law> state(tensorIn(t, "T", k), variables(t.at("e")[k], tensorIn(t, "h", k)));
        StateOf<Law> rate = law.rate(state, symm(L));
        rate += turning(state, skew(L));
        const auto expected = tensorIn(t, "dT", k), h = tensorIn(t, "dh", k);
        error(norm(rate.stress - expected) / norm(expected));
        const auto its = variables(t.at("de")[k], h);
        auto off = rate.variables;
        off += -1.0 * its;
        error(law.variableError(off, state) / law.variableError(its, state));
    }
    EXPECT_GE(t.at("e").size(), 4u);
    return error.value();
}

TEST(VonWolffersdorff, ratesOfRandomStates)
{
    EXPECT_LT(rateError(karlsruheOfVoidRatio, "plain", [](double e, SymmTensor<3>) { return VoidRatio{e}; }), 1e-8);
    EXPECT_LT(rateError(karlsruheIntergranular, "intergranular", [](double e, SymmTensor<3> h) { return GranularState{{e}, h}; }), 1e-8);
}

// On e = e_c and the cone of Matsuoka and Nakai, I1 I2/I3 = (9 - sin^2)/(1 - sin^2), there is a direction of flow at constant volume in
// which the stress stays: along N, L^-1 N being of size 1 and without trace.
TEST(VonWolffersdorff, criticalStates)
{
    const auto& law = karlsruheOfVoidRatio;
    const double p = 1e5, e_c = law.e_c0 * law.compression(p);
    EXPECT_NEAR(e_c, 0.788656, 5e-7);
    EXPECT_NEAR(law.e_i0 * law.compression(p), 0.938876, 5e-7);
    EXPECT_NEAR(law.e_d0 * law.compression(p), 0.497604, 5e-7);
    for (const double lode : {0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0})
    {
        const auto at = [&](double radius)
        {
            const auto part = [&](double turn) { return -p * (1 - radius * std::cos((lode + turn) * std::numbers::pi / 180)); };
            return principal(part(180), part(60), part(-60));
        };
        double low = 0, high = 0.9;
        for (int bisections = 0; bisections < 60; ++bisections)
        {
            const double radius = 0.5 * (low + high);
            const auto s = at(radius);
            const double I1 = trace(s), I2 = s.xx * s.yy + s.yy * s.zz + s.zz * s.xx, I3 = s.xx * s.yy * s.zz;
            (I3 < 0 && I1 * I2 / I3 < (9 - 0.25) / (1 - 0.25) ? low : high) = radius;
        }
        const auto s = at(low);
        const auto tangent = law.tangent({s, {e_c}});
        // D with L:D = -N: F^2 D + a^2 r (r:D) = -N/scale.
        const auto right = -1 / tangent.scale * tangent.N;
        const double along = doubleDot(tangent.r, right) / (tangent.F2 + tangent.a2 * doubleDot(tangent.r, tangent.r));
        const auto D = 1 / tangent.F2 * (right - tangent.a2 * along * tangent.r);
        EXPECT_NEAR(norm(D), 1, 1e-9) << lode;
        EXPECT_NEAR(trace(D), 0, 1e-9) << lode;
        EXPECT_LT(norm(law.rate({s, {e_c}}, D).stress), 1e-9 * norm(tangent.N));
    }
}

// Isotropic compression from e_i, from 10 kPa to 2.7 MPa, stays on it: whatever is wrong in f_b leaves it.
TEST(VonWolffersdorff, loosestStateStays)
{
    const auto& law = karlsruheOfVoidRatio;
    StateOf<VonWolffersdorff> now(principal(-1e4, -1e4, -1e4), {law.e_i0 * law.compression(1e4)});
    for (int k = 0; k < 10; ++k) now = integrateStress(law, now, -1e-2 / 3 * diagonal(1, 1, 1), tight());
    EXPECT_GT(-now.stress.xx, 1e5);
    EXPECT_NEAR(now.variables.e, law.e_i0 * law.compression(-now.stress.xx), 1e-9);
}

// Full mobilisation along the strain rate is the law itself, none of it m_R L.
TEST(IntergranularStrain, limits)
{
    const auto& law = karlsruheIntergranular;
    const auto s = principal(-1e5, -2e5, -3e5);
    const SymmTensor<3> D{0.1, 0.3, -0.2, -0.4, 0.2, 0.05};
    const auto plain = law.law.rate({s, {0.7}}, D).stress;
    EXPECT_LT(norm(law.rate({s, {{0.7}, law.R / norm(D) * D}}, D).stress - plain), 1e-12 * norm(plain));
    const auto elastic = law.m_R * law.law.tangent({s, {0.7}}).linear(D);
    EXPECT_LT(norm(law.rate({s, {{0.7}, {}}}, D).stress - elastic), 1e-12 * norm(elastic));
    // |h| comes to R and stays.
    StateOf<IntergranularStrain<VonWolffersdorff>> now(s, {{0.7}, {}});
    for (int k = 0; k < 20; ++k) now = integrateStress(law, now, 1e-3 * diagonal(0, 0, -1), tight(1e-9));
    EXPECT_NEAR(norm(now.variables.h), law.R, 1e-9 * law.R);
}

// No modulus of a plane wave is above `stiffness`.
TEST(VonWolffersdorff, stiffnessIsABound)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> share(0.05, 1), voidRatio(0.52, 0.9), part(0, 1);
    std::normal_distribution<double> any;
    const auto& law = karlsruheIntergranular;
    for (int k = 0; k < 20000; ++k)
    {
        const auto s = 1e5 * principal(-share(generator), -share(generator), -1);
        const VoidRatio e{voidRatio(generator)};
        Vector<3> n{any(generator), any(generator), any(generator)};
        const auto D = 1 / dot(n, n) * outer(n);
        const auto modulus = [&](SymmTensor<3> rate) { return dot(n, rate * n) / dot(n, n); };
        ASSERT_LE(modulus(law.law.rate({s, e}, D).stress), law.law.stiffness({s, e}));
        const SymmTensor<3> any6{any(generator), any(generator), any(generator), any(generator), any(generator), any(generator)};
        const auto h = part(generator) * law.R / norm(any6) * any6;
        ASSERT_LE(modulus(law.rate({s, {e, h}}, D).stress), law.stiffness({s, {e, h}}));
    }
}

// A deviator whose cube is less than the smallest number, as grains that lie alone have it, is none.
TEST(VonWolffersdorff, hairOffIsotropic)
{
    for (const double hair : {1e-16, 1e-60, 1e-106, 1e-160})
    {
        StateOf<VonWolffersdorff> now(principal(-10, -10, -10), {0.9});
        const auto expected = karlsruheOfVoidRatio.rate(now, principal(0, -1, 0));
        now.stress.xy = 10 * hair;
        const auto rate = karlsruheOfVoidRatio.rate(now, principal(0, -1, 0));
        EXPECT_LT(norm(rate.stress - expected.stress), 1e-12 * norm(expected.stress)) << hair;
        EXPECT_NEAR(karlsruheOfVoidRatio.stiffness(now), karlsruheOfVoidRatio.stiffness({principal(-10, -10, -10), {0.9}}), 1e-8) << hair;
    }
}

// Soil looser than e_i is free of stress, and takes load again when it has been pushed together; the void ratio follows the strain meanwhile.
TEST(VonWolffersdorff, apart)
{
    const auto& law = karlsruheOfVoidRatio;
    StressIntegration how;
    StateOf<VonWolffersdorff> now(principal(-1e3, -1e3, -1e3), {0.9});
    auto step = integrateStress(law, now, 0.05 * diagonal(1, 1, 1), how);
    EXPECT_EQ(step.state, StressState::stressFree);
    EXPECT_NEAR(step.variables.e, 1.9 * std::exp(0.15) - 1, 1e-6);
    EXPECT_NEAR(-step.stress.xx, how.floorPressure, 1e-9);
    step = integrateStress(law, step, -0.03 * diagonal(1, 1, 1), how);
    EXPECT_NEAR(-step.stress.xx, how.floorPressure, 1e-9);
    step = integrateStress(law, step, -0.02 * diagonal(1, 1, 1), how);
    EXPECT_GT(-step.stress.xx, 1e3);
    // Denser than e_d: refused, the stress stays.
    now = {principal(-1e5, -1e5, -1e5), {0.49}};
    step = integrateStress(law, now, 1e-3 * diagonal(0, 0, -1), how);
    EXPECT_EQ(step.state, StressState::inadmissible);
    EXPECT_EQ(step.stress.xx, now.stress.xx);
}

TEST(Elastic, Hooke)
{
    const double E = 2e7, nu = 0.3;
    const auto law = ElasticLaw::of(E, nu);
    const auto uniaxial = law.rate({}, principal(-nu, -nu, 1));
    EXPECT_NEAR(uniaxial.zz, E, 1e-6);
    EXPECT_NEAR(uniaxial.xx, 0, 1e-6);
    EXPECT_NEAR(law.rate({}, principal(0, 0, 1)).zz, E * (1 - nu) / (1 + nu) / (1 - 2 * nu), 1e-6);
    EXPECT_NEAR(law.rate({}, {0, 0.5, 0, 0, 0, 0}).xy, E / 2 / (1 + nu), 1e-6);
    EXPECT_NEAR(law.stiffness(), law.rate({}, principal(0, 0, 1)).zz, 1e-6);
    // Through zero and into tension, in one step.
    const auto step = integrateStress(law, principal(-1e3, -1e3, -1e3), diagonal(0, 0, 0.01), {});
    EXPECT_EQ(step.state, StressState::regular);
    EXPECT_NEAR(step.stress.zz, -1e3 + 0.01 * law.stiffness(), 1e-6);
}

// Stress path to failure with strains whose volume part is chosen: at the end f = 0, and sigma stays inside on the way.
TEST(DruckerPrager, yieldIsKept)
{
    const auto law = DruckerPrager::of(ElasticLaw::of(2e7, 0.3), 30, 10, 5e3);
    for (const auto& L : {diagonal(0, 0, -1), diagonal(0.5, 0.5, -1), Tensor<3>{0, 0, 1, 0, 0, 0, 0, 0, 0}, diagonal(0.3, 0.3, 0.3)})
    {
        auto stress = principal(-2e4, -2e4, -2e4);
        for (int k = 0; k < 20; ++k)
        {
            const auto step = integrateStress(law, stress, 2e-3 * L, tight(1e-8));
            ASSERT_EQ(step.state, StressState::regular) << k;
            stress = step.stress;
            ASSERT_LE(law.yield(stress), law.width(stress));
        }
    }
}

// Tension cracking: no mean tension above k_c/alpha_phi, and there no shear.
TEST(DruckerPrager, apexAndReturn)
{
    const auto law = DruckerPrager::of(ElasticLaw::of(2e7, 0.3), 30, 0, 5e3);
    const double apex = law.k_c / law.alpha_phi;
    const auto beyond = law.returned(principal(2 * apex, apex, apex));
    EXPECT_NEAR(trace(beyond), apex, 1e-9 * apex);
    EXPECT_NEAR(norm(deviator(beyond)), 0, 1e-9 * apex);
    const auto sheared = law.returned(principal(-1e4, -1e4, -1e6));
    EXPECT_NEAR(trace(sheared), -1.02e6, 1e-6);
    EXPECT_NEAR(law.yield(sheared), 0, 1e-6);
    EXPECT_EQ(norm(law.returned(principal(-1e4, -1e4, -1e4)) - principal(-1e4, -1e4, -1e4)), 0);
    const auto step = integrateStress(law, principal(-1e4, -1e4, -1e6), diagonal(0, 0, -1e-4), {});
    EXPECT_EQ(step.state, StressState::inadmissible);
    EXPECT_LE(law.yield(step.stress), law.width(step.stress));
}

// Without cohesion, pulled apart: stress-free, in a bounded number of substeps, and soil again when it is pushed together.
TEST(DruckerPrager, apart)
{
    const auto law = DruckerPrager::of(ElasticLaw::of(2e7, 0.3), 30, 0, 0);
    auto step = integrateStress(law, principal(-1e3, -1e3, -2e3), diagonal(0.01, 0.01, 0.01), {});
    EXPECT_EQ(step.state, StressState::regular);
    EXPECT_LT(norm(step.stress), 1e-3);
    EXPECT_LT(step.subSteps.accepted + step.subSteps.rejected, 200);
    step = integrateStress(law, {}, diagonal(-1e-3, -1e-3, -1e-3), {});
    EXPECT_EQ(step.state, StressState::regular);
    EXPECT_LT(relative(trace(step.stress), -3 * 3e-3 * law.elastic.K), 1e-9);
}

/// A strain by substeps of the law's own rate, to `tolerance`.
SymmTensor<3> bySubsteps(const DruckerPrager& law, SymmTensor<3> stress, SymmTensor<3> strain, double tolerance)
{
    const auto start = stress;
    const auto taken = integrate(
        dormandPrince, stress, 1, [&](double, SymmTensor<3> s) { return law.rate(s, strain); },
        [&](SymmTensor<3> e, SymmTensor<3> s) { return substepError(law, e, start, stress, s, tolerance); },
        [](SymmTensor<3>) { return true; },
        [&](SymmTensor<3>& s)
        {
            const auto back = law.returned(s);
            const bool changed = norm(back - s) > 0;
            s = back;
            return changed;
        },
        [](SymmTensor<3>) { return false; });
    EXPECT_TRUE(taken.resolved);
    return stress;
}

SymmTensor<3> anyTensor(std::mt19937& generator)
{
    std::normal_distribution<double> any;
    return {any(generator), any(generator), any(generator), any(generator), any(generator), any(generator)};
}

// The elastic path to the cone and the flow along it, in closed form or in its own two variables, against substeps of the law that look for
// the cone and follow it: random states and directions, with strains that move the stress by a hundredth to ten times of itself. The bound
// is ten times the tolerance of a substep of either.
TEST(DruckerPrager, stepIsTheIntegralOfTheRate)
{
    std::mt19937 generator(6);
    std::uniform_real_distribution<double> share(0, 1);
    for (const double psi : {0., 10., 30.})
    {
        const auto law = DruckerPrager::of(ElasticLaw::of(1e7, 0.3), 30, psi, 2e3);
        for (const double size : {1e-5, 1e-4, 1e-3})
        {
            Largest error;
            for (int k = 0; k < 100; ++k)
            {
                const auto start = law.returned(-1e4 * share(generator) * identity(SymmTensor<3>{}) + 2e3 * anyTensor(generator));
                const auto D = anyTensor(generator), strain = size / norm(D) * D;
                const auto step = integrateStress(law, start,
                                                  Tensor<3>{strain.xx, strain.xy, strain.xz, strain.xy, strain.yy, strain.yz, strain.xz,
                                                            strain.yz, strain.zz},
                                                  tight(psi > 0 ? 1e-9 : 1e-6));
                EXPECT_EQ(step.state, StressState::regular);
                EXPECT_LE(law.yield(step.stress), law.width(step.stress));
                error(norm(step.stress - bySubsteps(law, start, strain, 1e-9)) / std::max(norm(start), norm(step.stress)));
            }
            EXPECT_LT(error.value(), 1e-8) << psi << " " << size;
        }
    }
}

// From no stress soil without cohesion that is sheared while it is pressed together leaves the vertex along the strain's deviator, and
// stays on the cone: I1 and sqrt(J2) by hand, r = (a + b) t of ConeFlow.hpp.
TEST(DruckerPrager, leavesTheVertexAlongTheStrain)
{
    for (const double psi : {0., 20.})
    {
        const auto law = DruckerPrager::of(ElasticLaw::of(1e7, 0.3), 30, psi, 0);
        const double G = law.elastic.G, K = law.elastic.K, d = 9 * K * law.alpha_phi * law.alpha_psi + G, v = -1e-4, gamma = 1e-2;
        const auto step = integrateStress(law, {}, diagonal(v / 3 + gamma / 2, v / 3 - gamma / 2, v / 3), {});
        const double lambda = (3 * K * law.alpha_phi * v + G * gamma) / d; // n:D = gamma of pure shear
        EXPECT_EQ(step.state, StressState::regular);
        EXPECT_LT(relative(trace(step.stress), 3 * K * (v - 3 * law.alpha_psi * lambda)), 1e-9);
        EXPECT_LT(relative(0.5 * (step.stress.xx - step.stress.yy), G * (gamma - lambda)), 1e-9);
        EXPECT_NEAR(step.stress.zz, trace(step.stress) / 3, 1e-9 * norm(step.stress));
    }
}

// Soil that is shaken about its vertex, with and without cohesion, in steps that would take its stress to ten times of what it is: each
// resolved, in less than 60 substeps of two numbers; none without dilatancy.
TEST(DruckerPrager, isCheapAtItsVertex)
{
    std::mt19937 generator(7);
    for (const double psi : {0., 10.})
        for (const double c : {0., 500.})
        {
            const auto law = DruckerPrager::of(ElasticLaw::of(1e7, 0.3), 30, psi, c);
            SymmTensor<3> stress = principal(-1e3, -1e3, -1e3);
            auto D = anyTensor(generator);
            for (int k = 0; k < 5000; ++k)
            {
                D = 0.98 * D + 0.2 * anyTensor(generator);
                const auto step = integrateStress(law, stress, 1e-3 * Tensor<3>{D.xx, D.xy, 0, D.xy, D.yy, 0, 0, 0, D.zz}, {});
                ASSERT_EQ(step.state, StressState::regular) << k;
                ASSERT_LE(step.subSteps.accepted + step.subSteps.rejected, psi > 0 ? 60 : 0) << k;
                stress = step.stress;
            }
        }
}

// No strain within the cone is plastic, whatever the turn; beyond it all of a pure shear but what the stress needs: gamma - tau/G.
TEST(DruckerPrager, plasticStrain)
{
    const auto law = DruckerPrager::of(ElasticLaw::of(1e7, 0.3), 30, 0, 2e3);
    const SymmTensor<3> start{-1e4, 200, 0, -1.1e4, 100, -1e4};
    const Tensor<3> L{1e-5, 3e-4, 0, -3e-4, 2e-5, 0, 1e-5, 0, -1e-5};
    EXPECT_LT(norm(plasticStrain(law, start, integrateStress(law, start, L, {}).stress, L)), 1e-16);
    const double gamma = 0.01, p = 1e4, strength = law.k_c + 3 * p * law.alpha_phi;
    const auto shear = diagonal(gamma / 2, -gamma / 2, 0);
    const auto end = integrateStress(law, principal(-p, -p, -p), shear, {}).stress;
    const auto plastic = plasticStrain(law, principal(-p, -p, -p), end, shear);
    EXPECT_NEAR(std::sqrt(2.0) * norm(deviator(plastic)), gamma - strength / law.elastic.G, 1e-14);
    EXPECT_NEAR(trace(plastic), 0, 1e-16);
}

std::string errorsOf(const std::string& text, Soil* soil = nullptr)
{
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::parse(text, soilProperties, diagnostics);
    const auto read = readSoil(d);
    d.reportUnused();
    if (soil) *soil = read;
    try
    {
        diagnostics->throwIfAny();
    }
    catch (const CaseError& error)
    {
        return error.what();
    }
    std::string all;
    for (const auto& warning : diagnostics->warnings()) all += "warning " + warning;
    return all;
}

const std::string sand = "rho 1850;\nlaw wuBauer;\nwuBauerCoeffs\n{\n    c1 -69.4;\n    c2 -673.1;\n    c3 -655.9;\n    c4 699.6;\n}\n";

std::string with(std::string from, const std::string& to, std::string text = sand)
{
    return text.replace(text.find(from), from.size(), to);
}

TEST(SoilProperties, read)
{
    Soil soil;
    EXPECT_EQ(errorsOf(sand + "integrator bogackiShampine; tolerance 1e-4; turning within; stressFree detached; floorPressure 3;"
                              "elasticCoeffs { E 1; nu 0; }",
                       &soil),
              "");
    EXPECT_EQ(std::get<WuBauer>(soil.law).c4, 699.6);
    EXPECT_EQ(soil.rho, 1850);
    EXPECT_EQ(soil.integration.pair, &bogackiShampine);
    EXPECT_EQ(soil.integration.tolerance, 1e-4);
    EXPECT_EQ(soil.integration.turning, Turning::within);
    EXPECT_EQ(soil.integration.stressFree, StressFree::detached);
    EXPECT_EQ(soil.integration.floorPressure, 3);
    EXPECT_EQ(errorsOf("rho 1; law druckerPrager; druckerPragerCoeffs { E 1e7; nu 0.3; frictionAngle 30; cohesion 100; }", &soil), "");
    EXPECT_EQ(std::get<DruckerPrager>(soil.law).alpha_psi, 0);
    EXPECT_EQ(errorsOf("rho 1; law elastic; elasticCoeffs { E 1e7; nu 0.3; }", &soil), "");
}

// c and tan(phi) over F in every law that has them, whose dilatancy is at most the friction that is left; others refuse it. The law that is asked for with those constants has the same numbers to rounding.
TEST(SoilProperties, reduceStrength)
{
    constexpr double degree = std::numbers::pi / 180, F = 1.6;
    const double phi = std::atan(std::tan(30 * degree) / F) / degree;
    Soil soil;
    const std::string constants = "{ E 1e7; nu 0.3; frictionAngle 30; dilatancyAngle 25; cohesion 8e3; ", reduced = "reduceStrength 1.6;";
    EXPECT_EQ(errorsOf("rho 1; law mohrCoulomb; mohrCoulombCoeffs " + constants + "tensileStrength 3200; } " + reduced, &soil), "");
    const auto& mohr = std::get<MohrCoulomb>(soil.law).strength;
    EXPECT_NEAR(mohr.sinPhi, std::sin(phi * degree), 1e-14);
    EXPECT_NEAR(mohr.sinPsi, std::sin(phi * degree), 1e-14);
    EXPECT_NEAR(mohr.cohesion, 5e3, 1e-10);
    EXPECT_NEAR(mohr.cutOff, 2e3, 1e-10);
    EXPECT_EQ(errorsOf("rho 1; law druckerPrager; druckerPragerCoeffs " + constants + "} " + reduced, &soil), "");
    const auto& cone = std::get<DruckerPrager>(soil.law);
    const auto asked = DruckerPrager::of(cone.elastic, phi, phi, 5e3);
    EXPECT_NEAR(cone.alpha_phi, asked.alpha_phi, 1e-14);
    EXPECT_NEAR(cone.alpha_psi, asked.alpha_psi, 1e-14);
    EXPECT_NEAR(cone.k_c, asked.k_c, 1e-9);
    EXPECT_EQ(
        errorsOf("rho 1; law mohrCoulomb; mohrCoulombCoeffs " + constants +
                     "softening { plasticShearStrain (0 0.2); cohesion (8e3 1.6e3); frictionAngle (30 10); dilatancyAngle (0 0); } } " +
                     reduced,
                 &soil),
        "");
    const auto residual = std::get<MohrCoulombSoftening>(soil.law).strengthAt(0.3);
    EXPECT_NEAR(residual.cohesion, 1e3, 1e-10);
    EXPECT_NEAR(residual.sinPhi, std::sin(std::atan(std::tan(10 * degree) / F)), 1e-14);
    EXPECT_NE(errorsOf(sand + reduced).find("constant/soilProperties:10: law wuBauer has no cohesion and friction angle"),
              std::string::npos);
}

TEST(SoilProperties, mistakes)
{
    const auto expect = [](const std::string& text, const std::string& words)
    {
        const auto error = errorsOf(text);
        EXPECT_NE(error.find(words), std::string::npos) << "no \"" << words << "\" in: " << error;
    };
    expect(with("c1 -69.4", "c1 69.4"),
           "constant/soilProperties:5: c1 = 69.4, c4 = 699.6 give no earth pressure at rest, K_0, between 0 and 1");
    expect(with("c4 699.6", "c4 -699.6"), "constant/soilProperties:8: c1 = -69.4, c4 = -699.6 give no earth pressure");
    expect(with("c4 699.6", "c4 600"), "warning constant/soilProperties:8: c4 = 600 is not above 9 |c1|");
    expect(with("    c4 699.6;\n", ""), "constant/soilProperties:3: entry \"c4\" is missing in \"wuBauerCoeffs\"");
    expect(with("rho 1850", "rho 0"), "constant/soilProperties:1: \"rho\" must be positive");
    expect(with("law wuBauer", "law wuBaur"), "Did you mean \"wuBauer\"?");
    expect(with("wuBauerCoeffs", "wuBauerCoefs"), "wuBauerCoeffs");
    expect(sand + "integrator euler;", "constant/soilProperties:10");
    expect(sand + "tolerance 0;", "constant/soilProperties:10");
    expect(sand + "floorPressure 0;", "constant/soilProperties:10");
    expect(sand + "stressFree float;", "constant/soilProperties:10: stressFree \"float\" is unknown");
    const std::string bui =
        "rho 1; law druckerPrager; druckerPragerCoeffs { E 1e7; nu 0.3; frictionAngle 30; dilatancyAngle 10; cohesion 100; }";
    expect(with("Angle 10", "Angle 40", bui), "dilatancyAngle 40 is above frictionAngle 30");
    expect(with("nu 0.3", "nu 0.5", bui), "nu");
    expect(with("E 1e7", "E -1", bui), "\"E\" must be positive");
    expect("rho 1; law druckerPrager; druckerPragerCoeffs { E 1e7; nu 0.3; frictionAngle 0; }", "no strength");
}

}
