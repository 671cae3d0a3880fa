/// Wall adhesion: which wall a particle is next to, and the direction that its interface is given.
#include "models/tension/WallAdhesion.hpp"
#include "Channel.hpp"
#include "models/tension/CurvatureForce.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

// Normal and angle of the nearest wall within 5/6 H; beyond, none. The second wall has no contact angle: 90 degrees.
template<int dim> void nearestWallOfEach()
{
    const auto points = atHeights<dim>({0.02, 0.2, 0.249, 0.251, 0.45});
    Channel<dim> channel(points, WallNormal{}, 7); // what was there before is forgotten
    channel.store.allocate(WallCosine{});
    channel.coefficients.set(WettingAngles{{0.5, 0}});
    const auto directions = [&](double support)
    {
        channel.coefficients.support = support;
        evaluateAtWalls(WallAdhesion(channel.coefficients), channel.images, channel.store, false);
        std::vector<double> up;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const auto n_w = channel.at(WallNormal{}, i);
            EXPECT_NEAR(mag(n_w), std::abs(n_w.y), 1e-15);
            EXPECT_NEAR(channel.at(WallCosine{}, i), n_w.y > 0 ? 0.5 : 0, 1e-15);
            up.push_back(n_w.y);
        }
        return up;
    };
    EXPECT_EQ(directions(H), (std::vector<double>{1, 1, 1, 1, 1, 1, -1, -1, -1, -1}));  // 5/6 H = 0.308
    EXPECT_EQ(directions(0.27), (std::vector<double>{1, 1, 1, 1, 0, 0, 0, 0, -1, -1})); // 0.225
}
TEST(WallAdhesion, TakesTheNearestWallIn2D) { nearestWallOfEach<2>(); }
TEST(WallAdhesion, TakesTheNearestWallIn3D) { nearestWallOfEach<3>(); }

// Next to a wall the gradient of colour, which points into the liquid, is turned within the plane that it spans with the normal, and keeps its length:
// a liquid of 0 degrees would lie between wall and interface, one of 180 beyond.
TEST(WallAdhesion, TurnsTheInterfaceToTheContactAngle)
{
    const AdheringColourGradient term;
    const Vector<3> n_w{0, 0.6, 0.8}, gradC{3, -2, 1};
    struct
    {
        Vector<3> n_w;
        double cosTheta;
    } at{n_w, 0};
    for (double theta : {30.0, 90.0, 150.0})
    {
        at.cosTheta = std::cos(theta * std::numbers::pi / 180);
        const auto turned = term.finish(at, gradC);
        EXPECT_NEAR(mag(turned), mag(gradC), 1e-14 * mag(gradC));
        EXPECT_NEAR(dot(turned, n_w) / mag(gradC), -at.cosTheta, 1e-14);
        EXPECT_NEAR(dot(turned, cross(gradC, n_w)), 0, 1e-13);
        EXPECT_GT(dot(turned, gradC - dot(gradC, n_w) * n_w), 0);
    }
    at.n_w = {};
    EXPECT_EQ(mag(term.finish(at, gradC) - gradC), 0);
}

// Behind a wall that turns interfaces they go straight on; elsewhere they are mirrored, as if all walls had 90 degrees.
TEST(WallAdhesion, InterfacesGoStraightOnBehindTheWall)
{
    for (const bool straight : {false, true})
    {
        Channel<2> channel({{0.5, 0.1}}, ColourGradient{}, 2);
        if (straight) channel.images.continueInterfaces();
        Images<2>::refresh<ColourGradient>(channel.images, channel.store);
        ASSERT_GE(channel.images.count(), 1u);
        const auto ghost = channel.at(ColourGradient{}, 1);
        EXPECT_EQ(ghost.x, 2);
        EXPECT_EQ(ghost.y, straight ? 2 : -2);
    }
}

}
}
