/// Layers of wall particles: where they lie, how much of the solid they are, and what has none.
#include "SmallFiles.hpp"
#include "base/CaseError.hpp"
#include "geometry/makeWallLayers.hpp"
#include "reading.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <set>

namespace sph::test
{
namespace
{

struct Layers
{
    Geometry geometry;
    std::vector<LayerParticle> particles;
    std::string errors;
    double volume(double cell) const
    {
        return cell * std::accumulate(particles.begin(), particles.end(), 0.0,
                                      [](double sum, const LayerParticle& p) { return sum + p.volumeFactor; });
    }
};
Layers layersOf(const std::string& text, double spacing, double support = 2.6)
{
    auto [geometry, errors] = read(text, support * spacing);
    auto diagnostics = std::make_shared<Diagnostics>();
    Layers all{geometry, makeWallLayers(geometry, support * spacing, spacing, *diagnostics), errors};
    try
    {
        diagnostics->throwIfAny();
    }
    catch (const CaseError& e)
    {
        all.errors += e.what();
    }
    return all;
}

/// Places in units of the spacing, so that none is taken twice.
std::set<std::array<long, 3>> places(const std::vector<LayerParticle>& particles, double spacing)
{
    std::set<std::array<long, 3>> all;
    for (const auto& p : particles)
        all.insert({std::lround(p.x.x / spacing * 1000), std::lround(p.x.y / spacing * 1000), std::lround(p.x.z / spacing * 1000)});
    return all;
}

// Under a block that stands on the floor, as beside it, the layers leave no hole: every place of the lattice that the fluid sees
// and is not fluid itself is taken once.
TEST(WallLayers, LeaveNoHoleWhereABlockStands)
{
    const double h = 0.05;
    const auto [g, layers, errors] =
        layersOf("dimension 2; domain { min (0 0 0); max (2 1 0); }\n"
                 "walls { floor { type plane; point (0 0 0); normal (0 1 0); } block { type box; min (0.5 0 0); max (1.5 0.5 0); "
                 "fluid outside; } }",
                 h);
    ASSERT_EQ(errors, "");
    const auto taken = places(layers, h);
    EXPECT_EQ(taken.size(), layers.size());
    for (int i = 8; i < 15; ++i)
        for (int k = -3; k < 8; ++k)
        {
            const bool solid = k < 0 || i >= 10, seen = i < 12 && k >= -2;
            const long x = std::lround((i + 0.5) * 1000), y = std::lround((k + 0.5) * 1000);
            if (!seen && solid) continue;
            EXPECT_EQ(taken.contains({x, y, 0}), solid) << i << " " << k;
        }
}

// The domain's lattice goes on behind planes, as far as the kernel reaches: three layers of support 2.6, of the fluid's volume each.
TEST(WallLayers, GoOnWithTheLatticeBehindPlanes)
{
    const auto [g, layers, errors] =
        layersOf("dimension 2; domain { min (0 0 0); max (0.5 1 0); periodic (x); }\n"
                 "walls { a { type plane; point (0 0 0); normal (0 1 0); } b { type plane; point (0 1 0); normal (0 -1 0); } }",
                 0.1);
    ASSERT_EQ(errors, "");
    EXPECT_EQ(layers.size(), 2u * 3 * 5);
    EXPECT_EQ(places(layers, 0.1).size(), layers.size());
    for (const auto& p : layers)
    {
        EXPECT_NEAR(p.volumeFactor, 1, 1e-12);
        EXPECT_EQ(p.wall, p.x.y > 0.5);
        const double row = (p.x.y + 0.25) / 0.1, column = p.x.x / 0.1 - 0.5; // the middle one of the lower layers is 0
        EXPECT_NEAR(row - std::round(row), 0, 1e-9);
        EXPECT_NEAR(column - std::round(column), 0, 1e-9);
        EXPECT_LT(std::abs(p.x.y - 0.5), 0.5 + 0.26);
    }
}

// Corners and edges of a box are filled, and nothing is there twice: (n + 6)^d - n^d particles around n^d of the fluid.
TEST(WallLayers, FillTheCornersOfABox)
{
    const auto plane = layersOf(square + "walls { tank { type box; min (0 0 0); max (1 1 0); fluid inside; } }", 0.1);
    EXPECT_EQ(plane.errors, "");
    const auto within = [](const LayerParticle& p) {
        return std::max({std::abs(p.x.x - 0.5), std::abs(p.x.y - 0.5), p.x.z != 0 ? std::abs(p.x.z - 0.5) : 0}) < 0.8;
    };
    EXPECT_EQ(std::count_if(plane.particles.begin(), plane.particles.end(), within), 16 * 16 - 10 * 10);
    EXPECT_EQ(places(plane.particles, 0.1).size(), plane.particles.size());

    const auto space =
        layersOf("dimension 3; domain { min (0 0 0); max (1 1 1); }\nwalls { tank { type box; min (0 0 0); max (1 1 1); fluid inside; } }",
                 0.125);
    EXPECT_EQ(std::count_if(space.particles.begin(), space.particles.end(),
                            [](const LayerParticle& p) {
                                return std::max({std::abs(p.x.x - 0.5), std::abs(p.x.y - 0.5), std::abs(p.x.z - 0.5)}) < 0.5 + 3 * 0.125;
                            }),
              14 * 14 * 14 - 8 * 8 * 8);
    EXPECT_EQ(places(space.particles, 0.125).size(), space.particles.size());
}

// Behind curved walls the volume of the layers is that of the solid they fill, also where a grain reaches through a periodic face.
TEST(WallLayers, OfCurvedWallsHaveTheVolumeOfTheSolid)
{
    const double h = 0.05, depth = 3 * h, pi = std::numbers::pi;
    const auto ball = layersOf(cube + "walls { grain { type sphere; centre (0.1 0.5 0.95); radius 0.3; fluid outside; } }", h);
    EXPECT_EQ(ball.errors, "");
    EXPECT_NEAR(ball.volume(h * h * h), 4 * pi / 3 * (std::pow(0.3, 3) - std::pow(0.3 - depth, 3)), 1e-12);
    for (const auto& p : ball.particles)
    {
        EXPECT_TRUE(p.x.x >= 0 && p.x.x < 1 && p.x.z >= 0 && p.x.z < 1);
        EXPECT_LT(ball.geometry.distance(p.x), 0);
        EXPECT_NEAR(p.volumeFactor, 1, 0.02);
    }

    const auto pipe = layersOf("dimension 3; domain { min (0 0 0); max (0.5 2 2); periodic (x); }\n"
                               "walls { pipe { type cylinder; point (0 1 1); axis (1 0 0); radius 0.7; fluid inside; } }",
                               h);
    EXPECT_EQ(pipe.errors, "");
    EXPECT_NEAR(pipe.volume(h * h * h), 0.5 * pi * (sqr(0.7 + depth) - sqr(0.7)), 1e-12);

    const auto disc = layersOf(square + "walls { disc { type sphere; centre (0.5 0.5 0); radius 0.2; fluid outside; } }", h);
    EXPECT_NEAR(disc.volume(h * h), pi * (sqr(0.2) - sqr(0.2 - depth)), 1e-12);

    // A box in the fluid: all but its core.
    const auto box = layersOf(square + "walls { block { type box; min (0.2 0.3 0); max (0.6 0.75 0); fluid outside; } }", h);
    EXPECT_EQ(box.errors, "");
    EXPECT_NEAR(box.volume(h * h), 0.4 * 0.45 - 0.1 * 0.15, 1e-12);
}

// Of a box that goes on far beyond the domain only what the fluid can see is filled, from its faces inwards.
TEST(WallLayers, EndBeyondTheDomain)
{
    const double h = 0.05;
    const auto step = layersOf(square + "walls { step { type box; min (-1000 -1000 0); max (0.4 0.3 0); fluid outside; } }", h);
    EXPECT_EQ(step.errors, "");
    EXPECT_EQ(places(step.particles, h).size(), step.particles.size());
    double inside = 0;
    for (const auto& p : step.particles)
    {
        EXPECT_GT(std::max(p.x.x - 0.4, p.x.y - 0.3), -0.15);
        EXPECT_NEAR(std::remainder(p.x.x - 0.4, h), std::copysign(0.5 * h, std::remainder(p.x.x - 0.4, h)), 1e-9);
        if (p.x.x > 0 && p.x.y > 0) inside += h * h * p.volumeFactor;
    }
    EXPECT_NEAR(inside, 0.4 * 0.3 - 0.25 * 0.15, 1e-12);
}

// A slanted plane has a lattice of its own: the solid between it and the depth of the layers, in the middle of the domain.
TEST(WallLayers, OfASlantedPlaneAreAsDenseAsTheFluid)
{
    const double h = 0.02;
    const auto slope = layersOf(square + "walls { slope { type plane; point (0.5 0.5 0); normal (-1 2 0); } }", h);
    EXPECT_EQ(slope.errors, "");
    double area = 0;
    for (const auto& p : slope.particles)
        if (std::abs(2 * (p.x.x - 0.5) + (p.x.y - 0.5)) / std::sqrt(5) < 0.3) area += h * h * p.volumeFactor;
    EXPECT_NEAR(area, 0.6 * 3 * h, 0.6 * 3 * h * 0.02); // a row more or less at either end
}

TEST(WallLayers, ThatCannotBeMadeAreErrorsAtTheirWall)
{
    const auto torus = layersOf(
        cube + "walls\n{\n    ring { type torus; centre (0.5 0.5 0.5); axis (0 0 1); ringRadius 0.3; tubeRadius 0.15; fluid outside; }\n}",
        0.05);
    EXPECT_NE(torus.errors.find("constant/geometry:4: there are no layers of particles behind a torus"), std::string::npos) << torus.errors;
    const auto sheet = layersOf(square + "walls { sheet { type box; min (0.2 0.3 0); max (0.6 0.4 0); fluid outside; } }", 0.05);
    EXPECT_NE(sheet.errors.find("constant/geometry:2: the box is 0.1 m thick, less than two kernel supports, 0.26 m"), std::string::npos)
        << sheet.errors;
}

// Layers that cannot be written whole leave those that were there.
TEST(WallLayers, StayWhereNewOnesCannotBeWritten)
{
    const auto folder = std::filesystem::path(testing::TempDir()) / "fullWallLayers";
    std::filesystem::create_directories(folder / "constant");
    const auto layers = [](double spacing)
    { return layersOf(square + "walls { disc { type sphere; centre (0.5 0.5 0); radius 0.2; fluid outside; } }", spacing).particles; };
    const auto first = layers(0.05), finer = layers(0.01);
    writeWallLayers(folder, first);
    {
        const SmallFiles limit(4096);
        EXPECT_THROW(writeWallLayers(folder, finer), CaseError);
    }
    Diagnostics diagnostics;
    EXPECT_EQ(readWallLayers(folder, 1, diagnostics).size(), first.size());
    EXPECT_TRUE(diagnostics.ok());
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "constant")) ++entries;
    EXPECT_EQ(entries, 2u) << "only lagrangian and uniform are there";
    writeWallLayers(folder, finer);
    EXPECT_EQ(readWallLayers(folder, 1, diagnostics).size(), finer.size());
    std::filesystem::remove_all(folder);
}

// What is written is read again, to the bit; damaged files are errors that name them.
TEST(WallLayers, SurviveWritingAndReading)
{
    const auto folder = std::filesystem::path(testing::TempDir()) / "wallLayers";
    std::filesystem::create_directories(folder / "constant");
    const auto pipe = layersOf(square + "walls { disc { type sphere; centre (0.5 0.5 0); radius 0.2; fluid outside; } }", 0.05);
    writeWallLayers(folder, pipe.particles);
    const auto reread = [&](std::size_t walls)
    {
        Diagnostics diagnostics;
        const auto again = readWallLayers(folder, walls, diagnostics);
        std::string errors;
        try
        {
            diagnostics.throwIfAny();
        }
        catch (const CaseError& e)
        {
            errors = e.what();
        }
        return std::pair{again, errors};
    };
    const auto [again, none] = reread(1);
    EXPECT_EQ(none, "");
    ASSERT_EQ(again.size(), pipe.particles.size());
    for (std::size_t i = 0; i < again.size(); ++i)
    {
        EXPECT_EQ(mag(again[i].x - pipe.particles[i].x), 0);
        EXPECT_EQ(again[i].volumeFactor, pipe.particles[i].volumeFactor);
    }
    EXPECT_NE(reread(0).second.find("constant/lagrangian/wallLayers/wall: particle 0 belongs to wall 0"), std::string::npos);
    std::filesystem::remove(folder / "constant" / "lagrangian" / "wallLayers" / "volumeFactor");
    EXPECT_NE(reread(1).second.find("constant/lagrangian/wallLayers/volumeFactor: is missing"), std::string::npos);
    removeWallLayers(folder);
    EXPECT_NE(reread(1).second.find("constant/lagrangian/wallLayers: is missing"), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "constant"));
    std::filesystem::remove_all(folder);
}

}
}
