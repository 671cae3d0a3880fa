#include "particles.hpp"
#include "surfaces/EnclosedVolume.hpp"
#include <gtest/gtest.h>
#include <omp.h>
#include <random>

namespace sph::test
{

// Bit for bit the same colour function and volume from 1 and from 3 threads: every node sums in the order of the particles.
TEST(Determinism, ResultsDoNotDependOnTheNumberOfThreads)
{
    auto geometry = space(3, {0, 0, 0}, {12, 12, 12});
    geometry.periodic = {true, false, true};
    auto particles = lattice(geometry, ball({6, 6, 6}, 4));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> displacement(-0.3, 0.3);
    for (auto& x : particles.position) x += {displacement(random), displacement(random), displacement(random)};
    const auto grid = gridOfDomain(geometry, step);
    const int before = omp_get_max_threads();
    for (const auto normalise : {Normalisation::walls, Normalisation::particles})
    {
        omp_set_num_threads(1);
        const auto one = colourFunction(grid, {}, particles, "quinticSpline", support, normalise);
        const double oneVolume = enclosedVolume(grid, one, 0.5, {}).volume;
        omp_set_num_threads(3);
        EXPECT_EQ(colourFunction(grid, {}, particles, "quinticSpline", support, normalise), one);
        EXPECT_EQ(enclosedVolume(grid, one, 0.5, {}).volume, oneVolume);
    }
    omp_set_num_threads(before);
}

}
