/// Heat conduction and buoyancy: the plain sum, exact solutions, the account of heat, forces, restart, mistakes.
#include "CaseScene.hpp"
#include "Largest.hpp"
#include "kernels/Kernel.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

constexpr double spacing = 0.05, pi = 3.14159265358979323846;

/// Fluid at rest between planes at y = 0 and y = 1; `thermal` is constant/thermophysicalProperties.
Files slab(const std::string& thermal, double apart = spacing)
{
    auto files = channelCase();
    files.erase("constant/g");
    files["system/sphSchemes"] = fmt::format("resolution {{ spacing {}; support 2.6; kernel wendlandC2; }}\n", apart);
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (0.5 1 0); periodic (x); }\nwalls\n{\n    bottom { type plane; point "
        "(0 0 0); normal (0 1 0); }\n    top { type plane; point (0 1 0); normal (0 -1 0); }\n}\n";
    files["constant/phaseProperties"] = "phases (fluid);\nfluid { rho 1000; mu 1; soundSpeed 1; }\n";
    files["constant/thermophysicalProperties"] = thermal;
    return files;
}
/// Two fluids at rest, the light one above y = 0.5.
Files twoSlabs(const std::string& thermal)
{
    auto files = slab(thermal);
    files["constant/phaseProperties"] =
        "phases (heavy light);\nheavy { rho 1000; mu 1; soundSpeed 1; }\nlight { rho 400; mu 1; soundSpeed 1; }\n";
    return files;
}
/// A closed square, a wall of its own at each side.
Files square(const std::string& thermal)
{
    auto files = slab(thermal);
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (1 1 0); }\nwalls\n{\n    bottom { type plane; point (0 0 0); "
        "normal (0 1 0); }\n    top { type plane; point (0 1 0); normal (0 -1 0); }\n    hot { type plane; point (0 0 "
        "0); normal (1 0 0); }\n    cold { type plane; point (1 0 0); normal (-1 0 0); }\n}\n";
    return files;
}
const std::string wave = "\"300 + 10*sin(9*$x)*cos(4*$y)\"";

/// The number that stands before these words where they come first; NaN where they do not.
double numberBefore(const std::string& text, const std::string& words)
{
    const auto end = text.find(words);
    if (end == std::string::npos) return std::nan("");
    const auto begin = text.rfind(' ', end - 1);
    return std::stod(text.substr(begin + 1, end - begin));
}

double column(const CaseScene& s, const char* name) { return s.simulation->summary().columns.at(name); }

// Every pair written out, images in both walls included: a given temperature below, a given flux above, and phases that differ in all.
TEST(HeatFlux, IsThePlainSum)
{
    const CaseScene s(twoSlabs("kappa { heavy 20; light 120; } Cp { heavy 2; light 5; } initial " + wave +
                               "; walls { bottom { T 310; } top { q 700; } }"),
                      0.2);
    ASSERT_EQ(s.errors, "");
    const auto x = s.simulation->positions();
    const double *V = s["V"], *N = s["gradientScale"], *m = s["m"], *T = s["T"], *rate = s["dTdt"], *phase = s["phase"];
    const double *fromBottom = s["dheat_bottomdt"], *fromTop = s["dheat_topdt"];
    const Kernel<2> kernel("wendlandC2", 2.6 * spacing);
    const double mixed = 2 * 20 * 120 / 140., kappa[2][2] = {{20, mixed}, {mixed, 120}}, Cp[2] = {2, 5};
    Largest largest, worst, heat, worstHeat;
    for (std::size_t i = 0; i < s.simulation->size(); ++i)
    {
        double sum[3] = {0, 0, 0}; // of the fluid, and behind either wall
        for (std::size_t j = 0; j < s.simulation->size(); ++j)
            for (int shift = -1; shift <= 1; ++shift)
                for (int image = 0; image < 3; ++image)
                {
                    const double y_j = x.component[1][j], y = image == 0 ? y_j : image == 1 ? -y_j : 2 - y_j;
                    const double r = std::hypot(x.component[0][i] - x.component[0][j] - 0.5 * shift, x.component[1][i] - y);
                    if (r >= kernel.support() || r == 0) continue;
                    const int k_i = int(phase[i]), k_j = int(phase[j]);
                    const double T_j = image == 0 ? T[j] : image == 1 ? 2 * 310 - T[j] : T[j] + 2 * (1 - y_j) * 700 / kappa[k_j][k_j];
                    sum[image] += kappa[k_i][k_j] * (sqr(V[i]) + sqr(V[j])) * kernel.dWdrOverR(r) * 2 / (N[i] + N[j]) * (T[i] - T_j) / m[i];
                }
        const double all = (sum[0] + sum[1] + sum[2]) / Cp[int(phase[i])];
        largest(all);
        worst(all - rate[i]);
        heat(sum[1]);
        worstHeat(sum[1] - fromBottom[i]);
        worstHeat(sum[2] - fromTop[i]);
    }
    EXPECT_GT(largest.value(), 0);
    EXPECT_LT(worst.value(), 1e-10 * largest.value());
    EXPECT_LT(worstHeat.value(), 1e-10 * heat.value());
}

// A straight profile between walls of given temperature stays to round-off, in the corners of a square too, where each image of an image follows the
// rules of both walls; and the heat through either wall is kappa dT/L of its length.
TEST(Conduction, ThroughASlabIsExactOnALattice)
{
    const CaseScene s(square("kappa 0.6; Cp 4000; initial \"310 - 10*$x\"; walls { hot { T 310; } cold { T 300; } }"));
    ASSERT_EQ(s.errors, "");
    EXPECT_LT(s.size("dTdt"), 1e-10 * s.size("dheat_hotdt") / 4000);
    EXPECT_NEAR(column(s, "power(hot)"), 0.6 * 10, 1e-11 * 6);
    EXPECT_NEAR(column(s, "power(cold)"), -0.6 * 10, 1e-11 * 6);
}

// So it does between a wall of given heat flux and one of given temperature: q of the wall's length comes in.
TEST(Conduction, OfAGivenHeatFluxIsExactOnALattice)
{
    const CaseScene s(square("kappa 0.6; Cp 4000; initial \"300 + 50*(1 - $x)\"; walls { hot { q 30; } cold { T 300; } top { } }"));
    ASSERT_EQ(s.errors, "");
    EXPECT_LT(s.size("dTdt"), 1e-10 * s.size("dheat_hotdt") / 4000);
    EXPECT_NEAR(column(s, "power(hot)"), 30, 1e-10 * 30);
    EXPECT_NEAR(column(s, "power(cold)"), -30, 1e-10 * 30);
}

// In a relaxed packing a wall gives what it is told to within 0.5 %: measured are 0.12 % at the wall of given flux and 0.19 % at the other. Particles 0.2 spacings off
// their lattice, not relaxed, have 6 %.
TEST(Conduction, OfAGivenHeatFluxInARelaxedPacking)
{
    auto files = slab("kappa 0.6; Cp 4000; initial \"300 + 50*$y\"; walls { bottom { T 300; } top { q 30; } }");
    files["system/packParticlesDict"] = "lattice cubic; jitter 0.2; relax { steps 200; }\nfill ( { region all; phase fluid; } );\n";
    files["system/controlDict"] = controls;
    const TestCase relaxed(files);
    for (const char* program : {"packParticles", "meshToGhost"}) relaxed.runWell(program);
    const auto log = relaxed.runWell("sphFoamLike");
    EXPECT_NEAR(numberBefore(log, " W from top"), 0.5 * 30, 0.005 * 15) << log;
    EXPECT_NEAR(numberBefore(log, " W from bottom"), -0.5 * 30, 0.005 * 15) << log;
}

// In three dimensions too, in a cube: kappa dT/L of 1 m^2, by two walls, with two adiabatic ones beside them and periodic faces; and the account closes where
// buoyancy stirs it.
TEST(Conduction, ThroughACubeIsExactOnALattice)
{
    auto files = square("kappa 0.5; Cp 2; initial \"310 - 10*$x\"; walls { hot { T 310; } cold { T 300; } }\n");
    files["system/sphSchemes"] = "resolution { spacing 0.125; support 2.6; kernel wendlandC2; }\n";
    files["system/packParticlesDict"] = "lattice cubic;\nfill ( { region all; phase fluid; } );\n";
    files["system/controlDict"] = controls;
    auto& geometry = files["constant/geometry"];
    geometry.replace(geometry.find("dimension 2; domain { min (0 0 0); max (1 1 0); }"), 49,
                     "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (z); }");
    for (const bool buoyant : {false, true})
    {
        if (buoyant)
        {
            files["constant/thermophysicalProperties"] += "equationOfState { type Boussinesq; beta 0.1; T0 305; }\n";
            files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -1 0);\n";
        }
        const TestCase cube(files);
        for (const char* program : {"packParticles", "meshToGhost"}) cube.runWell(program);
        const auto log = cube.runWell("sphFoamLike");
        const auto behind = [&](const std::string& words)
        {
            const auto at = log.rfind(words);
            return at == std::string::npos ? std::nan("") : std::stod(log.substr(at + words.size()));
        };
        const bool exact = log.find(", 5 W from hot (0.4 J so far), -5 W from cold (-0.4 J so far)") != std::string::npos;
        EXPECT_EQ(exact, !buoyant) << log;
        EXPECT_EQ(behind("max|U| ") > 1e-6, buoyant);
        EXPECT_LT(std::abs(behind("balance off by ")), 1e-14);
    }
}

// sin(pi y) between walls at 0 decays as exp(-pi^2 a t): second order in the spacing, 0.1 of its error at 16 spacings from steps.
TEST(Conduction, OfADecayingSineIsOfSecondOrder)
{
    const double a = 1e-3, end = 20; // kappa/(rho Cp) [m^2/s], [s]; 82 % of the amplitude is left
    std::vector<double> errors;
    for (const double across : {8, 16, 32})
    {
        const CaseScene s(slab("kappa 1; Cp 1; initial \"sin(pi()*$y)\"; walls { bottom { T 0; } top { T 0; } }", 1 / across));
        ASSERT_EQ(s.errors, "");
        const int steps = int(std::ceil(end / s.simulation->stepLimit().deltaT));
        for (int n = 0; n < steps; ++n) s.simulation->step(0, end / steps);
        const auto x = s.simulation->positions();
        Largest worst;
        for (std::size_t i = 0; i < s.simulation->size(); ++i)
            worst(s["T"][i] - std::exp(-sqr(pi) * a * end) * std::sin(pi * x.component[1][i]));
        errors.push_back(worst.value());
    }
    EXPECT_LT(errors[2], 5e-4);
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.25);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.25);
}

// Two phases in series, from 20 K apart: straight lines that meet where the fluxes are equal, kappa_1 dT/dy = kappa_2 dT/dy; within what a kernel smears at
// the interface. As much heat leaves as comes in.
TEST(Conduction, PassesTwoPhasesInSeries)
{
    const CaseScene s(twoSlabs("kappa { heavy 1; light 5; } Cp { heavy 1; light 4; } initial { heavy \"320 - 100/3*$y\"; light \"300 + "
                               "20/3*(1 - $y)\"; } walls { bottom { T 320; } top { T 300; } }"));
    ASSERT_EQ(s.errors, "");
    for (int n = 0; n < 3000; ++n) s.simulation->step(0, 0.9 * s.simulation->stepLimit().deltaT);
    const auto x = s.simulation->positions();
    const double between = 300 + 20 / 6.; // temperature of the interface
    Largest worst;
    for (std::size_t i = 0; i < s.simulation->size(); ++i)
    {
        const double y = x.component[1][i];
        worst(s["T"][i] - (y < 0.5 ? 320 - 2 * (320 - between) * y : 300 + 2 * (between - 300) * (1 - y)));
    }
    EXPECT_LT(worst.value(), 0.005 * 20);
    const double exact = 0.5 * 2 * (320 - between); // of 0.5 m of wall
    EXPECT_NEAR(column(s, "power(bottom)"), exact, 0.005 * exact);
    EXPECT_NEAR(column(s, "power(top)"), -exact, 0.005 * exact);
}

// Off their lattice particles exchange pairwise: what walls give is all that the fluid gains, whatever the wall, the phase, the integrator.
TEST(HeatBalance, ClosesToRoundOff)
{
    const std::string materials = "kappa { heavy 20; light 120; } Cp { heavy 2; light 5; } initial " + wave + ";";
    auto grain = twoSlabs(materials);
    grain["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x y); }\nwalls { grain { type sphere; centre (0.5 0.5 0); "
        "radius 0.25; fluid outside; } }\n";
    auto hotGrain = grain;
    hotGrain["constant/thermophysicalProperties"] += "walls { grain { T 350; } }\n";
    const auto planes = twoSlabs(materials + "walls { bottom { T 310; } top { q 700; } }");
    auto tank = twoSlabs(materials + "walls { hot { T 350; } cold { q -20; } }");
    tank["constant/geometry"] = square("")["constant/geometry"];
    for (const auto& files : {grain, hotGrain, planes, tank})
        for (const char* scheme : {"predictorCorrector", "leapfrog", "symplecticEuler", "verlet", "semiImplicit", "implicit"})
        {
            auto stepped = files;
            stepped["system/sphSchemes"] += std::string("integration { scheme ") + scheme + "; }\n";
            const CaseScene s(stepped, 0.2);
            ASSERT_EQ(s.errors, "") << scheme;
            const double before = column(s, "heat");
            for (int n = 0; n < 50; ++n) s.simulation->step(0, s.simulation->stepLimit().deltaT);
            EXPECT_LT(std::abs(column(s, "heatBalanceError")), 1e-13) << scheme;
            const bool heated = files.at("constant/thermophysicalProperties").find("walls") != std::string::npos;
            if (heated) EXPECT_GT(std::abs(column(s, "heat") - before), 1e-6 * before) << scheme;
            else EXPECT_NEAR(column(s, "heat"), before, 1e-13 * before) << scheme;
        }
}

// -beta (T - T0) g beside the weight.
TEST(Buoyancy, IsTheWeightOfTheExpansion)
{
    auto files =
        twoSlabs("kappa 1; Cp 1; initial " + wave + "; equationOfState { type Boussinesq; beta { heavy 0.002; light 0.005; } T0 295; }");
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (3 -9.81 0);\n";
    const CaseScene s(files);
    files.erase("constant/thermophysicalProperties");
    const CaseScene without(files);
    ASSERT_EQ(s.errors + without.errors, "");
    const double g[2] = {3, -9.81};
    const auto x = s.simulation->positions();
    for (std::size_t i = 0; i < s.simulation->size(); ++i)
        for (int c = 0; c < 2; ++c)
        {
            const double y = x.component[1][i], beta = y > 0.5 ? 0.005 : 0.002;
            if (std::min(y, 1 - y) < 2.6 * spacing) continue; // walls answer by their pressure
            const double a = s.simulation->field("dUdt").component[c][i] - without.simulation->field("dUdt").component[c][i];
            EXPECT_NEAR(a, -beta * (s["T"][i] - 295) * g[c], 1e-10);
        }
}

// Fluid that is warmer above and at rest: dp/dy = -rho g (1 - beta (T - T0)), a parabola, with walls that continue it. Half a height from the walls away, and
// beside them alike; continued by the weight at T0 alone the pressure is 26 % of its range off. Rows of particles differ in turn by 0.5 %: within 1 %.
TEST(Buoyancy, OfAStratifiedFluidIsBalancedAtWalls)
{
    auto files =
        slab("kappa 0.1; Cp 1; initial \"$y\"; equationOfState { type Boussinesq; beta -2; T0 0; } walls { bottom { T 0; } top { T 1; } }");
    files["constant/phaseProperties"] = "phases (fluid);\nfluid { rho 1; mu 0.5; soundSpeed 10; }\n";
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -1 0);\n";
    const CaseScene s(files);
    ASSERT_EQ(s.errors, "");
    for (int n = 0; n < 3000; ++n) s.simulation->step(0, s.simulation->stepLimit().deltaT);
    const auto x = s.simulation->positions();
    const auto exact = [](double y) { return 2 - y - sqr(y); }; // p(y) - p(1), of rho g (1 + 2 y)
    double offset = 0;
    for (std::size_t i = 0; i < s.simulation->size(); ++i) offset += (s["p"][i] - exact(x.component[1][i])) / double(s.simulation->size());
    Largest worst;
    for (std::size_t i = 0; i < s.simulation->size(); ++i) worst(s["p"][i] - exact(x.component[1][i]) - offset);
    EXPECT_LT(worst.value(), 0.01 * exact(0));
}

// f h^2/a, h = 1.3 spacings, a the largest kappa/(rho Cp) of a pair; half with leapfrog.
TEST(Conduction, LimitsTheStep)
{
    for (const auto& [scheme, factor] : {std::pair("predictorCorrector", 0.125), std::pair("leapfrog", 0.0625)})
    {
        auto files = twoSlabs("kappa { heavy 1e6; light 10; } Cp { heavy 4; light 1; }");
        files["system/sphSchemes"] += std::string("integration { scheme ") + scheme + "; }\n";
        const CaseScene s(files);
        ASSERT_EQ(s.errors, "");
        const auto limit = s.simulation->stepLimit();
        EXPECT_EQ(limit.by, "conduction");
        EXPECT_NEAR(limit.deltaT, factor * sqr(1.3 * spacing) / (1e6 / (1000 * 4.)), 1e-12);
    }
}

// A scene without the file has neither the field nor a pass nor a column.
TEST(Conduction, CostsNothingWhereThereIsNone)
{
    auto files = slab("");
    files.erase("constant/thermophysicalProperties");
    const CaseScene s(files);
    ASSERT_EQ(s.errors, "");
    for (const auto& term : s.settings.terms) EXPECT_NE(term, "conduction");
    for (const auto& evolving : s.settings.state) EXPECT_NE(evolving.value.name, "T");
    EXPECT_FALSE(s.simulation->summary().columns.contains("heat"));
}

void expectError(const Files& files, const std::string& error)
{
    const CaseScene s(files);
    EXPECT_NE(s.errors.find(error), std::string::npos) << "not in: " << s.errors;
}
TEST(Conduction, MistakesSayWhereAndWhatIsPossible)
{
    const std::string file = "constant/thermophysicalProperties:";
    expectError(slab("Cp 1;"), "entry \"kappa\" is missing");
    expectError(slab("kappa 1;"), "entry \"Cp\" is missing");
    expectError(slab("Cp 1;\nkappa -1;"), file + "2: a conductivity is 0 or more [W/(m K)], not -1");
    expectError(slab("kappa 1;\nCp 0;"), file + "2: a specific heat capacity is above 0");
    expectError(slab("Cp 1;\nkappa [0 1 0 0 0 0 0] 1;"), file + "2: \"kappa\" has dimensions");
    expectError(twoSlabs("Cp 1;\nkappa { heavy 1; }"), "entry \"light\" is missing");
    expectError(slab("kappa 1; Cp 1;\nkapa 2;"), file + "2: entry \"kapa\" is not used here. Did you mean \"kappa\"?");
    expectError(slab("kappa 1; Cp 1;\nequationOfState\n{\ntype Boussinesq;\nbeta 1; T0 0; }"), file + "5: does nothing without gravity");
    expectError(slab("kappa 1; Cp 1;\nequationOfState { type perfectGas; }"),
                file + "2: type \"perfectGas\" is unknown. Known type: Boussinesq");
    expectError(slab("kappa 1; Cp 1;\nwalls {\nbotom { T 1; } }"),
                file + "3: wall \"botom\" is unknown. Did you mean \"bottom\"? Known walls: bottom, top");
    expectError(slab("kappa 1; Cp 1;\nwalls { bottom { T 1;\nq 2; } }"), file + "3: the wall has a temperature T already");
    expectError(slab("kappa 1; Cp 1;\nwalls { bottom { T 1;\nflux 2; } }"),
                file + "3: entry \"flux\" is not used here. Known entries: T, q");
    expectError(slab("kappa 1; Cp 1;\nwalls { bottom 3; }"), file + "2: wall \"bottom\" must be a dictionary");
    expectError(slab("kappa 0; Cp 1;\nwalls { bottom { q 2; } }"), file + "2: a heat flux needs a conductivity");
    expectError(slab("kappa 1; Cp 1;\ninitial \"sin($u)\";"), file + "2: ");
    auto both = slab("kappa 1; Cp 1;");
    both["constant/scalarTransport"] = "T { D 1; }\n";
    expectError(both, "constant/thermophysicalProperties: the temperature is the field T");
    auto creeping = slab("kappa 1; Cp 1; equationOfState { type Boussinesq; beta 1; T0 0; }");
    creeping["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -1 0);\n";
    creeping["system/sphSchemes"] += "integration { scheme quasiSteady; }\n";
    expectError(creeping, "quasiSteady leaves particles where they are, and a buoyant flow carries its heat");
    expectError(inLayers(slab("kappa 1; Cp 1;")), "take walls reflected");
}

// An inlet needs the temperature of what it brings, and brings it.
TEST(Conduction, GoesWithOpenings)
{
    auto files = openCase();
    files["constant/thermophysicalProperties"] = "kappa 20; Cp 2; initial 300;\n";
    const TestCase without(files);
    for (const char* program : {"packParticles", "meshToGhost"}) without.runWell(program);
    const auto missing = without.run("sphFoamLike");
    EXPECT_EQ(missing.code, 1);
    EXPECT_NE(missing.err.find("\"T\""), std::string::npos) << missing.err;
    auto& openings = files["constant/openings"];
    openings.replace(openings.find("phi "), 4, "T 350; phi ");
    const TestCase open(files);
    for (const char* program : {"packParticles", "meshToGhost"}) open.runWell(program);
    const auto log = open.runWell("sphFoamLike");
    EXPECT_NE(log.find(" .. 350 K"), std::string::npos) << log;
    EXPECT_EQ(log.find("balance off by nan"), std::string::npos);
}

}
}
