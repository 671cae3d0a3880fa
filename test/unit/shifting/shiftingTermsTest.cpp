/// Shifting and the transport velocity against plain loops.
#include "PlainSums.hpp"
#include <array>
#include <numbers>

namespace sph::test
{
namespace
{

/// Acceleration that moves particles, by a pressure of 0.7 rho c^2 and by min(10 |p|, that), and the stress of what they carry with them.
template<int dim> void transportVelocity()
{
    for (const bool local : {false, true})
        onEveryGeometry<dim>(
            [&](Geometry g)
            {
                Scene<dim> s(std::move(g), coefficients<dim>(3), with(summed, {local ? "localTransportVelocity" : "transportVelocity"}));
                const Plain<dim> plain(s);
                expectEqual(s, TransportAcceleration{},
                            [&](std::size_t i)
                            {
                                Vector<dim> sum;
                                overPairs(s, i,
                                          [&](std::size_t j, auto, double, double, auto gradW)
                                          { sum += (sqr(plain.V[i]) + sqr(plain.V[j])) * gradW; });
                                const double uniform = 0.7 * plain.rho[i] * 40 * 40; // 40 m/s: the largest sound speed
                                return -(local ? std::min(uniform, 10 * std::abs(plain.p[i])) : uniform) / s.at(Mass{}, i) * sum;
                            });
            });
    acceleration<dim>({"transportStress"},
                      [](auto& q, std::size_t i, std::size_t j, auto gradW, double)
                      {
                          const auto stress = [&](std::size_t k) { return q.rho[k] * dot(q.s.at(TransportVelocity{}, k), gradW) * q.v(k); };
                          return 0.5 * (sqr(q.V[i]) + sqr(q.V[j])) * (stress(i) + stress(j));
                      });
}
TEST(ShiftingTerms, TransportVelocityIn2D) { transportVelocity<2>(); }
TEST(ShiftingTerms, TransportVelocityIn3D) { transportVelocity<3>(); }

/// Root mean square of what the stress of v = (sin kx cos ky, -cos kx sin ky) carried by w = (cos ky, sin kx)/5 is off div(v w), n to the
/// period, each particle up to `jitter` spacings off its place. div w = 0, so that div(v w) = w . grad v.
double errorOfTransportStress(int n, double jitter)
{
    auto c = firstPhases(threePhases(2, 1.0 / n, 3), 1);
    c.densityScale = 1;
    Scene<2> s(periodicBox(2), c, {"gradientNormalisation", "numberDensity", "summedDensity", "transportStress"});
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> any(-jitter, jitter);
    const double k = 2 * std::numbers::pi;
    const auto x = s.store.pointers(Position{}), v = s.store.pointers(Velocity{}), w = s.store.pointers(TransportVelocity{});
    for (int a = 0, i = 0; a < n; ++a)
        for (int b = 0; b < n; ++b, ++i)
        {
            x[0][i] = (a + 0.5 + any(random)) / n;
            x[1][i] = (b + 0.5 + any(random)) / n;
            const double kx = k * x[0][i], ky = k * x[1][i];
            v[0][i] = std::sin(kx) * std::cos(ky);
            v[1][i] = -std::cos(kx) * std::sin(ky);
            w[0][i] = 0.2 * std::cos(ky);
            w[1][i] = 0.2 * std::sin(kx);
            s.store.component("m", 0)[i] = 1000.0 / (n * n);
        }
    s.images.build(s.store, s.n);
    s.lists.build(positions(s.store), s.n, s.images.nullParticle(), c.support);
    s.plan->bind(s.store, s.coefficients);
    s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
    double sum = 0;
    for (std::size_t i = 0; i < s.n; ++i)
    {
        const auto at = positionOf(s.store, i);
        const double kx = k * at.x, ky = k * at.y, u = 0.2 * std::cos(ky), q = 0.2 * std::sin(kx);
        const Vector<2> exact{k * (u * std::cos(kx) * std::cos(ky) - q * std::sin(kx) * std::sin(ky)),
                              k * (u * std::sin(kx) * std::sin(ky) - q * std::cos(kx) * std::cos(ky))};
        const auto off = s.at(Acceleration{}, i) - exact;
        sum += dot(off, off);
    }
    return std::sqrt(sum / double(s.n));
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

// The stress is of second order on a lattice. Disorder of the same share of a spacing at any resolution leaves A sum gradW, twice as much for twice the disorder;
// disorder that falls with the square of the spacing leaves first order.
TEST(TransportVelocity, StressIsConsistentWhereParticlesLieEvenly)
{
    const double even = errorOfTransportStress(80, 0);
    EXPECT_NEAR(order(errorOfTransportStress(40, 0), even), 2, 0.1);
    EXPECT_NEAR(errorOfTransportStress(80, 0.1) / errorOfTransportStress(80, 0.05), 2, 0.1);
    EXPECT_GT(order(errorOfTransportStress(40, 0.0125), errorOfTransportStress(80, 0.0125 / 4)), 0.9);
}

/// Shifting between phases, by itself and as a surface's law finds it; whatever the sums, nothing of it points to other phases. Three phases, so that
/// some particles see two others.
template<int dim> void interfaceShifting()
{
    std::array<int, 4> kinds{}; // no other phase in sight, turned away from one, let by, at the interface
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            Scene<dim> s(std::move(g), coefficients<dim>(3), with(summed, {"interfaceShifting", "concentrationWithinPhase"}));
            Plain<dim> plain(s);
            const auto expected = [&](std::size_t i)
            {
                Vector<dim> shift, n;
                overPairs(s, i,
                          [&](std::size_t j, auto, double, double, auto gradW)
                          {
                              shift += -2 * plain.V[i] * gradW;
                              if (s.at(Phase{}, j) != s.at(Phase{}, i)) n += plain.V[j] * gradW;
                          });
                const double towards = mag(n) > 0 ? dot(shift, n) / mag(n) : 0, fade = 1 - s.coefficients.support * mag(n);
                ++kinds[mag(n) == 0 ? 0 : fade < 0 ? 3 : towards > 0 ? 1 : 2];
                EXPECT_LE(dot(s.at(ShiftDirection{}, i), n), 1e-12 * mag(shift) * mag(n)) << "particle " << i;
                if (fade < 0) return Vector<dim>{};
                return towards > 0 ? fade * (shift - towards / mag(n) * n) : fade * shift;
            };
            expectEqual<dim>(s, ShiftDirection{}, expected);
            expectEqual<dim>(s, ConcentrationSlope{}, expected);
        });
    for (const int n : kinds) EXPECT_GT(n, 20);
}
TEST(ShiftingTerms, InterfaceShiftingIn2D) { interfaceShifting<2>(); }
TEST(ShiftingTerms, InterfaceShiftingIn3D) { interfaceShifting<3>(); }

/// Particles up to 0.45 spacings off their lattice, and a drop among them whose surface is torn over two spacings: how many have come among the other phase,
/// most of what they see by weight, that were not there at the start, after 50 shifts by H^2/50 with all else at rest.
int comeAmongOthers(const std::string& term, unsigned seed)
{
    const auto c = firstPhases(threePhases(2, 1.0 / 32, 3), 2);
    Scene<2> s(periodicBox(2), c, with(summed, {term}), false, seed);
    std::mt19937_64 random(seed + 2);
    std::uniform_real_distribution<double> any(-1, 1);
    for (std::size_t i = 0; i < s.n; ++i)
    {
        s.store.component("phase", 0)[i] = mag(positionOf(s.store, i) - Vector<2>{0.5, 0.5}) < 0.3 + any(random) * c.spacing;
        for (int k = 0; k < 2; ++k) s.store.component("positions", k)[i] += 0.3 * any(random) * c.spacing;
    }
    const auto evaluate = [&]
    {
        s.images.build(s.store, s.n);
        s.lists.build(positions(s.store), s.n, s.images.nullParticle(), c.support);
        s.plan->bind(s.store, s.coefficients);
        s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
    };
    const auto amongOthers = [&]
    {
        s.refresh(Phase{});
        std::vector<bool> is(s.n);
        for (std::size_t i = 0; i < s.n; ++i)
        {
            double others = 0, all = 0;
            NeighbourLists<2>::Room room;
            for (const int j : s.lists.of(i, room))
            {
                if (std::size_t(j) == i || std::size_t(j) == s.images.nullParticle()) continue;
                const double r = mag(positionOf(s.store, i) - positionOf(s.store, std::size_t(j))), W = r < c.support ? s.kernel.W(r) : 0;
                all += W;
                if (s.at(Phase{}, std::size_t(j)) != s.at(Phase{}, i)) others += W;
            }
            is[i] = others > 0.5 * all;
        }
        return is;
    };
    evaluate();
    const auto before = amongOthers();
    for (int step = 0; step < 50; ++step)
    {
        for (std::size_t i = 0; i < s.n; ++i)
            for (int k = 0; k < 2; ++k)
            {
                double& x = s.store.component("positions", k)[i];
                x += sqr(c.support) / 50 * s.store.component("shift", k)[i];
                x -= std::floor(x);
            }
        evaluate();
    }
    const auto after = amongOthers();
    int come = 0;
    for (std::size_t i = 0; i < s.n; ++i) come += after[i] && !before[i];
    return come;
}

// Of 4096 particles: 2, whose neighbours have moved, and 17 where shifting knows no phases.
TEST(InterfaceShifting, BringsNoParticleAmongTheOtherPhase)
{
    int within = 0, any = 0;
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
        within += comeAmongOthers("interfaceShifting", seed);
        any += comeAmongOthers("particleShifting", seed);
    }
    EXPECT_LE(within, 4);
    EXPECT_GE(any, 10);
}

}
}
