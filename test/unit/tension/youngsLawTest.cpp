/// Tensions of a wall with any number of phases from contact angles, by hand values; and angles that no sigmas allow.
#include "models/tension/YoungsLaw.hpp"
#include "models/tension/Tensions.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

/// Water, oil, air: 0.04 N/m of water and oil, 0.07 of water and air, 0.03 of oil and air.
Coefficients waterOilAir()
{
    Coefficients c;
    c.phases = {"water", "oil", "air"};
    c.restDensity = {1000, 800, 1};
    c.set(Tensions{{0, 0.04, 0.07, 0.04, 0, 0.03, 0.07, 0.03, 0}, {}});
    return c;
}

WallProperties wall(std::vector<WallProperties::PhaseAngle> angles)
{
    WallProperties w;
    w.wets = true;
    w.contactAngles = std::move(angles);
    return w;
}

struct Told
{
    std::vector<double> tension;
    std::string errors;
};
Told tell(const WallProperties& w, const Coefficients& c = waterOilAir())
{
    Told told;
    const auto complain = [&](const std::string& what) { told.errors += what + "\n"; };
    told.tension = wallTensions(phaseAngles(w, c, complain), c, complain);
    return told;
}
double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

// (water air) 30 and (oil air) 60: gamma_sa - gamma_sw = 0.07 cos 30 and gamma_sa - gamma_so = 0.03 cos 60, hence gamma_so - gamma_sw = 0.04562 ... which a
// sigma of 0.04 does not allow; with 60 and 70 it is 0.02474 = 0.04 cos 51.8. To rounding.
TEST(YoungsLaw, TwoAnglesTellTheTensionsOfThreePhases)
{
    const auto c = waterOilAir();
    const auto [tension, errors] = tell(wall({{"water", "air", 60}, {"oil", "air", 70}}));
    ASSERT_EQ(errors, "");
    ASSERT_EQ(tension.size(), 3u);
    EXPECT_NEAR(tension[2] - tension[0], 0.07 * cosine(60), 1e-15);
    EXPECT_NEAR(tension[2] - tension[1], 0.03 * cosine(70), 1e-15);
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += tension[k] / c.restDensity[k];
    EXPECT_NEAR(sum, 0, 1e-15);
}

// The order of the phases, of the pairs and of the words of a pair is nothing to the wall.
TEST(YoungsLaw, HangsOnNoOrder)
{
    const auto one = tell(wall({{"water", "air", 60}, {"oil", "air", 70}})),
               other = tell(wall({{"air", "oil", 110}, {"air", "water", 120}}));
    Coefficients turned = waterOilAir();
    turned.phases = {"air", "water", "oil"};
    turned.restDensity = {1, 1000, 800};
    turned.set(Tensions{{0, 0.07, 0.03, 0.07, 0, 0.04, 0.03, 0.04, 0}, {}});
    const auto third = tell(wall({{"water", "air", 60}, {"oil", "air", 70}}), turned);
    EXPECT_EQ(one.errors + other.errors + third.errors, "");
    for (std::size_t k = 0; k < 3; ++k)
    {
        EXPECT_NEAR(one.tension[k], other.tension[k], 1e-15);
        EXPECT_NEAR(one.tension[k], third.tension[(k + 1) % 3], 1e-15);
    }
}

// Half a degree is the rounding of a printed angle; more is a contradiction, and the error says what the others imply: 51.8.
TEST(YoungsLaw, AThirdAngleMustBeThatOfTheOthers)
{
    EXPECT_EQ(tell(wall({{"water", "air", 60}, {"oil", "air", 70}, {"water", "oil", 52}})).errors, "");
    EXPECT_EQ(tell(wall({{"water", "air", 60}, {"oil", "air", 70}, {"oil", "water", 128}})).errors, "");
    const auto errors = tell(wall({{"water", "air", 60}, {"oil", "air", 70}, {"water", "oil", 45}})).errors;
    EXPECT_NE(errors.find("the angle of (water oil) cannot be 45: by Young's law those before it imply 51.79 degrees"), std::string::npos)
        << errors;
}

// gamma_so - gamma_sw = 0.07 cos 30 - 0.03 cos 60 = 0.04562 N/m: more than sigma, whether the angle of the pair is given or not.
TEST(YoungsLaw, AnglesThatNoSigmasAllow)
{
    for (const auto& angles :
         {wall({{"water", "air", 30}, {"oil", "air", 60}}), wall({{"water", "air", 30}, {"oil", "air", 60}, {"oil", "water", 170}})})
    {
        const auto errors = tell(angles).errors;
        EXPECT_NE(
            errors.find(
                "no angle of (water oil) goes with the others: by Young's law its cosine is 1.141, the wall's tensions with the two being 0.04562 N/m "
                "apart and their own only 0.04. Possible with a sigma of (water oil) of at least 0.04562 N/m"),
            std::string::npos)
            << errors;
    }
}

TEST(YoungsLaw, PhasesThatNoAngleConnects)
{
    const auto errors = tell(wall({{"oil", "water", 60}})).errors;
    EXPECT_NE(errors.find(
                  "do not connect the phases (water oil), (air): with 3 phases 2 angles tell all others; (water air) is missing, for one"),
              std::string::npos)
        << errors;
    EXPECT_NE(tell(wall({{"oil", "watr", 60}})).errors.find("phase \"watr\" is unknown. Did you mean \"water\"?"), std::string::npos);
}

// The plain word is of two phases: through the first that the scene names.
TEST(YoungsLaw, OneAngleIsOfTwoPhases)
{
    WallProperties one;
    one.wets = true;
    one.contactAngle = 60;
    const auto errors = tell(one).errors;
    EXPECT_NE(errors.find("contactAngle 60 is of two phases, and here are 3"), std::string::npos) << errors;
    EXPECT_NE(errors.find("contactAngles ( (water oil) 60 (water air) 60 );"), std::string::npos) << errors;

    Coefficients two;
    two.phases = {"water", "air"};
    two.restDensity = {1000, 1};
    two.set(Tensions{{0, 0.07, 0.07, 0}, {}});
    const auto plain = tell(one, two), named = tell(wall({{"air", "water", 120}}), two);
    EXPECT_EQ(plain.errors + named.errors, "");
    EXPECT_NEAR(plain.tension[0] - plain.tension[1], -0.035, 1e-15);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(plain.tension[k], named.tension[k], 1e-16);
}

}
}
