/// What models tell one another: values with one provider and a default.
#include "scene/Facts.hpp"
#include "base/CaseError.hpp"
#include "periodicSquare.hpp"
#include "solver/models.hpp"
#include <gtest/gtest.h>
#include <stdexcept>

namespace sph::test
{
namespace
{
std::string messageOf(auto&& f)
{
    try
    {
        f();
    }
    catch (const std::exception& e)
    {
        return e.what();
    }
    return "";
}
}

TEST(Facts, BeginWithTheirDefaultAndKeepWhatIsGiven)
{
    Facts facts;
    EXPECT_EQ(facts.get<ForceReach>().supports, 2);
    EXPECT_EQ(facts.by<FreeSurface>(), "");
    facts.give(OpenBoundary{true}, "constant/openings");
    EXPECT_TRUE(facts.get<OpenBoundary>().exists);
    EXPECT_EQ(facts.by<OpenBoundary>(), "constant/openings");
}

TEST(Facts, OfTwoModelsAreAnErrorThatNamesBoth)
{
    Facts facts;
    facts.give(SchemeSet{"soil"}, "constant/soilProperties");
    EXPECT_EQ(messageOf([&] { facts.give(SchemeSet{"freeSurface"}, "constant/openings"); }),
              "both constant/soilProperties and constant/openings say which set of schemes the scene takes: take one of them away");
    EXPECT_THROW(facts.give(SchemeSet{"soil"}, "constant/openings"), CaseError) << "even where both say the same";
    EXPECT_EQ(facts.get<SchemeSet>().word, "soil");
}

TEST(Facts, ThatWereAskedForTooEarlyAreAnErrorOfTheProgram)
{
    Facts facts;
    EXPECT_FALSE(facts.get<IntegratedDensity>().exists);
    EXPECT_THROW(facts.give(IntegratedDensity{true}, "density"), std::logic_error);
}

// Every small case reads its settings: none asks for a fact before it is given.
TEST(Facts, OfAChannelAndOfADropHaveOneProviderEach)
{
    const auto channel = settingsOf(channelCase());
    EXPECT_FALSE(channel.facts.get<InterfaceForces>().act);
    EXPECT_EQ(channel.facts.get<PressureForce>().form, PressureForce::Form::huAdams);
    const auto drop = settingsOf(dropCase());
    EXPECT_TRUE(drop.facts.get<InterfaceForces>().act);
    EXPECT_GT(drop.facts.get<InterfaceEnergy>().largest, 0);
    EXPECT_GT(drop.facts.get<ForceReach>().supports, 2);
    EXPECT_EQ(drop.facts.by<InterfaceEnergy>(), "sigma of constant/phaseProperties");
}

}
