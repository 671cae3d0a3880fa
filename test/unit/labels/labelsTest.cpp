/// Numbers that particles keep for life, in whole runs.
#include "case/Cloud.hpp"
#include "smallCases.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

using namespace sph;
using namespace sph::test;

namespace
{
Cloud cloudOf(const TestCase& c, const std::string& time)
{
    Diagnostics diagnostics;
    auto cloud = readCloud(c.folder(), time, "sph", diagnostics);
    diagnostics.throwIfAny();
    return cloud;
}

std::vector<double> idsOf(const TestCase& c, const std::string& time) { return cloudOf(c, time).fields.at("origId").component[0]; }

Files labelled(Files files)
{
    files["system/sphSchemes"] += "shown (origId origProcId);\n";
    return files;
}

void prepare(const TestCase& c)
{
    c.runWell("packParticles");
    c.runWell("meshToGhost");
}

// All are there at each time, the speed at which the particle of a number has moved from time to time is one that the flow has, and the
// last run of two has the same numbers as one that was not stopped.
TEST(Labels, StayWithTheirParticles)
{
    const TestCase c(labelled(channelCase()));
    prepare(c);
    c.runWell("sphFoamLike");
    const auto start = cloudOf(c, "0");
    EXPECT_FALSE(start.fields.contains("origId"));
    const auto first = cloudOf(c, "0.02"), last = cloudOf(c, "0.04");
    const auto placesOf = [](const Cloud& cloud)
    {
        std::map<double, std::pair<double, double>> places;
        const auto& ids = cloud.fields.at("origId").component[0];
        for (std::size_t i = 0; i < cloud.size(); ++i) places[ids[i]] = {cloud.x[i], cloud.y[i]};
        return places;
    };
    const auto atFirst = placesOf(first), atLast = placesOf(last);
    ASSERT_EQ(atFirst.size(), start.size());
    EXPECT_EQ(atFirst.rbegin()->first, double(start.size() - 1));
    const double fastest = 2;
    for (const auto& [id, x] : atLast)
    {
        const auto [x_0, y_0] = atFirst.at(id);
        const double dx = std::remainder(x.first - x_0, 1.0);
        EXPECT_LT(std::hypot(dx, x.second - y_0), 0.02 * fastest) << id;
        const auto i = std::size_t(id);
        EXPECT_LT(std::hypot(std::remainder(x_0 - start.x[i], 1.0), y_0 - start.y[i]), 0.02 * fastest)
            << "the place in the first time folder";
    }
    EXPECT_EQ(first.fields.at("origProcId").component[0], std::vector<double>(start.size(), 0.0));
    const auto whole = c.files("0.08");
    for (const auto* time : {"0.06", "0.08"}) std::filesystem::remove_all(c.folder() / time);
    c.runWell("sphFoamLike");
    EXPECT_EQ(difference(whole, c.files("0.08")), "");
}

// Through an inlet come particles, and through an outlet others go: no number is given twice, also by the second of two runs.
TEST(Labels, OfWhatComesInAreNew)
{
    const TestCase c(labelled(openCase()));
    c.replace("system/controlDict", "endTime 0.08", "endTime 0.24");
    c.replace("system/controlDict", "writeInterval 0.02", "writeInterval 0.06");
    prepare(c);
    c.runWell("sphFoamLike");
    std::set<double> gone;
    std::set<double> before;
    double highest = 0;
    for (const auto* time : {"0.06", "0.12", "0.18", "0.24"})
    {
        const auto ids = idsOf(c, time);
        const std::set<double> now(ids.begin(), ids.end());
        EXPECT_EQ(now.size(), ids.size()) << "twice at " << time;
        EXPECT_GE(*now.begin(), 0);
        for (const double id : now) EXPECT_FALSE(gone.contains(id)) << id << " was gone before " << time;
        for (const double id : before)
            if (!now.contains(id)) gone.insert(id);
        for (const double id : now) EXPECT_TRUE(before.empty() || before.contains(id) || id > highest) << id << " is new at " << time;
        highest = std::max(highest, *now.rbegin());
        before = now;
    }
    EXPECT_FALSE(gone.empty());
    EXPECT_GT(highest, double(cloudOf(c, "0").size()));
    const auto whole = c.files("0.24");
    for (const auto* time : {"0.18", "0.24"}) std::filesystem::remove_all(c.folder() / time);
    c.runWell("sphFoamLike");
    EXPECT_EQ(difference(whole, c.files("0.24")), "");
}

// What an outlet takes away at the start has the highest numbers; what comes in then gets others. Who has a number of the start is where it was then, but for
// the way that the flow has gone.
TEST(Labels, OfWhatIsTakenAwayAtTheStartAreNotGivenAgain)
{
    const TestCase c(labelled(openCase()));
    c.replace("constant/geometry", "max (1.2 1 0)", "max (2 1 0)");
    prepare(c);
    const auto text = c.runWell("sphFoamLike");
    EXPECT_NE(text.find("further beyond taken away at the start"), std::string::npos);
    const auto start = cloudOf(c, "0"), first = cloudOf(c, "0.02");
    const auto& ids = first.fields.at("origId").component[0];
    EXPECT_GT(*std::ranges::max_element(start.x), 1.9);
    EXPECT_GT(*std::ranges::max_element(ids), double(start.size() - 1)) << "particles have come in";
    const double fastest = 5;
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
        if (ids[i] >= double(start.size())) continue;
        EXPECT_LT(std::abs(first.x[i] - start.x[std::size_t(ids[i])]), 0.02 * fastest) << ids[i];
    }
}

TEST(Labels, ThatNobodyAskedForCostNothing)
{
    const TestCase without(channelCase()), with(labelled(channelCase()));
    for (const auto* c : {&without, &with}) prepare(*c);
    const auto plan = [](const TestCase& c) { return c.runWell("sphFoamLike", "-dry-run"); };
    const auto bytes = [&](const TestCase& c)
    {
        const auto text = plan(c);
        return std::stod(text.substr(text.find("allocated") + 9));
    };
    EXPECT_EQ(plan(without).find("origId"), std::string::npos);
    EXPECT_NEAR(bytes(with) - bytes(without), 2 * sizeof(double), 0.5);
    without.runWell("sphFoamLike");
    EXPECT_FALSE(without.has("0.02/lagrangian/sph/origId"));
}

TEST(Labels, ThatAreUnknownAreRefused)
{
    const TestCase c(channelCase());
    prepare(c);
    c.write("system/sphSchemes", c.read("system/sphSchemes") + "shown (origID);\n");
    const auto outcome = c.run("sphFoamLike");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("Did you mean \"origId\"?"), std::string::npos) << outcome.err;
}

}
