/// The printed plan is what runs: the numbered stages and operations of -dry-run against a count of what steps have run.
#include "case/Case.hpp"
#include "smallCases.hpp"
#include "solver/Simulation.hpp"
#include "solver/models.hpp"
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>

namespace sph::test
{
namespace
{

using Counts = std::map<std::string, long>;

struct PrintedStage
{
    std::string text; ///< its name and equation
    bool onceAStep = false;
    std::vector<std::string> operations;
};
struct Printed
{
    std::vector<PrintedStage> stages;
    std::set<std::string> operations, leftOut;
};

/// Stages `  3. drift  x += dt/2 v` and operations `   12  tait  -> p (selected)`, each numbered from 1 without a gap.
Printed parsed(const std::string& plan)
{
    Printed printed;
    const std::regex stage(R"(^  (\d+)\. (.*)$)"), operation(R"(^ +(\d+)  (.*\S) +-> .*\)$)");
    std::istringstream lines(plan);
    std::smatch match;
    std::size_t operations = 0;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, match, stage))
        {
            printed.stages.push_back({match[2].str(), line.find("(in the middle one of several parts)") != std::string::npos, {}});
            EXPECT_EQ(std::stoul(match[1].str()), printed.stages.size()) << line;
        }
        else if (std::regex_match(line, match, operation))
        {
            EXPECT_EQ(std::stoul(match[1].str()), ++operations) << line;
            printed.stages.back().operations.push_back(match[2].str());
            printed.operations.insert(match[2].str());
        }
        else if (const auto at = line.find("    left out "); at == 0)
        {
            std::istringstream words(line.substr(13));
            for (std::string word; words >> word;) printed.leftOut.insert(word);
        }
    EXPECT_GT(operations, 0u) << plan;
    return printed;
}

struct Ran
{
    std::vector<PrintedStage> printed;
    Counts stages;                        ///< by name
    std::map<std::string, Counts> groups; ///< operations of each group
    std::set<std::string> operations;
};
Ran sorted(const Counts& counts)
{
    Ran ran;
    for (const auto& [name, count] : counts)
        if (const auto slash = name.find('/'); slash != std::string::npos)
        {
            ran.groups[name.substr(0, slash)][name.substr(slash + 1)] = count;
            ran.operations.insert(name.substr(slash + 1));
        }
        else ran.stages[name] = count;
    return ran;
}

/// A case packed by the utilities, as the solver reads it; what it prints and what `steps` steps run, compared.
template<int dim> Ran printsWhatRuns(const Files& files, int steps)
{
    const TestCase folder(files);
    folder.runWell("packParticles");
    folder.runWell("meshToGhost");
    const Case c(folder.folder());
    const auto resolution = readResolution(c.dictionary("system/sphSchemes"));
    const auto geometry = readGeometry(c.dictionary("constant/geometry"), resolution, supportsOfSolver);
    const auto settings = readSettings(c, geometry);
    const auto cloud = readCloud(folder.folder(), "0", "sph", c.diagnostics());
    c.diagnostics().throwIfAny();
    EXPECT_EQ(geometry.dimension, dim);
    const auto simulation = makeSimulation(settings, geometry, cloud, {});
    std::ostringstream plan;
    simulation->printPlan(plan);
    const auto printed = parsed(plan.str());

    simulation->count();
    double time = 0;
    for (int k = 0; k < steps; ++k)
    {
        const double deltaT = simulation->stepLimit().deltaT;
        simulation->step(time, deltaT);
        time += deltaT;
    }
    auto ran = sorted(simulation->counts());
    ran.printed = printed.stages;
    EXPECT_EQ(printed.operations, ran.operations) << plan.str();

    // Each printed stage is the longest name of one that ran which it begins with; those that are once in a step ran so often as it is printed.
    Counts lines, onceAStep;
    for (const auto& stage : printed.stages)
    {
        std::string name;
        for (const auto& [candidate, _] : ran.stages)
            if (stage.text.starts_with(candidate + " ") && candidate.size() > name.size()) name = candidate;
        EXPECT_NE(name, "") << "printed, and has not run: " << stage.text;
        ++lines[name];
        onceAStep[name] += stage.onceAStep;
    }
    const long parts = lines.contains("drift") ? ran.stages.at("drift") / lines.at("drift") : steps;
    for (const auto& [name, count] : ran.stages)
    {
        EXPECT_TRUE(lines.contains(name)) << "ran, and is not printed: " << name;
        EXPECT_EQ(count, onceAStep[name] * steps + (lines[name] - onceAStep[name]) * parts) << name;
    }
    // What joins evaluations, sortings and observations is printed where it does.
    const auto text = plan.str();
    for (const auto& [name, count] : simulation->countsWithin())
        EXPECT_TRUE(text.find(": " + name + ", ") != std::string::npos || text.find("; " + name + ": ") != std::string::npos)
            << "ran " << count << " times, and is not printed: " << name;
    if (const auto& within = simulation->countsWithin(); within.contains("near walls"))
    {
        EXPECT_EQ(within.at("near walls"), simulation->rebuilds()) << "once for each building of lists";
    }
    // A stage that evaluates its own group runs each of its operations once.
    for (const auto& [group, operations] : ran.groups)
    {
        if (!ran.stages.contains(group)) continue;
        for (const auto& [operation, count] : operations) EXPECT_EQ(count, ran.stages.at(group)) << group << '/' << operation;
    }

    // What is left out is all the rest of the catalogue and of the scene's own terms.
    std::set<std::string> all = printed.leftOut;
    for (const auto& operation : printed.operations)
        EXPECT_FALSE(printed.leftOut.contains(operation)) << operation << " is left out, and runs";
    all.insert(printed.operations.begin(), printed.operations.end());
    std::set<std::string> known;
    for (const auto& term : allTerms<dim>()) known.insert(term.name);
    for (const auto& term : settings.template ownTerms<dim>()) known.insert(term.name);
    EXPECT_EQ(all, known);

    EXPECT_NE(folder.runWell("sphFoamLike", "-dry-run").find(plan.str()), std::string::npos) << "-dry-run prints another plan than\n"
                                                                                             << plan.str();
    return ran;
}

// Water at the bottom of a bed of spheres that it wets, and air: surface tension and its force at walls act once in a step of three parts.
TEST(PrintedPlan, IsWhatRunsInABed)
{
    auto files = bedCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.08; support 2.6; kernel wendlandC2; }\nintegration { scheme leapfrog; maxSubSteps 3; }\n";
    files["constant/geometry"] =
        "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x y z); }\nwalls { grains { type sphereBed; lattice bcc; radius "
        "0.35; period 1; contactAngle 60; } }\n";
    files["constant/phaseProperties"] =
        "phases (water air);\nwater { rho 1000; mu 1; soundSpeed 15; }\nair { rho 1; mu 0.02; soundSpeed 15; }\nsigma ( (water "
        "air) 0.1 );\n";
    files["system/packParticlesDict"] =
        "lattice cubic; relax { steps 30; }\nfill ( { region all; phase air; } { region box; min (0 0 0); max (1 0.5 1); phase "
        "water; } );\n";
    const int steps = 4;
    const auto ran = printsWhatRuns<3>(files, steps);
    const auto& slow = ran.groups.at("evaluate what acts once a step");
    for (const char* term : {"curvatureForce", "wallPotential"}) EXPECT_EQ(slow.at(term), steps) << term;
    EXPECT_FALSE(ran.groups.at("evaluate").contains("wallPotential"));
    EXPECT_EQ(ran.stages.at("kick once a step"), steps);
    EXPECT_EQ(ran.stages.at("evaluate"), 3 * steps);
}

// Water that drips on a grain and drains, with its surface tension: what openings let in and hold is printed where lists are built and behind evaluations.
TEST(PrintedPlan, IsWhatRunsInABedWithOpenings)
{
    auto files = dripCase();
    auto& walls = files["constant/geometry"];
    walls.insert(walls.rfind('}'), "    grain { type sphere; centre (0.3 0.4 0); radius 0.15; fluid outside; contactAngle 60; }\n");
    const int steps = 4;
    const auto ran = printsWhatRuns<2>(files, steps);
    EXPECT_EQ(ran.stages.at("drive"), steps);
    for (const char* term : {"evenCurvatureForce", "wallPotential"}) EXPECT_TRUE(ran.operations.contains(term)) << term;
}

// Soil on its walls: its stress is advanced by the law, and what touches a wall stays there.
TEST(PrintedPlan, IsWhatRunsInSoil)
{
    const int steps = 5;
    const auto ran = printsWhatRuns<2>(soilCase(), steps);
    EXPECT_EQ(ran.stages.at("stress"), steps);
}

// Powder migrates in steps of its own, what openings hold is driven, and viscosity is solved for.
TEST(PrintedPlan, IsWhatRunsInASuspensionWithOpenings)
{
    const int steps = 5;
    const auto ran = printsWhatRuns<2>(openCase(), steps);
    for (const char* stage : {"evaluate", "solve", "kick", "drive", "migrate", "shift"}) EXPECT_EQ(ran.stages.at(stage), steps) << stage;
    EXPECT_EQ(ran.groups.at("correct the gradient").at("gradientCorrection"), steps);
    for (const auto& stage : ran.printed) // what joins each evaluation is part of it
        EXPECT_EQ(stage.text.starts_with("evaluate "), stage.text.find("; hold: dq/dt = 0 of what openings hold") != std::string::npos)
            << stage.text;
    const auto& migration = ran.groups.at("rates of migration");
    for (const auto& [term, count] : migration) EXPECT_EQ(count, migration.at("phillipsFlux")) << term;
    EXPECT_GE(migration.at("phillipsFlux"), steps);
    EXPECT_GE(ran.groups.at("response").at("harmonicViscousResponse"), steps);
}

// The same where the flux by viscosity is solved for: its operator runs at least once for the iteration and once for the fluxes.
TEST(PrintedPlan, IsWhatRunsWhereMigrationIsSolvedFor)
{
    const int steps = 5;
    auto files = openCase();
    files["system/sphSchemes"] += "integration { migration semiImplicit; }\n";
    const auto ran = printsWhatRuns<2>(files, steps);
    EXPECT_EQ(ran.stages.at("migrate"), steps);
    EXPECT_GE(ran.groups.at("response of migration").at("viscosityFluxResponse"), 2 * steps);
    EXPECT_EQ(ran.groups.at("rates of migration").at("viscosityFluxRate"), ran.groups.at("rates of migration").at("phillipsFlux"));
}

TEST(PrintedPlan, IsWhatRunsInAnImplicitDrop)
{
    auto files = dropCase();
    auto& schemes = files["system/sphSchemes"];
    schemes.replace(schemes.find("predictorCorrector"), 18, "semiImplicit");
    const int steps = 5;
    const auto ran = printsWhatRuns<2>(files, steps);
    for (const auto& [term, count] : ran.groups.at("evaluate")) EXPECT_EQ(count, steps) << term;
    EXPECT_TRUE(ran.groups.at("evaluate").contains("wallPotential"));
    EXPECT_GE(ran.groups.at("response").at("harmonicViscousResponse"), steps);
}

TEST(PrintedPlan, IsWhatRunsWithAnImplicitPressure)
{
    for (const bool secondOrder : {false, true}) // which solves for viscosity too
    {
        auto files = dropCase();
        auto& schemes = files["system/sphSchemes"];
        schemes.replace(schemes.find("predictorCorrector"), 18, secondOrder ? "implicit; theta 0.5" : "implicit");
        const int steps = 5;
        const auto ran = printsWhatRuns<2>(files, steps);
        for (const auto& [term, count] : ran.groups.at("evaluate")) EXPECT_EQ(count, steps) << term;
        const auto& response = ran.groups.at("response");
        for (const auto& [term, count] : response) EXPECT_EQ(count, response.at("pressureResponse")) << term;
        EXPECT_EQ(response.contains("harmonicViscousResponse"), secondOrder);
        for (const char* stage : {"drift", "evaluate", "solve", "kick", "drift on"}) EXPECT_EQ(ran.stages.at(stage), steps) << stage;
    }
}

// A drop alone, whose gas is left out: its density is completed, and its tension is by curvature from its own side.
TEST(PrintedPlan, IsWhatRunsInADropAlone)
{
    auto files = dropCase();
    files["system/packParticlesDict"] =
        "lattice cubic; jitter 0.1;\nfill ( { region sphere; centre (0.5 0 0); radius 0.4; phase liquid; } );\n";
    auto& walls = files["constant/geometry"];
    for (const char* angle : {" contactAngle 60;", " contactAngle 120;"}) walls.erase(walls.find(angle), std::string(angle).size());
    files["constant/phaseProperties"] = "phases (liquid);\nliquid { rho 1; mu 0.05; soundSpeed 20; sigma 1; }\n";
    const auto explicitly = files["system/sphSchemes"] + "gas none;\n";
    auto implicitly = explicitly;
    implicitly.replace(implicitly.find("predictorCorrector"), 18, "implicit");
    for (const auto& schemes : {explicitly, implicitly})
    {
        files["system/sphSchemes"] = schemes;
        const auto ran = printsWhatRuns<2>(files, 4);
        for (const char* term : {"completedVolume", "uniformNormalisation", "liquidNormals", "freeSurfaceCurvature", "freeSurfaceSmoothing",
                                 "freeSurfaceForce", "singlePhaseTransposedViscosity"})
            EXPECT_TRUE(ran.operations.contains(term)) << term;
        EXPECT_FALSE(ran.operations.contains("numberDensity"));
    }
}

// What is evaluated twice a step is printed twice.
TEST(PrintedPlan, IsWhatRunsWithAnEvaluationMore)
{
    const auto ran = printsWhatRuns<2>(channelCase(), 3);
    EXPECT_EQ(ran.stages.at("evaluate"), 6);
    EXPECT_EQ(ran.stages.at("filter"), 3);
}

// The forces of a lid, asked for by a balance: after each evaluation, or at the end of the step that solves for viscosity.
TEST(PrintedPlan, IsWhatRunsWithALid)
{
    for (const auto& [scheme, evaluations] : {std::pair("predictorCorrector", 2), {"semiImplicit", 1}})
    {
        SCOPED_TRACE(scheme);
        auto files = channelCase();
        auto &schemes = files["system/sphSchemes"], &geometry = files["constant/geometry"];
        schemes.replace(schemes.find("predictorCorrector"), 18, scheme);
        geometry.insert(geometry.rfind("normal (0 -1 0);"), "velocity (1 0 0); ");
        files["system/controlDict"] += "functions { sums { type conservation; } }\n";
        const int steps = 3;
        const auto ran = printsWhatRuns<2>(files, steps);
        const auto& forces = ran.groups.at("forces of walls");
        EXPECT_EQ(forces.size(), 2);
        for (const auto& [term, count] : forces) EXPECT_EQ(count, evaluations * steps) << term;
    }
}

// Creeping flow: particles stay where they are, and what the log shows is evaluated at the new velocities.
TEST(PrintedPlan, IsWhatRunsInCreepingFlow)
{
    auto files = suspensionCase();
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel quinticSpline; }\nintegration { scheme quasiSteady; }\n";
    files["system/packParticlesDict"] = "lattice cubic; jitter 0.001;\nfill ( { region all; phase feedstock; } );\n";
    printsWhatRuns<2>(files, 3);
}

}
}
