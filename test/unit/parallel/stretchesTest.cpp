/// Pieces of a loop on all threads: each round once, whoever takes it.
#include "parallel/Stretches.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

TEST(Stretches, GiveEachRoundOnce)
{
    const int before = omp_get_max_threads();
    for (const int threads : {1, 2, 3, 8})
        for (const std::size_t n : {0, 1, 7, 256, 1000})
            for (const std::size_t piece : {1, 3, 256})
            {
                omp_set_num_threads(threads);
                std::vector<std::atomic<int>> visits(n);
                Stretches stretches(n, piece);
#pragma omp parallel
                stretches.forEach(
                    [&](std::size_t begin, std::size_t end)
                    {
                        EXPECT_LE(end - begin, piece);
                        for (std::size_t i = begin; i < end; ++i) ++visits[i];
                    });
                for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(visits[i], 1) << threads << " threads, " << n << " rounds of " << piece;
            }
    omp_set_num_threads(before);
}

// Where some threads do not come their stretches are worked through by the others.
TEST(Stretches, AreLeftToNobody)
{
    const int before = omp_get_max_threads();
    omp_set_num_threads(4);
    Stretches stretches(100, 7);
    omp_set_num_threads(before);
    std::size_t rounds = 0;
    stretches.forEach([&](std::size_t begin, std::size_t end) { rounds += end - begin; });
    EXPECT_EQ(rounds, 100u);
}

}
}
