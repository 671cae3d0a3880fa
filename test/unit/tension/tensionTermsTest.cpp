/// Surface tension by stress and by curvature against plain loops.
#include "PlainSums.hpp"
#include "models/tension/phaseCurvatureTerms.hpp"

namespace sph::test
{
namespace
{

/// gradC of particle i over the neighbours that count.
template<int dim> Vector<dim> colourGradient(Scene<dim>& s, const Plain<dim>& plain, std::size_t i, auto counts)
{
    Vector<dim> gradC;
    overPairs(s, i,
              [&](std::size_t j, auto, double, double, auto gradW)
              {
                  if (counts(j)) gradC += sqr(plain.V[j]) / plain.V[i] * gradW;
              });
    return gradC;
}

/// gamma (|g| I/d - g g/|g|)
template<int dim> SymmTensor<dim> tensionOf(const Scene<dim>& s, Vector<dim> gradC, double gamma)
{
    if (mag(gradC) < 0.01 / s.coefficients.support) return {};
    return gamma * (mag(gradC) / dim * identity(gradC) - 1 / mag(gradC) * outer(gradC));
}

/// The acceleration is the divergence of the stress that the scene has, in either form.
template<int dim> void expectDivergenceOfStress(Scene<dim>& s, Plain<dim>& plain, bool weighted)
{
    s.refresh(Stress{});
    expectEqual(
        s, Acceleration{},
        [&](std::size_t i)
        {
            Vector<dim> force;
            overPairs(s, i,
                      [&](std::size_t j, auto, double, double, auto gradW)
                      {
                          const double V2_i = sqr(plain.V[i]), V2_j = sqr(plain.V[j]), rho_i = plain.rho[i], rho_j = plain.rho[j];
                          const auto S_i = s.at(Stress{}, i), S_j = s.at(Stress{}, j);
                          force +=
                              (weighted ? (V2_i + V2_j) / (rho_i + rho_j) * (rho_j * S_i + rho_i * S_j) : V2_i * S_i + V2_j * S_j) * gradW;
                      });
            return 1 / plain.m(i) * force;
        },
        1e-11);
}

/// Interface stress of one, two and three phases with the tension of each wall, and its divergence in both forms.
template<int dim> void interfaceStress(int phases, bool weighted, const Terms& first = rawGradient)
{
    SCOPED_TRACE(std::to_string(phases) + (weighted ? " phases, density-weighted" : " phases"));
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            if (phases == 1 && g.walls.empty()) return; // no interface at all
            Scene<dim> s(std::move(g), coefficients<dim>(phases),
                         with(with(summed, first),
                              {"interfaceStress", "wallTension", weighted ? "densityWeightedStressDivergence" : "stressDivergence"}));
            Plain<dim> plain(s);
            const auto& c = s.coefficients;
            const WallTension wallTension(c);
            expectEqual(s, Stress{},
                        [&](std::size_t i)
                        {
                            const int k = int(s.at(Phase{}, i));
                            SymmTensor<dim> S{};
                            for (int l = 0; l < phases; ++l)
                            {
                                if (l == k) continue;
                                const auto gradC = colourGradient(s, plain, i, [&](std::size_t j) { return int(s.at(Phase{}, j)) == l; });
                                S += tensionOf(s, gradC, tensionsOf(c).between[std::size_t(k * phases + l)]);
                            }
                            for (const auto& patch : s.geometry.patches)
                            {
                                const auto foot = patch.shape->foot(in3D(positionOf(s.store, i)));
                                if (foot.distance >= c.support) continue;
                                const auto n = in<dim>(foot.normal);
                                S += 2 * tensionsOf(c).ofWalls[std::size_t(patch.wall * phases + k)] * wallTension.marginal(foot.distance) *
                                     (identity(n) - outer(n));
                            }
                            return S;
                        });
            expectDivergenceOfStress(s, plain, weighted);
        });
}
TEST(TensionTerms, WallTensionOfOnePhase) { interfaceStress<2>(1, false); }
TEST(TensionTerms, InterfaceStressOfTwoPhasesIn2D) { interfaceStress<2>(2, false); }
TEST(TensionTerms, InterfaceStressOfTwoPhasesIn3D) { interfaceStress<3>(2, false); }
TEST(TensionTerms, InterfaceStressOfThreePhasesIn2D) { interfaceStress<2>(3, false); }
TEST(TensionTerms, InterfaceStressOfThreePhasesIn3D) { interfaceStress<3>(3, false); }
TEST(TensionTerms, InterfaceStressWithNormalisedGradient) { interfaceStress<2>(3, false, normalisedGradient); }
TEST(TensionTerms, DensityWeightedStressOfThreePhasesIn2D) { interfaceStress<2>(3, true); }
TEST(TensionTerms, DensityWeightedStressOfThreePhasesIn3D) { interfaceStress<3>(3, true); }
TEST(TensionTerms, DensityWeightedStressWithNormalisedGradient) { interfaceStress<2>(3, true, normalisedGradient); }

/// The stress that each ghost behind a plane carries is what its own sums over the fluid give: exact, by the mirror. Ghosts beyond the
/// periodic faces lack neighbours of their own and are left aside.
template<int dim> void ghostsOwnSums(Scene<dim>& s, const std::vector<int>& wall, const auto& tension, const auto& gradient)
{
    const int phases = int(s.coefficients.phases.size());
    Largest largest, worst;
    for (std::size_t j = s.n; j < s.images.nullParticle(); ++j)
    {
        const auto x = in3D(positionOf(s.store, j));
        if (wall[j] == 0 || x.x < 0 || x.x > s.geometry.high.x || (dim == 3 && (x.z < 0 || x.z > s.geometry.high.z))) continue;
        SymmTensor<dim> own{};
        for (int k = 0; k < phases; ++k)
            own += tension(gradient(j, [&](std::size_t i) { return wall[i] == 0 && int(s.at(Phase{}, i)) == k; }),
                           tensionsOf(s.coefficients).ofWalls[std::size_t((wall[j] - 1) * phases + k)]);
        const auto off = s.at(Stress{}, j) - own;
        largest(std::sqrt(doubleDot(own, own)));
        worst(std::sqrt(doubleDot(off, off)));
    }
    EXPECT_GT(largest.value(), 0);
    EXPECT_LE(worst.value(), 1e-11 * largest.value());
}

/// The solid as a phase of its own: every image behind a wall is of that phase, whatever it mirrors; and ghosts carry the solid's
/// stress.
template<int dim> void solidPhase(int phases, bool weighted, const Terms& first = rawGradient)
{
    SCOPED_TRACE(std::to_string(phases) + (weighted ? " phases, density-weighted" : " phases"));
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            if (phases == 1 && g.walls.empty()) return; // no interface at all
            Scene<dim> s(std::move(g), coefficients<dim>(phases),
                         with(with(summed, first),
                              {"solidPhaseStress", "stressOfSolid", weighted ? "densityWeightedStressDivergence" : "stressDivergence"}));
            Plain<dim> plain(s);
            const auto& c = s.coefficients;
            const auto wall = wallsBehind(s);
            const auto tension = [&](auto gradC, double gamma) { return tensionOf(s, gradC, gamma); };
            const auto gradient = [&](std::size_t i, auto counts) { return colourGradient(s, plain, i, counts); };
            const auto phase = [&](std::size_t j) { return int(s.at(Phase{}, j)); };
            const auto gammaOfWall = [&](int w, int k) { return tensionsOf(c).ofWalls[std::size_t(w * phases + k)]; };
            const int walls = int(tensionsOf(c).ofWalls.size()) / phases;
            expectEqual(s, Stress{},
                        [&](std::size_t i)
                        {
                            SymmTensor<dim> S{};
                            for (int l = 0; l < phases; ++l)
                                if (l != phase(i))
                                    S += tension(gradient(i, [&](std::size_t j) { return wall[j] == 0 && phase(j) == l; }),
                                                 tensionsOf(c).between[std::size_t(phase(i) * phases + l)]);
                            for (int w = 0; w < walls; ++w)
                                S += tension(gradient(i, [&](std::size_t j) { return wall[j] == 1 + w; }), gammaOfWall(w, phase(i)));
                            return S;
                        });
            if (!s.geometry.patches.empty())
                expectEqual(s, SolidStress{},
                            [&](std::size_t i)
                            {
                                SymmTensor<dim> S{};
                                for (int w = 0; w < walls; ++w)
                                    for (int k = 0; k < phases; ++k)
                                        S += tension(gradient(i, [&](std::size_t j) { return wall[j] == 1 + w && phase(j) == k; }),
                                                     gammaOfWall(w, k));
                                return S;
                            });
            s.refresh(Stress{});
            if (s.geometry.patches.size() == 2) ghostsOwnSums(s, wall, tension, gradient);
            expectDivergenceOfStress(s, plain, weighted);
        });
}

TEST(TensionTerms, SolidPhaseOfOneFluidIn2D) { solidPhase<2>(1, false); }
TEST(TensionTerms, SolidPhaseOfTwoFluidsIn2D) { solidPhase<2>(2, false); }
TEST(TensionTerms, SolidPhaseOfTwoFluidsIn3D) { solidPhase<3>(2, false); }
TEST(TensionTerms, SolidPhaseOfThreeFluidsIn2D) { solidPhase<2>(3, false); }
TEST(TensionTerms, SolidPhaseOfThreeFluidsIn3D) { solidPhase<3>(3, false); }
TEST(TensionTerms, SolidPhaseWithNormalisedGradient) { solidPhase<2>(3, false, normalisedGradient); }
TEST(TensionTerms, DensityWeightedStressWithASolidPhase) { solidPhase<2>(3, true, normalisedGradient); }

/// A stress -p I accelerates as the pressure p does: the density-weighted divergence is the density-weighted pressure's sibling.
template<int dim> void stressOfAPressure()
{
    onEveryGeometry<dim>(
        [](Geometry g)
        {
            Scene<dim> pressure(g, coefficients<dim>(3), with(summed, {"densityWeightedPressure"}));
            Scene<dim> stress(std::move(g), coefficients<dim>(3), with(summed, {"pressureAsStress", "densityWeightedStressDivergence"}));
            expectEqual(stress, Acceleration{}, [&](std::size_t i) { return pressure.at(Acceleration{}, i); });
        });
}
TEST(TensionTerms, DensityWeightedStressOfAPressureIsThePressureForceIn2D) { stressOfAPressure<2>(); }
TEST(TensionTerms, DensityWeightedStressOfAPressureIsThePressureForceIn3D) { stressOfAPressure<3>(); }

/// The curvature form: four sums, each from the fields of the one before, so that each is shown by itself.
template<int dim> void curvatureForm(const Terms& first, const std::string& ofJump = "curvatureForce")
{
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            Scene<dim> s(std::move(g), coefficients<dim>(2), with(with(summed, first), {ofJump, "smoothedColourGradient"}));
            Plain<dim> plain(s);
            const auto& c = s.coefficients;
            expectEqual(s, SmoothedColour{},
                        [&](std::size_t i)
                        {
                            double colour = 0;
                            overPairs(s, i,
                                      [&](std::size_t j, auto, double, double W, auto)
                                      { colour += s.at(Phase{}, j) == 0 ? plain.V[j] * W : 0; });
                            return colour;
                        });
            s.refresh(SmoothedColour{});
            expectEqual(s, ColourGradient{},
                        [&](std::size_t i)
                        {
                            Vector<dim> sum;
                            overPairs(s, i,
                                      [&](std::size_t j, auto, double, double, auto gradW)
                                      { sum += plain.V[j] * (s.at(SmoothedColour{}, j) - s.at(SmoothedColour{}, i)) * gradW; });
                            return sum;
                        });
            s.refresh(ColourGradient{});
            // kappa_i = [sum V_j (n_j - n_i) gradW] : B^-1 with B = sum V_j (x_j - x_i) gradW, over particles with a
            // normal; at most 1/spacing.
            const auto normal = [&](std::size_t j) { return 1 / mag(s.at(ColourGradient{}, j)) * s.at(ColourGradient{}, j); };
            const auto present = [&](std::size_t j) { return mag(s.at(ColourGradient{}, j)) > 0.01 / c.support; };
            expectEqual(
                s, RawCurvature{},
                [&](std::size_t i)
                {
                    SymmTensor<dim> gradient{}, B{};
                    if (!present(i)) return 0.0;
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double, double, auto gradW)
                              {
                                  if (!present(j)) return;
                                  gradient += 0.5 * plain.V[j] * twiceSymm(normal(j) - normal(i), gradW);
                                  B += -0.5 * plain.V[j] * twiceSymm(x, gradW);
                              });
                    const double kappa = determinant(B) > 0.05 ? doubleDot(gradient, adjugate(B)) / determinant(B) : 0;
                    return std::clamp(kappa, -1 / c.spacing, 1 / c.spacing);
                },
                1e-10);
            s.refresh(RawCurvature{});
            const auto weight = [&](std::size_t j) { return mag(s.at(ColourGradient{}, j)); };
            expectEqual(s, Curvature{},
                        [&](std::size_t i)
                        {
                            double kappa = 0, all = 0;
                            if (s.at(Phase{}, i) > 0 && s.at(SmoothedColour{}, i) == 0 && mag(s.at(ColourGradient{}, i)) == 0)
                                return 0.0; // nobody asks
                            overPairs(s, i,
                                      [&](std::size_t j, auto, double, double W, auto)
                                      {
                                          kappa += plain.V[j] * weight(j) * s.at(RawCurvature{}, j) * W;
                                          all += plain.V[j] * weight(j) * W;
                                      });
                            return all > 0 ? kappa / all : 0;
                        });
            s.refresh(Curvature{});
            expectEqual(
                s, Acceleration{},
                [&](std::size_t i)
                {
                    Vector<dim> force;
                    overPairs(s, i,
                              [&](std::size_t j, auto, double, double, auto gradW)
                              {
                                  if (s.at(Phase{}, j) == s.at(Phase{}, i)) return;
                                  const bool even = s.plan->has("evenCurvatureForce");
                                  const double kappa = 0.5 * (s.at(Curvature{}, i) + s.at(Curvature{}, j)),
                                               sign = s.at(Phase{}, i) == 0 ? 1 : -1;
                                  const double share = even ? 1 : 2 * plain.rho[i] / (plain.rho[i] + plain.rho[j]);
                                  force +=
                                      sign * tensionsOf(c).between[1] * kappa * share * 0.5 * (sqr(plain.V[i]) + sqr(plain.V[j])) * gradW;
                              });
                    return 1 / plain.m(i) * force;
                },
                1e-11);
        });
}
/// Three phases, each against the other two: colours and forces by plain sums, the latter from the curvatures that the terms have found; gradients and
/// curvatures are those of two phases under other names.
template<int dim> void curvatureOfThreePhases(bool even)
{
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            Settings settings;
            settings.coefficients = coefficients<dim>(3);
            const auto forces = definePhaseCurvature(settings, {.even = even});
            const auto terms = with(with(summed, rawGradient), forces);
            Scene<dim> s(std::move(g), settings.coefficients, terms, false, 1, settings.ownTerms<dim>());
            Plain<dim> plain(s);
            const auto& c = s.coefficients;
            const auto phase = [&](std::size_t i) { return int(s.at(Phase{}, i)); };
            for (int k = 0; k < 3; ++k)
            {
                const auto name = "colour." + c.phases[std::size_t(k)];
                Largest worst;
                for (std::size_t i = 0; i < s.n; ++i)
                {
                    double colour = 0;
                    overPairs(s, i, [&](std::size_t j, auto, double, double W, auto) { colour += phase(j) == k ? plain.V[j] * W : 0; });
                    worst(colour - s.at(SmoothedColour{}, name, i), i);
                }
                EXPECT_LT(worst.value(), 1e-12);
                Images<dim>::template refresh<Curvature>(s.images, s.store, "kappa." + c.phases[std::size_t(k)]);
            }
            const auto& sigma = tensionsOf(c).between; // 0.03, 0.02, 0.07: shares -0.01, 0.04, 0.03
            const double half = 0.5 * (sigma[1] + sigma[2] + sigma[5]);
            const double share[3]{half - sigma[5], half - sigma[2], half - sigma[1]};
            expectEqual(
                s, Acceleration{},
                [&](std::size_t i)
                {
                    Vector<dim> force;
                    overPairs(s, i,
                              [&](std::size_t j, auto, double, double, auto gradW)
                              {
                                  const int k = phase(i), l = phase(j);
                                  if (k == l) return;
                                  const auto kappa = [&](int of)
                                  {
                                      const auto name = "kappa." + c.phases[std::size_t(of)];
                                      return 0.5 * (s.at(Curvature{}, name, i) + s.at(Curvature{}, name, j));
                                  };
                                  const double weight = even ? 1 : 2 * plain.rho[i] / (plain.rho[i] + plain.rho[j]);
                                  force += (share[k] * kappa(k) - share[l] * kappa(l)) * weight * 0.5 *
                                           (sqr(plain.V[i]) + sqr(plain.V[j])) * gradW;
                              });
                    return 1 / plain.m(i) * force;
                },
                1e-11);
        });
}
TEST(TensionTerms, CurvatureOfThreePhasesIn2D)
{
    curvatureOfThreePhases<2>(true);
    curvatureOfThreePhases<2>(false);
}
TEST(TensionTerms, CurvatureOfThreePhasesIn3D) { curvatureOfThreePhases<3>(true); }

TEST(TensionTerms, CurvatureFormIn2D) { curvatureForm<2>(rawGradient); }
TEST(TensionTerms, CurvatureFormWithNormalisedGradientIn2D) { curvatureForm<2>(normalisedGradient); }
TEST(TensionTerms, CurvatureFormIn3D) { curvatureForm<3>(rawGradient); }
TEST(TensionTerms, CurvatureFormSharedEvenlyIn2D) { curvatureForm<2>(normalisedGradient, "evenCurvatureForce"); }
TEST(TensionTerms, CurvatureFormSharedEvenlyIn3D) { curvatureForm<3>(rawGradient, "evenCurvatureForce"); }

}

}
