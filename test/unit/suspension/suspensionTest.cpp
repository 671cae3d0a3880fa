/// Powder in a suspension: what its fluxes conserve and where they end, which shear rates are exact, and the capped viscosity.
#include "Largest.hpp"
#include "Scene.hpp"
#include "models/suspension/OfDensity.hpp"
#include "models/suspension/ShearRate.hpp"
#include "models/suspension/ViscosityFlux.hpp"
#include <functional>
#include <numbers>

namespace sph::test
{
namespace
{

/// No two numbers are alike, and D_eta/D_c c is not 1.
Coefficients suspension(int dimension, double spacing = 0.1)
{
    auto c = firstPhases(threePhases(dimension, spacing, 2.6), 1);
    c.set(Suspension{0.4, 0.68, 0.66, 1.82, 0.013, 0.037, 0.5 * 0.025 * sqr(spacing)});
    return c;
}

template<int dim> void set(Scene<dim>& s, const char* field, const std::function<double(Vector<dim>)>& value)
{
    for (std::size_t i = 0; i < s.n; ++i) s.store.component(field, 0)[i] = value(positionOf(s.store, i));
}
template<int dim> void evaluate(Scene<dim>& s) { s.plan->evaluate(s.store, s.images, s.lists, s.kernel); }

/// `of`: the fraction is that of the density, phi = rho V_phi/m, or that at rest.
template<int dim> void sumIsPlain(Geometry g, const std::string& of)
{
    // Velocities are random, so that gammaDot is; masses differ by 5 %, densities by 3 %.
    const auto c = suspension(dim);
    Scene<dim> s(g, c, {"integratedVolume", "gradientNormalisation", "correctedGradientShear", "kriegerSlope" + of, "phillipsFlux" + of},
                 true);
    set<dim>(s, "phi", [](auto x) { return 0.4 + 0.2 * std::sin(9 * x.x) * std::cos(4 * x.y); });
    evaluate(s);
    s.refresh(ShearRate{});
    s.refresh(PowderFraction{});
    s.refresh(Volume{});
    s.refresh(GradientScale{});
    s.refresh(Density{});
    std::vector<double> phi(s.images.nullParticle());
    for (std::size_t i = 0; i < phi.size(); ++i)
        phi[i] = s.store.component("phi", 0)[i] * (of.empty() ? 1 : s.store.component("rho", 0)[i] / c.restDensity[0]);
    const double *gammaDot = s.store.component("gammaDot", 0), *V = s.store.component("V", 0), *N = s.store.component("gradientScale", 0),
                 *m = s.store.component("m", 0), *rate = s.store.component("dphidt", 0);
    const auto& k = c.of<Suspension>();
    const auto B = [&](std::size_t i) { return gammaDot[i] * sqr(phi[i]) * k.exponent / (k.phiMax - std::min(phi[i], k.phiCritical)); };
    Largest largest, worst;
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < s.n; ++i)
    {
        double flux = 0;
        for (std::size_t j = 0; j < s.images.nullParticle(); ++j)
        {
            const double r = mag(positionOf(s.store, i) - positionOf(s.store, j));
            const double* wall = s.store.component("ghostWall", 0);
            if (j == i || r >= s.kernel.support() || wall[j] > 0) continue;
            const double w = -s.kernel.dWdrOverR(r) * 2 / (N[i] + N[j]);
            flux -= V[i] * V[j] * w *
                    (k.Dc_a2 * (phi[i] + phi[j]) * (phi[i] * gammaDot[i] - phi[j] * gammaDot[j]) +
                     k.Deta_a2 * (B(i) + B(j)) * (phi[i] - phi[j]));
        }
        const double expected = flux * c.restDensity[0] / m[i];
        largest(expected);
        worst(expected - rate[i]);
        sum += m[i] * rate[i];
        size += std::abs(m[i] * rate[i]);
    }
    EXPECT_GT(largest.value(), 0);
    EXPECT_LT(worst.value(), 1e-11 * largest.value());
    EXPECT_LT(std::abs(sum), 1e-14 * size) << "powder is made or lost";
}
// Plain double loop, and the conservation of sum m_i phi_i/rho_0 whatever the masses: also between walls, which nothing passes, and around a
// grain, whose ghosts weigh less than their sources.
TEST(PhillipsFlux, IsThePlainSumAndConservesPowder)
{
    for (const char* of : {"", "OfDensity"})
    {
        for (const auto& g : {periodicBox(2), channel(2), aroundABall(2, 0.25)}) sumIsPlain<2>(g, of);
        sumIsPlain<3>(channel(3), of);
    }
}

/// The terms of a step that solves for J_eta, in a channel with random velocities.
template<int dim> Scene<dim> implicitFlux(const Geometry& g, double Dc_a2)
{
    auto c = suspension(dim);
    auto numbers = c.of<Suspension>();
    numbers.Dc_a2 = Dc_a2;
    c.set(numbers);
    Scene<dim> s(g, c,
                 {"integratedVolume", "gradientNormalisation", "correctedGradientShear", "kriegerSlope", "phillipsFlux",
                  "diffusivityOfViscosity", "viscosityFluxResponse", "viscosityFluxRate"},
                 true);
    set<dim>(s, "phi", [](auto x) { return 0.4 + 0.2 * std::sin(9 * x.x) * std::cos(4 * x.y); });
    return s;
}
// K phi is PhillipsFlux without D_c; it is symmetric in the product with the masses, keeps powder, and its diagonal is what a change of one particle
// alone makes there.
template<int dim> void responseIsOfTheFlux(const Geometry& g)
{
    auto s = implicitFlux<dim>(g, 0);
    const double *phi = s.store.component("phi", 0), *m = s.store.component("m", 0), *flux = s.store.component("dphidt", 0),
                 *response = s.store.component(PowderResponse::info.name, 0), *lambda = s.store.component(PowderRelaxation::info.name, 0);
    double* const q = s.store.component(PowderChange::info.name, 0);
    const auto K = [&](const auto& of)
    {
        for (std::size_t i = 0; i < s.n; ++i) q[i] = of(i);
        evaluate(s);
        return std::vector<double>(response, response + s.n);
    };
    const auto first = [](std::size_t i) { return std::sin(0.7 * double(i)); },
               second = [](std::size_t i) { return std::cos(double(i * i)); };
    const auto Kphi = K([&](std::size_t i) { return phi[i]; }), K1 = K(first), K2 = K(second);
    const std::size_t one = s.n / 2;
    const auto alone = K([&](std::size_t i) { return double(i == one); });
    Largest largest, worst;
    double kept = 0, size = 0, a = 0, b = 0;
    for (std::size_t i = 0; i < s.n; ++i)
    {
        largest(flux[i]);
        worst(Kphi[i] - flux[i]);
        kept += m[i] * K1[i];
        size += std::abs(m[i] * K1[i]);
        a += m[i] * first(i) * K2[i];
        b += m[i] * second(i) * K1[i];
    }
    EXPECT_GT(largest.value(), 0);
    EXPECT_LT(worst.value(), 1e-12 * largest.value());
    EXPECT_LT(std::abs(kept), 1e-14 * size);
    EXPECT_NEAR(a, b, 1e-12 * size);
    EXPECT_NEAR(alone[one], -lambda[one], 1e-12 * lambda[one]);
    EXPECT_GT(lambda[one], 0);
}
TEST(ViscosityFlux, IsThatPartOfThePhillipsFluxAndSymmetric)
{
    for (const auto& g : {periodicBox(2), channel(2), aroundABall(2, 0.25)}) responseIsOfTheFlux<2>(g);
    responseIsOfTheFlux<3>(channel(3));
}

/// The largest |dphi/dt| on a lattice with phi a sine of y and phi gammaDot mu^r uniform, over that of J_c alone.
double imbalance(int rows)
{
    const double spacing = 1.0 / rows;
    const auto c = suspension(2, spacing);
    const PhillipsFlux flux(c);
    auto alone = flux;
    alone.Deta_a2 = 0;
    const Krieger krieger(c);
    const KriegerSlope slope(c);
    const Kernel<2> kernel("wendlandC2", c.support);
    std::vector<OwnValues<PhillipsFlux, 2>> row(static_cast<std::size_t>(rows));
    for (int b = 0; b < rows; ++b)
    {
        auto& q = row[std::size_t(b)];
        q.phi = 0.45 + 0.1 * std::sin(2 * std::numbers::pi * b * spacing);
        q.V = sqr(spacing);
        q.slope = slope(q);
        q.gammaDot = 1 / q.phi * std::pow(krieger(q) / c.viscosity[0], -flux.Deta_a2 / flux.Dc_a2);
    }
    Largest most, mostAlone;
    for (int i = 0; i < rows; ++i)
    {
        double both = 0, one = 0;
        for (int a = -3; a <= 3; ++a)
            for (int b = -3; b <= 3; ++b)
            {
                const Vector<2> x{a * spacing, b * spacing};
                if (mag(x) == 0 || mag(x) >= c.support) continue;
                const Pair<2> ij{x, 0, kernel.dWdrOverR(mag(x))};
                const auto& j = row[std::size_t((i - b + rows) % rows)];
                both += flux(ij, row[std::size_t(i)], j);
                one += alone(ij, row[std::size_t(i)], j);
            }
        most(both);
        mostAlone(one);
    }
    return most.value() / mostAlone.value();
}
// J_c and J_eta cancel where phi gammaDot mu^r is uniform: of each flux what is left is of second order in the spacing.
TEST(PhillipsFlux, VanishesWherePowderIsInBalance)
{
    const double coarse = imbalance(20), fine = imbalance(40);
    EXPECT_LT(fine, 0.02);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.15);
}

TEST(PhillipsFlux, IsAntisymmetricWhateverTheMasses)
{
    const PhillipsFlux flux(suspension(3));
    OwnValues<PhillipsFlux, 3> i, j;
    i.V = 2, i.phi = 0.3, i.gammaDot = 5, i.slope = 4, i.m = 7, i.wall = 0;
    j.V = 3, j.phi = 0.5, j.gammaDot = 1, j.slope = 9, j.m = 1, j.wall = 0;
    const Pair<3> ij{{0.1, 0.2, -0.1}, 0, -11}, ji{{-0.1, -0.2, 0.1}, 0, -11};
    EXPECT_EQ(flux(ij, i, j), -flux(ji, j, i));
    const double B = 5 * 0.09 * 4 + 1 * 0.25 * 9;
    EXPECT_NEAR(flux(ij, i, j), -2 * 3 * 11 * (0.013 * 0.8 * (1.5 - 0.5) + 0.037 * B * -0.2), 1e-13);
    j.wall = 1;
    EXPECT_EQ(flux(ij, i, j), 0) << "powder passes a wall";
}

/// How far gammaDot is from that of a linear velocity on jittered particles, whose ends are free.
template<int dim> double shearError(std::vector<std::string> terms)
{
    const auto c = suspension(dim);
    Geometry g = domain(dim, {1, 1, dim == 3 ? 1.0 : 0.0});
    terms.insert(terms.end(), {"integratedVolume"});
    Scene<dim> s(g, c, terms, true);
    const double L[3][3] = {{0.3, 2, -1}, {0.5, -0.2, 0.7}, {-0.4, 1.1, -0.1}};
    double DD = 0;
    for (int a = 0; a < dim; ++a)
    {
        for (int b = 0; b < dim; ++b) DD += 0.25 * sqr(L[a][b] + L[b][a]);
        set<dim>(s, "mu", [&](auto) { return 0.3; });
        for (std::size_t i = 0; i < s.n; ++i)
        {
            double x[3] = {};
            store(positionOf(s.store, i), [&](int d, double q) { x[d] = q; });
            s.store.component("U", a)[i] = L[a][0] * x[0] + L[a][1] * x[1] + (dim == 3 ? L[a][2] * x[2] : 0);
        }
    }
    evaluate(s);
    Largest worst;
    for (std::size_t i = 0; i < s.n; ++i) worst(s.store.component("gammaDot", 0)[i] / std::sqrt(2 * DD) - 1);
    return worst.value();
}
// Exact with the correction, up to the free ends of jittered particles: round-off of a hundred neighbours; the plain gradient of eq. (3.5) is not.
TEST(ShearRate, OfALinearVelocityIsExactWithTheCorrection)
{
    for (const char* term : {"resolvedShear", "correctedGradientShear"})
    {
        EXPECT_LT(shearError<2>({term}), 1e-12) << term;
        EXPECT_LT(shearError<3>({term}), 1e-12) << term;
    }
    EXPECT_GT(shearError<2>({"velocityGradientShear"}), 0.1);
}

// By hand: alpha spacing^2/2 laplacian(tau^2) is added to tau^2 and never taken away; ghosts have no share in it.
TEST(ShearRate, HasWhatTheParticlesExtentAdds)
{
    const auto c = suspension(2);
    const SubParticleShear shear(c);
    OwnValues<SubParticleShear, 2> i;
    i.tau = 3, i.mu = 0.5, i.V = 0.01, i.wall = 0;
    EXPECT_NEAR(shear.finish(i, 7), std::sqrt(9 + 0.5 * 0.025 * 0.01 * 7) / 0.5, 1e-14);
    EXPECT_EQ(shear.finish(i, -7), 6);
    NeighbourValues<SubParticleShear, 2> j;
    j.tau = 5, j.V = 0.02, j.wall = 0;
    const Pair<2> ij{{0.1, 0}, 0, -13};
    EXPECT_NEAR(shear(ij, i, j), 2 * 0.02 * 13 * (25 - 9), 1e-12);
    j.wall = 2;
    EXPECT_EQ(shear(ij, i, j), 0);
}

TEST(Krieger, IsCappedWithoutAJumpOfTheViscosityOrItsSlope)
{
    const auto c = suspension(2);
    const Krieger mu(c);
    const KriegerSlope slope(c);
    const auto at = [](double phi) { return OwnValues<Krieger, 2>{phi}; };
    EXPECT_NEAR(mu(at(0)), 0.3, 1e-15);
    EXPECT_NEAR(mu(at(0.34)), 0.3 * std::pow(2, 1.82), 1e-14);
    EXPECT_NEAR(slope(at(0.34)), 1.82 / 0.34, 1e-13);
    const double phi_c = 0.66, step = 1e-7;
    EXPECT_NEAR(mu(at(phi_c + step)) / mu(at(phi_c - step)), 1 + 2 * step * 1.82 / 0.02, 1e-9);
    EXPECT_NEAR(slope(at(phi_c + step)), slope(at(phi_c - step)), 1e-3);
    EXPECT_NEAR(mu(at(0.68)) / mu(at(phi_c)), std::exp(1.82), 1e-12) << "finite at phi_m";
    const KriegerOfDensity muOfDensity(c);
    const KriegerSlopeOfDensity slopeOfDensity(c);
    for (const double phi : {0.34, 0.66}) // 3 % denser than at rest, 800 kg/m^3: either side of phi_c
    {
        EXPECT_NEAR(muOfDensity(OwnValues<KriegerOfDensity, 2>{phi, 824}), mu(at(1.03 * phi)), 1e-10);
        EXPECT_NEAR(slopeOfDensity(OwnValues<KriegerOfDensity, 2>{phi, 824}), slope(at(1.03 * phi)), 1e-12);
    }
    for (const double phi : {0.2, 0.65, 0.67, 0.7}) // the slope is that of the viscosity, on both branches
        EXPECT_NEAR((mu(at(phi + 1e-6)) - mu(at(phi - 1e-6))) / 2e-6 / mu(at(phi)), slope(at(phi)), 1e-6 * slope(at(phi)));
}

}
}
