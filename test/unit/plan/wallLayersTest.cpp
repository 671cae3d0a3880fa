/// What the fluid sees in walls that are layers of particles.
#include "Largest.hpp"
#include "Scene.hpp"
#include "geometry/makeWallLayers.hpp"
#include "models/suspension/PhillipsFlux.hpp"
#include "models/suspension/ShearRate.hpp"
#include "models/walls/ghostRules.hpp"

namespace sph::test
{
namespace
{

constexpr double spacing = 0.1, support = 2.6;

Coefficients oneLiquid(int dimension)
{
    auto c = firstPhases(threePhases(dimension, spacing, support), 1);
    c.of<Tensions>().ofWalls.clear();
    c.set(Suspension{0.4, 0.68, 0.66, 1.82, 0.013, 0.037, 0.5 * 0.025 * sqr(spacing)});
    return c;
}

Geometry layered(Geometry g)
{
    Diagnostics none;
    repeatPeriodically(g, 1.3 * support * spacing);
    g.layers = makeWallLayers(g, support * spacing, spacing, none);
    none.throwIfAny();
    return g;
}

/// The corner of two planes, 0 < x, y.
Geometry corner()
{
    Geometry g = domain(2, {1, 1, 0});
    addWall(g, Plane({0, 0, 0}, {1, 0, 0}));
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    return g;
}

template<int dim> void set(Scene<dim>& s, const char* field, int component, const auto& value)
{
    for (std::size_t i = 0; i < s.n; ++i) s.store.component(field, component)[i] = value(positionOf(s.store, i));
}

/// The rule of a sticking wall, in the place of the scene's -v, which knows of no distances.
template<int dim> void stick(Scene<dim>& s)
{
    s.images.rules().set(Velocity{}, std::make_unique<ReflectedVelocity<dim>>(s.geometry));
    s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
}

// The fluid sticks to the surface, not to the particles behind it: between walls at rest and in motion a linear velocity is seen without
// a kink by every particle of a disordered fluid, so that the shear rate is exact.
template<int dim> void shearIsExact()
{
    auto g = layered(channel(dim));
    g.walls[1].velocity = {0.7, 0, dim == 3 ? -0.3 : 0};
    Scene<dim> s(g, oneLiquid(dim), {"integratedVolume", "correctedGradientShear"}, true);
    EXPECT_GT(s.images.layers()->count(), 0u);
    set(s, "U", 0, [](auto x) { return 0.7 * x.y; });
    set(s, "U", 1, [](auto) { return 0; });
    if constexpr (dim == 3) set(s, "U", 2, [](auto x) { return -0.3 * x.y; });
    stick(s);
    const double shear = dim == 3 ? std::hypot(0.7, 0.3) : 0.7;
    for (std::size_t i = 0; i < s.n; ++i) EXPECT_NEAR(s.store.component("gammaDot", 0)[i], shear, 1e-11) << positionOf(s.store, i).y;
}
TEST(WallLayers, ContinueALinearShear)
{
    shearIsExact<2>();
    shearIsExact<3>();
}

// A fluid that turns with a round wall as one body does is not rubbed by it but for what curvature and disorder leave; beside a wall at rest it is.
TEST(WallLayers, LetAFluidTurnWithTheWall)
{
    Geometry around = domain(2, {2, 2, 0}, {true, true, false});
    addWall(around, Cylinder({1, 1, 0}, {0, 0, 1}, 0.5, FluidSide::outside));
    auto g = layered(around);
    g.walls[0].origin = {1, 1, 0};
    Scene<2> s(g, oneLiquid(2), {"integratedVolume", "correctedGradientShear"}, true);
    set(s, "U", 0, [](auto x) { return -2 * (x.y - 1); });
    set(s, "U", 1, [](auto x) { return 2 * (x.x - 1); });
    const auto shear = [&](double omega)
    {
        s.geometry.walls[0].omega = {0, 0, omega};
        stick(s);
        Largest most;
        for (std::size_t i = 0; i < s.n; ++i)
            if (mag(positionOf(s.store, i) - Vector<2>{1, 1}) < 0.7) most(s.store.component("gammaDot", 0)[i]);
        return most.value();
    };
    EXPECT_LT(shear(2), 0.2 * shear(0));
}

// In a corner of a lattice x y has no viscous force.
TEST(WallLayers, HaveNoForceOnAProductInACorner)
{
    const auto g = layered(corner());
    auto c = oneLiquid(2);
    c.densityScale = 1;
    Scene<2> s(g, c, {"integratedVolume", "singlePhaseViscosity"}, true);
    std::size_t i = 0; // on the lattice, where sums over neighbours are even
    for (int a = 0; a < 10; ++a)
        for (int b = 0; b < 10; ++b, ++i)
        {
            s.store.component("positions", 0)[i] = (a + 0.5) * spacing;
            s.store.component("positions", 1)[i] = (b + 0.5) * spacing;
            s.store.component("rho", 0)[i] = 1000;
            s.store.component("m", 0)[i] = 10;
        }
    ASSERT_EQ(i, s.n);
    set(s, "U", 0, [](auto x) { return x.x * x.y; });
    set(s, "U", 1, [](auto) { return 0; });
    s.images.build(s.store, s.n);
    s.lists.build(positions(s.store), s.n, s.images.nullParticle(), s.coefficients.support + 0.3 * spacing);
    s.images.listLayers(s.lists);
    s.plan->bind(s.store, s.coefficients);
    stick(s);
    const double unlike =
        c.viscosity[0] / c.restDensity[0]; // nu v/spacing^2 of one neighbour whose velocity is off by x y of the second row
    for (const double x : {0.05, 0.15, 0.25})
        for (i = 0; i < s.n; ++i)
        {
            const auto at = positionOf(s.store, i);
            if (std::abs(at.x - x) > 1e-9 || at.y > 0.6) continue;
            EXPECT_LT(mag(s.at(Acceleration{}, i)), 1e-11 * unlike) << at.y;
        }
}

// Wall particles have the pressure of the fluid at rest before them, and where it changes along the wall, that of the fluid beside them.
TEST(WallLayers, ContinueThePressure)
{
    const auto g = layered(channel(2));
    auto c = oneLiquid(2);
    Scene<2> s(g, c, {"numberDensity", "summedDensity", "tait", "huAdamsPressure"});
    const Vector<2> force = in<2>(1000 * c.g) + in<2>(c.bodyForce);
    s.images.rules().set(Pressure{}, std::make_unique<HydrostaticPressure<2>>(s.store, c));
    s.images.rules().bind();
    set(s, "rho", 0, [](auto) { return 1000; });
    set(s, "p", 0, [&](auto x) { return 50000 + force.y * x.y; });
    s.refresh(Pressure{});
    int seen = 0;
    for (std::size_t k = s.images.nullParticle() - s.images.layers()->count(); k < s.images.nullParticle(); ++k)
    {
        const auto x = positionOf(s.store, k);
        const double p = s.store.component("p", 0)[k];
        if (p == 0) continue; // out of reach of this disordered fluid
        EXPECT_NEAR(p, 50000 + force.y * x.y, 1e-9 * 50000) << x.y;
        ++seen;
    }
    EXPECT_GT(seen, 50);
}

// No powder passes the wall: what particles give and take cancels, and a fluid of uniform phi keeps it.
TEST(WallLayers, HoldThePowder)
{
    Scene<2> s(layered(aroundABall(2, 0.3)), oneLiquid(2),
               {"integratedVolume", "gradientNormalisation", "correctedGradientShear", "kriegerSlope", "phillipsFlux"}, true);
    set(s, "phi", 0, [](auto x) { return 0.4 + 0.2 * std::sin(9 * x.x) * std::cos(4 * x.y); });
    stick(s);
    const double *m = s.store.component("m", 0), *rate = s.store.component("dphidt", 0);
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < s.n; ++i)
    {
        sum += m[i] * rate[i];
        size += std::abs(m[i] * rate[i]);
    }
    EXPECT_GT(size, 0);
    EXPECT_LT(std::abs(sum), 1e-14 * size);
}

// Beside a curved wall the layers make up what is missing of the kernel: its integral over the solid, by a fine lattice. At half a spacing a row
// is 0.02 short of it, as one of a plane lattice is.
template<int dim> void kernelIsFilled()
{
    const double R = 0.45, fine = spacing / (dim == 2 ? 40 : 12);
    const auto g = layered(aroundABall(dim, R));
    const Kernel<dim> kernel("wendlandC2", support * spacing);
    const Vector<3> centre{0.5, 0.5, dim == 3 ? 0.5 : 0};
    for (const double d : {0.3, 0.5, 1.0, 1.5})
    {
        // towards the pole of the spiral, and between
        for (const double angle : {0.2, 1.3})
        {
            const auto x = centre + (R + d * spacing) * (dim == 3 ? Vector<3>{0, std::sin(angle), std::cos(angle)}
                                                                  : Vector<3>{std::cos(angle), std::sin(angle), 0});
            double sum = 0, integral = 0;
            for (const auto& p : g.layers) sum += p.volumeFactor * std::pow(spacing, dim) * kernel.W(mag(p.x - x));
            const int n = int(support * spacing / fine) + 1;
            for (int a = -n; a <= n; ++a)
                for (int b = -n; b <= n; ++b)
                    for (int c = dim == 3 ? -n : 0; c <= (dim == 3 ? n : 0); ++c)
                    {
                        const Vector<3> y{a * fine, b * fine, c * fine};
                        if (mag(x + y - centre) < R) integral += std::pow(fine, dim) * kernel.W(mag(y));
                    }
            EXPECT_NEAR(sum, integral, 0.03) << dim << " dimensions, " << d << " spacings from the wall";
        }
    }
}
TEST(WallLayers, FillTheKernel)
{
    kernelIsFilled<2>();
    kernelIsFilled<3>();
}

// Rings at depths of 0.5 and 1.5 spacings behind a pipe are all that a support of 2.3 spacings has place for; in one of 2.6 a third is missing.
TEST(WallLayers, AreAsManyAsTheSupportHasPlaceFor)
{
    Geometry g = domain(2, {1, 1, 0});
    addWall(g, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.4, FluidSide::inside));
    Diagnostics none;
    repeatPeriodically(g, support * spacing);
    g.layers = makeWallLayers(g, 2.3 * spacing, spacing, none);
    none.throwIfAny();
    const auto within = [&](double H) { WallLayers<2>(g, Kernel<2>("wendlandC2", H), H, spacing); };
    EXPECT_NO_THROW(within(2.3 * spacing));
    EXPECT_THROW(within(2.6 * spacing), CaseError);
}

// A scene of layers has no mirror images, and its periodic copies are those of the fluid and of the wall.
TEST(WallLayers, MirrorNothing)
{
    Scene<2> reflected(channel(2), oneLiquid(2), {"numberDensity"}), layers(layered(channel(2)), oneLiquid(2), {"numberDensity"});
    EXPECT_LT(layers.images.count(), reflected.images.count());
    EXPECT_EQ(reflected.images.layers(), nullptr);
    const auto copies = layers.images.layers()->count() - layers.geometry.layers.size();
    EXPECT_EQ(layers.geometry.layers.size(), 2u * 3 * 10);
    EXPECT_EQ(copies, 2u * 3 * 6) << "three columns beyond either periodic face";
}

}
}
