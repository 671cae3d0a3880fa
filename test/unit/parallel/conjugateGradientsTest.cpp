/// Conjugate gradients: exact after as many iterations as there are unknowns, the residual at hand is that of the solution, and weights are respected.
#include "parallel/conjugateGradients.hpp"
#include "Largest.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace sph::test
{
namespace
{

constexpr std::size_t n = 12;

/// Two components, coupled: A = W^-1 S with S symmetric, so that A is symmetric in the product with the weights.
struct Chain
{
    std::array<std::vector<double>, 2> x, r, p, Ap, b;
    std::vector<double> weight = std::vector<double>(n);
    int applied = 0;
    double lowest = 0; ///< taken off the diagonal of the last unknown: 6 and more make the matrix indefinite

    Chain()
    {
        for (auto* arrays : {&x, &r, &p, &Ap, &b})
            for (auto& array : *arrays) array.resize(n);
        for (std::size_t i = 0; i < n; ++i)
        {
            weight[i] = 1 + 0.7 * double(i % 5);
            for (int c = 0; c < 2; ++c) b[std::size_t(c)][i] = r[std::size_t(c)][i] = std::sin(3.0 * double(i) + c) + 0.1 * c;
        }
    }
    double diagonal(std::size_t i) const { return (4 + 0.2 * double(i)) / weight[i]; }
    double product(const std::array<std::vector<double>, 2>& q, int c, std::size_t i) const
    {
        const auto& of = q[std::size_t(c)];
        double sum = (4 + 0.2 * double(i) - (i + 1 == n ? lowest : 0)) * of[i] + 0.5 * q[std::size_t(1 - c)][i];
        if (i > 0) sum -= of[i - 1];
        if (i + 1 < n) sum -= of[i + 1];
        return sum / weight[i];
    }
    int solve(double tolerance, int most)
    {
        double start = 0;
        return conjugateGradients(
            LinearSystem<2>{
                "a chain", n, weight.data(), {x[0].data(), x[1].data()}, {r[0].data(), r[1].data()}, {p[0].data(), p[1].data()}},
            [&](std::size_t i) { return diagonal(i); },
            [&]
            {
                ++applied;
                for (int c = 0; c < 2; ++c)
                    for (std::size_t i = 0; i < n; ++i) Ap[std::size_t(c)][i] = product(p, c, i);
            },
            [&](int c, std::size_t i) { return Ap[std::size_t(c)][i]; }, [](std::size_t) { return 1; },
            [&](const ResidualSums<int>& now, int iterations)
            {
                EXPECT_EQ(now.further, int(n));
                if (iterations == 0) start = now.rz;
                if (iterations == most) throw std::runtime_error("not converged");
                return now.rz <= tolerance * tolerance * start;
            });
    }
};

TEST(ConjugateGradients, SolveInAsManyIterationsAsThereAreUnknowns)
{
    Chain chain;
    const int iterations = chain.solve(1e-13, 2 * int(n) + 1);
    EXPECT_EQ(iterations, chain.applied);
    EXPECT_LE(iterations, 2 * int(n));
    Largest left, ofResidual;
    for (int c = 0; c < 2; ++c)
        for (std::size_t i = 0; i < n; ++i)
        {
            const double exact = chain.b[std::size_t(c)][i] - chain.product(chain.x, c, i);
            left(exact);
            ofResidual(exact - chain.r[std::size_t(c)][i]);
        }
    EXPECT_LT(left.value(), 1e-12);
    EXPECT_LT(ofResidual.value(), 1e-14);
}

// What is left is at hand at any tolerance, and whoever asks may give up.
TEST(ConjugateGradients, LeaveTheirResidualAndMayBeGivenUp)
{
    Chain chain;
    chain.solve(0.1, 100);
    Largest left, ofResidual;
    for (int c = 0; c < 2; ++c)
        for (std::size_t i = 0; i < n; ++i)
        {
            left(chain.r[std::size_t(c)][i]);
            ofResidual(chain.b[std::size_t(c)][i] - chain.product(chain.x, c, i) - chain.r[std::size_t(c)][i]);
        }
    EXPECT_GT(left.value(), 1e-3);
    EXPECT_LT(ofResidual.value(), 1e-14);
    EXPECT_THROW(Chain().solve(0, 3), std::runtime_error);
}

// Along the last unknown p.Ap is negative: the solve says so by the name it was given, in place of going uphill to what is no solution.
TEST(ConjugateGradients, RefuseAMatrixThatIsNotPositive)
{
    Chain chain;
    chain.lowest = 40;
    for (int c = 0; c < 2; ++c)
        for (std::size_t i = 0; i < n; ++i) chain.r[std::size_t(c)][i] = i + 1 == n;
    try
    {
        chain.solve(1e-13, 100);
        FAIL() << "solved for";
    }
    catch (const DivergedError& e)
    {
        EXPECT_NE(std::string(e.what()).find("a chain cannot be solved for: after 0 iterations its matrix has the product p.Ap = -"),
                  std::string::npos)
            << e.what();
    }
}
// One that shows it later is refused there.
TEST(ConjugateGradients, RefuseAMatrixThatIsNotPositiveInTheEnd)
{
    Chain chain;
    chain.lowest = 7;
    EXPECT_THROW(chain.solve(1e-13, 100), DivergedError);
    EXPECT_GT(chain.applied, 1);
}

}
}
