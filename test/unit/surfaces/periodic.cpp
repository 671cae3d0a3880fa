#include "particles.hpp"
#include "surfaces/EnclosedVolume.hpp"
#include "surfaces/IsoSurface.hpp"
#include <gtest/gtest.h>

namespace sph::test
{

namespace
{

struct Result
{
    double area, volume;
    int pieces;
};

/// A ball of radius 6 around `centre` in a periodic cube of 24 spacings, its particles wrapped into the cube or not.
Result periodicBall(Vector<3> centre, bool wrapped)
{
    auto geometry = space(3, {0, 0, 0}, {24, 24, 24});
    geometry.periodic = {true, true, true};
    auto particles = lattice(geometry, ball({12, 12, 12}, 6));
    for (auto& x : particles.position)
    {
        x += centre - Vector<3>{12, 12, 12};
        if (wrapped) x = {x.x - 24 * std::floor(x.x / 24), x.y - 24 * std::floor(x.y / 24), x.z - 24 * std::floor(x.z / 24)};
    }
    const auto grid = gridOfDomain(geometry, step);
    const auto colour = colourFunction(grid, {}, particles, "wendlandC2", support, Normalisation::particles);
    const auto enclosed = enclosedVolume(grid, colour, 0.5, {});
    return {measure(freeSurface(grid, colour, 0.5, geometry, 0)), enclosed.volume, enclosed.pieces};
}

}

// A ball across the corner of a periodic domain has area and volume of the same ball in the middle, and is one piece. The
// surface's points are single precision in steps (1e-7 of 48), hence 1e-6 for the area.
TEST(Periodic, ABallAcrossTheCornerIsTheBallInTheMiddle)
{
    const auto middle = periodicBall({12, 12, 12}, true);
    for (const bool wrapped : {true, false})
    {
        const auto corner = periodicBall({0, 24, 0}, wrapped);
        EXPECT_NEAR(corner.area / middle.area, 1, 1e-6);
        EXPECT_NEAR(corner.volume / middle.volume, 1, 1e-12);
        EXPECT_EQ(corner.pieces, 1);
    }
}

// A support larger than the domain needs several images of each particle: a uniform lattice in a domain of 2 spacings gives a
// uniform sum, 1 to the kernel's quadrature error.
TEST(Periodic, DomainsSmallerThanTheKernelAreImagedSeveralTimes)
{
    auto geometry = space(2, {0, 0, 0}, {2, 2, 0});
    geometry.periodic = {true, true, false};
    const auto grid = gridOfDomain(geometry, 1);
    const auto colour = colourFunction(grid, {}, lattice(geometry, [](Vector<3>) { return true; }), "wendlandC2", 5, Normalisation::none);
    for (const double c : colour) EXPECT_NEAR(c, 1, 2e-3);
}

// In a large domain grids lie around what is there alone: two balls far apart, one of them across a corner of the periodic domain, have the volume and the level of
// the grid that fills the domain, node by node, and a node for each of a few hundred of its.
TEST(Periodic, GridsAroundWhatIsThereGiveWhatTheWholeGridGives)
{
    auto geometry = space(3, {0, 0, 0}, {80, 80, 80});
    geometry.periodic = {true, false, false};
    const auto inEither = [](Vector<3> x)
    {
        const double across = x.x > 40 ? x.x - 80 : x.x;
        return mag(Vector<3>{across, x.y - 10, x.z - 10}) < 4 || mag(x - Vector<3>{50, 70, 60}) < 4;
    };
    const auto particles = lattice(geometry, inEither);
    std::vector<Vector<3>> ofPhase;
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (particles.inPhase[p]) ofPhase.push_back(particles.position[p]);
    const auto enclosedOn = [&](const RegularGrid& grid)
    { return enclosedVolume(grid, colourFunction(grid, {}, particles, "wendlandC2", support, Normalisation::none), 0.5, {}); };
    const auto whole = gridOfDomain(geometry, 1);
    const auto grids = gridsAround(geometry, 1, ofPhase, support + 2);
    ASSERT_EQ(grids.size(), 2u);
    std::size_t nodes = 0;
    Enclosed parts;
    for (const auto& grid : grids)
    {
        nodes += grid.size();
        const auto part = enclosedOn(grid);
        parts.volume += part.volume;
        parts.pieces += part.pieces;
    }
    const auto all = enclosedOn(whole);
    EXPECT_NEAR(parts.volume / all.volume, 1, 1e-12);
    EXPECT_EQ(parts.pieces, 2);
    EXPECT_EQ(all.pieces, 2);
    EXPECT_LT(nodes, whole.size() / 8);
}

}
