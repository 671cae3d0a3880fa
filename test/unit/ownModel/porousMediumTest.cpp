/// The model that doc/ownModel.md brings in, read behind those of the suite: hand values, the flow that it slows, its limit, mistakes.
#include "models/porousMedium/porousMedium.hpp"
#include "CaseScene.hpp"
#include "models/porousMedium/PorousDrag.hpp"
#include "solver/TimeStepLimits.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

constexpr double nu = 0.01, g = 1; // [m^2/s], [m/s^2]

/// Fluid in a square that repeats in both directions, driven along x; it has no walls.
Files plugFlow(const std::string& porousMedium)
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.1; support 2.6; kernel wendlandC2; }\nintegration { scheme predictorCorrector; }\n";
    files["constant/geometry"] = "dimension 2; domain { min (0 0 0); max (1 1 0); periodic (x y); }\nwalls { }\n";
    files["constant/porousMedium"] = porousMedium;
    return files;
}

/// The case, with the model read behind all others.
struct OwnModelScene : CaseScene
{
    explicit OwnModelScene(const Files& files) : CaseScene(files)
    {
        const auto schemes = theCase.dictionary("system/sphSchemes"), phases = theCase.dictionary("constant/phaseProperties");
        try
        {
            porousMediumModel().read(
                {theCase, geometry, schemes, phases, settings, [](const Settings& s, const Measured& m) { return stepLimits(s, m); }});
            theCase.diagnostics().throwIfAny();
            simulation = makeSimulation(settings, geometry, cloud(0), {});
        }
        catch (const CaseError& e)
        {
            errors = e.what();
        }
    }
    /// Speed along x after a time, in so many steps.
    double speedAfter(double time, int steps)
    {
        for (int n = 0; n < steps; ++n) simulation->step(n * time / steps, time / steps);
        return (*this)["U"][0];
    }
};

struct Place
{
    Vector<2> x, v;
};

TEST(PorousDrag, HasTheValuesOfItsFormulaInItsBoxAndNoneOutside)
{
    const PorousDrag drag{{300, 8, {0, 0, 0}, {1, 1, 0}}, nu};
    const auto a = drag(Place{{0.5, 0.5}, {3, -4}});
    EXPECT_NEAR(a.x, -(0.01 * 300 + 0.5 * 5 * 8) * 3, 1e-12);
    EXPECT_NEAR(a.y, (0.01 * 300 + 0.5 * 5 * 8) * 4, 1e-12);
    EXPECT_EQ(mag(drag(Place{{0.5, 1.5}, {3, -4}})), 0);
}

// v = g/(nu d) (1 - exp(-nu d t)) by Darcy's part alone; half the step has a quarter of the error.
TEST(PorousMedium, StartsAFlowAsDarcyHasItToSecondOrder)
{
    const double d = 400, time = 0.25, exact = g / (nu * d) * (1 - std::exp(-nu * d * time));
    OwnModelScene coarse(plugFlow("d 400;")), fine(plugFlow("d 400;"));
    ASSERT_EQ(coarse.errors, "");
    const double error = coarse.speedAfter(time, 100) / exact - 1, half = fine.speedAfter(time, 200) / exact - 1;
    EXPECT_LT(std::abs(half), 1e-5);
    EXPECT_NEAR(error / half, 4, 0.2);
}

// Where it is steady, g = (nu d + v f/2) v; half of it by either part, and the fluid moves by a twentieth of a spacing until then.
TEST(PorousMedium, ComesToTheSpeedOfForchheimer)
{
    const double d = 4000, f = 3000, steady = (std::sqrt(sqr(nu * d) + 2 * f * g) - nu * d) / f;
    OwnModelScene scene(plugFlow("d 4000; f 3000;"));
    ASSERT_EQ(scene.errors, "");
    EXPECT_NEAR(scene.speedAfter(0.25, 250) / steady, 1, 1e-6);
}

TEST(PorousMedium, LimitsTheStepByTheFastestParticle)
{
    OwnModelScene scene(plugFlow("d 400; f 30;"));
    ASSERT_EQ(scene.errors, "");
    Measured measured;
    measured.maxSpeed = 2;
    const auto limit = porousMediumModel().limits.at(0)(scene.settings, measured);
    ASSERT_TRUE(limit);
    EXPECT_DOUBLE_EQ(limit->deltaT, 0.5 / (nu * 400 + 0.5 * 2 * 30));
}

TEST(PorousMedium, WithoutItsFileThereIsNothingOfIt)
{
    auto files = plugFlow("");
    files.erase("constant/porousMedium");
    OwnModelScene scene(files);
    ASSERT_EQ(scene.errors, "");
    EXPECT_EQ(std::count(scene.settings.terms.begin(), scene.settings.terms.end(), PorousDrag::name), 0);
    EXPECT_FALSE(porousMediumModel().limits.at(0)(scene.settings, {}));
}

std::string mistake(const std::string& porousMedium) { return OwnModelScene(plugFlow(porousMedium)).errors; }
TEST(PorousMedium, MistakesAreSaidWithFileAndLine)
{
    EXPECT_NE(mistake("f 3;").find("porousMedium"), std::string::npos);
    EXPECT_NE(mistake("\nd -3;").find("constant/porousMedium:2: \"d\" must not be negative, found -3"), std::string::npos)
        << mistake("\nd -3;");
    EXPECT_NE(mistake("d 3; max (-1 1 0);").find("the box has no volume"), std::string::npos);
    EXPECT_NE(mistake("d 3; g 4;").find("\"g\" is"), std::string::npos) << mistake("d 3; g 4;");
}

}
}
