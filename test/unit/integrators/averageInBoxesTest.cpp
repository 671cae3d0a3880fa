/// Means over boxes keep momentum, leave what is uniform, and know nothing of their neighbours.
#include "integrators/averageInBoxes.hpp"
#include <gtest/gtest.h>
#include <vector>

namespace sph::test
{
namespace
{

TEST(AverageInBoxes, IsTheMeanByMassOfEachBox)
{
    // Boxes of 1 m: three particles in that of -1 .. 0 along x, one in that of 0 .. 1, one above it.
    std::vector<double> x{-0.9, -0.2, 0.1, -0.5, 0.1}, y{0.5, 0.5, 0.5, 0.9, 1.5}, m{1, 2, 5, 1, 3}, ux{4, 1, 7, -2, -3}, uy{0, 3, 1, 6, 9};
    averageInBoxes<2>({ux.data(), uy.data()}, {x.data(), y.data()}, m.data(), m.size(), 1);
    EXPECT_EQ(ux, (std::vector<double>{1, 1, 7, 1, -3})); // (4 + 2 - 2)/4
    EXPECT_EQ(uy, (std::vector<double>{3, 3, 1, 3, 9}));  // (0 + 6 + 6)/4
}

TEST(AverageInBoxes, LeavesWhatIsUniform)
{
    std::vector<double> x, y, z, m, u[3];
    for (int i = 0; i < 200; ++i)
    {
        x.push_back(std::sin(3.0 * i));
        y.push_back(std::sin(5.0 * i));
        z.push_back(std::cos(7.0 * i));
        m.push_back(1 + i % 3);
        for (int c = 0; c < 3; ++c) u[c].push_back(c - 1.5);
    }
    averageInBoxes<3>({u[0].data(), u[1].data(), u[2].data()}, {x.data(), y.data(), z.data()}, m.data(), m.size(), 0.3);
    for (int c = 0; c < 3; ++c)
        for (const double value : u[c]) EXPECT_NEAR(value, c - 1.5, 1e-15);
}

TEST(AverageInBoxes, SumsInTheOrderOfTheParticles)
{
    // Particles of seven boxes in turns of 1 to 40, so that a box is met again and again: to the last bit what one loop over all of them sums.
    std::vector<double> x, y, m, u, mass(7), momentum(7);
    std::vector<std::size_t> box;
    for (int turn = 0; x.size() < 5000; ++turn)
        for (int k = 0; k < 1 + turn * 7 % 40; ++k)
        {
            const int i = int(x.size());
            box.push_back(std::size_t(turn * 3 % 7));
            x.push_back(double(box.back()) + 0.5 + 0.4 * std::sin(i));
            y.push_back(0.5);
            m.push_back(1 + 0.1 * std::cos(i));
            u.push_back(std::sin(2.0 * i));
            mass[box.back()] += m.back();
            momentum[box.back()] += m.back() * u.back();
        }
    std::vector<double> v = u;
    averageInBoxes<2>({u.data(), v.data()}, {x.data(), y.data()}, m.data(), m.size(), 1);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_EQ(u[i], 1 / mass[box[i]] * momentum[box[i]]) << i;
    EXPECT_EQ(u, v);
}

}
}
