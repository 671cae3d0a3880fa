/// Potential of walls: its energy per area, and the force on particles between plane walls.
#include "models/tension/WallPotential.hpp"
#include "Channel.hpp"
#include "Largest.hpp"
#include "geometry/SolidBox.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

/// Simpson's rule over 400 intervals.
double integral(double from, double to, const auto& f)
{
    const int n = 400;
    const double step = (to - from) / n;
    double sum = 0;
    for (int k = 0; k <= n; ++k) sum += (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * f(from + k * step);
    return sum * step / 3;
}

// A wall covered by a phase stores its tension: the integral of Phi = -int slope over the fluid's side is 1; Phi(0) = 35/(16 H); no force at
// either end. The slope is of degree 5 in d: Simpson's rule errs by about (1/400)^4.
TEST(WallPotential, StoresTheTension)
{
    Coefficients c;
    c.support = H;
    const WallPotential wall(c);
    const auto Phi = [&](double d) { return -integral(d, H, [&](double q) { return wall.slope(q, 0, 0); }); };
    EXPECT_NEAR(integral(0, H, Phi), 1, 1e-8);
    EXPECT_NEAR(Phi(0) * H, 35.0 / 16, 1e-8);
    EXPECT_EQ(wall.slope(0, 0, 0), 0);
    EXPECT_EQ(wall.slope(H, 0, 0), 0);
    EXPECT_EQ(wall.slope(1.05 * H, 0, 0), 0);
}

// The same over curved walls, per area of wall: outside a sphere and a cylinder of two supports, inside a sphere; dA(d)/dA(0) = (1 - k_1 d)(1 - k_2 d).
TEST(WallPotential, StoresTheTensionOfCurvedWalls)
{
    Coefficients c;
    c.support = H;
    const WallPotential wall(c);
    for (const auto& [k1, k2] : {std::pair(-0.5 / H, -0.5 / H), std::pair(-0.5 / H, 0.0), std::pair(0.5 / H, 0.5 / H)})
    {
        const auto potential = [&](double d) { return -integral(d, H, [&](double q) { return wall.slope(q, k1, k2); }); };
        const double stored = integral(0, H, [&](double d) { return potential(d) * (1 - k1 * d) * (1 - k2 * d); });
        EXPECT_NEAR(stored, 1, 1e-7) << k1 << ' ' << k2;
        EXPECT_EQ(wall.slope(H, k1, k2), 0);
        EXPECT_EQ(wall.slope(0, k1, k2), 0) << "what lies on the wall is pulled through it";
    }
}

// Each wall within H pulls along its normal, by the tension that it has with the particle's phase; what was there before stays.
template<int dim> void planeWallsAddUp()
{
    const auto points = atHeights<dim>({0.02, 0.1, 0.25, 0.3, 0.45});
    const double before = 3;
    Channel<dim> channel(points, Acceleration{}, before);
    auto& c = channel.coefficients;
    c.support = H;
    c.restDensity = {1000, 1.2};
    const WallPotential wall(c);
    evaluateAtWalls(wall, channel.images, channel.store, true);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const std::size_t phase = i % 2;
        const double lower = wall.slope(points[i].y, 0, 0), upper = wall.slope(Channel<dim>::height - points[i].y, 0, 0);
        const double up = (-tensionsOf(c).ofWalls[phase] * lower + tensionsOf(c).ofWalls[2 + phase] * upper) / c.restDensity[phase];
        double a[3] = {};
        store(channel.at(Acceleration{}, i), [&](int d, double q) { a[d] = q; });
        EXPECT_NEAR(a[1], before + up, 1e-13 * (1 + std::abs(up))) << "particle " << i;
        EXPECT_NE(up, 0);
        EXPECT_EQ(a[0], before);
        EXPECT_EQ(a[2], dim == 3 ? before : 0);
    }
}
TEST(WallPotential, OfPlaneWallsAddsUpIn2D) { planeWallsAddUp<2>(); }
TEST(WallPotential, OfPlaneWallsAddsUpIn3D) { planeWallsAddUp<3>(); }

// Around the corner of a box the force is the gradient of one potential of the distance: no work on a closed way through the regions of both
// faces and of the edge. Where images ended the potential, a liquid circulated for ever. Trapezoidal rule over 4000 points: 1e-6 of the pull.
TEST(WallPotential, DoesNoWorkOnAWayRoundACorner)
{
    Geometry g;
    g.dimension = 2;
    g.high = {2, 2, 0};
    g.walls.resize(1);
    g.originals = {{std::make_shared<SolidBox>(Vector<3>{-1, -1, -Box::infinity}, Vector<3>{1, 1, Box::infinity}), 0}};
    repeatPeriodically(g, 1.1 * H);
    Coefficients c;
    c.phases = {"water", "air"};
    c.set(Tensions{{}, {-0.4, 0.4}});
    c.restDensity = {1, 1};
    c.support = H;
    const int n = 4000;
    FieldStore<2> store;
    store.allocateState(Position{});
    store.allocateState(Phase{});
    store.allocate(Acceleration{});
    store.resize(n + 1);
    const auto x = store.pointers(Position{}), a = store.pointers(Acceleration{});
    std::vector<Vector<2>> way;
    for (int k = 0; k < n; ++k)
    {
        const double angle = 2 * std::numbers::pi * k / n;
        way.push_back({1.1 + 0.25 * std::cos(angle), 1.1 + 0.25 * std::sin(angle)});
        if (way.back().x < 1 && way.back().y < 1) way.back() = {1, 1};
        x[0][k] = way.back().x;
        x[1][k] = way.back().y;
        a[0][k] = a[1][k] = store.component("phase", 0)[k] = 0;
    }
    Images<2> images(g, 1.1 * H, 0.1);
    images.build(store, n);
    const auto after = store.pointers(Acceleration{});
    evaluateAtWalls(WallPotential(c), images, store, true);
    test::Largest largest;
    double work = 0;
    for (int k = 0; k < n; ++k)
    {
        const int next = (k + 1) % n;
        const Vector<2> mean{(after[0][k] + after[0][next]) / 2, (after[1][k] + after[1][next]) / 2};
        work += dot(mean, way[std::size_t(next)] - way[std::size_t(k)]);
        largest(mag(mean));
    }
    EXPECT_GT(largest.value(), 1);
    EXPECT_LT(std::abs(work), 1e-4 * largest.value());
}

}
}
