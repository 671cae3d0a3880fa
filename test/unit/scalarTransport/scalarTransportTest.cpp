/// Scalars that ride on particles: the plain sum, what it conserves, what walls and phases make of it, several at once, restart, openings, mistakes.
#include "CaseScene.hpp"
#include "Largest.hpp"
#include "kernels/Kernel.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <regex>

namespace sph::test
{
namespace
{

constexpr double spacing = 0.05;

/// Two liquids, one above the other, between y = 0 and y = 1; `scalars` is constant/scalarTransport.
Files layers(const std::string& scalars)
{
    auto files = channelCase();
    files.erase("constant/g");
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\n";
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (0.4 1 0); periodic (x); }\nwalls\n{\n    bottom { type plane; point "
        "(0 0 0); normal (0 1 0); }\n    top { type plane; point (0 1 0); normal (0 -1 0); }\n}\n";
    files["constant/phaseProperties"] =
        "phases (heavy light);\nheavy { rho 1000; mu 1; soundSpeed 15; }\nlight { rho 400; mu 1; soundSpeed 15; }\n";
    files["constant/scalarTransport"] = scalars;
    return files;
}
Files grain(const std::string& scalars)
{
    auto files = layers(scalars);
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x y); }\nwalls { grain { type sphere; centre (0.5 0.5 0); "
        "radius 0.25; fluid outside; } }\n";
    return files;
}

using Scene = CaseScene;

const std::string wave = "\"1 + sin(9*$x)*cos(4*$y)\"";

// Every pair written out, mirror images in both walls included: one has a value, nothing passes the other.
TEST(ScalarFlux, IsThePlainSum)
{
    const Scene s(layers("dye { D { heavy 0.02; light 0.3; } initial " + wave + "; walls { bottom 2; } }"), 0.2);
    ASSERT_EQ(s.errors, "");
    const auto x = s.simulation->positions();
    const double *V = s["V"], *N = s["gradientScale"], *m = s["m"], *c = s["dye"], *rate = s["ddyedt"], *phase = s["phase"];
    const Kernel<2> kernel("wendlandC2", 2.6 * spacing);
    const double k[2][2] = {{20, 2 * 20 * 120 / 140.}, {2 * 20 * 120 / 140., 120}};
    Largest largest, worst;
    for (std::size_t i = 0; i < s.simulation->size(); ++i)
    {
        double sum = 0;
        for (std::size_t j = 0; j < s.simulation->size(); ++j)
            for (int shift = -1; shift <= 1; ++shift)
                for (int image = 0; image < 3; ++image)
                {
                    const double y = image == 0 ? x.component[1][j] : image == 1 ? -x.component[1][j] : 2 - x.component[1][j];
                    const double r = std::hypot(x.component[0][i] - x.component[0][j] - 0.4 * shift, x.component[1][i] - y);
                    if (r >= kernel.support() || r == 0) continue;
                    const double c_j = image == 1 ? 4 - c[j] : c[j];
                    sum +=
                        k[int(phase[i])][int(phase[j])] * (sqr(V[i]) + sqr(V[j])) * kernel.dWdrOverR(r) * 2 / (N[i] + N[j]) * (c[i] - c_j);
                }
        largest(sum / m[i]);
        worst(sum / m[i] - rate[i]);
    }
    EXPECT_GT(largest.value(), 0);
    EXPECT_LT(worst.value(), 1e-11 * largest.value());
}

// sum m c, whatever the masses, the phases and the walls; with ghosts that weigh less than their sources too.
TEST(ScalarFlux, ConservesTheAmount)
{
    const std::string dye = "dye { D { heavy 0.02; light 0.3; } initial " + wave + "; }";
    for (const auto& files : {layers(dye), grain(dye)})
    {
        const Scene s(files, 0.2);
        ASSERT_EQ(s.errors, "");
        EXPECT_LT(std::abs(s.total("ddyedt")), 1e-14 * s.size("ddyedt"));
        const double before = s.total("dye");
        for (int n = 0; n < 50; ++n) s.simulation->step(0, s.simulation->stepLimit().deltaT);
        EXPECT_NEAR(s.total("dye"), before, 1e-13 * before);
        EXPECT_LT(std::abs(s.simulation->summary().columns.at("change(dye)")), 1e-13);
    }
}

// In a corner each ghost of a ghost has its counterpart.
TEST(ScalarFlux, ConservesTheAmountInABox)
{
    auto files = layers("dye { D 0.1; initial " + wave + "; }");
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (1 1 0); }\nwalls { tank { type box; min (0 0 0); max (1 1 0); fluid "
        "inside; } }\n";
    const Scene s(files, 0.2);
    ASSERT_EQ(s.errors, "");
    EXPECT_LT(std::abs(s.total("ddyedt")), 1e-14 * s.size("ddyedt"));
}

// Nothing passes a wall, and beside it diffusion along the wall is as fast as anywhere: c of x alone stays one.
TEST(ScalarFlux, DoesNotFeelAPlaneWallThatNothingPasses)
{
    const Scene s(layers("dye { D 0.1; initial \"sin(5*pi()*$x)\"; }"));
    ASSERT_EQ(s.errors, "");
    const auto x = s.simulation->positions();
    Largest most, spread;
    for (std::size_t i = 0; i < s.simulation->size(); ++i)
        for (std::size_t j = 0; j < s.simulation->size(); ++j)
            if (std::abs(x.component[0][i] - x.component[0][j]) < 1e-9 && s["phase"][i] == s["phase"][j] &&
                std::abs(x.component[1][i] - 0.5) > 0.2 && std::abs(x.component[1][j] - 0.5) > 0.2)
            {
                most(s["ddyedt"][i]);
                spread(s["ddyedt"][i] - s["ddyedt"][j]);
            }
    EXPECT_GT(most.value(), 0.1);
    EXPECT_LT(spread.value(), 1e-10 * most.value());
}

// c = 1 below, 0 above, 0.14 s from the exact profile, four times as long as its slowest mode lives: straight lines that
// meet where k_1 dc/dy = k_2 dc/dy, k = rho D; within what a kernel smears at the interface.
TEST(ScalarFlux, PassesTwoLayersInSeries)
{
    const Scene s(
        layers("dye { D { heavy 2; light 10; } initial { heavy \"1 - 4/3*$y\"; light \"2/3*(1 - $y)\"; } walls { bottom 1; top 0; } }"));
    ASSERT_EQ(s.errors, "");
    for (int n = 0; n < 3000; ++n) s.simulation->step(0, 0.9 * s.simulation->stepLimit().deltaT);
    const auto x = s.simulation->positions();
    const double between = 2000. / (2000 + 4000); // c of the interface
    Largest worst;
    for (std::size_t i = 0; i < s.simulation->size(); ++i)
    {
        const double y = x.component[1][i];
        worst(s["dye"][i] - (y < 0.5 ? 1 - 2 * (1 - between) * y : 2 * between * (1 - y)));
    }
    EXPECT_LT(worst.value(), 0.005);
}

// Each as if it were alone, to the last bit; the log and the step know both.
TEST(ScalarTransport, SeveralScalarsDoNotMeet)
{
    const std::string dye = "dye { D 0.1; initial " + wave + "; }\n",
                      heat = "T { D { heavy 0.3; light 0; } initial { heavy 300; light \"300 + $x\"; } walls { bottom 320; } }\n";
    const Scene both(layers(dye + heat), 0.2), first(layers(dye), 0.2), second(layers(heat), 0.2);
    ASSERT_EQ(both.errors, "");
    const double dt = 0.5 * both.simulation->stepLimit().deltaT;
    for (const auto* s : {&both, &first, &second})
        for (int n = 0; n < 20; ++n) s->simulation->step(0, dt);
    for (std::size_t i = 0; i < both.simulation->size(); ++i)
    {
        EXPECT_EQ(both["dye"][i], first["dye"][i]);
        EXPECT_EQ(both["T"][i], second["T"][i]);
    }
    EXPECT_NE(both.simulation->report().find("T: "), std::string::npos);
    std::vector<std::string> written;
    for (const auto& field : both.simulation->fields()) written.push_back(field.name);
    for (const char* name : {"dye", "T"}) EXPECT_NE(std::find(written.begin(), written.end(), name), written.end());
    EXPECT_EQ(std::find(written.begin(), written.end(), "scalar"), written.end());
}

// f h^2/D, h = 1.3 spacings, D of the worst pair of phases; half with leapfrog.
TEST(ScalarTransport, LimitsTheStep)
{
    for (const auto& [scheme, factor] :
         {std::pair("predictorCorrector", 0.125), std::pair("leapfrog", 0.0625), std::pair("symplecticEuler", 0.125)})
    {
        auto files = layers("dye { D { heavy 20; light 0; } }");
        files["system/sphSchemes"] += std::string("integration { scheme ") + scheme + "; }\n";
        const Scene s(files);
        ASSERT_EQ(s.errors, "");
        const auto limit = s.simulation->stepLimit();
        EXPECT_EQ(limit.by, "diffusion of dye");
        EXPECT_NEAR(limit.deltaT, factor * sqr(1.3 * spacing) / 20, 1e-12);
    }
}

// A run that stops and goes on ends with the same bytes.
TEST(ScalarTransport, RestartsToTheLastBit)
{
    auto files = channelCase();
    files["constant/scalarTransport"] = "dye { D 0.01; initial " + wave + "; walls { top 0.5; } }\n";
    for (const char* scheme : {"predictorCorrector", "leapfrog", "semiImplicit"})
    {
        files["system/sphSchemes"] =
            std::string("resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\nintegration { scheme ") + scheme + "; }\n";
        const TestCase whole(files);
        for (const char* program : {"packParticles", "meshToGhost", "sphFoamLike"}) whole.runWell(program);
        const TestCase parts(files);
        parts.replace("system/controlDict", "endTime 0.08", "endTime 0.04");
        for (const char* program : {"packParticles", "meshToGhost", "sphFoamLike"}) parts.runWell(program);
        parts.replace("system/controlDict", "endTime 0.04", "endTime 0.08");
        parts.runWell("sphFoamLike");
        EXPECT_EQ(difference(whole.files("0.08/lagrangian"), parts.files("0.08/lagrangian")), "") << scheme;
        EXPECT_TRUE(whole.has("0.08/lagrangian/sph/dye"));
    }
}

// What comes in has the inlet's value, and what has come in, gone out and diffused into what is held makes up what there is.
TEST(ScalarTransport, ComesInThroughOpenings)
{
    auto files = openCase();
    files["constant/scalarTransport"] = "dye { D 0.1; initial 0.2; }\n";
    auto& openings = files["constant/openings"];
    const TestCase without(files);
    for (const char* program : {"packParticles", "meshToGhost"}) without.runWell(program);
    const auto missing = without.run("sphFoamLike");
    EXPECT_EQ(missing.code, 1);
    EXPECT_NE(missing.err.find("constant/openings"), std::string::npos) << missing.err;
    EXPECT_NE(missing.err.find("\"dye\""), std::string::npos) << missing.err;

    openings.replace(openings.find("phi "), 4, "dye 1; phi ");
    for (const char* scheme : {"semiImplicit", "leapfrog", "predictorCorrector", "symplecticEuler"})
    {
        files["system/sphSchemes"] =
            std::string("resolution { spacing 0.05; support 2.6; kernel quinticSpline; }\nshifting 2;\nintegration { scheme ") + scheme +
            "; }\n";
        const TestCase open(files);
        for (const char* program : {"packParticles", "meshToGhost"}) open.runWell(program);
        const auto log = open.runWell("sphFoamLike");
        std::smatch off;
        auto from = log.cbegin();
        Largest worst;
        int found = 0;
        const std::regex line("balance: mass off by .*, dye by ([-+0-9.e]+)");
        for (; std::regex_search(from, log.cend(), off, line); from = off.suffix().first, ++found) worst(std::stod(off[1]));
        EXPECT_GT(found, 2) << scheme;
        EXPECT_LT(worst.value(), 1e-13) << scheme;
    }
}

void expectError(const Files& files, const std::string& error)
{
    const Scene s(files);
    EXPECT_NE(s.errors.find(error), std::string::npos) << "not in: " << s.errors;
}
TEST(ScalarTransport, MistakesSayWhereAndWhatIsPossible)
{
    const std::string file = "constant/scalarTransport:";
    expectError(layers("dye\n{\n}\n"), file + "1: entry \"D\" is missing");
    expectError(layers("dye\n{\n    D -1;\n}\n"), file + "3: a diffusivity is 0 or more");
    expectError(layers("dye\n{\n    D [0 1 0 0 0 0 0] 1;\n}\n"), file + "3: \"D\" has dimensions");
    expectError(layers("dye\n{\n    D { heavy 1; }\n}\n"), "entry \"light\" is missing");
    expectError(layers("dye\n{\n    D { heavy 1; light 2; lihgt 3; }\n}\n"), "\"lihgt\" is not used here");
    expectError(layers("dye { D 1;\n walls { botom 1; } }\n"),
                file + "2: wall \"botom\" is unknown. Did you mean \"bottom\"? Known walls: bottom, top");
    expectError(layers("dye { D 1;\n initial \"sin($u)\"; }\n"), file + "2: ");
    expectError(layers("dye { D 1;\n inital 1; }\n"), "Did you mean \"initial\"?");
    expectError(layers("dye 3;\n"), "scalar \"dye\" must be a dictionary");
    for (const char* name : {"U", "p", "phase", "positions", "rho", "kappa", "phi", "dUdt", "coordinates"})
        expectError(layers("\n" + std::string(name) + " { D 1; }\n"), file + "2: \"" + name + "\" is the name of a field already");
    expectError(layers("dye { D 1; }\ndye_0 { D 1; }\n"), file + "2: \"dye_0\" is the name of a field already");
    expectError(layers("\"a/b\" { D 1; }\n"), "is no name of a scalar");
    auto files = openCase();
    files["constant/scalarTransport"] = "velocity { D 1; }\n";
    const TestCase open(files);
    for (const char* program : {"packParticles", "meshToGhost"}) open.runWell(program);
    const auto outcome = open.run("sphFoamLike");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("is an entry of every opening"), std::string::npos) << outcome.err;
}

}
}
