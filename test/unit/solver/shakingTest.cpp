/// Gravity that varies with time is that of the middle of each step, for forces and walls alike.
#include "Largest.hpp"
#include "periodicSquare.hpp"
#include "solver/Simulation.hpp"
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test
{
namespace
{

Files shaken(Files files, const std::string& value, const std::string& shaking)
{
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value " + value + "; shaking \"" + shaking + "\";\n";
    return files;
}

/// Liquid without walls, shaken from rest for 0.25 s: its velocity at the end, the same of all particles but for `uneven`.
struct Shaken
{
    double x = 0, y = 0;
    Largest uneven;

    Shaken(const std::string& integrator, int steps)
    {
        auto files = shaken(channelCase(), "(0 0 0)", "vector(3*cos(2*pi()*$t), 4*$t, 0)");
        files["system/sphSchemes"] =
            "resolution { spacing 0.1; support 2.6; kernel wendlandC4; }\nintegration { scheme " + integrator + "; }\n";
        files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 20; soundSpeed 8; exponent 1; }\n";
        const auto settings = settingsOf(files);
        const auto g = periodicSquare();
        Cloud cloud;
        for (int a = 0; a < 100; ++a)
        {
            cloud.x.push_back(0.1 * (a % 10) + 0.05);
            cloud.y.push_back(0.1 * (a / 10) + 0.05);
            cloud.z.push_back(0);
        }
        const auto simulation = makeSimulation(settings, g, cloud, {});
        for (int k = 0; k < steps; ++k) simulation->step(0.25 * k / steps, 0.25 / steps);
        const auto& U = simulation->field("U").component;
        x = U[0][0];
        y = U[1][0];
        for (std::size_t i = 0; i < simulation->size(); ++i)
        {
            uneven(U[0][i] - x);
            uneven(U[1][i] - y);
        }
    }
};

// The mean over a step of what is linear in time is its middle, exactly; that of the cosine comes near with the square of the step.
TEST(Shaking, IsOfSecondOrder)
{
    const double exact = 3 / (2 * std::numbers::pi);
    for (const char* integrator : {"predictorCorrector", "leapfrog", "symplecticEuler", "semiImplicit", "implicit"})
    {
        SCOPED_TRACE(integrator);
        const Shaken coarse(integrator, 25), fine(integrator, 50);
        EXPECT_NEAR(fine.y, 2 * 0.0625, 1e-9);
        EXPECT_LT(fine.uneven.value(), 1e-9);
        EXPECT_NEAR(std::abs(coarse.x - exact) / std::abs(fine.x - exact), 4, 0.1);
    }
}

// How fast a vessel throws its water no formula knows: the log says that the user has to.
TEST(Shaking, IsNotInTheAutomaticSoundSpeed)
{
    auto files = shaken(channelCase(), "(0 -9.81 0)", "vector(30*sin($t), 0, 0)");
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 20; soundSpeed automatic; }\nexpected { depth 1; }\n";
    const auto said = [](const Files& given) {
        return fmt::format("{}", fmt::join(settingsOf(given).reasons, "\n")).find("`shaking` of constant/g is not in it") !=
               std::string::npos;
    };
    EXPECT_TRUE(said(files));
    files["constant/g"] = "value (0 -9.81 0);\n";
    EXPECT_FALSE(said(files));
}

// The same bytes, walls with their momentum balance and hydrostatic pressure included; and without it the channel stands still.
TEST(Shaking, ThatIsConstantIsGravity)
{
    const TestCase constant(channelCase()), sameShaken(shaken(channelCase(), "(0.25 0 0)", "vector(0.75, 0, 0)"));
    for (const auto* c : {&constant, &sameShaken})
    {
        c->runWell("packParticles");
        c->runWell("meshToGhost");
        c->runWell("sphFoamLike");
    }
    EXPECT_EQ(difference(constant.files("0.08/lagrangian"), sameShaken.files("0.08/lagrangian")), "");
}

// Height has the gravity of the moment, while a case runs and afterwards: -sum m g(t) y of the particles that the time folder has, and of
// no component along which the domain is periodic.
TEST(Shaking, IsInThePotentialEnergy)
{
    auto files = shaken(channelCase(), "(0 -1 0)", "vector(0.5, -20*$t, 0)");
    files["system/controlDict"] += "functions { sums { type conservation; } }\n";
    const TestCase c(files);
    for (const char* program : {"packParticles", "meshToGhost", "sphFoamLike"}) c.runWell(program);
    const auto written = [&] { return c.read("postProcessing/sums/0/conservation.dat"); };
    const auto energyAt = [](const std::string& table, const std::string& time)
    {
        std::istringstream lines(table);
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with(time + "\t")) return std::stod(line.substr(line.rfind('\t') + 1));
        ADD_FAILURE() << "no row of time " << time << " in\n" << table;
        return 0.0;
    };
    const auto table = written();
    for (const auto& [time, g] : {std::pair{"0.04", 1.8}, {"0.08", 2.6}})
    {
        const Case theCase(c.folder());
        const auto cloud = readCloud(c.folder(), time, "sph", theCase.diagnostics());
        double expected = 0;
        for (std::size_t i = 0; i < cloud.size(); ++i) expected += cloud.fields.at("m").component[0][i] * g * cloud.y[i];
        EXPECT_NEAR(energyAt(table, time) / expected, 1, 1e-12) << time;
    }
    std::filesystem::remove_all(c.folder() / "postProcessing");
    c.runWell("sphPostProcess");
    for (const std::string time : {"0.04", "0.08"}) EXPECT_NEAR(energyAt(written(), time) / energyAt(table, time), 1, 1e-12) << time;
}

// Liquid that falls as a whole under a gravity that grows: the energy that it holds is the work that the account of energy was given. By
// the trapezoidal rule a step has it to (dt/t)^2/2 of the whole, 2e-4 in 50 steps.
TEST(Shaking, DoesTheWorkThatTheEnergyBalanceHas)
{
    auto files = shaken(channelCase(), "(0 -1 0)", "vector(0, -40*$t, 0)");
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 0; soundSpeed 8; exponent 1; }\n";
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\nintegration { scheme leapfrog; }\n";
    const auto settings = settingsOf(files);
    const auto square = periodicSquare();
    Cloud cloud;
    for (int a = 0; a < 400; ++a)
    {
        cloud.x.push_back(0.05 * (a % 20) + 0.025);
        cloud.y.push_back(0.05 * (a / 20) + 0.025);
        cloud.z.push_back(0);
    }
    const auto simulation = makeSimulation(settings, square, cloud, {});
    const auto before = simulation->energy();
    const int steps = 50;
    for (int k = 0; k < steps; ++k) simulation->step(0.1 * k / steps, 0.1 / steps);
    const auto after = simulation->energy();
    EXPECT_NEAR(simulation->gravity().y, -5, 1e-12);
    EXPECT_NEAR(after.held(), 0.5 * 1000 * sqr(0.1 + 0.2), 1e-3);
    EXPECT_NEAR((after.supplied - before.supplied) / after.held(), 1, 1e-3);
}

TEST(Shaking, ThatCannotBeIsRefused)
{
    const auto refused = [](const Files& files, const std::vector<std::string>& words)
    {
        try
        {
            settingsOf(files);
            FAIL();
        }
        catch (const CaseError& e)
        {
            for (const auto& word : words) EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    refused(shaken(channelCase(), "(0 0 0)", "9.81*sin($t)"),
            {"constant/g:1", "gives a number: an acceleration is a vector, vector(x, y, z)"});
    refused(shaken(channelCase(), "(0 0 0)", "vector(0, 9.81*sin($time), 0)"), {"constant/g:1", "$time is unknown here", "$t"});
    refused(shaken(channelCase(), "(0 0 0)", "vector(0, 0, 9.81)"), {"constant/g:1", "\"shaking\""});

    refused(shaken(channelCase(), "(0 0 0)", "$t < 0.1 ? vector(1, 0, 0) : 0"),
            {"constant/g:1", "a condition chooses between a number and a vector"});

    // Where it has a value at the start, and none later.
    const auto settings = settingsOf(shaken(channelCase(), "(0 0 0)", "vector(sqrt(0.09 - $t), 0, 0)"));
    const auto g = periodicSquare();
    Cloud cloud;
    cloud.x = cloud.y = {0.5};
    cloud.z = {0};
    const auto simulation = makeSimulation(settings, g, cloud, {});
    EXPECT_NO_THROW(simulation->step(0, 0.01));
    EXPECT_THROW(simulation->step(0.1, 0.01), CaseError);

    auto creeping = shaken(suspensionCase(), "(0 0 0)", "vector(9.81*sin($t), 0, 0)");
    auto& schemes = creeping["system/sphSchemes"];
    schemes.replace(schemes.find("shifting 2;"), 11, "");
    schemes.replace(schemes.find("semiImplicit"), 12, "quasiSteady");
    refused(creeping, {"quasiSteady leaves particles where they are, and constant/g has `shaking`"});
}

}
}
