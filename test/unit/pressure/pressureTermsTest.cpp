/// Pressure forces and their responses against plain loops.
#include "PlainSums.hpp"

namespace sph::test
{
namespace
{

template<int dim> void pressures(const Terms& first)
{
    acceleration<dim>(with(first, {"huAdamsPressure"}), [](auto& q, std::size_t i, std::size_t j, auto gradW, double)
                      { return -(q.p[i] * sqr(q.V[i]) + q.p[j] * sqr(q.V[j])) * gradW; });
    acceleration<dim>(with(first, {"monaghanPressure"}), [](auto& q, std::size_t i, std::size_t j, auto gradW, double)
                      { return -q.V[i] * q.V[j] * (q.p[i] + q.p[j]) * gradW; });
    acceleration<dim>(with(first, {"massWeightedPressure"}), [](auto& q, std::size_t i, std::size_t j, auto gradW, double)
                      { return -q.m(i) * q.s.at(Mass{}, j) * (q.p[i] / sqr(q.rho[i]) + q.p[j] / sqr(q.rho[j])) * gradW; });
    acceleration<dim>(with(first, {"differencePressure"}), [](auto& q, std::size_t i, std::size_t j, auto gradW, double)
                      { return -q.V[i] * q.V[j] * (q.p[j] - q.p[i]) * gradW; });
    acceleration<dim>(with(first, {"densityWeightedPressure"}),
                      [](auto& q, std::size_t i, std::size_t j, auto gradW, double)
                      {
                          const double p_ij = (q.rho[j] * q.p[i] + q.rho[i] * q.p[j]) / (q.rho[i] + q.rho[j]);
                          return -(sqr(q.V[i]) + sqr(q.V[j])) * p_ij * gradW;
                      });
}
TEST(PressureTerms, PressuresIn2D) { pressures<2>(rawGradient); }
TEST(PressureTerms, PressuresWithNormalisedGradientIn2D) { pressures<2>(normalisedGradient); }
TEST(PressureTerms, PressuresIn3D) { pressures<3>(rawGradient); }
TEST(PressureTerms, PressuresWithNormalisedGradientIn3D) { pressures<3>(normalisedGradient); }

/// p_j - p_i where p_i < 0 inside the fluid: the jitter brings lambda to either side of 0.93, and p has either sign.
template<int dim> void tensileControl()
{
    acceleration<dim>({"tensileControlledPressure"},
                      [](auto& q, std::size_t i, std::size_t j, auto gradW, double)
                      {
                          const bool inverted = q.p[i] < 0 && q.s.at(LeastEigenvalue{}, i) > 0.93;
                          return -q.V[i] * q.V[j] * (inverted ? q.p[j] - q.p[i] : q.p[i] + q.p[j]) * gradW;
                      });
}
TEST(PressureTerms, TensileControlledPressureIn2D) { tensileControl<2>(); }
TEST(PressureTerms, TensileControlledPressureIn3D) { tensileControl<3>(); }

template<int dim> void pressureResponse(const Terms& first)
{
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            Scene<dim> s(std::move(g), coefficients<dim>(3),
                         with(with(summed, first), {"volumeStiffness", "repulsionOfChange", "pressureResponse", "pressureRate"}));
            Plain<dim> plain(s);
            const auto& c = s.coefficients;
            // a = V^2 dp/dsigma, by a difference of the state equation: a cube root of round-off
            const auto stiffness = [&](std::size_t i)
            {
                const auto k = std::size_t(s.at(Phase{}, i));
                const auto p = [&](double sigma)
                { return c.stateEquation[k].B * std::pow(plain.rho[i] * plain.V[i] * sigma / c.restDensity[k], c.stateEquation[k].n); };
                const double sigma = 1 / plain.V[i], change = 1e-5 * sigma;
                return sqr(plain.V[i]) * (p(sigma + change) - p(sigma - change)) / (2 * change);
            };
            expectEqual(s, VolumeStiffness{}, stiffness, 1e-8);
            s.refresh(VolumeStiffness{});
            s.refresh(Displacement{});
            const auto a = [&](std::size_t i) { return s.at(VolumeStiffness{}, i); };
            const auto u = [&](std::size_t i) { return s.at(Displacement{}, i); };
            expectEqual(
                s, CompressionChange{},
                [&](std::size_t i)
                {
                    double change = 0;
                    overPairs(s, i, [&](std::size_t j, auto, double, double, auto gradW) { change += dot(gradW, u(i) - u(j)); });
                    return a(i) * change;
                },
                1e-11);
            s.refresh(CompressionChange{});
            // the force of a pair over its distance, where it repels
            const auto repels = [&](std::size_t i, std::size_t j, auto x, double r, auto gradW)
            { return j == i ? 0 : std::max(0.0, plain.p[i] * sqr(plain.V[i]) + plain.p[j] * sqr(plain.V[j])) * -dot(gradW, x) / (r * r); };
            expectEqual(
                s, StiffResponse{},
                [&](std::size_t i)
                {
                    Vector<dim> force;
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double r, double, auto gradW)
                              {
                                  force -= (s.at(CompressionChange{}, i) + s.at(CompressionChange{}, j)) * gradW;
                                  force -= repels(i, j, x, r, gradW) * (u(i) - u(j));
                              });
                    return 1 / plain.m(i) * force;
                },
                1e-10);
            expectEqual(
                s, StiffRate{},
                [&](std::size_t i)
                {
                    Vector<dim> slope;
                    double rate = 0;
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double r, double, auto gradW)
                              {
                                  slope += gradW;
                                  rate += a(j) * dot(gradW, gradW) / dim + repels(i, j, x, r, gradW);
                              });
                    return (rate + a(i) * dot(slope, slope) / dim) / plain.m(i);
                },
                1e-10);
        });
}
TEST(PressureTerms, PressureResponseIn2D) { pressureResponse<2>(rawGradient); }
TEST(PressureTerms, PressureResponseWithNormalisedGradientIn2D) { pressureResponse<2>(normalisedGradient); }
TEST(PressureTerms, PressureResponseWithNormalisedGradientIn3D) { pressureResponse<3>(normalisedGradient); }

// The stiffness is symmetric, takes energy from every displacement, and no momentum: to round-off of sums over pairs.
TEST(PressureTerms, PressureResponseIsSymmetricPositiveAndConservesMomentum)
{
    Scene<2> s(periodicBox(2), coefficients<2>(3),
               with(with(summed, normalisedGradient), {"volumeStiffness", "repulsionOfChange", "pressureResponse"}));
    using Field = std::vector<Vector<2>>;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto response = [&](const Field& u) // M^-1 K u
    {
        for (std::size_t i = 0; i < s.n; ++i)
            for (int c = 0; c < 2; ++c) s.store.component("dU", c)[i] = c == 0 ? u[i].x : u[i].y;
        s.plan->evaluate(s.store, s.images, s.lists, s.kernel);
        Field Ku(s.n);
        for (std::size_t i = 0; i < s.n; ++i) Ku[i] = s.at(StiffResponse{}, i);
        return Ku;
    };
    const auto product = [&](const Field& u, const Field& w)
    {
        double sum = 0;
        for (std::size_t i = 0; i < s.n; ++i) sum += s.at(Mass{}, i) * dot(u[i], w[i]);
        return sum;
    };
    Field u(s.n), w(s.n);
    for (std::size_t i = 0; i < s.n; ++i) u[i] = {any(random), any(random)}, w[i] = {any(random), any(random)};
    const auto Ku = response(u), Kw = response(w);
    const double uKu = -product(u, Ku), wKu = -product(w, Ku);
    EXPECT_GT(uKu, 0);
    EXPECT_NEAR(-product(u, Kw), wKu, 1e-12 * uKu);
    Vector<2> momentum;
    double scale = 0;
    for (std::size_t i = 0; i < s.n; ++i) momentum += s.at(Mass{}, i) * Ku[i], scale += s.at(Mass{}, i) * mag(Ku[i]);
    EXPECT_LT(mag(momentum), 1e-12 * scale);
}

// Eqs. (3.1) and (3.2) of Kauzlaric et al. (2011) belong together: what pressure does to the velocities, sum m_i v_i.a_i, density takes up as energy,
// sum m_i p_i/rho_i^2 drho_i/dt, and momentum is none; whatever masses and densities are.
template<int dim> void massesKeepEnergy()
{
    Scene<dim> s(periodicBox(dim), coefficients<dim>(1), {"integratedVolume", "massContinuity", "tait", "massWeightedPressure"}, true);
    double power = 0, size = 0;
    Vector<dim> momentum;
    for (std::size_t i = 0; i < s.n; ++i)
    {
        const double m = s.at(Mass{}, i), stored = m * s.at(Pressure{}, i) / sqr(s.at(Density{}, i)) * s.at(DensityRate{}, i);
        power += m * dot(s.at(Velocity{}, i), s.at(Acceleration{}, i)) + stored;
        momentum += m * s.at(Acceleration{}, i);
        size += std::abs(stored);
    }
    EXPECT_GT(size, 0);
    EXPECT_LT(std::abs(power), 1e-13 * size);
    EXPECT_LT(mag(momentum), 1e-13 * size); // speeds are about 1 m/s
}
TEST(MassWeightedPressure, KeepsEnergyWithTheContinuityByMass)
{
    massesKeepEnergy<2>();
    massesKeepEnergy<3>();
}

template<int dim> void correctedPressure()
{
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            Scene<dim> s(std::move(g), coefficients<dim>(3), with(summed, {"correctedDifferencePressure"}));
            Plain<dim> plain(s);
            expectEqual(
                s, Acceleration{},
                [&](std::size_t i)
                {
                    SymmTensor<dim> B;
                    Vector<dim> sum;
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double r, double, auto gradW)
                              {
                                  if (j == i) return;
                                  B += -plain.V[j] * dot(gradW, x) / (r * r) * outer(x);
                                  sum += plain.V[j] * (plain.p[j] - plain.p[i]) * gradW;
                              });
                    return -plain.V[i] / plain.m(i) / determinant(B) * (adjugate(B) * sum);
                },
                1e-10);
        });
}
TEST(PressureTerms, CorrectedPressureIn2D) { correctedPressure<2>(); }
TEST(PressureTerms, CorrectedPressureIn3D) { correctedPressure<3>(); }

}
}
