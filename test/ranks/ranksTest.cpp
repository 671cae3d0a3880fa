/// Particles shared between ranks: the same answer on any number of them.
#include "Cloud.hpp"
#include "smallCases.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

using namespace sph;
using namespace sph::test;

namespace
{
/// With `arguments` to sphFoamLike on so many ranks, all on whatever processors there are.
Outcome runParallel(const TestCase& c, int ranks)
{
    const auto log = std::filesystem::temp_directory_path() / (c.folder().filename().string() + ".ranks");
    const std::string command = "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none "
                                "OMPI_MCA_mpi_yield_when_idle=1 OMP_NUM_THREADS=1 timeout 60 mpirun -np " +
                                std::to_string(ranks) + " '" SPH_APPLICATIONS "/sphFoamLike' -parallel -case '" + c.folder().string() +
                                "' < /dev/null > '" + log.string() + ".out' 2> '" + log.string() + ".err'";
    const int status = std::system(command.c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128, contentsOf(log.string() + ".out"), contentsOf(log.string() + ".err")};
    std::filesystem::remove(log.string() + ".out");
    std::filesystem::remove(log.string() + ".err");
    return outcome;
}

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

struct Scene
{
    const char* name;
    Files (*files)();
    double bound; ///< of the difference of U after some hundred steps: what round-off grows to
};

class Ranks : public testing::TestWithParam<Scene>
{};

TEST_P(Ranks, GiveTheSameAnswer)
{
    const TestCase c(GetParam().files());
    c.runWell("packParticles");
    c.runWell("meshToGhost");
    const TestCase alone({});
    for (const auto* folder : {"0", "constant", "system"}) alone.copyFrom(c, folder);
    alone.runWell("sphFoamLike");
    const std::string end = c.read("system/controlDict").find("endTime 0.04") != std::string::npos ? "0.04" : "0.08";
    const auto expected = cloudOf(alone, end);
    for (const int ranks : {2, 3, 7})
    {
        const TestCase shared({});
        for (const auto* folder : {"0", "constant", "system"}) shared.copyFrom(c, folder);
        const auto outcome = runParallel(shared, ranks);
        ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
        EXPECT_NE(outcome.out.find("nProcs : " + std::to_string(ranks)), std::string::npos);
        const auto cloud = cloudOf(shared, end);
        ASSERT_EQ(cloud.size(), expected.size());
        EXPECT_LT(difference(expected, cloud, "U"), GetParam().bound) << ranks;
        EXPECT_LT(difference(expected, cloud, "rho"), GetParam().bound) << ranks;
        EXPECT_NEAR(std::accumulate(cloud.fields.at("m").component[0].begin(), cloud.fields.at("m").component[0].end(), 0.0),
                    std::accumulate(expected.fields.at("m").component[0].begin(), expected.fields.at("m").component[0].end(), 0.0), 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Ranks,
                         testing::Values(Scene{"channel", channelCase, 1e-9}, Scene{"drop", dropCase, 1e-9}, Scene{"grain", grainCase, 1e-9},
                                         Scene{"column", columnCase, 1e-9}, Scene{"bed", bedCase, 1e-9}, Scene{"soil", soilCase, 1e-9},
                                         Scene{"suspension", suspensionCase, 1e-9}),
                         [](const auto& scene) { return scene.param.name; });

}
