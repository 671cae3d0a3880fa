/// Mistakes in the words of a scheme, with file and line; and the choices that are made for the user.
#include "geometry/Plane.hpp"
#include "models/shifting/TransportVelocity.hpp"
#include "models/suspension/Migration.hpp"
#include "models/suspension/SuspensionConstants.hpp"
#include "models/tension/Tensions.hpp"
#include "models/viscosity/ArtificialViscosity.hpp"
#include "smallCases.hpp"
#include "solver/TimeStepLimits.hpp"
#include "solver/readSettings.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

namespace sph::test
{
namespace
{

Geometry channelGeometry()
{
    Geometry g;
    g.dimension = 2;
    g.high = {1, 1, 0};
    g.periodic = {true, false, false};
    g.walls.resize(2);
    g.originals = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0},
                   {std::make_shared<Plane>(Vector<3>{0, 1, 0}, Vector<3>{0, -1, 0}), 1}};
    repeatPeriodically(g, 0.2);
    return g;
}

struct Reading
{
    Settings settings;
    std::string errors;
};
Reading reading(const Files& files)
{
    const TestCase folder(files);
    const Case c(folder.folder());
    Reading r;
    try
    {
        r.settings = readSettings(c, channelGeometry());
        c.diagnostics().throwIfAny();
    }
    catch (const CaseError& e)
    {
        r.errors = e.what();
    }
    return r;
}
Files edited(Files files, const std::string& file, const std::string& from, const std::string& to)
{
    auto& text = files[file];
    text.replace(text.find(from), from.size(), to);
    return files;
}
void expectError(const Files& files, const std::string& error)
{
    EXPECT_NE(reading(files).errors.find(error), std::string::npos) << reading(files).errors;
}

TEST(Settings, OfGoodCasesAreRead)
{
    for (const auto& files : {channelCase(), dropCase(), grainCase()}) EXPECT_EQ(reading(files).errors, "");
}

TEST(Settings, UnknownWordsAreSuggested)
{
    const std::string schemes = "system/sphSchemes";
    expectError(edited(channelCase(), schemes, "secondOrder", "secondorder"), "system/sphSchemes:2: ");
    expectError(edited(channelCase(), schemes, "predictorCorrector", "leapFrog"), "Did you mean \"leapfrog\"?");
    expectError(edited(channelCase(), schemes, "wallVelocity", "pressureGradient huAdam; wallVelocity"), "Did you mean \"huAdams\"?");
    expectError(edited(channelCase(), schemes, "wallVelocity", "density numberdensity; wallVelocity"), "Did you mean \"numberDensity\"?");
    expectError(edited(channelCase(), schemes, "support 2.6", "support 26"), "system/sphSchemes:1: ");
}

// Terms in single precision: no finer than floats hold, no wider than places do.
TEST(Settings, MixedPrecisionIsRefusedWhereFloatsDoNotHold)
{
    const std::string schemes = "system/sphSchemes";
    const auto mixed = edited(channelCase(), schemes, "wallVelocity", "precision mixed; wallVelocity");
    EXPECT_EQ(reading(mixed).errors, "");
    expectError(edited(mixed, schemes, "spacing 0.05", "spacing 9e-7"),
                "system/sphSchemes:2: single precision holds the terms of pairs down to a spacing of 1e-06 m, and it is 9e-07 m here");
    expectError(
        edited(mixed, schemes, "spacing 0.05", "spacing 9e-6"),
        "system/sphSchemes:2: places in single precision are multiples of 2^-30 of the domain, enough for 1e+05 spacings, and it has 1.11e+05");
}

// Words of a free surface, and the term that each selects; without them none of these terms is there.
TEST(Settings, AFreeSurfaceHasTheTermsThatItsWordsName)
{
    const auto selects = [](const Files& files, const std::string& term)
    {
        const auto terms = reading(files).settings.terms;
        return std::find(terms.begin(), terms.end(), term) != terms.end();
    };
    EXPECT_EQ(reading(columnCase()).errors, "");
    for (const char* term : {"tensileControlledPressure", "surfaceShifting", "artificialViscosity", "renormalisedDiffusion"})
    {
        EXPECT_TRUE(selects(columnCase(), term)) << term;
        EXPECT_FALSE(selects(grainCase(), term)) << term;
    }
    EXPECT_TRUE(selects(grainCase(), "particleShifting"));
    EXPECT_TRUE(selects(grainCase(), "densityDiffusion"));
    EXPECT_EQ(reading(columnCase()).settings.coefficients.of<ArtificialNumber>().mu, 0.02 * (0.5 * 3 * 0.05) * 40 * 1000);
    EXPECT_EQ(reading(columnCase()).settings.chosen.at("wallPressure"), "detaching");
    EXPECT_NE(reading(channelCase()).settings.chosen.at("wallPressure"), "detaching");
    expectError(edited(columnCase(), "system/sphSchemes", "tangential", "tangent"), "Did you mean \"tangential\"?");
    expectError(edited(columnCase(), "system/sphSchemes", "Viscosity 0.02", "Viscosity -1"), "system/sphSchemes:4: ");
    expectError(edited(columnCase(), "system/sphSchemes", "density continuity;", ""), "goes with `density continuity;` alone");
}

// Walls by layers: the particles' rules are those of ghosts, but for what needs a mirror image.
TEST(Settings, WallsByLayersHaveNoInterfaceAndStick)
{
    const std::string schemes = "system/sphSchemes";
    const auto with = [&](const Files& files, const std::string& words)
    { return edited(files, schemes, "\nintegration", "\n" + words + "\nintegration"); };
    EXPECT_EQ(reading(with(channelCase(), "walls layers;")).errors, "");
    EXPECT_EQ(reading(with(channelCase(), "walls layers;")).settings.chosen.at("walls"), "layers");
    EXPECT_NE(reading(with(channelCase(), "walls reflected;")).settings.chosen.at("walls"), "layers");
    EXPECT_EQ(reading(with(suspensionCase(), "walls layers;")).errors, "");
    expectError(with(channelCase(), "walls layer;"), "system/sphSchemes:3: walls \"layer\" is unknown. Did you mean \"layers\"?");
    expectError(with(dropCase(), "walls layers;"), "system/sphSchemes:2: layers have no interface to continue");
    expectError(edited(with(channelCase(), "walls layers;"), schemes, "secondOrder", "freeSlip"),
                "system/sphSchemes:2: freeSlip needs what carries");
}

// A word about what the case has not is a mistake; where it is there and 0, as in variants that switch it off, it is meant.
TEST(Settings, FormsOfWhatIsNotThere)
{
    const std::string schemes = "system/sphSchemes";
    for (const char* word : {"shiftingAtSurface tangential", "shiftingSpeed largest"})
    {
        expectError(edited(channelCase(), schemes, "wallVelocity", std::string(word) + ";\nwallVelocity"),
                    "system/sphSchemes:2: does nothing without shifting");
        EXPECT_EQ(reading(edited(channelCase(), schemes, "wallVelocity", "shifting 0; " + std::string(word) + "; wallVelocity")).errors,
                  "");
    }
    expectError(edited(channelCase(), schemes, "wallVelocity", "densityDiffusionForm antuono; wallVelocity"),
                "system/sphSchemes:2: does nothing without densityDiffusion");
}

// Several phases are shifted each within itself unless `any` says otherwise, with a free surface's law behind it or without; one phase has no interface.
TEST(Settings, ShiftingKeepsPhasesApart)
{
    const auto drop = [](const std::string& words)
    { return edited(dropCase(), "system/sphSchemes", "integration", words + "\nintegration"); };
    const auto selected = [](const Files& files)
    {
        const auto read = reading(files);
        EXPECT_EQ(read.errors, "");
        std::vector<std::string> found;
        for (const auto& term : read.settings.terms)
            if (term.ends_with("hifting") || term.starts_with("concentration")) found.push_back(term);
        return found;
    };
    using Terms = std::vector<std::string>;
    EXPECT_EQ(selected(drop("")), Terms{});
    EXPECT_EQ(selected(drop("shifting 2;")), Terms{"interfaceShifting"});
    EXPECT_EQ(selected(drop("shifting 2; shiftingAtInterface none;")), Terms{"interfaceShifting"});
    EXPECT_EQ(selected(drop("shifting 2; shiftingAtInterface any;")), Terms{"particleShifting"});
    EXPECT_EQ(selected(drop("shifting 2; shiftingAtSurface tangential;")), (Terms{"surfaceShifting", "concentrationWithinPhase"}));
    EXPECT_EQ(selected(drop("shifting 2; shiftingAtInterface any; shiftingAtSurface tangential;")),
              (Terms{"surfaceShifting", "concentrationGradient"}));
    EXPECT_EQ(selected(columnCase()), (Terms{"surfaceShifting", "concentrationGradient"}));
    const auto alone = [](const std::string& words)
    {
        auto files = channelCase();
        files["system/sphSchemes"] = "resolution { spacing 0.05; support 3; kernel wendlandC2; }\ngas none;\n" + words;
        return files;
    };
    EXPECT_EQ(selected(alone("")), Terms{"interiorShifting"});
    EXPECT_EQ(selected(alone("shifting 0;\n")), Terms{});
    expectError(edited(grainCase(), "system/sphSchemes", "shifting 2;", "shifting 2; shiftingAtInterface none;"),
                "system/sphSchemes:2: is between phases");
}

TEST(Settings, ATransportVelocityHasItsTermsAndStandsAlone)
{
    const std::string schemes = "system/sphSchemes";
    const auto with = [&](const std::string& words) { return edited(channelCase(), schemes, "wallVelocity", words + "\nwallVelocity"); };
    const auto uniform = reading(with("transportVelocity 0.5;")), local = reading(with("transportVelocity 1; transportPressure local;"));
    EXPECT_EQ(uniform.errors + local.errors, "");
    EXPECT_EQ(uniform.settings.coefficients.of<TransportNumber>().C, 0.5);
    const auto has = [](const Reading& r, const char* term) { return std::count(r.settings.terms.begin(), r.settings.terms.end(), term); };
    EXPECT_EQ(has(uniform, "transportVelocity") + has(uniform, "transportStress") + has(local, "localTransportVelocity"), 3);
    EXPECT_EQ(has(local, "transportVelocity") + has(reading(channelCase()), "transportStress"), 0);
    expectError(with("transportVelocity 1; shifting 2;"), "system/sphSchemes:2: keeps particles evenly spaced, and so does shifting");
    expectError(with("transportPressure local;"), "system/sphSchemes:2: does nothing without transportVelocity");
    expectError(edited(with("transportVelocity 1;"), schemes, "predictorCorrector", "semiImplicit"), "goes with steps that sound limits");
}

TEST(Settings, SurfaceTensionOnceInAStepOfParts)
{
    const std::string schemes = "system/sphSchemes";
    const auto with = [&](const std::string& words) { return edited(dropCase(), schemes, "predictorCorrector", words); };
    const auto settings = reading(with("leapfrog; maxSubSteps 3")).settings;
    EXPECT_EQ(settings.integration.maxSubSteps, 3);
    EXPECT_DOUBLE_EQ(settings.integration.factors.capillary, 0.5 * StepFactors{}.capillary);
    EXPECT_EQ(settings.slowTerms, (std::vector<std::string>{"curvatureForce", "smoothedColourGradient"}));
    EXPECT_EQ(std::count(settings.terms.begin(), settings.terms.end(), "curvatureForce"), 0);
    EXPECT_EQ(std::count(settings.terms.begin(), settings.terms.end(), "harmonicViscosity"), 1);
    EXPECT_TRUE(reading(dropCase()).settings.slowTerms.empty());
    for (const char* words : {"leapfrog; maxSubSteps 4", "leapfrog; maxSubSteps 0", "leapfrog; maxSubSteps -3"})
        expectError(with(words), "system/sphSchemes:2: is an odd number");
    expectError(with("semiImplicit; maxSubSteps 3"), "system/sphSchemes:2: goes with explicit integration");
    expectError(edited(channelCase(), schemes, "predictorCorrector", "leapfrog; maxSubSteps 3"),
                "without surface tension nothing acts more slowly than sound");
}

TEST(Settings, SurfaceTensionOfUnknownPhases)
{
    expectError(edited(dropCase(), "constant/phaseProperties", "(liquid gas) 1", "(liquit gas) 1"),
                "constant/phaseProperties:4: phase \"liquit\" is unknown. Did you mean \"liquid\"?");
    expectError(edited(dropCase(), "constant/phaseProperties", "(liquid gas) 1", "(liquid liquid) 1"),
                "\"liquid\" has no surface tension with itself");
    expectError(edited(dropCase(), "constant/phaseProperties", "(liquid gas) 1", "(liquid gas) -1"), "must not be negative");
}

/// A third phase, oil, in the drop's case.
Files threePhaseCase(const std::string& sigma)
{
    auto files = edited(dropCase(), "constant/phaseProperties", "phases (liquid gas);", "phases (liquid gas oil);");
    files["constant/phaseProperties"] += "oil { rho 0.8; mu 0.05; soundSpeed 20; }\n";
    return edited(files, "constant/phaseProperties", "sigma ( (liquid gas) 1 );", sigma);
}

// A pair left out would mix, and of two values the last would count: neither without a word.
TEST(Settings, EachPairOfPhasesHasOneSurfaceTension)
{
    EXPECT_EQ(reading(threePhaseCase("sigma ( (liquid gas) 1 (oil gas) 0.5 (liquid oil) 0 );")).errors, "");
    EXPECT_EQ(reading(threePhaseCase("")).errors, "");
    expectError(
        threePhaseCase("sigma ( (liquid gas) 1 );"),
        "constant/phaseProperties:4: sigma of (liquid oil), (gas oil) is missing: each pair of phases has a surface tension, 0 for none");
    expectError(
        threePhaseCase("sigma ( (liquid gas) 1 (oil gas) 0.5 (liquid oil) 0 (gas liquid) 2 );"),
        "constant/phaseProperties:4: the surface tension of gas and liquid is there twice, (liquid gas) 1 and (gas liquid) 2: each pair has one");
}

// Each phase against all others: one force for each, and none of the terms of two phases; of four phases whose tensions are no sums of a share of each the
// interface stress, which needs none.
TEST(Settings, MoreThanTwoPhasesHaveACurvatureEach)
{
    const auto has = [](const Reading& r, const std::string& term)
    { return std::count(r.settings.terms.begin(), r.settings.terms.end(), term); };
    const auto three = reading(threePhaseCase("sigma ( (liquid gas) 1 (oil gas) 0.5 (liquid oil) 0.6 );"));
    EXPECT_EQ(three.errors, "");
    for (const char* phase : {"liquid", "gas", "oil"}) EXPECT_EQ(has(three, std::string("curvatureForce of ") + phase), 1);
    EXPECT_EQ(has(three, "evenCurvatureForce") + has(three, "curvatureForce") + has(three, "interfaceStress"), 0);
    EXPECT_EQ(has(reading(dropCase()), "curvatureForce of liquid"), 0);

    const auto four = [](double last)
    {
        auto files =
            edited(threePhaseCase(
                       fmt::format("sigma ( (liquid gas) 1 (oil gas) 0.5 (liquid oil) 0.7 (tar liquid) 0.9 (tar gas) 0.7 (tar oil) {} );",
                                   last)),
                   "constant/phaseProperties", "gas oil);", "gas oil tar);");
        files["constant/phaseProperties"] += "tar { rho 0.8; mu 0.05; soundSpeed 20; }\n";
        return files;
    };
    EXPECT_EQ(has(reading(four(0.4)), "curvatureForce of tar"), 1); // shares 0.6, 0.4, 0.1, 0.3
    EXPECT_EQ(has(reading(four(0.5)), "interfaceStress"), 1);
    auto files = four(0.5);
    files["system/sphSchemes"] += "surfaceTension curvature;\n";
    const auto asked = reading(files);
    EXPECT_EQ(asked.errors, "");
    EXPECT_EQ(has(asked, "curvatureForce of tar"), 1);
    const auto& reasons = asked.settings.reasons;
    EXPECT_TRUE(std::any_of(reasons.begin(), reasons.end(),
                            [](const auto& r) { return r.find("by a share of each: where three meet") != std::string::npos; }));
}

// With file and line of constant/geometry, from where meshToGhost has carried them.
TEST(Settings, AnglesOfMoreThanTwoPhasesComeInPairs)
{
    const auto read = [](const Files& files, const std::vector<WallProperties::PhaseAngle>& angles)
    {
        const TestCase folder(files);
        const Case c(folder.folder());
        auto g = channelGeometry();
        g.walls[1].name = "top";
        g.walls[1].wets = true;
        g.walls[1].contactAngle = 60;
        g.walls[1].contactAngles = angles;
        g.walls[1].anglesAt = {"constant/geometry", 6};
        Reading r{readSettings(c, g), ""};
        try
        {
            c.diagnostics().throwIfAny();
        }
        catch (const CaseError& e)
        {
            r.errors = e.what();
        }
        return r;
    };
    const auto three = threePhaseCase("sigma ( (liquid gas) 1 (oil gas) 0.5 (liquid oil) 0.6 );");
    const auto expect = [](const std::string& errors, const std::string& what)
    { EXPECT_NE(errors.find(what), std::string::npos) << errors; };
    expect(read(three, {}).errors, "constant/geometry:6: wall \"top\": contactAngle 60 is of two phases, and here are 3");
    expect(read(three, {{"liquid", "gas", 60}}).errors,
           "constant/geometry:6: wall \"top\": its contact angles do not connect the phases (liquid gas), (oil)");
    expect(read(three, {{"liquid", "gas", 30}, {"gas", "oil", 60}}).errors, "no angle of (liquid oil) goes with the others");
    const auto good = read(three, {{"liquid", "gas", 60}, {"oil", "gas", 80}});
    EXPECT_EQ(good.errors, "");
    const auto& tension = tensionsOf(good.settings.coefficients).ofWalls;
    ASSERT_EQ(tension.size(), 6u); // walls x phases
    EXPECT_EQ(tension[0], 0);
    EXPECT_NEAR(tension[4] - tension[3], 0.5, 1e-14);
    EXPECT_TRUE(std::count(good.settings.terms.begin(), good.settings.terms.end(), "wallPotential") > 0);

    const auto plain = read(dropCase(), {}).settings, named = read(dropCase(), {{"gas", "liquid", 120}}).settings;
    ASSERT_EQ(tensionsOf(named.coefficients).ofWalls.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(tensionsOf(plain.coefficients).ofWalls[k], tensionsOf(named.coefficients).ofWalls[k], 1e-15);
}

TEST(Settings, WrongDimensionsAndSigns)
{
    expectError(edited(channelCase(), "constant/phaseProperties", "mu 10", "mu [0 2 -1 0 0 0 0] 10"), "constant/phaseProperties:2: ");
    expectError(edited(channelCase(), "constant/phaseProperties", "mu 10", "mu -10"), "constant/phaseProperties:2: ");
    expectError(edited(channelCase(), "system/sphSchemes", "spacing 0.05", "spacing [1 0 0 0 0 0 0] 0.05"), "system/sphSchemes:1: ");
}

TEST(Settings, OfAPhaseThatIsNotDescribed)
{
    expectError(edited(channelCase(), "constant/phaseProperties", "phases (water)", "phases (water oil)"), "oil");
}

// The largest of what `expected` implies, times ten: sqrt(|g| depth) = sqrt(1 x 4) = 2 m/s against 1 m/s.
TEST(Settings, ChooseTheSoundSpeedAndSayWhy)
{
    auto files = edited(channelCase(), "constant/phaseProperties", "soundSpeed 15;", "soundSpeed automatic;");
    files["constant/phaseProperties"] += "expected { velocity 1; depth 4; }\n";
    const auto r = reading(files);
    EXPECT_EQ(r.errors, "");
    EXPECT_NEAR(r.settings.coefficients.soundSpeed.at(0), 20, 1e-12);
    ASSERT_FALSE(r.settings.reasons.empty());
    EXPECT_NE(r.settings.reasons[0].find("hydrostatic pressure over the expected depth"), std::string::npos) << r.settings.reasons[0];
    expectError(edited(channelCase(), "constant/phaseProperties", "soundSpeed 15;", ""), "\"soundSpeed\" of water is missing");
}

// Where viscosities differ the surface of the more viscous phase is free of stress only by the whole of it; elsewhere the transpose does nothing.
TEST(Settings, PhasesOfUnequalViscosityHaveTheWholeStress)
{
    const auto form = [](const Files& files) { return reading(files).settings.chosen.at("viscosity"); };
    const auto unequal = edited(dropCase(), "constant/phaseProperties", "rho 0.5; mu 0.05", "rho 0.5; mu 0.01");
    EXPECT_EQ(form(unequal), "newtonian");
    EXPECT_EQ(form(dropCase()), "harmonic");
    EXPECT_EQ(form(channelCase()), "harmonic");
    EXPECT_EQ(form(edited(unequal, "system/sphSchemes", "integration", "viscosity harmonic;\nintegration")), "harmonic");
    const auto terms = reading(unequal).settings.terms;
    for (const char* term : {"harmonicViscosity", "viscousGradient", "transposedViscosity"})
        EXPECT_EQ(std::count(terms.begin(), terms.end(), term), 1) << term;
}

// nu (laplacian v + 2 grad div v): compression is resisted three times as much as shear. Measured without: plane Poiseuille flow diverges.
TEST(Settings, ViscosityAlongTheLineOfCentresTakesAThirdOfTheStep)
{
    const auto harmonic = reading(channelCase()).settings;
    auto files = channelCase();
    files["system/sphSchemes"] += "viscosity cleary;\n";
    const auto r = reading(files);
    EXPECT_EQ(r.errors, "");
    EXPECT_DOUBLE_EQ(r.settings.integration.factors.viscous, harmonic.integration.factors.viscous / 3);
    const auto& terms = r.settings.terms;
    EXPECT_NE(std::find(terms.begin(), terms.end(), "singlePhaseClearyViscosity"), terms.end());
    EXPECT_EQ(std::find(terms.begin(), terms.end(), "singlePhaseViscosity"), terms.end());
}

// Young: gamma_sl - gamma_sg = -gamma cos(theta), shared by density, for each wall its own; a wall that says nothing has 90 degrees: no tension
// with either phase.
TEST(Settings, WallTensionsObeyYoungsLaw)
{
    const TestCase folder(dropCase());
    const Case c(folder.folder());
    auto g = channelGeometry();
    g.walls.resize(3);
    g.walls[0].wets = g.walls[1].wets = true;
    g.walls[0].contactAngle = 60;
    g.walls[1].contactAngle = 120;
    const auto settings = readSettings(c, g);
    const auto& tension = tensionsOf(settings.coefficients).ofWalls;
    ASSERT_EQ(tension.size(), 6u); // walls x phases
    EXPECT_NEAR(tension[0] - tension[1], -0.5, 1e-14);
    EXPECT_NEAR(tension[2] - tension[3], 0.5, 1e-14);
    EXPECT_NEAR(tension[0] / tension[1], -1 / 0.5, 1e-12);
    EXPECT_EQ(tension[4], 0);
    EXPECT_EQ(tension[5], 0);
}

/// Settings of the drop with these words in its sphSchemes and contact angles on both walls of the channel.
Settings wetting(const std::string& words, double first = 60, double second = 120)
{
    auto files = dropCase();
    files["system/sphSchemes"] += words;
    const TestCase folder(files);
    const Case c(folder.folder());
    auto g = channelGeometry();
    g.walls[0].wets = g.walls[1].wets = true;
    g.walls[0].contactAngle = first;
    g.walls[1].contactAngle = second;
    const auto settings = readSettings(c, g);
    c.diagnostics().throwIfAny();
    return settings;
}
bool selects(const Settings& settings, const std::string& term)
{
    return std::count(settings.terms.begin(), settings.terms.end(), term) > 0;
}

TEST(Settings, SemiImplicitTakesItsEntries)
{
    const auto with = [](const std::string& entries)
    { return edited(channelCase(), "system/sphSchemes", "predictorCorrector", "semiImplicit" + entries); };
    const auto settings = reading(with("; theta 0.5; tolerance 1e-9; maxIter 7")).settings;
    EXPECT_EQ(settings.integration.scheme, "semiImplicit");
    EXPECT_TRUE(settings.integration.solves);
    EXPECT_EQ(settings.integration.theta, 0.5);
    EXPECT_EQ(settings.integration.tolerance, 1e-9);
    EXPECT_EQ(settings.integration.maxIter, 7);
    EXPECT_TRUE(selects(settings, "singlePhaseViscousRate"));
    EXPECT_FALSE(selects(reading(channelCase()).settings, "singlePhaseViscousRate"));
    expectError(with("; theta 0.4"), "is 1/2 (Crank-Nicolson) to 1 (Euler)");
    expectError(with("; maxIter 0"), "maxIter is a number of steps, at least 1, not 0");
    expectError(with("; maxIter 0.5"), "\"maxIter\" must be an integer");
    auto inviscid = with("");
    auto& phases = inviscid["constant/phaseProperties"];
    phases.replace(phases.find("mu"), phases.find(';', phases.find("mu")) - phases.find("mu") + 1, "");
    expectError(inviscid, "semiImplicit and quasiSteady solve for viscosity, and there is none");
}

TEST(Settings, ImplicitTakesItsEntries)
{
    const auto with = [](const std::string& entries)
    { return edited(channelCase(), "system/sphSchemes", "predictorCorrector", "implicit" + entries); };
    const auto settings = reading(with("; tolerance 0.02; flowFactor 0.1")).settings;
    EXPECT_TRUE(settings.integration.solves && settings.integration.solvesPressure);
    EXPECT_EQ(settings.integration.tolerance, 0.02);
    EXPECT_EQ(reading(with("")).settings.integration.tolerance, 0.1);
    EXPECT_EQ(settings.integration.factors.flow, 0.1);
    EXPECT_EQ(settings.integration.responses,
              (std::vector<std::string>{"repulsionOfChange", "pressureResponse", "singlePhaseViscousResponse"}));
    EXPECT_TRUE(selects(settings, "uniformVolumeStiffness") && selects(settings, "pressureRate"));
    auto inviscid = with("");
    auto& phases = inviscid["constant/phaseProperties"];
    phases.replace(phases.find("mu"), phases.find(';', phases.find("mu")) - phases.find("mu") + 1, "");
    inviscid["system/sphSchemes"].replace(inviscid["system/sphSchemes"].find("wallVelocity secondOrder;"), 25, "");
    EXPECT_EQ(reading(inviscid).errors, "");
    EXPECT_EQ(reading(inviscid).settings.integration.responses, (std::vector<std::string>{"repulsionOfChange", "pressureResponse"}));
    EXPECT_EQ(reading(with("; theta 0.5")).settings.integration.theta, 0.5);
    EXPECT_EQ(reading(with("")).settings.integration.theta, 1);
    expectError(with("; theta 0.4"), "theta is 1/2 (Crank-Nicolson) to 1 (Euler), not 0.4");
    expectError(with("; maxSubSteps 3"), "goes with explicit integration");
    expectError(with("; } pressureGradient monaghan; unused {"), "it needs `density numberDensity` and `pressureGradient huAdams`");
    expectError(with("; } density continuity; unused {"), "it needs `density numberDensity` and `pressureGradient huAdams`");
    expectError(with("; tolerance -1"), "tolerance");
    expectError(with("; tolerance 1"), "is a share of the forces, below 1");
    expectError(edited(openCase(), "system/sphSchemes", "semiImplicit", "implicit"),
                "opening \"gate\" has a pressure, which drives the plug that it holds at the start of a step");
}

// Surface tension allows the drop steps of 0.5 (1.5 h^3/4 pi)^1/2 = 3.5e-3 s, viscosity of h^2/8 nu = 7e-4 s/nu: nu is twice mu.
TEST(Settings, AnImplicitStepLeavesViscosityOutOfItsSolveWhereSurfaceTensionBindsIt)
{
    const auto drop = [](const std::string& mu, const std::string& entries)
    {
        auto files = edited(dropCase(), "system/sphSchemes", "predictorCorrector", "implicit" + entries);
        for (const char* phase : {"liquid { rho 1; mu ", "gas { rho 0.5; mu "})
            files = edited(files, "constant/phaseProperties", phase + std::string("0.05"), phase + mu);
        return reading(files).settings;
    };
    const auto thin = drop("0.05", "");
    EXPECT_TRUE(thin.integration.viscosityAtStart);
    EXPECT_FALSE(selects(thin, "harmonicViscousRate"));
    EXPECT_TRUE(selects(thin, "harmonicViscosity"));
    EXPECT_EQ(thin.integration.responses, (std::vector<std::string>{"repulsionOfChange", "pressureResponse"}));
    EXPECT_NE(thin.reasons.back().find("viscosity, which does not shorten it, at its start"), std::string::npos) << thin.reasons.back();
    const auto limits = stepLimits(thin, {});
    EXPECT_TRUE(std::ranges::any_of(limits, [](const StepLimit& limit) { return limit.by == "viscosity"; }));
    EXPECT_EQ(leastOf(limits).by, "capillary");
    EXPECT_TRUE(drop("0.098", "").integration.viscosityAtStart);
    const auto thick = drop("0.102", "");
    EXPECT_FALSE(thick.integration.viscosityAtStart);
    EXPECT_TRUE(selects(thick, "harmonicViscousRate"));
    EXPECT_EQ(stepLimits(thick, {}).size(), 1u);
    EXPECT_FALSE(drop("0.05", "; theta 0.5").integration.viscosityAtStart); // which would no longer be of second order
}

// An implicit step is the default where surface tension would allow steps 1.5 times as long as sound and stiffness do; a form without an energy, which
// it could not solve for, is warned of.
TEST(Settings, ChooseAnImplicitStepWhereItPays)
{
    const auto with = [](const std::string& gas, const std::string& schemes)
    {
        auto files = edited(dropCase(), "system/sphSchemes", "integration { scheme predictorCorrector; }", schemes);
        return edited(files, "constant/phaseProperties", "gas { rho 0.5", "gas { rho " + gas);
    };
    const auto scheme = [&](const std::string& gas, const std::string& schemes)
    { return reading(with(gas, schemes)).settings.integration.scheme; };
    EXPECT_EQ(scheme("0.5", ""), "implicit");
    EXPECT_EQ(scheme("1e-3", ""), "implicit");
    EXPECT_EQ(reading(edited(with("0.5", ""), "constant/phaseProperties", "(liquid gas) 1", "(liquid gas) 10")).settings.integration.scheme,
              "predictorCorrector");
    EXPECT_EQ(scheme("1e-3", "integration { scheme leapfrog; }"), "leapfrog");
    EXPECT_EQ(scheme("1e-3", "scheme paper;"), "predictorCorrector");
    EXPECT_EQ(scheme("1e-3", "pressureGradient densityWeighted;"), "predictorCorrector");
    const auto settings = reading(with("1e-3", "")).settings;
    EXPECT_EQ(settings.chosen.at("pressureGradient"), "huAdams");
    EXPECT_TRUE(selects(settings, "evenCurvatureForce"));
    EXPECT_TRUE(std::ranges::any_of(settings.reasons,
                                    [](const auto& r) { return r.starts_with("integration implicit: surface tension allows steps of"); }));
    EXPECT_TRUE(selects(reading(with("1e-3", "pressureGradient densityWeighted;")).settings, "curvatureForce"));
    auto open = with("1e-3", "");
    open["constant/openings"] = "drip { type drip; points ((0.5 1 0)); radius 0.1; normal (0 -1 0); flowRate 1e-3; phase liquid; }\n";
    EXPECT_EQ(reading(open).settings.integration.scheme, "implicit");
    open["constant/openings"] += "in { type inlet; point (0 0.5 0); normal (1 0 0); pressure 10; phase liquid; }\n";
    EXPECT_EQ(reading(open).settings.integration.scheme, "predictorCorrector");
    auto nothing = with("1e-3", "surfaceTension curvature;");
    nothing["constant/phaseProperties"] = "phases ();\n";
    expectError(nothing, "there must be at least one phase");
}

std::vector<std::string> warningsOf(Files files, const std::string& schemes, const Geometry& geometry = channelGeometry())
{
    files["system/sphSchemes"] += schemes + "\n";
    const TestCase folder(files);
    const Case c(folder.folder());
    readSettings(c, geometry);
    return c.diagnostics().warnings();
}

TEST(Settings, AFormWithoutAnEnergyIsWarnedOf)
{
    const auto found = warningsOf(dropCase(), "pressureGradient densityWeighted;");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("system/sphSchemes:3: densityWeighted has no energy between phases of densities 1 : 2"), std::string::npos)
        << found[0];
    EXPECT_TRUE(
        warningsOf(edited(dropCase(), "constant/phaseProperties", "rho 0.5", "rho 1"), "pressureGradient densityWeighted;").empty());
}

TEST(Settings, APotentialOfWallsBesideTheInterfaceStressIsWarnedOf)
{
    auto geometry = channelGeometry();
    geometry.walls[0].contactAngle = 60;
    geometry.walls[0].wets = true;
    const auto found = warningsOf(dropCase(), "surfaceTension interfaceStress; contactAngle wallPotential;", geometry);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("system/sphSchemes:3: wallPotential asks the interface to bend"), std::string::npos) << found[0];
    EXPECT_TRUE(warningsOf(dropCase(), "contactAngle wallPotential;", geometry).empty());
}

TEST(Settings, AnIntegratedDensityNeedsForetoldVelocities)
{
    for (const char* integrator : {"symplecticEuler", "semiImplicit"})
        expectError(edited(channelCase(), "system/sphSchemes", "predictorCorrector;",
                           std::string(integrator) + "; } density continuity; unused {"),
                    "continuity needs velocities of the middle of a step");
}

// r^N lambda dt/2 = 1/2, r = lambda dt + sqrt(1 + (lambda dt)^2): 0.0572 for N = 50, 0.1751 for 10.
TEST(Settings, VerletTakesItsEntries)
{
    const auto with = [](const std::string& entries)
    { return edited(channelCase(), "system/sphSchemes", "predictorCorrector", "verlet" + entries); };
    for (const auto& [entries, decay] : {std::pair("", 0.05724), std::pair("; verletSteps 10", 0.17512)})
    {
        const auto settings = reading(with(entries)).settings;
        EXPECT_NEAR(settings.integration.factors.viscous / (decay * StepFactors{}.viscous), 1, 1e-3);
        EXPECT_EQ(settings.integration.factors.sound, 0.5 * StepFactors{}.sound);
        EXPECT_FALSE(settings.integration.predicts);
        std::set<std::string> state;
        for (const auto& q : settings.state) state.insert(q.value.name);
        EXPECT_TRUE(state.contains("UIncrement"));
        EXPECT_FALSE(state.contains("mIncrement"));
    }
    expectError(with("; verletSteps 1"), "system/sphSchemes:3: ");
    expectError(with("; maxSubSteps 3"), "system/sphSchemes:3: goes with steps from one level");
    expectError(edited(suspensionCase(), "system/sphSchemes", "semiImplicit", "verlet"), "does not go with constant/transportProperties");
    expectError(edited(layersCase(), "system/sphSchemes", "semiImplicit", "verlet"), "does not go with constant/openings");
}

TEST(Settings, StepFactorScalesAllFactors)
{
    const auto settings =
        reading(edited(channelCase(), "system/sphSchemes", "predictorCorrector;", "predictorCorrector; soundFactor 0.2; stepFactor 3;"))
            .settings;
    EXPECT_NEAR(settings.integration.factors.sound, 0.6, 1e-15);
    EXPECT_NEAR(settings.integration.factors.viscous, 3 * StepFactors{}.viscous, 1e-15);
    EXPECT_NEAR(settings.integration.factors.capillary, 3 * StepFactors{}.capillary, 1e-15);
}

// Each form of the contact angle selects its own terms; `scheme paper;` takes the paper's, unless the case says otherwise, has no contact angle,
// or has no interface stress that the solid could be a phase of.
TEST(Settings, ContactAnglesTakeTheFormThatTheCaseNames)
{
    const auto form = [](const Settings& s)
    {
        EXPECT_EQ(selects(s, "solidPhaseStress"), selects(s, "stressOfSolid"));
        EXPECT_NE(selects(s, "solidPhaseStress"),
                  selects(s, "interfaceStress") || selects(s, "curvatureForce") || selects(s, "evenCurvatureForce"));
        return selects(s, "solidPhaseStress")         ? "paper"
               : selects(s, "wallTension")            ? "wallStress"
               : selects(s, "wallPotential")          ? "wallPotential"
               : selects(s, "adheringColourGradient") ? "wallAdhesion"
                                                      : "none";
    };
    EXPECT_STREQ(form(wetting("")), "wallPotential");
    EXPECT_STREQ(form(wetting("surfaceTension interfaceStress;")), "wallStress");
    EXPECT_STREQ(form(wetting("contactAngle wallStress;")), "wallStress");
    EXPECT_STREQ(form(wetting("contactAngle wallPotential;")), "wallPotential");
    EXPECT_STREQ(form(wetting("contactAngle wallAdhesion;")), "wallAdhesion");
    EXPECT_STREQ(form(wetting("contactAngle paper;")), "paper");
    EXPECT_STREQ(form(wetting("scheme paper;")), "paper");
    EXPECT_STREQ(form(wetting("scheme paper; contactAngle wallStress;")), "wallStress");
    EXPECT_STREQ(form(wetting("scheme paper; surfaceTension curvature;")), "wallPotential");
    EXPECT_STREQ(form(reading(edited(dropCase(), "system/sphSchemes", "integration", "scheme paper; integration")).settings), "none");
}

// 90 degrees is no tension with either phase; as a phase of its own the solid then still ends the fluids' colour gradients.
TEST(Settings, ASolidPhaseOf90DegreesIsASolidPhase)
{
    EXPECT_FALSE(selects(wetting("", 90, 90), "wallTension"));
    const auto settings = wetting("contactAngle paper;", 90, 90);
    EXPECT_TRUE(selects(settings, "solidPhaseStress"));
    EXPECT_EQ(tensionsOf(settings.coefficients).ofWalls, std::vector<double>(4, 0.0));
}

TEST(Settings, ASolidPhaseNeedsTheInterfaceStress)
{
    for (const char* tension : {"curvature", "none"})
        expectError(edited(dropCase(), "system/sphSchemes", "integration",
                           "\nsurfaceTension " + std::string(tension) + ";\ncontactAngle paper;\nintegration"),
                    "system/sphSchemes:4: paper makes the solid a phase of the interface stress and goes with surfaceTension "
                    "interfaceStress, not " +
                        std::string(tension));
    expectError(edited(dropCase(), "system/sphSchemes", "integration", "contactAngle papr; integration"), "Did you mean \"paper\"?");
}

TEST(Settings, AContactAngleNeedsTensionAndAWallThatHasIt)
{
    for (const auto& files : {channelCase(), dropCase()})
        expectError(edited(files, "system/sphSchemes", "integration", "\ncontactAngle wallAdhesion;\nintegration"),
                    "does nothing without a wall that has a contactAngle in constant/geometry");
}

// Nothing that a dictionary says is ignored: where an entry has no effect in its scene it is an error with file and line that says what it
// would need. The same words do no harm where a set of defaults brings them.
TEST(Settings, EntriesWithoutAnEffectAreErrors)
{
    const std::string schemes = "system/sphSchemes", phases = "constant/phaseProperties";
    const auto wetting = [](const Files& files)
    {
        const TestCase folder(files);
        const Case c(folder.folder());
        auto g = channelGeometry();
        g.walls[0].name = "floor";
        g.walls[0].wets = true;
        g.walls[0].contactAngle = 30;
        g.walls[0].anglesAt = {"constant/geometry", 4};
        readSettings(c, g);
        try
        {
            c.diagnostics().throwIfAny();
        }
        catch (const CaseError& e)
        {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(wetting(channelCase()),
              "constant/geometry:4: the contact angle of wall \"floor\" does nothing here: it is one of two phases, and "
              "constant/phaseProperties lists one, whose free surface has no tension. Add the gas as a phase, and sigma between both; "
              "or leave the angle out");
    for (const char* sigma : {"", "sigma ( (liquid gas) 0 );"})
        EXPECT_EQ(
            wetting(edited(dropCase(), phases, "sigma ( (liquid gas) 1 );", sigma)),
            "constant/geometry:4: the contact angle of wall \"floor\" does nothing here: constant/phaseProperties gives no sigma between any two "
            "phases. Give it, or leave the angle out");
    EXPECT_EQ(wetting(dropCase()), "");
    EXPECT_EQ(wetting(edited(dropCase(), schemes, "integration", "surfaceTension none; integration")), "") << "the user says so";

    const auto without = [&](const std::string& gravity) { return edited(channelCase(), "constant/g", "(1 0 0)", gravity); };
    const auto soundBy = [&](const Files& files, const std::string& expected)
    {
        return edited(edited(files, phases, "soundSpeed 15", "soundSpeed automatic"), phases, "phases",
                      "expected { velocity 1;\n" + expected + " }\nphases");
    };
    expectError(soundBy(without("(0 0 0)"), "depth 1;"), "constant/phaseProperties:2: depth does nothing without gravity");
    expectError(soundBy(channelCase(), "radius 1;"), "constant/phaseProperties:2: radius does nothing without sigma");
    EXPECT_EQ(reading(soundBy(channelCase(), "depth 1;")).errors, "");

    const auto adding = [&](const Files& files, const std::string& words)
    { return edited(files, schemes, "integration", "\n" + words + "\nintegration"); };
    expectError(adding(edited(edited(channelCase(), phases, "mu 10; ", ""), schemes, "wallVelocity secondOrder;", ""),
                       "viscosity harmonic;"),
                "system/sphSchemes:4: viscosity does nothing here: no phase of constant/phaseProperties has mu; leave it out");
    for (const char* word : {"detaching", "hydrostatic", "mirrored"})
    {
        const auto entry = fmt::format("wallPressure {};", word);
        expectError(adding(without("(0 0 0)"), entry), "system/sphSchemes:4: wallPressure does nothing here: without gravity");
        EXPECT_EQ(reading(adding(channelCase(), entry)).errors, "");
    }
    EXPECT_EQ(reading(edited(edited(without("(0 0 0)"), schemes, "wallVelocity secondOrder;", "scheme freeSurface;"), schemes,
                             "predictorCorrector", "leapfrog"))
                  .errors,
              "")
        << "the set has wallPressure detaching";
    expectError(adding(channelCase(), "shiftingSpeed own;"), "system/sphSchemes:4: does nothing without shifting");
    const auto damped = [&](const std::string& words)
    { return edited(channelCase(), schemes, "integration {", "integration { damping { " + words + " }"); };
    expectError(damped("rate 5;"), "system/sphSchemes:3: does nothing without `until`");
    expectError(damped("until 5;"), "system/sphSchemes:3: does nothing without `rate`");
    EXPECT_EQ(reading(damped("rate 5; until 1;")).errors, "");

    // A set's words are those of the user's line that names it.
    expectError(adding(edited(channelCase(), schemes, "predictorCorrector", "implicit"), "scheme bed;"),
                "system/sphSchemes:4, scheme bed:1: goes with steps that sound limits");
    // A factor of a limit that the scene does not have; of the limits of this one, sound, viscosity and force, each is taken.
    const auto scaled = [&](const Files& scene, const std::string& factor)
    { return edited(scene, schemes, "predictorCorrector;", "predictorCorrector; " + factor + " 0.1;"); };
    for (const char* factor : {"soundFactor", "viscousFactor", "forceFactor"})
        EXPECT_EQ(reading(scaled(channelCase(), factor)).errors, "") << factor;
    for (const char* factor : {"stiffnessFactor", "diffusiveFactor", "capillaryFactor"})
        expectError(scaled(channelCase(), factor),
                    std::string("system/sphSchemes:3: ") + factor + " does nothing here: it is the share of the limit by ");
    for (const char* factor : {"stiffnessFactor", "capillaryFactor"}) EXPECT_EQ(reading(scaled(dropCase(), factor)).errors, "") << factor;
    const auto implicitly = edited(dropCase(), schemes, "predictorCorrector;", "implicit; soundFactor 0.1;");
    expectError(implicitly, "system/sphSchemes:2: soundFactor does nothing here");

    auto files = channelCase();
    files["constant/soilProperties"] = "";
    expectError(files, "constant/soilProperties: does nothing here: no phase of constant/phaseProperties has `stress constitutiveLaw`");
}

// Rules of walls are refused in a scene without walls.
TEST(Settings, RulesOfWallsNeedAWall)
{
    const auto errors = [](const std::string& words)
    {
        auto files = edited(channelCase(), "system/sphSchemes", "wallVelocity secondOrder;", words);
        const TestCase folder(files);
        const Case c(folder.folder());
        auto g = channelGeometry();
        g.walls.clear();
        g.patches.clear();
        g.periodic[1] = true;
        readSettings(c, g);
        try
        {
            c.diagnostics().throwIfAny();
        }
        catch (const CaseError& e)
        {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(errors("wallVelocity reflected;"),
              "system/sphSchemes:2: wallVelocity does nothing here: there are no walls in constant/geometry; leave it out");
    EXPECT_EQ(errors("wallPressure mirrored;"),
              "system/sphSchemes:2: wallPressure does nothing here: there are no walls in constant/geometry; leave it out");
    EXPECT_EQ(errors("scheme freeSurface;"), "");
}

TEST(Settings, AVelocityBehindWallsNeedsOneThatHolds)
{
    const auto errors = [](bool lidSlips)
    {
        const TestCase folder(edited(channelCase(), "system/sphSchemes", "wallVelocity secondOrder;", "wallVelocity reflected;"));
        const Case c(folder.folder());
        auto g = channelGeometry();
        for (auto& wall : g.walls) wall.slips = true;
        g.walls.back().slips = lidSlips;
        readSettings(c, g);
        return c.diagnostics().errors();
    };
    EXPECT_EQ(errors(true), 1u);
    EXPECT_EQ(errors(false), 0u);
}

// The automatic sound speed of a gas that moves as slowly as the liquid, 1.5 m/s: rho c^2 is 1.125 Pa, and the interface presses by 16 and
// 20 Pa. A sound speed of 10 sqrt(p/rho), p their sum, keeps the density within 1 %; with one of that size nothing is said.
TEST(Settings, WarnsOfAnAutomaticSoundSpeedThatInterfacesOutdo)
{
    const auto warnings = [](const std::string& sound)
    {
        const TestCase folder(edited(edited(dropCase(), "constant/phaseProperties", "gas { rho 0.5; mu 0.05; soundSpeed 20",
                                            "gas { rho 0.5; mu 0.05; soundSpeed " + sound),
                                     "constant/phaseProperties", "sigma", "expected { velocity 0.15; }\nsigma"));
        const Case c(folder.folder());
        readSettings(c, channelGeometry());
        return c.diagnostics().warnings();
    };
    const auto found = warnings("automatic");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(
        found[0],
        "constant/phaseProperties:3: the automatic sound speed of gas, 1.5 m/s, makes rho c^2 1.12 Pa, less than the background pressure, 16 Pa, "
        "and the capillary pressure sigma/spacing, 20 Pa, together: its density will vary by a third and more. A soundSpeed of 84.9 m/s keeps "
        "it within 1 %, one of 26.8 m/s within 10 %");
}

/// Terms of the group that gives the rates of the powder.
std::vector<std::string> migrationTerms(const Reading& r)
{
    for (const auto& group : r.settings.groups)
        if (group.name == ofMigration) return group.terms;
    return {};
}

TEST(Settings, OfASuspensionAreRead)
{
    const auto r = reading(suspensionCase());
    EXPECT_EQ(r.errors, "");
    const auto& s = r.settings.coefficients.of<Suspension>();
    EXPECT_NEAR(s.Dc_a2, 0.4 * 0.05 * 0.05, 1e-15);
    EXPECT_NEAR(s.phiCritical, 0.99 * 0.68, 1e-15);
    EXPECT_EQ(migrationTerms(r), (std::vector<std::string>{"subParticleShear", "kriegerSlope", "phillipsFlux"}));
    EXPECT_TRUE(selects(r.settings, "harmonicViscosity"));
    EXPECT_TRUE(selects(r.settings, "harmonicViscousRate"));
    EXPECT_EQ(r.settings.chosen.at("wallVelocity"), "reflected");

    // D_c and D_eta go with the square of what the case says: a factor 4 in time.
    const std::string transport = "constant/transportProperties";
    const auto byDiameter = reading(edited(suspensionCase(), transport, "a radius", "a diameter")).settings.coefficients.of<Suspension>();
    EXPECT_NEAR(byDiameter.Dc_a2, 4 * s.Dc_a2, 1e-15);
    EXPECT_NEAR(byDiameter.Deta_a2, 4 * s.Deta_a2, 1e-15);
    const auto given = reading(edited(suspensionCase(), transport, "radius 0.05", "diameter 0.1")).settings.coefficients.of<Suspension>();
    EXPECT_EQ(given.Dc_a2, s.Dc_a2);

    const auto schemes = [](const std::string& words) { return edited(suspensionCase(), "system/sphSchemes", "shifting 2;", words); };
    EXPECT_EQ(migrationTerms(reading(schemes("shearRate gradient;")))[0], "velocityGradientShear");
    expectError(schemes("scheme paper;"), "paper is Barker et al. (2012), who have no powder; take paperPowder");
    EXPECT_EQ(migrationTerms(reading(schemes("shearRate correctedGradient;")))[0], "correctedGradientShear");
    EXPECT_EQ(migrationTerms(reading(schemes("subParticleShear 0;")))[0], "resolvedShear");
    EXPECT_EQ(reading(schemes("")).settings.chosen.at("wallVelocity"), "reflected");
}

// Near packing powder moves by steps that solve, where J_eta is 40 times as stiff as J_c: phi_m - phi < 0.04 here.
TEST(Settings, OfAPackedSuspensionSolveForItsMigration)
{
    const auto solves = [](const Files& files)
    {
        const auto r = reading(files);
        EXPECT_EQ(r.errors, "");
        return std::ranges::any_of(r.settings.groups, [](const Group& group) { return group.name == ofMigrationSolve; });
    };
    const auto at = [](const char* phi) { return edited(suspensionCase(), "constant/transportProperties", "phi 0.4", phi); };
    EXPECT_FALSE(solves(at("phi 0.4")));
    EXPECT_TRUE(solves(at("phi 0.67")));
    EXPECT_FALSE(solves(edited(at("phi 0.67"), "system/sphSchemes", "semiImplicit", "semiImplicit; migration explicit")));
    EXPECT_TRUE(solves(edited(at("phi 0.4"), "system/sphSchemes", "semiImplicit", "semiImplicit; migration semiImplicit")));
}

/// n particles of the channel, 400 of which would fill it.
Files holding(Files files, int n)
{
    std::string positions =
        "FoamFile { version 2.0; format ascii; class Cloud<passiveParticle>; object positions; }\n" + std::to_string(n) + "\n(\n";
    for (int i = 0; i < n; ++i)
        positions += "(" + std::to_string(0.05 * (i % 20) + 0.025) + " " + std::to_string(0.05 * (i / 20) + 0.025) + " 0) 0\n";
    files["0/lagrangian/sph/positions"] = positions + ")\n";
    return files;
}

// Every set goes with a scene of its class, and gives way to the words of the file.
TEST(Settings, SetsOfWordsGoTogether)
{
    const std::string schemes = "system/sphSchemes";
    const auto by = [&](Files files, const std::string& set)
    {
        files[schemes] = "scheme " + set + ";\nresolution { spacing 0.05; }\n";
        return files;
    };
    auto layers = edited(dropCase(), "constant/phaseProperties", "sigma ( (liquid gas) 1 );", "");
    for (const auto& [files, set] : std::vector<std::pair<Files, std::string>>{{channelCase(), "suite"},
                                                                               {channelCase(), "freeSurface"},
                                                                               {channelCase(), "channel"},
                                                                               {channelCase(), "enclosed"},
                                                                               {channelCase(), "bed"},
                                                                               {channelCase(), "paper"},
                                                                               {dropCase(), "twoPhase"},
                                                                               {layers, "twoPhase"},
                                                                               {suspensionCase(), "suspension"},
                                                                               {suspensionCase(), "paperPowder"}})
        EXPECT_EQ(reading(by(files, set)).errors, "") << set;
    const auto suspension = reading(by(suspensionCase(), "suspension"));
    EXPECT_EQ(suspension.settings.resolution.kernel, "quinticSpline");
    EXPECT_EQ(suspension.settings.integration.scheme, "semiImplicit");

    auto files = by(channelCase(), "freeSurface");
    EXPECT_EQ(reading(files).settings.chosen.at("pressureGradient"), "tensileControlled");
    files[schemes] += "pressureGradient monaghan; integration { scheme predictorCorrector; }\n";
    const auto mixed = reading(files);
    EXPECT_EQ(mixed.errors, "");
    EXPECT_EQ(mixed.settings.chosen.at("pressureGradient"), "monaghan");
    EXPECT_EQ(mixed.settings.integration.scheme, "predictorCorrector");
    EXPECT_TRUE(mixed.settings.facts.get<IntegratedDensity>().exists);
    // A support goes with its kernel, a set's too.
    const auto supportOf = [&](Files f, const std::string& words)
    {
        f[schemes] += words;
        return reading(f).settings.resolution.support;
    };
    EXPECT_EQ(supportOf(by(channelCase(), "suite"), ""), 3.05);
    EXPECT_EQ(supportOf(by(channelCase(), "suite"), "resolution { kernel wendlandC4; }\n"), 3.4);
    EXPECT_EQ(supportOf(by(suspensionCase(), "suspension"), ""), 2.6);
    EXPECT_EQ(supportOf(by(suspensionCase(), "suspension"), "resolution { kernel wendlandC2; }\n"), 3.05);
    EXPECT_EQ(supportOf(by(suspensionCase(), "suspension"), "resolution { kernel wendlandC2; support 4; }\n"), 4);

    expectError(by(channelCase(), "freesurface"), "Did you mean \"freeSurface\"?");
    expectError(by(dropCase(), "freeSurface"), "scheme freeSurface:1: ");
}

// `scheme paperPowder;` is eqs. (3.1) to (3.8) of Kauzlaric et al. (2011) term by term; words of the file override, and creeping flow of particles at
// rest needs no velocities of the middle of a step.
TEST(Settings, ThePowdersPaperIsTakenTermByTerm)
{
    const auto by = [](const std::string& words)
    {
        auto files = suspensionCase();
        files["system/sphSchemes"] = "scheme paperPowder;\nresolution { spacing 0.05; }\n" + words;
        return files;
    };
    const auto r = reading(by(""));
    EXPECT_EQ(r.errors, "");
    for (const char* term :
         {"massContinuity", "massWeightedPressure", "tait", "clearyMonaghanViscosity", "integratedVolume", "kriegerOfDensity"})
        EXPECT_TRUE(selects(r.settings, term)) << term;
    EXPECT_FALSE(selects(r.settings, "gradientNormalisation"));
    EXPECT_EQ(migrationTerms(r), (std::vector<std::string>{"velocityGradientShear", "kriegerSlopeOfDensity", "phillipsFluxOfDensity"}));
    EXPECT_EQ(r.settings.chosen.at("walls"), "layers");
    EXPECT_EQ(r.settings.chosen.at("wallVelocity"), "morris");
    EXPECT_EQ(r.settings.integration.scheme, "predictorCorrector");
    EXPECT_EQ(r.settings.resolution.kernel, "cubicSpline");
    EXPECT_EQ(r.settings.coefficients.stateEquation[0].n, 7);

    const auto other = reading(by("walls reflected; wallVelocity reflected; shearRate stress; continuityForm volume;"));
    EXPECT_EQ(other.errors, "");
    EXPECT_TRUE(selects(other.settings, "continuity"));
    EXPECT_EQ(migrationTerms(other)[0], "subParticleShear");
    expectError(by("walls reflected;"), "mirror images lie as deep: take reflected, or walls layers");
    expectError(by("density numberDensity; volume numberDensity;"), "goes with `density continuity;`: no density is integrated");

    const auto creeping = reading(by("integration { scheme quasiSteady; }"));
    EXPECT_EQ(creeping.errors, "");
    EXPECT_EQ(creeping.settings.integration.responses, (std::vector<std::string>{"clearyMonaghanViscousResponse"}));
    EXPECT_TRUE(selects(creeping.settings, "clearyMonaghanViscousRate"));
    expectError(by("integration { scheme semiImplicit; }"), "continuity needs velocities of the middle of a step");
}

// A liquid that fills half of its space has a free surface; one that fills it, comes in through openings, or has words of its own, is left as it is.
TEST(Settings, AFreeSurfaceIsSeen)
{
    const std::string schemes = "system/sphSchemes";
    auto channel = edited(channelCase(), schemes, "wallVelocity secondOrder;", "");
    const auto free = [](const Files& files) { return reading(files).settings.chosen.at("pressureGradient") == "tensileControlled"; };
    const auto half = reading(holding(channel, 200));
    EXPECT_EQ(half.errors, "");
    EXPECT_EQ(half.settings.chosen.at("pressureGradient"), "tensileControlled");
    EXPECT_TRUE(half.settings.facts.get<IntegratedDensity>().exists);
    EXPECT_TRUE(std::any_of(half.settings.reasons.begin(), half.settings.reasons.end(),
                            [](const auto& reason) { return reason.find("fills 50 % of its space") != std::string::npos; }));
    EXPECT_TRUE(free(holding(channel, 370)));
    EXPECT_FALSE(free(holding(channel, 390)));
    EXPECT_FALSE(free(channel));
    EXPECT_FALSE(free(holding(edited(channel, schemes, "integration", "shifting 2; integration"), 200)));
    EXPECT_FALSE(free(holding(edited(channel, schemes, "integration", "scheme suite; integration"), 200)));
    EXPECT_FALSE(free(holding(dropCase(), 200)));
    EXPECT_FALSE(free(holding(openCase(), 200)));
}

// Second-order walls are the default where their momentum balance is whole, and no reason speaks against them.
TEST(Settings, WallVelocityFollowsTheScene)
{
    const std::string schemes = "system/sphSchemes", phases = "constant/phaseProperties";
    const auto byDefault = [](const Files& files) { return reading(files).settings.chosen.at("wallVelocity"); };
    const auto adding = [&](Files files, const std::string& words)
    {
        files[schemes] += words + "\n";
        return files;
    };
    auto channel = edited(channelCase(), schemes, "wallVelocity secondOrder;", "");
    EXPECT_EQ(byDefault(channel), "secondOrder");
    EXPECT_EQ(byDefault(edited(channel, schemes, "integration", "pressureGradient monaghan; integration")), "reflected");

    const auto drop = dropCase();
    EXPECT_EQ(byDefault(drop), "reflected");
    const auto layers = edited(drop, phases, "sigma ( (liquid gas) 1 );", "");
    EXPECT_EQ(byDefault(layers), "secondOrder");
    EXPECT_EQ(byDefault(edited(layers, phases, "mu 0.05", "mu 0")), "reflected");
    expectError(adding(edited(layers, phases, "mu 0.05", "mu 0"), "wallVelocity secondOrder;"),
                "secondOrder needs viscosity in all phases");

    // What walls see of the forces is kept by itself, tension too; the viscosity is the source's.
    const auto r = reading(adding(drop, "wallVelocity secondOrder; surfaceTension curvature; contactAngle wallPotential;"));
    const auto& terms = r.settings.terms;
    for (const char* term : {"huAdamsPressureApart", "evenCurvatureForceApart", "addPressure"})
        EXPECT_EQ(std::count(terms.begin(), terms.end(), term), 1) << term;
    EXPECT_EQ(r.settings.ruleReads.at("U").size(), 3u);
    expectError(adding(edited(drop, schemes, "predictorCorrector", "predictorCorrector; maxSubSteps 5"), "wallVelocity secondOrder;"),
                "take maxSubSteps 1");
}

// A scene without powder has none of its words, terms and numbers.
TEST(Settings, OfAPureLiquidHaveNothingOfASuspension)
{
    const auto r = reading(channelCase());
    EXPECT_FALSE(r.settings.coefficients.has<Suspension>());
    EXPECT_TRUE(r.settings.groups.empty());
    EXPECT_EQ(std::count_if(r.settings.state.begin(), r.settings.state.end(), [](const Evolving& q) { return q.value.name == "phi"; }), 0);
    expectError(edited(channelCase(), "system/sphSchemes", "predictorCorrector", "predictorCorrector; migrationSteps 2"),
                "entry \"migrationSteps\" is not used");
    expectError(edited(channelCase(), "system/sphSchemes", "wallVelocity", "shearRate stress; wallVelocity"),
                "entry \"shearRate\" is not used");
    expectError(edited(channelCase(), "system/sphSchemes", "predictorCorrector", "quasiSteady"), "and there is no suspension");
}

TEST(Settings, MistakesOfASuspensionHaveFileAndLine)
{
    const std::string transport = "constant/transportProperties";
    const auto with = [&](const std::string& from, const std::string& to) { return edited(suspensionCase(), transport, from, to); };
    expectError(with("phi 0.4;", "phi 0.68;"), "constant/transportProperties:3: 0.68 must be less than phiMax, 0.68");
    expectError(with("phi 0.4;", "phi -0.1;"), "constant/transportProperties:3: ");
    expectError(with("phiMax 0.68", "phiMax 1.2"), "constant/transportProperties:4: 1.2 is no volume fraction");
    expectError(with("phiMax 0.68;", "phiMax 0.68; phiCritical 0.7;"),
                "constant/transportProperties:4: 0.7 must be less than phiMax, 0.68");
    EXPECT_EQ(reading(with("phiMax 0.68;", "phiMax 0.68; phiCritical 0.7;")).errors.find("-nan"), std::string::npos);
    EXPECT_EQ(reading(with("suspension", "suspenson")).errors.find("errors"), std::string::npos);
    for (const char* steps : {"0", "-1"})
        expectError(edited(suspensionCase(), "system/sphSchemes", "semiImplicit", "semiImplicit; migrationSteps " + std::string(steps)),
                    "migrationSteps is a number of steps, at least 1");
    expectError(edited(suspensionCase(), "system/sphSchemes", "semiImplicit", "semiImplicit; migrationSteps 3e9"),
                "\"migrationSteps\" must be an integer");
    expectError(edited(suspensionCase(), "system/sphSchemes", "semiImplicit", "predictorCorrector; } viscosity none; moving {"),
                "none leaves out the viscosity that powder migrates by");
    expectError(with("exponent 1.82", "exponent 0"), "constant/transportProperties:5: ");
    expectError(with("Dc 0.4", "Dc -1"), "constant/transportProperties:6: ");
    expectError(with("Deta 0.62", "Deta 0.4"), "constant/transportProperties:7: Dc/Deta is 1: from 1 on there is no steady state");
    EXPECT_EQ(reading(with("Deta 0.62", "noSteadyState warn; Deta 0.4")).errors, "");
    for (const char* size : {"radius 0", "radius -1e-6"}) expectError(with("radius 0.05", size), "constant/transportProperties:8: ");
    expectError(with("radius 0.05;", ""), "the powder's size is missing: give its `diameter` or `radius`");
    expectError(with("radius 0.05;", "radius 0.05; diameter 0.1;"), "the powder's size is given twice");
    expectError(with("a radius", "a radus"), "constant/transportProperties:9: ");
    expectError(with("a radius;", ""), "\"a\"");
    expectError(edited(suspensionCase(), "constant/phaseProperties", "mu 10;", ""), "needs the viscosity `mu` of its binder");
    expectError(edited(suspensionCase(), "system/sphSchemes", "semiImplicit", "quasiSteady"),
                "moves particles, which quasiSteady leaves where they are");
}

// 10 sqrt(100 kPa/(1000 kg/m^3)): the scale that compresses a stiff fluid is a stress, not a speed.
TEST(Settings, ChooseTheSoundSpeedByThePressure)
{
    auto files = edited(suspensionCase(), "constant/phaseProperties", "soundSpeed 15;", "soundSpeed automatic;");
    files["constant/phaseProperties"] += "expected { velocity 1; pressure 1e5; }\n";
    const auto r = reading(files);
    EXPECT_EQ(r.errors, "");
    EXPECT_NEAR(r.settings.coefficients.soundSpeed.at(0), 100, 1e-12);
    EXPECT_NE(r.settings.reasons.at(0).find("by the expected pressure difference"), std::string::npos) << r.settings.reasons.at(0);
}

}
}
