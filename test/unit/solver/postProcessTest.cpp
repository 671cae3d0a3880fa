/// sphPostProcess from its command line to its tables: the times and functions that are asked for, and the case as it was.
#include "smallCases.hpp"
#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <set>
#include <sstream>

namespace sph::test
{
namespace
{

const char* const functions =
    "functions\n{\n    sums { type conservation; }\n    mean { type volFieldValue; operation volAverage; fields (p rho); }\n"
    "    wet { type bedHydrodynamics; liquid liquid; samples 16; }\n    here { type probes; fields (p U); probeLocations ((0.5 0.2 0)); }\n}\n";

/// A drop on a floor, run to its four write times; made once.
const TestCase& stored()
{
    static const auto made = []
    {
        auto c = std::make_unique<TestCase>(dropCase());
        for (const char* program : {"packParticles", "meshToGhost", "sphFoamLike"}) c->runWell(program);
        c->write("system/controlDict", c->read("system/controlDict") + functions);
        return c;
    }();
    return *made;
}

/// A copy of the case, sphPostProcess run with these arguments, and what it left.
struct Processed : TestCase
{
    Outcome outcome;
    explicit Processed(const std::string& arguments, int threads = 1) : TestCase(Files{})
    {
        for (const auto& entry : std::filesystem::directory_iterator(stored().folder()))
            copyFrom(stored(), entry.path().filename().string());
        outcome = run("sphPostProcess", arguments, threads);
    }
    /// The times in the tables of one kind.
    std::set<std::string> timesOf(const std::string& table) const
    {
        std::set<std::string> times;
        for (const auto& [name, text] : files("postProcessing"))
        {
            if (!name.ends_with(table)) continue;
            std::istringstream lines(text);
            for (std::string line; std::getline(lines, line);)
                if (!line.starts_with("#")) times.insert(line.substr(0, line.find_first_of(" \t")));
        }
        return times;
    }
};
using Times = std::set<std::string>;

TEST(PostProcess, TakesTheTimesThatAreAskedFor)
{
    const std::pair<std::string, Times> asked[]{{"", {"0", "0.02", "0.04", "0.06", "0.08"}}, {"-time 0.02,0.06", {"0.02", "0.06"}},
                                                {"-time 0.02:0.04", {"0.02", "0.04"}},       {"-time :0.02", {"0", "0.02"}},
                                                {"-time 0.06:", {"0.06", "0.08"}},           {"-latestTime", {"0.08"}}};
    for (const auto& [arguments, times] : asked)
    {
        const Processed c(arguments);
        ASSERT_EQ(c.outcome.code, 0) << c.outcome.err;
        for (const char* table : {"conservation.dat", "volFieldValue.dat", "bedHydrodynamics.dat"})
            EXPECT_EQ(c.timesOf(table), times) << arguments << " " << table;
        for (const auto& time : times) EXPECT_NE(c.outcome.out.find("Time = " + time + "\n"), std::string::npos) << arguments;
        EXPECT_NE(c.outcome.out.find("\nEnd\n"), std::string::npos);
        for (const char* folder : {"0", "0.02", "0.08", "constant", "system"})
            EXPECT_EQ(difference(stored().files(folder), c.files(folder)), "") << folder;
    }
}

TEST(PostProcess, RunsTheFunctionsThatAreAskedFor)
{
    const Processed c("-latestTime -func mean -func sums");
    ASSERT_EQ(c.outcome.code, 0) << c.outcome.err;
    Times folders;
    for (const auto& [name, text] : c.files("postProcessing")) folders.insert(name.substr(0, name.find('/')));
    EXPECT_EQ(folders, (Times{"mean", "sums"}));
}

// Mean density and pressure of a liquid of 1 and a gas of 0.5 kg/m^3: numbers, and those of the same time on four threads to the byte.
TEST(PostProcess, WritesTheSameNumbersOnAnyNumberOfThreads)
{
    const Processed one("-time 0.04:", 1), four("-time 0.04:", 4);
    EXPECT_EQ(difference(one.files("postProcessing"), four.files("postProcessing")), "");
    for (const auto& [name, text] : one.files("postProcessing")) EXPECT_EQ(text.find("nan"), std::string::npos) << name << text;
    std::istringstream last(one.read("postProcessing/mean/0.04/volFieldValue.dat"));
    std::string line;
    for (std::string next; std::getline(last, next);) line = next;
    std::istringstream cells(line);
    double time = 0, p = 0, rho = 0;
    cells >> time >> p >> rho;
    EXPECT_EQ(time, 0.08);
    EXPECT_GT(rho, 0.5);
    EXPECT_LT(rho, 1);
}

TEST(PostProcess, SaysWhatItCannotDo)
{
    const auto refused =
        [](const std::string& arguments, const std::vector<std::string>& words, const std::function<void(const TestCase&)>& damage = {})
    {
        SCOPED_TRACE(arguments);
        Processed c("-help");
        if (damage) damage(c);
        const auto outcome = c.run("sphPostProcess", arguments);
        EXPECT_EQ(outcome.code, 1);
        for (const auto& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << "no \"" << word << "\" in " << outcome.err;
        EXPECT_FALSE(c.has("postProcessing/sums/0.08/conservation.dat"));
    };
    refused("-time 7", {"no time folder matches \"7\". There are: 0, 0.02, 0.04, 0.06, 0.08"});
    refused("-time 1:2", {"no time folder matches \"1:2\""});
    refused("-time later", {"\"later\" is neither a time nor a range such as 0.1:0.5"});
    refused("-time 0.02 -latestTime", {"-time excludes -latestTime"});
    refused("-func means", {"system/controlDict:3", "there is no function \"means\". Did you mean \"mean\"?"});
    refused("", {"has no functions to run"}, [](const TestCase& c) { c.write("system/controlDict", controls); });
    refused("-latestTime", {"0.08/lagrangian/sph/rho"},
            [](const TestCase& c) { std::filesystem::resize_file(c.folder() / "0.08/lagrangian/sph/rho", 300); });
    refused("", {"No time folder of", "has a cloud lagrangian/sph"},
            [](const TestCase& c)
            {
                for (const char* time : {"0", "0.02", "0.04", "0.06", "0.08"}) std::filesystem::remove_all(c.folder() / time);
            });
}

}
}
