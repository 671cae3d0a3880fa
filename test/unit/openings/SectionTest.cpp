/// Sections of ducts: their lines, their area, and the profile of developed flow, against plane channels, squares and pipes.
#include "Section.hpp"
#include "Duct.hpp"
#include "Largest.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test
{
namespace
{

double meanOf(const Section& section)
{
    double sum = 0;
    for (const auto& line : section.lines()) sum += line.profile;
    return sum / double(section.lines().size());
}

// 9.6 spacings from wall to wall: ten lines, a little closer, and rows a little further apart.
TEST(Section, FillsAPlaneChannel)
{
    const Section section(inlet(), channel(0.96), 0.1);
    ASSERT_EQ(section.lines().size(), 10u);
    EXPECT_NEAR(section.area(), 0.96, 1e-9);
    EXPECT_NEAR(section.rowSpacing() * section.area() / 10, 0.01, 1e-12);
    EXPECT_NEAR(section.width(), 0.96, 1e-9);
    for (int l = 0; l < 10; ++l)
    {
        const auto x = section.lines()[std::size_t(l)].foot;
        EXPECT_NEAR(x.x, 0, 1e-15);
        EXPECT_EQ(section.lineAt(x + Vector<3>{-0.2, 0.04, 0}), l);
    }
    EXPECT_EQ(section.lineAt({0, 1, 0}), -1);
}

// u = 6 y (1 - y): the mean of a parabola is 2/3 of its top.
TEST(Section, DevelopsAParabola)
{
    Largest error[2];
    for (int k = 0; k < 2; ++k)
    {
        auto opening = inlet();
        opening.developed = true;
        const Section section(opening, channel(1), k == 0 ? 0.1 : 0.05);
        EXPECT_NEAR(meanOf(section), 1, 1e-12);
        for (const auto& line : section.lines()) error[k](line.profile - 6 * line.foot.y * (1 - line.foot.y));
    }
    EXPECT_LT(error[0].value(), 0.02);
    EXPECT_NEAR(error[0].value() / error[1].value(), 4, 0.3);
}

// The largest velocity in a square duct is 2.0963 of the mean (Shah & London 1978), in a round pipe 2.
TEST(Section, DevelopsTheFlowOfASquareDuctAndOfAPipe)
{
    auto opening = inlet();
    opening.developed = true;
    const auto largest = [](const Section& section)
    {
        Largest u;
        for (const auto& line : section.lines()) u(line.profile);
        return u.value();
    };
    const Section square(opening, squareDuct(), 1 / 15.0), fine(opening, squareDuct(), 1 / 31.0);
    EXPECT_EQ(square.lines().size(), 225u);
    EXPECT_NEAR(largest(square), 2.0963, 0.03);
    EXPECT_NEAR(largest(fine), 2.0963, 0.007);
    const Section pipe(opening, roundPipe(0.5), 1 / 15.0);
    EXPECT_NEAR(pipe.area(), std::numbers::pi / 4, 0.003);
    EXPECT_NEAR(pipe.rowSpacing() * pipe.area() / double(pipe.lines().size()), std::pow(15.0, -3), 1e-12);
    EXPECT_NEAR(largest(pipe), 2, 0.06);
}

TEST(Section, RepeatsAcrossPeriodicFaces)
{
    auto geometry = channel(1);
    geometry.walls.clear();
    geometry.originals.clear();
    geometry.periodic[1] = true;
    repeatPeriodically(geometry, 0.3);
    auto opening = inlet();
    opening.developed = true; // nothing holds it back
    const Section section(opening, geometry, 0.1);
    ASSERT_EQ(section.lines().size(), 10u);
    for (const auto& line : section.lines()) EXPECT_EQ(line.profile, 1);
    EXPECT_EQ(section.lineAt({0, 1.05, 0}), section.lineAt({0, 0.05, 0}));
}

TEST(Section, IsNothingInsideAWall)
{
    auto opening = inlet();
    opening.extent = {{-1, 1.2, -1}, {1, 1.5, 1}};
    EXPECT_TRUE(Section(opening, channel(1), 0.1).lines().empty());
}

}
}
