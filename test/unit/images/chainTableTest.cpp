/// The decision table of chains, row by row: each row has a chain for which it alone decides, and the comment in chainTable names the reason.
#include "images/chainTable.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

constexpr double spacing = 0.1;

/// Patches of the tests: two planes at 60 degrees of fluid, one at 90 degrees to the first, two curved bodies, and two meshes.
enum Patches
{
    floorPlane,
    acutePlane,
    sidePlane,
    ball,
    rod,
    rock,
    stone
};
const double s60 = std::sin(std::numbers::pi / 3);
const std::vector<Reflector> reflectors{{Reflector::Kind::plane, {0, 1, 0}},
                                        {Reflector::Kind::plane, {s60, -0.5, 0}},
                                        {Reflector::Kind::plane, {1, 0, 0}},
                                        {Reflector::Kind::body},
                                        {Reflector::Kind::body},
                                        {Reflector::Kind::mesh},
                                        {Reflector::Kind::mesh}};

/// A chain of weight 1 that was mirrored in these patches in turn, with normals at 60 degrees to one another.
Chain chainOf(const std::vector<int>& patches, const Vector<3>& x = {})
{
    Chain chain{x};
    for (const int p : patches)
    {
        chain.faces[std::size_t(chain.reflections)].normal = p % 2 ? Vector<3>{s60, -0.5, 0} : Vector<3>{0, 1, 0};
        chain.mirrors[std::size_t(chain.reflections++)] = {p};
    }
    return chain;
}

ChainStep step(int patch, const std::vector<int>& before, int dim = 3) { return stepInto(patch, chainOf(before), reflectors, dim); }

TEST(ChainTable, MirrorsAParticleInEachWall)
{
    for (int p = 0; p < int(reflectors.size()); ++p) EXPECT_EQ(step(p, {}), ChainStep::newWall);
}

TEST(ChainTable, EndsAfterTheMostReflections)
{
    const std::vector<int> longest(std::size_t(mostReflections), rock), shorter(longest.begin() + 1, longest.end());
    EXPECT_EQ(step(rock, longest), ChainStep::none);
    EXPECT_EQ(step(rock, shorter), ChainStep::sameMesh);
}

TEST(ChainTable, UsesAsManyWallsAsThereAreDimensions)
{
    EXPECT_EQ(step(ball, {floorPlane, rock}, 3), ChainStep::newWall);
    EXPECT_EQ(step(ball, {floorPlane, rock}, 2), ChainStep::none);
    EXPECT_EQ(step(ball, {floorPlane, rock, rod}, 3), ChainStep::none);
}

TEST(ChainTable, GoesRoundTheEdgesOfAMesh)
{
    EXPECT_EQ(step(rock, {rock}), ChainStep::sameMesh);
    EXPECT_EQ(step(rock, {floorPlane, rock}), ChainStep::sameMesh);
}

TEST(ChainTable, DoesNotMirrorInTheSurfaceThatMadeTheImage)
{
    EXPECT_EQ(step(ball, {ball}), ChainStep::none);
    EXPECT_EQ(step(floorPlane, {floorPlane}), ChainStep::none);
}

TEST(ChainTable, MirrorsAThirdTimeInAnAcuteWedgeOfPlanes)
{
    EXPECT_EQ(step(floorPlane, {floorPlane, acutePlane}), ChainStep::thirdOfPlanes);
    EXPECT_EQ(step(acutePlane, {acutePlane, floorPlane}, 2), ChainStep::thirdOfPlanes);
}

TEST(ChainTable, MirrorsTwiceInOtherPlanes)
{
    EXPECT_EQ(step(floorPlane, {floorPlane, sidePlane}), ChainStep::none);              // at right angles
    EXPECT_EQ(step(acutePlane, {floorPlane, acutePlane, floorPlane}), ChainStep::none); // a fourth time
}

TEST(ChainTable, MirrorsOnceBetweenThreeBodies)
{
    EXPECT_EQ(step(ball, {ball, rod, rock}), ChainStep::none);
    EXPECT_EQ(step(ball, {ball, rock, stone}), ChainStep::none);
}

TEST(ChainTable, MirrorsTwoBodiesInTurn)
{
    EXPECT_EQ(step(ball, {ball, floorPlane}), ChainStep::inTurn);
    EXPECT_EQ(step(rock, {rock, stone, rock, stone}), ChainStep::inTurn);
    EXPECT_EQ(step(floorPlane, {floorPlane, ball, floorPlane, ball}, 2), ChainStep::inTurn);
}

Kept kept(const Chain& next, ChainStep how, const std::vector<Chain>& others = {}, bool fills = true)
{
    return keepsImage(next, how, others, reflectors, spacing, [&] { return fills; });
}

TEST(ChainTable, LeavesOutWhatHasNoWeight)
{
    Chain small = chainOf({ball, rod});
    small.weight = 0.5 * leastWeight;
    EXPECT_EQ(kept(small, ChainStep::newWall), Kept::negligible);
    // In one mesh the third reflection on: beside blunt edges the weight of the first two grows faster than it is foreseen.
    for (const int reflections : {1, 2, 3, 4})
    {
        Chain ofOne = chainOf(std::vector<int>(std::size_t(reflections), rock));
        ofOne.weight = 0.5 * leastWeight;
        EXPECT_EQ(kept(ofOne, ChainStep::sameMesh), reflections < 3 ? Kept::yes : Kept::negligible) << reflections;
    }
}

TEST(ChainTable, KeepsAllImagesThatGoRoundAMesh)
{
    const auto next = chainOf({rock, rock});
    EXPECT_EQ(kept(next, ChainStep::sameMesh, {next}, false), Kept::yes);
}

// Beside an edge that all but touches another wall images come back to one another without end, whatever bodies they are of.
TEST(ChainTable, EndsWhereManyImagesComeBack)
{
    std::vector<Chain> many(mostInCorners, chainOf({rock, floorPlane, rock}, {0.5, 0, 0}));
    many.front() = chainOf({});
    const std::vector<int> four{floorPlane, rock, floorPlane, rock};
    EXPECT_EQ(kept(chainOf(four, {0.02, 0, 0}), ChainStep::inTurn, many), Kept::yes) << "no more than corners have";
    many.push_back(many.back());
    EXPECT_EQ(kept(chainOf(four, {0.02, 0, 0}), ChainStep::inTurn, many), Kept::twin) << "of the particle itself";
    EXPECT_EQ(kept(chainOf(four, {0.51, 0, 0}), ChainStep::inTurn, many), Kept::twin) << "of an image of fewer reflections";
    EXPECT_EQ(kept(chainOf(four, {0.03, 0, 0}), ChainStep::inTurn, many), Kept::yes) << "more than a quarter of a spacing off";
    EXPECT_EQ(kept(chainOf({rock, rock, rock, rock}, {0.02, 0, 0}), ChainStep::sameMesh, many), Kept::twin);
}

TEST(ChainTable, LeavesOutWhatFillsNoCorner)
{
    EXPECT_EQ(kept(chainOf({ball, rod}), ChainStep::newWall, {}, false), Kept::inNeither);
    EXPECT_EQ(kept(chainOf({ball}), ChainStep::newWall, {}, false), Kept::yes); // the first image is no corner's
}

TEST(ChainTable, HasOneThirdImageAtSixtyDegrees)
{
    const auto next = chainOf({floorPlane, acutePlane, floorPlane}, {0.01, 0, 0}), other = chainOf({acutePlane, floorPlane, acutePlane});
    EXPECT_EQ(kept(next, ChainStep::thirdOfPlanes, {other}), Kept::twin);
    EXPECT_EQ(kept(next, ChainStep::thirdOfPlanes, {chainOf({acutePlane, floorPlane, acutePlane}, {1, 0, 0})}), Kept::yes);
}

TEST(ChainTable, KeepsBothOrdersInAWedgeOfBodies)
{
    EXPECT_EQ(kept(chainOf({floorPlane, ball}), ChainStep::newWall, {chainOf({ball, floorPlane})}), Kept::yes);
}

TEST(ChainTable, HasOneImageOfBothOrdersAtRightAngles)
{
    const auto other = chainOf({sidePlane, floorPlane});
    EXPECT_EQ(kept(chainOf({floorPlane, sidePlane}, {0.02, 0, 0}), ChainStep::newWall, {other}), Kept::twin);
    EXPECT_EQ(kept(chainOf({floorPlane, sidePlane}, {0.03, 0, 0}), ChainStep::newWall, {other}),
              Kept::yes);                                                                 // more than a quarter of a spacing
    EXPECT_EQ(kept(chainOf({floorPlane, ball}), ChainStep::newWall, {other}), Kept::yes); // in other walls
}

// The share of the wedge is for reflections beyond those that a corner has.
TEST(ChainTable, TellsWhichReflectionsGoOnInAWedge)
{
    const auto inTurn = chainOf({ball, floorPlane, ball, floorPlane});
    EXPECT_FALSE(goesOnInWedge(inTurn.mirrors.data(), 1, reflectors, 2));
    EXPECT_TRUE(goesOnInWedge(inTurn.mirrors.data(), 2, reflectors, 2));
    EXPECT_FALSE(goesOnInWedge(inTurn.mirrors.data(), 2, reflectors, 3));
    EXPECT_TRUE(goesOnInWedge(inTurn.mirrors.data(), 3, reflectors, 3));
    EXPECT_FALSE(goesOnInWedge(chainOf({floorPlane, acutePlane, floorPlane}).mirrors.data(), 2, reflectors, 2));
    EXPECT_FALSE(goesOnInWedge(chainOf({rock, rock, rock, rock}).mirrors.data(), 3, reflectors, 3));
}

}
}
