/// Particles shared between ranks: the same answer on any number of them.
#include "Largest.hpp"
#include "SmallDisk.hpp"
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "smallCases.hpp"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <sstream>

using namespace sph;
using namespace sph::test;

namespace
{
/// A program of the suite on so many ranks, all on whatever processors there are. `meanwhile` runs beside it.
Outcome onRanks(int ranks, const std::string& program, const std::string& meanwhile = "")
{
    // Apart from other runs: an mpirun that ends removes the folder of all in TMPDIR once it is empty, and one that has just made it then fails.
    const TestCase own(Files{});
    const auto folder = own.folder().string();
    const std::string command = "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 "
                                "OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1 OMP_NUM_THREADS=1; TMPDIR='" +
                                folder + "' timeout 100 mpirun -np " + std::to_string(ranks) + " " SPH_APPLICATIONS "/" + program +
                                " < /dev/null > '" + folder + "/out' 2> '" + folder + "/err' & run=$!; " + meanwhile + " wait $run";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, own.read("out"), own.read("err")};
}

Outcome runParallel(const TestCase& c, int ranks, const std::string& meanwhile = "")
{
    return onRanks(ranks, "sphFoamLike -parallel -case " + c.folder().string(), meanwhile);
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

/// A copy of a case, with a folder for each of so many ranks.
struct Decomposed : CopyOf
{
    Decomposed(const TestCase& c, int parts, const std::string& method = "rcb") : CopyOf(c) { decompose(parts, method); }
    void decompose(int parts, const std::string& method = "rcb", const std::string& arguments = "") const
    {
        write("system/decomposeParDict", "numberOfSubdomains " + std::to_string(parts) + ";\nmethod " + method + ";\n");
        runWell("decomposeParticles", arguments);
    }
};

Files labelledChannel()
{
    auto files = channelCase();
    files["system/sphSchemes"] += "shown (origId);\n";
    return files;
}

Cloud cloudOf(const TestCase& c, const std::string& time)
{
    Diagnostics diagnostics;
    auto cloud = readCloud(c.folder(), time, "sph", diagnostics);
    diagnostics.throwIfAny();
    return cloud;
}

/// The largest difference of a field between particles i of one cloud and partner[i] of another, over the largest value. NaN where there is one: then no bound holds.
double difference(const Cloud& a, const Cloud& b, const std::vector<std::size_t>& partner, const std::string& name)
{
    const auto &fieldA = a.fields.at(name), &fieldB = b.fields.at(name);
    Largest worst, largest;
    for (std::size_t k = 0; k < fieldA.component.size(); ++k)
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            worst(fieldA.component[k][i] - fieldB.component[k][partner[i]]);
            largest(fieldA.component[k][i]);
        }
    return worst.value() / largest.value();
}

/// Of particles at the same place; infinite where one has no partner within 1e-3.
double difference(const Cloud& a, const Cloud& b, const std::string& name)
{
    std::vector<std::size_t> partner(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        double nearest = INFINITY;
        for (std::size_t j = 0; j < b.size(); ++j)
            if (const double d = std::hypot(a.x[i] - b.x[j], a.y[i] - b.y[j], a.z[i] - b.z[j]); d < nearest)
            {
                nearest = d;
                partner[i] = j;
            }
        if (nearest > 1e-3) return INFINITY;
    }
    return difference(a, b, partner, name);
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

/// Of particles of the same number, without a look at their places; infinite where the numbers are not the same.
double labelledDifference(const Cloud& a, const Cloud& b, const std::string& name)
{
    const auto numbered = [](const Cloud& cloud)
    {
        std::map<double, std::size_t> places;
        const auto& ids = cloud.fields.at("origId").component[0];
        for (std::size_t i = 0; i < ids.size(); ++i) places[ids[i]] = i;
        return places;
    };
    const auto inA = numbered(a), inB = numbered(b);
    if (inA.size() != a.size() || inB.size() != a.size() || b.size() != a.size()) return INFINITY;
    std::vector<std::size_t> partner(a.size());
    for (const auto& [id, i] : inA)
    {
        if (!inB.contains(id)) return INFINITY;
        partner[i] = inB.at(id);
    }
    return difference(a, b, partner, name);
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

/// With water in its pores, that of a level which falls before it; or that of a membrane.
Files saturatedSoilCase(const std::string& ofWater)
{
    auto files = soilCase();
    files["constant/soilProperties"] =
        "rho 1850;\nlaw elastic;\nelasticCoeffs { E 1e6; nu 0.3; }\nporeWater { porosity 0.4; tolerance 1e-9; " + ofWater + " }\n";
    auto& control = files["system/controlDict"];
    control.replace(control.find("endTime 0.08"), 12, "endTime 0.04");
    return files;
}
Files wetSoilCase()
{
    return saturatedSoilCase("permeability 1e-3; waterLevel \"0.3 - $t\"; unsaturated { capillaryHead 0.05; specificYield 0.01; } "
                             "walls { left { waterLevel 0.4; } } initial { type hydrostatic; waterTable 0.3; }");
}
Files undrainedSoilCase()
{
    auto files = saturatedSoilCase("permeability 0; bulkModulus 1e7; freeSurface closed; projection exact;");
    files["system/sphSchemes"] += "soil { stressDivergence balanced; }\n";
    return files;
}

void expectTheSameAnswer(const Scene& scene)
{
    const Prepared c(scene.files());
    const CopyOf alone(c);
    alone.runWell("sphFoamLike");
    const std::string end = c.read("system/controlDict").find("endTime 0.04") != std::string::npos ? "0.04" : "0.08";
    const auto expected = cloudOf(alone, end);
    const auto mass = [](const Cloud& cloud)
    {
        const auto& m = cloud.fields.at("m").component[0];
        return std::accumulate(m.begin(), m.end(), 0.0);
    };
    for (const int ranks : {2, 5})
    {
        const CopyOf shared(c);
        const auto outcome = runParallel(shared, ranks);
        ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
        EXPECT_NE(outcome.out.find("nProcs : " + std::to_string(ranks)), std::string::npos);
        EXPECT_NE(outcome.out.find("messages cost more than a rank brings"), std::string::npos);
        const auto cloud = cloudOf(shared, end);
        ASSERT_EQ(cloud.size(), expected.size());
        EXPECT_LT(difference(expected, cloud, "U"), scene.bound) << ranks;
        EXPECT_LT(difference(expected, cloud, "rho"), scene.bound) << ranks;
        EXPECT_NEAR(mass(cloud), mass(expected), 1e-12 * mass(expected));
        expectSameMasses(alone, shared, end, 1e-12 * mass(expected));
    }
}

TEST_P(Ranks, GiveTheSameAnswer) { expectTheSameAnswer(GetParam()); }

// Nothing to cut by at the start: the first rank has all of space. When it is cut again is a matter of processor time, and not asked here.
TEST(RanksOfAnEmptyScene, GiveTheSameAnswer) { expectTheSameAnswer({"dripAlone", dripAloneCase, 1e-7}); }

// The numbers of a restart are those of the whole, in every folder, and the particles are those of one process.
TEST_P(Ranks, DoSoFromFoldersOfTheirOwn)
{
    const Prepared c(GetParam().files());
    const CopyOf alone(c);
    alone.runWell("sphFoamLike");
    const Decomposed shared(c, 3);
    const auto outcome = runParallel(shared, 3);
    ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
    const std::string end = c.read("system/controlDict").find("endTime 0.04") != std::string::npos ? "0.04" : "0.08";
    for (const auto* rank : {"processor1/", "processor2/"})
        for (const auto& file : {end + "/uniform/sphState", end + "/uniform/time"})
            EXPECT_EQ(shared.read(rank + file), shared.read("processor0/" + file));
    shared.runWell("reconstructParticles", "-latestTime");
    const auto expected = cloudOf(alone, end), cloud = cloudOf(shared, end);
    ASSERT_EQ(cloud.size(), expected.size());
    EXPECT_LT(difference(expected, cloud, "U"), GetParam().bound);
    EXPECT_LT(difference(expected, cloud, "rho"), GetParam().bound);
}

class RanksOfARestart : public testing::TestWithParam<Scene>
{};

// The number of processes changes from one to three, to two, and back.
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

// Each rank reads its slice: whoever finds the mistake, one message names file and particle, and so it does where several ranks find one.
TEST(RanksRefuse, BadParticlesOfTheirSlices)
{
    const Prepared c(channelCase());
    c.replace("system/controlDict", "endTime 0.08", "endTime 0.02");
    c.runWell("sphFoamLike");
    const std::string U = "0.02/lagrangian/sph/U";
    const auto good = c.read(U);
    const auto n = cloudOf(c, "0.02").size();
    const auto at = [&](std::size_t i) { return good.size() - 2 - 24 * (n - i); }; // 24 bytes each, and ")" and a line end behind them
    const auto withNaN = [&](std::initializer_list<std::size_t> particles)
    {
        auto text = good;
        for (const auto i : particles) text.replace(at(i) + 6, 2, "\xf8\x7f");
        c.write(U, text);
    };
    c.replace("system/controlDict", "endTime 0.02", "endTime 0.04");
    withNaN({n - 1});
    isRefused(c, 3, {U, "the value of particle " + std::to_string(n - 1) + " is not finite"});
    withNaN({n / 2, n - 1});
    isRefused(c, 3, {U, "the value of particle " + std::to_string(n / 2) + " is not finite"});
    c.write(U, good.substr(0, good.size() - 30));
    isRefused(c, 3, {U, "the file is truncated"});
    withNaN({n - 1});
    c.replace("system/controlDict", "endTime 0.04", "endTime often");
    isRefused(c, 3, {U, "is not finite", "system/controlDict", "often"});
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

/// The latest time folder, and its time.
std::pair<std::string, double> latestIn(const std::filesystem::path& folder)
{
    std::pair<std::string, double> latest{"", 0};
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (const auto name = entry.path().filename().string(); std::isdigit(name[0]) && name.find("partial") == std::string::npos)
            if (const double time = std::stod(name); time > latest.second) latest = {name, time};
    return latest;
}

/// A run without end of which one rank is killed once a time has been written: it ends soon, and not as a success.
void runUntilOneDies(const TestCase& c)
{
    c.replace("system/controlDict", "endTime 0.08", "endTime 1000");
    const std::string folder = c.folder().string();
    const auto outcome =
        runParallel(c, 3,
                    "for k in $(seq 300); do [ -z \"$(find " + folder +
                        " -maxdepth 2 -name 0.02)\" ] || break; sleep 0.1; done; sleep 1; pkill -9 -n -f 'sphFoamLike -parallel -case " +
                        folder + "';");
    EXPECT_NE(outcome.code, 0);
    EXPECT_NE(outcome.code, 124) << "they went on until they were stopped";
}

// Whichever of them is asked to stop: the present time is written whole, and the exit code is that of the signal.
TEST(RanksThatAreAsked, StopTogether)
{
    const Prepared c(channelCase());
    c.replace("system/controlDict", "endTime 0.08", "endTime 1000");
    c.replace("system/controlDict", "writeInterval 0.02", "writeInterval 500");
    const auto outcome = runParallel(c, 3, "sleep 3; pkill -TERM -n -f 'sphFoamLike -parallel -case " + c.folder().string() + "';");
    EXPECT_EQ(outcome.code, 128 + SIGTERM) << outcome.err;
    EXPECT_NE(outcome.out.find("\nStopped by signal 15 "), std::string::npos) << outcome.out;
    const auto [name, latest] = latestIn(c.folder());
    ASSERT_GT(latest, 0) << outcome.out;
    EXPECT_EQ(cloudOf(c, name).size(), cloudOf(c, "0").size());
}

// What had been written is whole, and a new run goes on from there.
TEST(RanksThatDie, TakeTheOthersWithThem)
{
    const Prepared c(channelCase());
    runUntilOneDies(c);
    const auto [name, latest] = latestIn(c.folder());
    ASSERT_GT(latest, 0);
    EXPECT_EQ(cloudOf(c, name).size(), cloudOf(c, "0").size());
    c.replace("system/controlDict", "endTime 1000", "endTime " + std::to_string(latest + 0.02));
    EXPECT_EQ(runParallel(c, 2).code, 0);
}

TEST(RanksThatDie, LeaveFoldersThatOthersGoOnFrom)
{
    const Prepared c(channelCase());
    const Decomposed shared(c, 3);
    runUntilOneDies(shared);
    const double latest = latestIn(shared.folder() / "processor0").second;
    ASSERT_GT(latest, 0);
    shared.replace("system/controlDict", "endTime 1000", "endTime " + std::to_string(latest + 0.04));
    const auto outcome = runParallel(shared, 3);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto end = latestIn(shared.folder() / "processor2");
    EXPECT_NEAR(end.second, latest + 0.04, 1e-6);
    shared.runWell("reconstructParticles", "-time " + end.first);
    EXPECT_EQ(cloudOf(shared, end.first).size(), cloudOf(c, "0").size());
}

// Each rank reads and writes its folder; put together, the particles are those of one process, each by its number, and any number of ranks
// goes on from there.
TEST(RanksOfADecomposedCase, ReadAndWriteTheirFolders)
{
    const Prepared c(labelledChannel());
    const CopyOf alone(c);
    alone.runWell("sphFoamLike");
    for (const auto* method : {"rcb", "rib", "hilbert"})
    {
        const Decomposed shared(c, 3, method);
        shared.replace("system/controlDict", "endTime 0.08", "endTime 0.06");
        const auto outcome = runParallel(shared, 3);
        ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
        EXPECT_EQ(outcome.out.find("boxes for the ranks") != std::string::npos, std::string(method) != "rcb");
        EXPECT_FALSE(shared.has("0.06"));
        for (const auto* rank : {"1", "2"})
            for (const auto* file : {"sphState", "time"})
                EXPECT_EQ(shared.read(std::string("processor") + rank + "/0.06/uniform/" + file),
                          shared.read(std::string("processor0/0.06/uniform/") + file));
        shared.runWell("reconstructParticles");
        const auto whole = cloudOf(alone, "0.06");
        for (const auto* field : {"U", "rho"}) EXPECT_LT(labelledDifference(whole, cloudOf(shared, "0.06"), field), 1e-9) << method;
        EXPECT_TRUE(shared.has("0.02"));

        shared.replace("system/controlDict", "endTime 0.06", "endTime 0.08");
        if (std::string(method) == "rcb") EXPECT_EQ(runParallel(shared, 3).code, 0) << "from the folders";
        else if (std::string(method) == "rib")
        {
            shared.decompose(2, "rcb", "-force");
            EXPECT_EQ(runParallel(shared, 2).code, 0) << "from others";
        }
        else shared.runWell("sphFoamLike"); // from what has been put together
        if (!shared.has("0.08")) shared.runWell("reconstructParticles", "-newTimes");
        EXPECT_LT(labelledDifference(cloudOf(alone, "0.08"), cloudOf(shared, "0.08"), "U"), 1e-9) << method;
    }
}

// Particles that ranks read of the case itself have the same numbers, too.
// Stages, passes and operations, which the unit tests of the solver hold to what runs, are those of one process; the numbers of fields are not.
TEST(RanksOfACase, PrintThePlanOfOneProcess)
{
    for (const auto& files : {openCase(), soilCase(), bedCase()})
    {
        const Prepared c(files);
        const auto plan = [](const std::string& log)
        {
            std::string numbered;
            std::istringstream lines(log);
            for (std::string line; std::getline(lines, line);)
                if (const auto at = line.find_first_not_of(' '); at != std::string::npos && at > 1 && std::isdigit(line[at]))
                    numbered += line + '\n';
            return numbered;
        };
        const auto alone = plan(c.runWell("sphFoamLike", "-dry-run"));
        const auto shared = onRanks(2, "sphFoamLike -parallel -dry-run -case " + c.folder().string());
        EXPECT_EQ(shared.code, 0) << shared.err;
        EXPECT_GT(std::ranges::count(alone, '\n'), 8) << alone;
        EXPECT_EQ(plan(shared.out), alone);
    }
}

TEST(RanksOfACase, NumberItsParticles)
{
    const Prepared c(labelledChannel());
    const CopyOf alone(c), shared(c);
    alone.runWell("sphFoamLike");
    ASSERT_EQ(runParallel(shared, 3).code, 0);
    EXPECT_LT(labelledDifference(cloudOf(alone, "0.08"), cloudOf(shared, "0.08"), "U"), 1e-9);
}

TEST(RanksRefuse, FoldersThatAreNotTheirs)
{
    const Prepared c(channelCase());
    const Decomposed two(c, 2);
    std::filesystem::remove(two.folder() / "system/decomposeParDict");
    isRefused(two, 3, {"number of processor directories = 2 is not equal to the number of processors = 3"});
    isRefused(two, 1, {"number of processor directories = 2 is not equal to the number of processors = 1"});
    const Decomposed three(c, 3);
    std::filesystem::remove_all(three.folder() / "processor1");
    isRefused(three, 3, {"processor1", "is missing, and processor2 is there"});
    three.decompose(3, "rcb", "-force");
    std::filesystem::rename(three.folder() / "processor2/0", three.folder() / "processor2/0.02");
    isRefused(three, 3, {"no time is in all of the 3 processor directories"});
    three.decompose(3, "rcb", "-force");
    three.write("processor1/constant/decomposition", "numberOfSubdomains 3; part 1; stamp \"other\"; times (\"0\");\n");
    isRefused(three, 3, {"processor1/constant/decomposition", "another decomposition"});
    three.decompose(3, "rcb", "-force");
    three.write("processor1/0/lagrangian/sph/U", "FoamFile {}");
    isRefused(three, 3, {"processor1/0/lagrangian/sph/U"});
}

// A time that not all have written does not count: the run begins with the last that all have, and writes the others anew.
TEST(RanksOfADecomposedCase, GoOnFromWhatAllHaveWritten)
{
    const Prepared c(channelCase());
    const Decomposed shared(c, 2);
    ASSERT_EQ(runParallel(shared, 2).code, 0);
    const auto whole = shared.files("processor1/0.08");
    std::filesystem::remove_all(shared.folder() / "processor1/0.08");
    const auto before = shared.run("reconstructParticles");
    EXPECT_EQ(before.code, 1);
    EXPECT_NE(before.err.find("processor1/0.08: is missing, and others have that time"), std::string::npos) << before.err;
    const auto outcome = runParallel(shared, 2);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("times 0.08 are not in all of the 2 directories"), std::string::npos) << outcome.out;
    shared.runWell("reconstructParticles", "-latestTime");
    EXPECT_EQ(cloudOf(shared, "0.08").size(), cloudOf(c, "0").size());
}

TEST(DecomposeParticles, RefusesWhatIsThereAndWhatIsWrong)
{
    const Prepared c(channelCase());
    const Decomposed shared(c, 2);
    const auto refused = [&](const std::string& application, const std::string& arguments, const std::vector<std::string>& words)
    {
        const auto outcome = shared.run(application, arguments);
        EXPECT_EQ(outcome.code, 1) << application;
        for (const auto& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " in\n" << outcome.err;
    };
    refused("decomposeParticles", "", {"already decomposed with 2 domains", "-force"});
    refused("decomposeParticles", "-force -time 7", {"-time", "no time folder", "There are: 0"});
    EXPECT_TRUE(shared.has("processor1/0/lagrangian/sph/U"));
    shared.write("system/decomposeParDict", "numberOfSubdomains 4;\n");
    refused("reconstructParticles", "", {"system/decomposeParDict:1", "numberOfSubdomains is 4, and the case has 2 processor folders"});
    shared.write("system/decomposeParDict", "method hilbrt;\n");
    refused("decomposeParticles", "-force", {"numberOfSubdomains", "hilbert"});
    std::filesystem::remove(shared.folder() / "system/decomposeParDict");
    refused("decomposeParticles", "-force", {"system/decomposeParDict"});
    const auto times = shared.runWell("reconstructParticles");
    EXPECT_NE(times.find("No further times"), std::string::npos) << times;
}

/// A cloud of so many particles of each rank, whose values are those of their numbers in the whole; -1: each phase is a label.
Outcome writeOnRanks(const TestCase& c, const std::string& format, std::vector<int> counts, int withoutLabel = -1)
{
    std::string words = "collatedWriting write " + c.folder().string() + " " + format + " " + std::to_string(withoutLabel);
    for (const int n : counts) words += " " + std::to_string(n);
    return onRanks(int(counts.size()), words);
}

class CollatedFiles : public testing::TestWithParam<const char*>
{};

// One file a field, to the last byte that of one process; ascii lines are of any length, rho is one value of all, and some ranks have nothing. The
// last cloud is longer than the buffer of an OutputFile.
TEST_P(CollatedFiles, AreThoseOfOneProcess)
{
    for (const auto& counts : std::vector<std::vector<int>>{{5, 0, 9}, {0, 0, 3}, {0, 1, 0}, {4, 6, 0}, {0, 0, 0}, {60000, 90000, 1}})
    {
        const TestCase together(Files{}), alone(Files{});
        const auto outcome = writeOnRanks(together, GetParam(), counts);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const auto ofOne = writeOnRanks(alone, GetParam(), {std::accumulate(counts.begin(), counts.end(), 0)});
        ASSERT_EQ(ofOne.code, 0) << ofOne.err;
        const auto files = together.files("");
        EXPECT_EQ(files.size(), 6u);
        EXPECT_EQ(test::difference(alone.files(""), files), "") << counts[0];
    }
}

/// How often these words are there.
int countOf(const std::string& text, const std::string& words)
{
    int n = 0;
    for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++n;
    return n;
}

// Particle 9 is the fifth of the second rank: all three say so, in the words of one process, and nothing is left.
TEST_P(CollatedFiles, ThatCannotBeWrittenEndAllRanks)
{
    const TestCase together(Files{}), alone(Files{});
    const std::string words = "field phase: 10000000000 of particle 9 is not a label\n";
    EXPECT_EQ(countOf(writeOnRanks(alone, GetParam(), {20}, 9).err, words), 1);
    const auto outcome = writeOnRanks(together, GetParam(), {5, 5, 10}, 9);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(countOf(outcome.err, words), 3) << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(together.folder()));
}

// 600 particles fit, 5000 do not, be it the share of the first rank or of the last: the last good time is whole.
TEST_P(CollatedFiles, OfAFullDiskAreRemoved)
{
    const SmallDisk disk("128k");
    if (!disk.mounted()) GTEST_SKIP() << SmallDisk::notPermitted;
    const TestCase c(Files{}, disk.folder());
    ASSERT_EQ(writeOnRanks(c, GetParam(), {100, 200, 300}).code, 0);
    const auto before = c.files("");
    for (const auto& counts : std::vector<std::vector<int>>{{100, 0, 5000}, {5000, 1, 1}})
    {
        const auto outcome = writeOnRanks(c, GetParam(), counts);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(countOf(outcome.err, ": cannot be written: No space left on device\n"), 3) << outcome.err;
        EXPECT_EQ(test::difference(before, c.files("")), "");
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, CollatedFiles, testing::Values("ascii", "binary"), [](const auto& format) { return format.param; });

// A run whose second time has no place: one message, exit code 1, and the times before are whole.
TEST(RanksOfAFullDisk, EndWithOneMessage)
{
    const SmallDisk disk("1m");
    if (!disk.mounted()) GTEST_SKIP() << SmallDisk::notPermitted;
    const Prepared prepared(channelCase());
    const TestCase c(Files{}, disk.folder());
    for (const auto* part : {"0", "constant", "system"}) c.copyFrom(prepared, part);
    c.replace("system/controlDict", "endTime 0.08", "endTime 8");
    isRefused(c, 3, {"cannot be written: No space left on device"});
    const auto [name, latest] = latestIn(c.folder());
    EXPECT_EQ(cloudOf(c, name).size(), cloudOf(prepared, "0").size());
    for (const auto& entry : std::filesystem::directory_iterator(c.folder())) EXPECT_NE(entry.path().extension(), ".partial");
}

/// The number behind the last of these words.
double numberBehind(const std::string& text, const std::string& words)
{
    const auto at = text.rfind(words);
    if (at == std::string::npos) throw std::logic_error("no \"" + words + "\" in\n" + text);
    return std::stod(text.substr(at + words.size()));
}

/// Liquid that fills a periodic box.
Files blockCase()
{
    auto files = bedCase();
    files["constant/geometry"] = "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x y z); }\n";
    files["system/sphSchemes"] =
        "resolution { spacing 0.0625; support 2.6; kernel wendlandC2; }\nintegration { scheme predictorCorrector; }\n";
    files["system/packParticlesDict"] =
        "lattice cubic; jitter 0.1; velocity { type taylorGreen; U 1; L 1; }\nfill ( { region all; phase water; } );\n";
    return files;
}

// Steps have two evaluations, and there are a few at the start and before a time is written: within a fifth for some ten steps.
TEST(EstimateOfRanks, IsWhatTheySend)
{
    const Prepared c(blockCase());
    const auto estimate = c.runWell("decomposeParticles", "-estimate 3");
    EXPECT_FALSE(c.has("processor0"));
    const auto at = estimate.find("bytes of a step");
    double least, mean;
    std::istringstream(estimate.substr(at + std::string("bytes of a step").size())) >> least >> mean;
    const auto run = runParallel(c, 3);
    ASSERT_EQ(run.code, 0) << run.err;
    double sent = 0;
    for (const auto* rank : {"Rank 0", "Rank 1", "Rank 2"})
    {
        const auto line = run.out.substr(run.out.find(rank));
        sent += 1e6 * numberBehind(line.substr(0, line.find(" MB sent")), "s, ") / 3;
    }
    EXPECT_NEAR(sent / (mean * numberBehind(run.out, "\nstep ")), 1, 0.2) << estimate << run.out;
}

TEST(EstimateOfRanks, RefusesWhatMakesNoSense)
{
    const Prepared c(channelCase());
    for (const auto* arguments : {"-estimate 0", "-estimate 200000", "-latency 1e-6", "-estimate 4 -bandwidth -1", "-estimate 1000"})
        EXPECT_EQ(c.run("decomposeParticles", arguments).code, 1) << arguments;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Ranks,
                         testing::Values(Scene{"channel", watchedCase, 1e-9}, Scene{"drop", dropCase, 1e-9},
                                         Scene{"dropsAlone", dropsAloneCase, 1e-9}, Scene{"grain", grainCase, 1e-9},
                                         Scene{"column", columnCase, 1e-9}, Scene{"bed", bedCase, 1e-9}, Scene{"soil", soilCase, 1e-9},
                                         Scene{"wetSoil", wetSoilCase, 1e-7}, Scene{"undrainedSoil", undrainedSoilCase, 1e-7},
                                         Scene{"loadedSoil", loadedSoilCase, 1e-9}, Scene{"suspension", suspensionCase, 1e-9},
                                         Scene{"openChannel", openCase, 1e-9}, Scene{"periodicOpenChannel", periodicOpenCase, 1e-9},
                                         Scene{"layersOfTwo", layersCase, 1e-9}, Scene{"drip", dripCase, 1e-9},
                                         Scene{"filling", fillingCase, 1e-9}, Scene{"layeredChannel", layeredChannelCase, 1e-9},
                                         Scene{"layeredSoil", layeredSoilCase, 1e-9}, Scene{"convection", convectionCase, 1e-9}),
                         [](const auto& scene) { return scene.param.name; });
INSTANTIATE_TEST_SUITE_P(Scenes, RanksOfARestart,
                         testing::Values(Scene{"channel", channelCase, 1e-9}, Scene{"openChannel", openCase, 1e-9},
                                         Scene{"drip", dripCase, 1e-9}, Scene{"layeredChannel", layeredChannelCase, 1e-9}),
                         [](const auto& scene) { return scene.param.name; });

}
