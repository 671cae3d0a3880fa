/// Particles shared between ranks: the same answer on any number of them.
#include "Case.hpp"
#include "Cloud.hpp"
#include "smallCases.hpp"
#include <cctype>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace sph;
using namespace sph::test;

namespace
{
/// sphFoamLike on so many ranks, all on whatever processors there are. `meanwhile` runs beside it.
Outcome runParallel(const TestCase& c, int ranks, const std::string& meanwhile = "")
{
    const auto log = std::filesystem::temp_directory_path() / (c.folder().filename().string() + ".ranks");
    const std::string command =
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 "
        "OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1 OMP_NUM_THREADS=1; timeout 100 mpirun -np " +
        std::to_string(ranks) + " '" SPH_APPLICATIONS "/sphFoamLike' -parallel -case '" + c.folder().string() + "' < /dev/null > '" +
        log.string() + ".out' 2> '" + log.string() + ".err' & run=$!; " + meanwhile + " wait $run";
    const int status = std::system(command.c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128, contentsOf(log.string() + ".out"), contentsOf(log.string() + ".err")};
    std::filesystem::remove(log.string() + ".out");
    std::filesystem::remove(log.string() + ".err");
    return outcome;
}

struct Prepared : TestCase
{
    explicit Prepared(const Files& files) : TestCase(files)
    {
        runWell("packParticles");
        runWell("meshToGhost");
    }
};

struct CopyOf : TestCase
{
    explicit CopyOf(const TestCase& c) : TestCase(Files{})
    {
        for (const auto* folder : {"0", "constant", "system"}) copyFrom(c, folder);
    }
};

Cloud cloudOf(const TestCase& c, const std::string& time)
{
    Diagnostics diagnostics;
    auto cloud = readCloud(c.folder(), time, "sph", diagnostics);
    diagnostics.throwIfAny();
    return cloud;
}

/// The largest difference of a field between particles at the same place, over the largest value; infinite where one has no partner within 1e-3.
double difference(const Cloud& a, const Cloud& b, const std::string& name)
{
    const auto &fieldA = a.fields.at(name), &fieldB = b.fields.at(name);
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        std::size_t partner = 0;
        double nearest = INFINITY;
        for (std::size_t j = 0; j < b.size(); ++j)
            if (const double d = std::hypot(a.x[i] - b.x[j], a.y[i] - b.y[j], a.z[i] - b.z[j]); d < nearest)
            {
                nearest = d;
                partner = j;
            }
        if (nearest > 1e-3) return INFINITY;
        for (std::size_t k = 0; k < fieldA.component.size(); ++k)
        {
            worst = std::max(worst, std::fabs(fieldA.component[k][i] - fieldB.component[k][partner]));
            largest = std::max(largest, std::fabs(fieldA.component[k][i]));
        }
    }
    return worst / largest;
}

/// Masses that openings have let pass, as a restart finds them.
std::map<std::string, double> massesOf(const TestCase& c, const std::string& time)
{
    const Case theCase(c.folder());
    const auto state = theCase.dictionary(time + "/uniform/sphState");
    std::map<std::string, double> masses;
    for (const auto& name : state.keys())
        if (name.ends_with("Mass") || name.find("Mass_") != std::string::npos) masses[name] = state.get<double>(name);
    return masses;
}

void expectSameMasses(const TestCase& expected, const TestCase& c, const std::string& time, double tolerance)
{
    const auto masses = massesOf(c, time);
    for (const auto& [name, mass] : massesOf(expected, time)) EXPECT_NEAR(masses.at(name), mass, tolerance) << name;
}

struct Scene
{
    const char* name;
    Files (*files)();
    double bound; ///< of the difference of U after some hundred steps: what round-off grows to
};

class Ranks : public testing::TestWithParam<Scene>
{};

/// With a function object between write times: the first rank runs it, all know when.
Files watchedCase()
{
    auto files = channelCase();
    files["system/controlDict"] += "functions { energies { type conservation; executeControl runTime; executeInterval 0.01; } }\n";
    return files;
}

/// Without walls, from face to face.
Files periodicOpenCase()
{
    auto files = openCase();
    files["constant/geometry"] = "dimension 2; domain { min (-0.2 0 0); max (1.2 1 0); periodic (y); }\nwalls {}\n";
    auto& openings = files["constant/openings"];
    openings.replace(openings.find("profile developed"), 17, "profile uniform");
    return files;
}
Files layeredChannelCase() { return inLayers(channelCase()); }
Files layeredSoilCase() { return inLayers(soilCase()); }

TEST_P(Ranks, GiveTheSameAnswer)
{
    const Prepared c(GetParam().files());
    const CopyOf alone(c);
    alone.runWell("sphFoamLike");
    const std::string end = c.read("system/controlDict").find("endTime 0.04") != std::string::npos ? "0.04" : "0.08";
    const auto expected = cloudOf(alone, end);
    const auto mass = [](const Cloud& cloud)
    {
        const auto& m = cloud.fields.at("m").component[0];
        return std::accumulate(m.begin(), m.end(), 0.0);
    };
    for (const int ranks : {2, 3, 7})
    {
        const CopyOf shared(c);
        const auto outcome = runParallel(shared, ranks);
        ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
        EXPECT_NE(outcome.out.find("nProcs : " + std::to_string(ranks)), std::string::npos);
        const auto cloud = cloudOf(shared, end);
        ASSERT_EQ(cloud.size(), expected.size());
        EXPECT_LT(difference(expected, cloud, "U"), GetParam().bound) << ranks;
        EXPECT_LT(difference(expected, cloud, "rho"), GetParam().bound) << ranks;
        EXPECT_NEAR(mass(cloud), mass(expected), 1e-12 * mass(expected));
        expectSameMasses(alone, shared, end, 1e-12 * mass(expected));
    }
}

class RanksOfARestart : public testing::TestWithParam<Scene>
{};

// From one process to three, to two, and back.
TEST_P(RanksOfARestart, AreAsManyAsOneLikes)
{
    const Prepared c(GetParam().files());
    const CopyOf whole(c);
    whole.runWell("sphFoamLike");
    const auto until = [&](const std::string& from, const std::string& to)
    { c.replace("system/controlDict", "endTime " + from, "endTime " + to); };
    until("0.08", "0.02");
    c.runWell("sphFoamLike");
    until("0.02", "0.04");
    EXPECT_EQ(runParallel(c, 3).code, 0);
    until("0.04", "0.06");
    EXPECT_EQ(runParallel(c, 2).code, 0);
    until("0.06", "0.08");
    c.runWell("sphFoamLike");
    const auto expected = cloudOf(whole, "0.08"), reached = cloudOf(c, "0.08");
    ASSERT_EQ(reached.size(), expected.size());
    EXPECT_LT(difference(expected, reached, "U"), GetParam().bound);
    expectSameMasses(whole, c, "0.08", 1e-9);
}

/// Ends all ranks, with one message.
void isRefused(const TestCase& c, int ranks, const std::vector<std::string>& words)
{
    const auto outcome = runParallel(c, ranks);
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    const std::string head = "--> FATAL ERROR";
    const auto first = outcome.err.find(head);
    EXPECT_NE(first, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find(head, first + 1), std::string::npos) << outcome.err;
    for (const auto& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " in\n" << outcome.err;
}

TEST(RanksRefuse, WhatTheyCannotShare)
{
    auto few = channelCase();
    few["system/packParticlesDict"] = "lattice cubic; fill ( { region box; min (0 0 0); max (0.1 0.1 0); phase water; } );\n";
    isRefused(Prepared(few), 7, {"7 ranks for 4 particles"});
}

TEST(RanksRefuse, MistakesOfTheirDictionary)
{
    const Prepared c(channelCase());
    c.write("system/decomposeParDict", "numberOfSubdomains 4;\nmethod rcb;\n");
    isRefused(c, 3, {"system/decomposeParDict:1", "says 4 ranks", "with 3"});
    c.write("system/decomposeParDict", "numberOfSubdomains 3;\nmethod scotch;\n");
    isRefused(c, 3, {"system/decomposeParDict:2", "scotch", "rcb"});
    c.replace("constant/phaseProperties", "rho 1000;", "");
    c.write("system/decomposeParDict", "numberOfSubdomains 3;\n");
    isRefused(c, 3, {"constant/phaseProperties", "rho"});
}

// What ends one rank ends the run, soon and not as a success; what had been written is whole, and a new run goes on from there.
TEST(RanksThatDie, TakeTheOthersWithThem)
{
    const Prepared c(channelCase());
    c.replace("system/controlDict", "endTime 0.08", "endTime 1000");
    const auto outcome = runParallel(c, 3, "sleep 3; pkill -9 -n -f 'sphFoamLike -parallel -case " + c.folder().string() + "';");
    EXPECT_NE(outcome.code, 0);
    EXPECT_NE(outcome.code, 124) << "they went on until they were stopped";
    double latest = 0;
    std::string name;
    for (const auto& entry : std::filesystem::directory_iterator(c.folder()))
        if (const auto folder = entry.path().filename().string(); std::isdigit(folder[0]) && folder.find("partial") == std::string::npos)
            if (const double time = std::stod(folder); time > latest)
            {
                latest = time;
                name = folder;
            }
    ASSERT_GT(latest, 0) << outcome.err;
    EXPECT_EQ(cloudOf(c, name).size(), cloudOf(c, "0").size());
    c.replace("system/controlDict", "endTime 1000", "endTime " + std::to_string(latest + 0.02));
    EXPECT_EQ(runParallel(c, 2).code, 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Ranks,
                         testing::Values(Scene{"channel", watchedCase, 1e-9}, Scene{"drop", dropCase, 1e-9},
                                         Scene{"grain", grainCase, 1e-9}, Scene{"column", columnCase, 1e-9}, Scene{"bed", bedCase, 1e-9},
                                         Scene{"soil", soilCase, 1e-9}, Scene{"suspension", suspensionCase, 1e-9},
                                         Scene{"openChannel", openCase, 1e-9}, Scene{"periodicOpenChannel", periodicOpenCase, 1e-9},
                                         Scene{"layersOfTwo", layersCase, 1e-9}, Scene{"drip", dripCase, 1e-9},
                                         Scene{"filling", fillingCase, 1e-9}, Scene{"layeredChannel", layeredChannelCase, 1e-9},
                                         Scene{"layeredSoil", layeredSoilCase, 1e-9}),
                         [](const auto& scene) { return scene.param.name; });
INSTANTIATE_TEST_SUITE_P(Scenes, RanksOfARestart,
                         testing::Values(Scene{"channel", channelCase, 1e-9}, Scene{"openChannel", openCase, 1e-9},
                                         Scene{"drip", dripCase, 1e-9}, Scene{"layeredChannel", layeredChannelCase, 1e-9}),
                         [](const auto& scene) { return scene.param.name; });

}
