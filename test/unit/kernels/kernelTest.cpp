/// Every kernel in two and three dimensions against what defines it: unit integral, slope, compact support, positivity.
#include "kernels/Kernel.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

constexpr double H = 0.37; ///< not 1: a missing power of H shows

template<int dim> void forEachKernel(const auto& check)
{
    for (const auto& name : kernelNames())
    {
        SCOPED_TRACE(name + " in " + std::to_string(dim) + "-D");
        check(Kernel<dim>(name, H));
    }
}

/// Composite Simpson over [0, b]; b is cut at sixths of H, where the splines join their polynomials.
double integral(double b, const auto& f)
{
    const int pieces = 6, n = 200;
    double sum = 0;
    for (int p = 0; p < pieces; ++p)
    {
        const double step = b / pieces / n;
        for (int k = 0; k <= n; ++k) sum += (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * f((p + double(k) / n) * b / pieces) * step / 3;
    }
    return sum;
}

template<int dim> void integratesToOne()
{
    // The integrand is a polynomial of degree at most 10 on each piece: Simpson with 200 intervals is exact to about 1e-11.
    forEachKernel<dim>(
        [](const Kernel<dim>& kernel)
        {
            const double pi = std::numbers::pi;
            const double one = integral(H, [&](double r) { return kernel.W(r) * (dim == 2 ? 2 * pi * r : 4 * pi * r * r); });
            EXPECT_NEAR(one, 1, 1e-9);
        });
}
TEST(Kernel, IntegratesToOneIn2D) { integratesToOne<2>(); }
TEST(Kernel, IntegratesToOneIn3D) { integratesToOne<3>(); }

template<int dim> void slopeIsTheDerivative()
{
    // Fourth-order central differences with a step of 1e-3 H: error below (1e-3)^4 times a fifth derivative of a few thousand
    // W_0/H^5, and at the joins of the splines, where the third or fifth derivative jumps, (1e-3)^2 times its size.
    forEachKernel<dim>(
        [](const Kernel<dim>& kernel)
        {
            const double scale = kernel.W(0) / (H * H), e = 1e-3 * H;
            for (double r = 0.01 * H; r < 0.99 * H; r += 0.00731 * H)
            {
                const double derivative =
                    (8 * (kernel.W(r + e) - kernel.W(r - e)) - (kernel.W(r + 2 * e) - kernel.W(r - 2 * e))) / (12 * e);
                EXPECT_NEAR(kernel.dWdrOverR(r), derivative / r, 2e-5 * scale * H / r) << "r/H = " << r / H;
            }
        });
}
TEST(Kernel, SlopeIsTheDerivativeIn2D) { slopeIsTheDerivative<2>(); }
TEST(Kernel, SlopeIsTheDerivativeIn3D) { slopeIsTheDerivative<3>(); }

template<int dim> void endsAtTheSupport()
{
    // Exactly 0 from H on: entries of the neighbour list beyond it, and the null particle far away, add nothing at all. H
    // itself may differ from the sum of the splines' pieces by round-off.
    forEachKernel<dim>(
        [](const Kernel<dim>& kernel)
        {
            EXPECT_EQ(kernel.support(), H);
            for (double r : {1.0000001 * H, 1.5 * H, 2 * H, 1e6 * H})
            {
                EXPECT_EQ(kernel.W(r), 0) << r;
                EXPECT_EQ(kernel.dWdrOverR(r), 0) << r;
            }
            EXPECT_NEAR(kernel.W(H), 0, 1e-30);
            EXPECT_LT(kernel.W(0.999 * H), 1e-4 * kernel.W(0));
        });
}
TEST(Kernel, EndsAtTheSupportIn2D) { endsAtTheSupport<2>(); }
TEST(Kernel, EndsAtTheSupportIn3D) { endsAtTheSupport<3>(); }

template<int dim> void fallsMonotonically()
{
    // W > 0 and dW/dr < 0 inside; the slope over r is finite at r = 0, where a particle meets itself.
    forEachKernel<dim>(
        [](const Kernel<dim>& kernel)
        {
            EXPECT_TRUE(std::isfinite(kernel.dWdrOverR(0)));
            for (double r = 0; r < 0.99 * H; r += 0.01 * H)
            {
                EXPECT_GT(kernel.W(r), 0);
                EXPECT_LT(kernel.dWdrOverR(r), 0);
            }
        });
}
TEST(Kernel, FallsMonotonicallyIn2D) { fallsMonotonically<2>(); }
TEST(Kernel, FallsMonotonicallyIn3D) { fallsMonotonically<3>(); }

// Values at the centre as printed: Wendland C2 with H = 2 h is 7/(4 pi h^2) and 21/(16 pi h^3) (Dehnen & Aly 2012, table 1),
// the cubic spline 10/(7 pi h^2) and 1/(pi h^3), the quintic with H = 3 h 66 x 7/(478 pi h^2) and 66/(120 pi h^3). Round-off.
TEST(Kernel, HasThePrintedCentreValues)
{
    const double pi = std::numbers::pi, h = 0.5 * H, third = H / 3;
    EXPECT_NEAR(Kernel<2>("wendlandC2", H).W(0) / (7 / (4 * pi * h * h)), 1, 1e-14);
    EXPECT_NEAR(Kernel<3>("wendlandC2", H).W(0) / (21 / (16 * pi * h * h * h)), 1, 1e-14);
    EXPECT_NEAR(Kernel<2>("wendlandC4", H).W(0) / (9 / (pi * H * H)), 1, 1e-14);
    EXPECT_NEAR(Kernel<3>("wendlandC6", H).W(0) / (1365 / (64 * pi * H * H * H)), 1, 1e-14);
    EXPECT_NEAR(Kernel<2>("cubicSpline", H).W(0) / (10 / (7 * pi * h * h)), 1, 1e-14);
    EXPECT_NEAR(Kernel<3>("cubicSpline", H).W(0) * pi * h * h * h, 1, 1e-14);
    EXPECT_NEAR(Kernel<2>("quinticSpline", H).W(0) / (66 * 7 / (478 * pi * third * third)), 1, 1e-14);
    EXPECT_NEAR(Kernel<3>("quinticSpline", H).W(0) / (66 / (120 * pi * third * third * third)), 1, 1e-14);
}

TEST(Kernel, OfAnUnknownNameIsABrokenInvariant) { EXPECT_THROW(Kernel<2>("gauss", H), std::invalid_argument); }

}
}
