/// What comes in of one suspension and leaves of another: accounts that close to round-off, and the one in the place of the other at the end.
#include "smallCases.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace sph::test
{
namespace
{

/// The number after `word` in the last line of a log that has it.
double lastAfter(const std::string& log, const std::string& word) { return std::stod(log.substr(log.rfind(word) + word.size())); }

// 3 m/s through 1 m for 0.6 s: phi of 0.4 has left but beside the walls, where the first row moves at 0.44 m/s.
TEST(OpenScene, FillsWithWhatComesIn)
{
    auto files = openCase();
    auto& control = files["system/controlDict"];
    control.replace(control.find("0.08"), 4, "0.6");
    control.replace(control.find("0.02"), 4, "0.1");
    control += "functions { middle { type volFieldValue; operation volAverage; fields (phi); min (0 0.25 0); max (1 0.75 0); } }\n";
    const TestCase c(files);
    c.runWell("packParticles");
    c.runWell("meshToGhost");
    const auto log = c.runWell("sphFoamLike", "", 1);
    EXPECT_LT(std::abs(lastAfter(log, "balance: mass off by ")), 1e-12);
    EXPECT_LT(std::abs(lastAfter(log, ", powder by ")), 1e-12);
    const auto table = c.read("postProcessing/middle/0/volFieldValue.dat");
    std::istringstream last(table.substr(table.rfind('\n', table.size() - 2) + 1));
    double time = 0, phi = 0;
    last >> time >> phi;
    EXPECT_NEAR(time, 0.6, 1e-12);
    EXPECT_NEAR(phi, 0.45, 0.01); // powder leaves the walls, whose fluid the first has not left
}

}
}
