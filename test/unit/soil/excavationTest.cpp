/// Soil that is dug out: the stress that is left, the heave, what is counted, mistakes.
#include "CaseScene.hpp"
#include "messages.hpp"
#include "runTo.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>

namespace sph::test
{
namespace
{

/// An elastic column 1 m high under its weight, E_oed 1e7 Pa, at rest.
Files column(const std::string& where)
{
    auto files = soilCase();
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (0.5 1 0); }\nwalls { base { type plane; point (0 0 0); normal (0 1 0); slip yes; } "
        "left { type plane; point (0 0 0); normal (1 0 0); slip yes; } right { type plane; point (0.5 0 0); normal (-1 0 0); slip yes; } }\n";
    files["constant/soilProperties"] = fmt::format(
        "rho 1850;\nlaw elastic;\nelasticCoeffs {{ E 7.428571428571429e6; nu 0.3; }}\ninitialStress {{ type geostatic; surface 1; K0 {}; }}\n"
        "excavation {{ where \"{}\"; }}\n",
        0.3 / 0.7, where);
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 3.6; kernel wendlandC2; }\nintegration { damping { rate 400; until 100; } }\n";
    return files;
}

}

// The upper half goes in rows: what is below has the weight of what is left, on the mean of two rows, and rises by y rho g 0.5 m/E_oed.
TEST(Excavation, LeavesTheWeightOfWhatIsLeft)
{
    const CaseScene scene(column("$y > 1 - 2*$t && $y > 0.5"));
    ASSERT_EQ(scene.errors, "");
    const double weight = 1850 * 9.81;
    runTo(*scene.simulation, 0.2);
    EXPECT_EQ(scene.simulation->size(), 120u) << "four of five rows above 0.6 m";
    runTo(*scene.simulation, 0.8);
    ASSERT_EQ(scene.simulation->size(), 100u);
    std::map<int, std::pair<double, double>> rows; // stress and height by number
    const auto* const y = scene.simulation->positions().component[1];
    const auto& sigma = scene.simulation->field("sigma");
    for (std::size_t i = 0; i < 100; ++i)
    {
        auto& [stress, height] = rows[int(y[i] / 0.05)];
        stress += sigma.component[3][i] / 10;
        height += y[i] / 10;
    }
    ASSERT_EQ(rows.size(), 10u);
    for (int row = 0; row < 6; row += 2)
    {
        const double stress = 0.5 * (rows[row].first + rows[row + 1].first), height = 0.05 * (row + 1);
        const double rises = height * weight * 0.5 / 1e7;
        EXPECT_NEAR(stress / (-weight * (0.5 - height)), 1, 0.01) << row;
        EXPECT_NEAR((0.5 * (rows[row].second + rows[row + 1].second) - height) / rises, 1, 0.02) << row;
    }
}

TEST(Excavation, SaysWhatIsWrong)
{
    EXPECT_PRED2(says, CaseScene(column("$p > 3")).errors, "$p is unknown here. Known: $x, $y, $z, $t");
    EXPECT_PRED2(says, CaseScene(column("vector(1, 0, 0)")).errors, "the result is a vector, not a number");
    EXPECT_PRED2(says, CaseScene(column("sqrt($y - 0.5)")).errors, "this has no value");
    const CaseScene all(column("$t > 0.01"));
    EXPECT_PRED2(says, messageOf([&] { runTo(*all.simulation, 0.1); }), "this leaves no soil");
}

}
