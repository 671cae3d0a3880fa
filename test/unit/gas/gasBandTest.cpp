/// Gas in a band beside a layer of liquid: what joins and goes, what stands still, and what the liquid feels of it.
#include "CaseScene.hpp"
#include "messages.hpp"
#include "models/gas/AmbientGas.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <set>

namespace sph::test
{
namespace
{

template<class Real = double> struct Side
{
    Real p, V, m = 1, ambient;
};

template<class Real>
Vector<2> force(const Side<Real>& i, const std::vector<Side<Real>>& others, const std::vector<Vector<2>>& gradients, double p_b)
{
    Coefficients c;
    c.backgroundPressure = p_b;
    const AmbientPressure term(c);
    Vector<2> sum;
    for (std::size_t k = 0; k < others.size(); ++k)
    {
        struct
        {
            Vector<2, Real> gradW;
        } const ij{{Real(gradients[k].x), Real(gradients[k].y)}};
        const auto a = term(ij, i, others[k]);
        sum += Vector<2>{double(a.x), double(a.y)};
    }
    return sum;
}

/// A layer of liquid below y = 0.5, gas above, in a box of 1 x 2 between floor and lid, or periodic.
Files layer(const std::string& schemes, const std::string& g, bool between)
{
    auto files = channelCase();
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value " + g + ";\n";
    files["constant/geometry"] =
        std::string("dimension 2; domain { min (0 0 0); max (1 2 0); periodic ") +
        (between
             ? "(x); }\nwalls { floor { type plane; point (0 0 0); normal (0 1 0); } lid { type plane; point (0 2 0); normal (0 -1 0); } }\n"
             : "(x y); }\nwalls { }\n");
    files["constant/phaseProperties"] =
        "phases (liquid gas);\nliquid { rho 1000; mu 1; soundSpeed 10; }\ngas { rho 1; mu 1e-2; soundSpeed 100; "
        "exponent 1.4; }\nsigma ( (liquid gas) 50 );\n";
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\n" + schemes;
    return files;
}

void advance(AnySimulation& simulation, double from, double to)
{
    while (from < to)
    {
        const double deltaT = std::min(simulation.stepLimit().deltaT, to - from);
        simulation.step(from, deltaT);
        from += deltaT;
    }
}

}

// Uniform ambient gas exerts no force on itself however it lies, and is that of Hu and Adams where no share of it is ambient.
TEST(AmbientPressure, HasNoLatticeOfUniformGas)
{
    const std::vector<Vector<2>> gradients{{1, 0.2}, {-0.3, 0.8}, {0.1, -0.4}};
    const double p_b = 300;
    const auto gas = [&](double V, double share) { return Side<>{p_b, V, 1, Ambient::moving(share)}; };
    EXPECT_NEAR(mag(force(gas(0.9, 1), {gas(1.1, 1), gas(1, 1), gas(0.8, 1)}, gradients, p_b)), 0, 1e-12);
    Vector<2> huAdams;
    const std::vector<Side<>> others{{310, 1.1, 1, 0}, {290, 1, 1, 0}, {300, 0.8, 1, 0}};
    const Side<> i{305, 0.9, 1, 0};
    for (std::size_t k = 0; k < 3; ++k) huAdams -= (i.p * sqr(i.V) + others[k].p * sqr(others[k].V)) * gradients[k];
    EXPECT_NEAR(mag(force(i, others, gradients, p_b) - huAdams), 0, 1e-12 * mag(huAdams));
}

// In single precision the same force up to its rounding, and none of uniform ambient gas either.
TEST(AmbientPressure, BearsSinglePrecision)
{
    const std::vector<Vector<2>> gradients{{1, 0.2}, {-0.3, 0.8}, {0.1, -0.4}};
    const std::vector<Side<>> others{{310, 1.1, 1, Ambient::moving(0.3)}, {290, 1, 1, 0}, {300, 0.8, 1, Ambient::stands}};
    const Side<> i{305, 0.9, 1, Ambient::moving(0.7)};
    const auto single = [](const Side<>& s) { return Side<Single>{s.p, s.V, s.m, s.ambient}; };
    std::vector<Side<Single>> othersInSingle;
    for (const auto& other : others) othersInSingle.push_back(single(other));
    const auto exact = force(i, others, gradients, 300);
    EXPECT_NEAR(mag(force(single(i), othersInSingle, gradients, 300) - exact), 0, 1e-5 * mag(exact));
    const Side<Single> uniform{300, 0.9, 1, Ambient::moving(1)};
    EXPECT_EQ(mag(force(uniform, {uniform, uniform, uniform}, gradients, 300)), 0);
}

TEST(GasBand, LeavesOutWhatIsFarAndKeepsTheRestAtRest)
{
    CaseScene scene(layer("gas band;\n", "(0 0 0)", true));
    ASSERT_EQ(scene.errors, "");
    auto& simulation = *scene.simulation;
    advance(simulation, 0, 0.2);
    const double* const y = simulation.positions().component[1];
    const double *const phase = scene["phase"], width = 3 * 2.6 * 0.05;
    std::size_t gas = 0;
    double highest = 0;
    for (std::size_t i = 0; i < simulation.size(); ++i)
    {
        if (phase[i] == 0) continue;
        ++gas;
        highest = std::max(highest, y[i]);
    }
    EXPECT_GT(highest, 0.5 + width - 0.05);
    EXPECT_LT(highest, 0.5 + width + 2 * 0.05) << "the band and a spacing";
    EXPECT_EQ(gas, std::size_t(20 * std::lround((highest - 0.475) / 0.05))) << "whole rows of 20";
    EXPECT_LT(simulation.summary().maxSpeedOfScene(), 1e-9);
}

// Liquid whose surface breaks up: what joins beside gas that moves, and what joins beyond it, may be the same place.
TEST(GasBand, PutsNoTwoParticlesInOnePlace)
{
    CaseScene scene(layer("gas band;\n", "(0.3 -1 0)", false), 0.3);
    ASSERT_EQ(scene.errors, "");
    auto& simulation = *scene.simulation;
    for (int k = 0; k < 150; ++k)
    {
        advance(simulation, 0.002 * k, 0.002 * (k + 1));
        const auto places = simulation.positions();
        std::set<std::pair<double, double>> taken;
        for (std::size_t i = 0; i < simulation.size(); ++i) taken.emplace(places.component[0][i], places.component[1][i]);
        ASSERT_EQ(taken.size(), simulation.size()) << "at " << 0.002 * (k + 1);
    }
}

// Gas that comes to stand has no velocity left, nor one that a corrector would bring back.
TEST(GasBand, StandsStillInStepsThatPredict)
{
    for (const std::string scheme : {"leapfrog", "verlet"})
    {
        CaseScene scene(layer("gas band;\nintegration { scheme " + scheme + "; }\n", "(0.3 -1 0)", false));
        ASSERT_EQ(scene.errors, "");
        auto& simulation = *scene.simulation;
        std::size_t standing = 0;
        for (int k = 0; k < 80; ++k)
        {
            advance(simulation, 0.01 * k, 0.01 * (k + 1));
            const auto U = simulation.field("U");
            const double* const ambient = scene["ambient"];
            for (std::size_t i = 0; i < simulation.size(); ++i)
                if (ambient[i] == Ambient::stands)
                {
                    ++standing;
                    ASSERT_EQ(std::hypot(U.component[0][i], U.component[1][i]), 0) << scheme << " at " << 0.01 * (k + 1);
                }
        }
        EXPECT_GT(standing, 1000u);
    }
}

// Gas that lies off its lattice, and whose interface does, is thrown about; it is held at nine tenths of what flow allows for the step, s h/dt with s = 0.2, unless the liquid is faster.
TEST(GasBand, NoGasOfItBindsTheStep)
{
    CaseScene scene(layer("gas band;\nintegration { scheme implicit; }\n", "(0 0 0)", true), 0.3);
    ASSERT_EQ(scene.errors, "");
    auto& simulation = *scene.simulation;
    double time = 0;
    std::size_t held = 0;
    for (int step = 0; step < 60; ++step)
    {
        const double deltaT = simulation.stepLimit().deltaT;
        simulation.step(time, deltaT);
        time += deltaT;
        std::array<double, 2> fastest{};
        const auto U = simulation.field("U");
        const double* const phase = scene["phase"];
        for (std::size_t i = 0; i < simulation.size(); ++i)
            fastest[phase[i] == 1] = std::max(fastest[phase[i] == 1], std::hypot(U.component[0][i], U.component[1][i]));
        const double most = std::max(0.9 * 0.2 * 0.5 * 2.6 * 0.05 / deltaT, fastest[0]);
        EXPECT_LE(fastest[1], most * (1 + 1e-12)) << "step " << step;
        held += fastest[1] > most * (1 - 1e-9);
    }
    EXPECT_GT(held, 0u);
}

// Liquid that falls in gas at rest, as if there were none: the gas has a thousandth of its density.
TEST(GasBand, FollowsALayerThatFalls)
{
    CaseScene scene(layer("gas band;\n", "(0 -1 0)", false));
    ASSERT_EQ(scene.errors, "");
    auto& simulation = *scene.simulation;
    const double end = 0.8;
    advance(simulation, 0, end);
    const double* const v = simulation.field("U").component[1];
    const double *const phase = scene["phase"], *const m = scene["m"];
    double momentum = 0, mass = 0;
    for (std::size_t i = 0; i < simulation.size(); ++i)
        if (phase[i] == 0)
        {
            momentum += m[i] * v[i];
            mass += m[i];
        }
    EXPECT_NEAR(momentum / mass, -end, 0.15 * end)
        << "fell by six spacings; all of the gas before it has to go, and 0.13 less was measured";
    const auto report = simulation.report();
    EXPECT_EQ(report.find(" 0 kg joined"), std::string::npos) << report;
    const auto at = report.find("balance off by ");
    ASSERT_NE(at, std::string::npos) << report;
    EXPECT_LT(std::stod(report.substr(at + 15)), 1e-12);
}

// The force lacks the background pressure where gas is farther than five spacings from the liquid, and nowhere else; what is at rest stays so.
TEST(CalmGas, IsThatFarFromTheLiquid)
{
    CaseScene scene(layer("gas calm;\n", "(0 0 0)", true));
    ASSERT_EQ(scene.errors, "");
    auto& simulation = *scene.simulation;
    advance(simulation, 0, 0.05);
    const double* const y = simulation.positions().component[1];
    const double *const phase = scene["phase"], *const ambient = scene["ambient"];
    int between = 0;
    for (std::size_t i = 0; i < simulation.size(); ++i)
    {
        const double share = Ambient::share(ambient[i]), d = (y[i] - 0.475) / 0.05; // from the liquid's last row
        ASSERT_LT(ambient[i], Ambient::stands);
        if (phase[i] == 0 || d < 2.9) ASSERT_EQ(share, 0) << y[i];
        else if (d > 5.1) ASSERT_EQ(share, 1) << y[i];
        else if (share > 0 && share < 1) ++between;
    }
    EXPECT_EQ(between, 20) << "the row at four spacings";
    EXPECT_LT(simulation.summary().maxSpeedOfScene(), 1e-9);
}

// A layer that falls and drives gas round by the periodic faces: dv/dt = -g - k v, k = (r + 2 |v|/Delta_x) m_gas/(m_gas + m_liquid). What the layer feels of the friction, of what is exact: 99.3 % at 0.1 of the
// limits (r dt 0.2) and 98.4 % at 0.02; 83 and 95 % where positions did not feel it.
TEST(GasFriction, IsThatOfTheGasAloneWhichTheLiquidDrives)
{
    const double r = 200, end = 0.4;
    const auto shareOfExact = [&](const std::string& stepFactor)
    {
        CaseScene scene(layer("gasFriction 200;\nintegration { scheme implicit; stepFactor " + stepFactor + "; }\n", "(0 -1 0)", false));
        EXPECT_EQ(scene.errors, "");
        auto& simulation = *scene.simulation;
        advance(simulation, 0, end);
        const double* const v = simulation.field("U").component[1];
        const double *const phase = scene["phase"], *const m = scene["m"];
        double momentum = 0, mass[2] = {0, 0};
        for (std::size_t i = 0; i < simulation.size(); ++i)
        {
            mass[phase[i] == 0 ? 0 : 1] += m[i];
            if (phase[i] == 0) momentum += m[i] * v[i];
        }
        double exact = 0;
        const int steps = 10000;
        for (int k = 0; k < steps; ++k) exact += end / steps * (1 - (r + exact / 0.025) * mass[1] / (mass[0] + mass[1]) * exact);
        return (end + momentum / mass[0]) / (end - exact);
    };
    EXPECT_NEAR(shareOfExact("0.1"), 1, 0.02);
    EXPECT_NEAR(shareOfExact("0.02"), 1, 0.03);
}

// Backward Euler with a friction: v_1 = s (v_0 + dt g), and x_1 = x_0 + dt v_1 as without it.
TEST(SlowDown, IsFeltByPositionsOfImplicitSteps)
{
    CaseScene scene(layer("integration { scheme implicit; tolerance 1e-9; damping { rate 100; until 1; } }\n", "(0 -1 0)", false));
    ASSERT_EQ(scene.errors, "");
    auto& simulation = *scene.simulation;
    const auto mean = [&](const double* q) { return std::accumulate(q, q + simulation.size(), 0.0) / double(simulation.size()); };
    const double deltaT = 2e-3, s = std::exp(-100 * deltaT), start = mean(simulation.positions().component[1]);
    double v = 0, way = 0;
    for (int k = 0; k < 10; ++k)
    {
        simulation.step(k * deltaT, deltaT);
        v = s * (v - deltaT);
        way += deltaT * v;
    }
    EXPECT_NEAR(mean(simulation.field("U").component[1]), v, 1e-9);
    EXPECT_NEAR(mean(simulation.positions().component[1]) - start, way, 1e-11);
}

TEST(GasFriction, RefusesWhatItCannotGoWith)
{
    auto alone = channelCase();
    alone["system/sphSchemes"] += "gasFriction 10;\n";
    const auto errors = CaseScene(alone).errors;
    EXPECT_NE(errors.find("the lightest of several phases"), std::string::npos) << errors;
    EXPECT_NE(CaseScene(layer("gasFriction -1;\n", "(0 0 0)", true)).errors.find("gasFriction"), std::string::npos);
}

TEST(CalmGas, RefusesWhatItCannotGoWith)
{
    EXPECT_PRED2(says, CaseScene(layer("gas calm; backgroundPressure 0;\n", "(0 0 0)", true)).errors,
                 "calm leaves out a backgroundPressure");
    EXPECT_PRED2(says, CaseScene(layer("gas calm; pressureGradient densityWeighted;\n", "(0 0 0)", true)).errors,
                 "pressureGradient huAdams");
}

TEST(GasBand, RefusesWhatItCannotGoWith)
{
    const auto errors = [](const std::string& schemes) { return CaseScene(layer(schemes, "(0 0 0)", true)).errors; };
    EXPECT_PRED2(says, errors("gas band; gasBand 2;\n"), "gasBand");
    EXPECT_PRED2(says, errors("gasBand 3;\n"), "is the width of `gas band;`");
    EXPECT_PRED2(says, errors("gas band; backgroundPressure 0;\n"), "needs a backgroundPressure above 0");
    EXPECT_PRED2(says, errors("gas band; pressureGradient densityWeighted;\n"), "pressureGradient huAdams");
    auto open = layer("gas band;\n", "(0 0 0)", true);
    open["constant/openings"] = "wind { type inlet; point (0 1.8 0); normal (0 -1 0); velocity 1; phase gas; }\n";
    EXPECT_PRED2(says, CaseScene(open).errors, "opening \"wind\" lets gas in");
    auto alone = channelCase();
    alone["system/sphSchemes"] += "gas band;\n";
    EXPECT_PRED2(says, CaseScene(alone).errors, "the lightest of several phases");
}

}
