/// Tension of walls: the kernel's marginal, and the stress on particles between plane walls.
#include "models/tension/WallTension.hpp"
#include "Channel.hpp"
#include "kernels/Kernel.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

Coefficients withMarginal(Coefficients c, const std::string& kernel, int dim)
{
    c.support = H;
    c.set(KernelMarginal::of(kernel, dim, H));
    return c;
}
/// The law with the numbers that it points at.
struct Tension
{
    Coefficients coefficients;
    WallTension law{coefficients};

    Tension(const Coefficients& c, const std::string& kernel, int dim) : coefficients(withMarginal(c, kernel, dim)) {}
    Tension(const Tension&) = delete;
    double marginal(double d) const { return law.marginal(d); }
};

// The half space holds half of the kernel. w_1 is tabled at 257 places and read between them by straight lines, so that the
// trapezium over the table is the integral of marginal() itself; with W' = 0 at both ends it is that of w_1 to 1e-12. Each value is
// a midpoint sum of 400 panels: as good in 2-D; in 3-D, whose element 2 pi t has a slope at t = 0, (R/400)^2/24 2 pi W(d) too large
// with R^2 = H^2 - d^2: at most 3e-6 of the integral.
template<int dim> void marginalHoldsHalfOfTheKernel()
{
    for (const auto& name : kernelNames())
    {
        SCOPED_TRACE(name + " in " + std::to_string(dim) + "-D");
        const Tension tension({}, name, dim);
        const int n = 256;
        double half = 0;
        for (int k = 0; k <= n; ++k) half += (k == 0 || k == n ? 0.5 : 1) * tension.marginal(H * k / n) * H / n;
        EXPECT_NEAR(half, 0.5, dim == 2 ? 1e-11 : 4e-6);
        EXPECT_EQ(tension.marginal(H), 0);
        for (int k = 0; k < n; ++k) EXPECT_GE(tension.marginal(H * k / n), tension.marginal(H * (k + 1) / n)) << k;
    }
}
TEST(WallTension, MarginalHoldsHalfOfTheKernelIn2D) { marginalHoldsHalfOfTheKernel<2>(); }
TEST(WallTension, MarginalHoldsHalfOfTheKernelIn3D) { marginalHoldsHalfOfTheKernel<3>(); }

// w_1(0) of Wendland C2, with q = r/H. 2-D, W = 7/(pi H^2) (1 - q)^4 (1 + 4 q): 2 int_0^H W dr = 14/(pi H) (1/5 + 4/30) =
// 14/(3 pi H). 3-D, W = 21/(2 pi H^3) (1 - q)^4 (1 + 4 q): 2 pi int_0^H W r dr = 21/H (1/30 + 4/105) = 3/(2 H). With steps of
// h = H/400 the midpoint rule makes 7/5760 h^4 2 W'''(0) = 2.5e-11/H less of the first and h^2/24 2 pi W(0) = 5.5e-6/H more of the
// second.
TEST(WallTension, MarginalAtTheWallHasTheHandValue)
{
    EXPECT_NEAR(Tension({}, "wendlandC2", 2).marginal(0) * H, 14 / (3 * std::numbers::pi), 3e-11);
    EXPECT_NEAR(Tension({}, "wendlandC2", 3).marginal(0) * H, 1.5, 6e-6);
}

// S_w = 2 gamma w_1(d) (I - n n) of each wall within H, with the tension of that wall and of the particle's phase: along the walls
// alone, and the sum of both where both are near. Between H and the images' reach there is none. Round-off.
template<int dim> void tensionsAddUp()
{
    const auto points = atHeights<dim>({0.02, 0.1, 0.25, 0.3, 0.45});
    Channel<dim> channel(points, Stress{}, 1e9);
    const Tension tension(channel.coefficients, "wendlandC2", dim);
    evaluateAtWalls(tension.law, channel.images, channel.store, false);
    int nearBoth = 0, nearOne = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double d[] = {points[i].y, Channel<dim>::height - points[i].y};
        const std::size_t phase = i % 2;
        double along = 0;
        for (std::size_t w : {0u, 1u})
            if (d[w] < H) along += 2 * tensionsOf(channel.coefficients).ofWalls[2 * w + phase] * tension.marginal(d[w]);
        ++(d[0] < H && d[1] < H ? nearBoth : nearOne);
        Vector<dim> n;
        n.y = 1;
        const auto expected = along * (identity(n) - outer(n));
        double found[6] = {};
        store(channel.at(Stress{}, i), [&](int c, double q) { found[c] = q; });
        store(expected, [&](int c, double q) { EXPECT_NEAR(found[c], q, 1e-15) << "particle " << i << " component " << c; });
        EXPECT_NE(along, 0);
    }
    EXPECT_GT(nearBoth, 0);
    EXPECT_GT(nearOne, 0);
}
TEST(WallTension, OfPlaneWallsAddsUpIn2D) { tensionsAddUp<2>(); }
TEST(WallTension, OfPlaneWallsAddsUpIn3D) { tensionsAddUp<3>(); }

}
}
