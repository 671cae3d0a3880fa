/// Plain double loops over all pairs, written from the equations of the headers, that planned evaluation is held against.
///
/// Sums of some dozens to a hundred pairs in another order, with reciprocals that -ffast-math may take: 1e-12 of the largest
/// value of the field, a hundred times what is measured, and far below any wrong factor, sign or missing pair.
#pragma once
#include "Largest.hpp"
#include "Scene.hpp"
#include <functional>

namespace sph::test
{

using Terms = std::vector<std::string>;

/// sum_j f(j, x_ij, r_ij, w_j W_ij, w_j gradW_ij) over owned particles and images, j = i included.
template<int dim> void overPairs(Scene<dim>& s, std::size_t i, const auto& f)
{
    const auto x_i = positionOf(s.store, i);
    const double* const w = s.store.has(ImageWeight{}) ? s.store.component("volumeFactor", 0) : nullptr;
    for (std::size_t j = 0; j < s.images.nullParticle(); ++j)
    {
        const auto x = x_i - positionOf(s.store, j);
        const double r = mag(x), w_j = w ? w[j] : 1, N = s.N.empty() ? 1 : 0.5 * (s.N[i] + s.N[j]);
        if (r < s.kernel.support()) f(j, x, r, w_j * s.kernel.W(r), w_j * s.kernel.dWdrOverR(r) / N * x);
    }
}

/// Expects these values of field F at all owned particles.
template<int dim, class F>
void expectEqual(Scene<dim>& s, F tag, const std::function<decltype(unwrap(At<F, dim>{}))(std::size_t)>& expected, double tolerance = 1e-12)
{
    Largest largest, worst;
    for (std::size_t i = 0; i < s.n; ++i)
    {
        double found[9] = {}, wanted[9] = {};
        store(s.at(tag, i), [&](int c, double q) { found[c] = q; });
        store(expected(i), [&](int c, double q) { wanted[c] = q; });
        for (int c = 0; c < 9; ++c)
        {
            largest(wanted[c]);
            worst(found[c] - wanted[c], i);
        }
    }
    EXPECT_GT(largest.value(), 0) << F::info.name << " is zero everywhere: nothing is shown";
    EXPECT_LE(worst.value(), tolerance * largest.value()) << F::info.name << ", worst at particle " << worst.at();
}

/// Periodic alone, with two plane walls of unlike tension, and with a curved wall (weights).
template<int dim> void onEveryGeometry(const std::function<void(Geometry)>& check)
{
    const auto named = [&](const char* name, Geometry g)
    {
        SCOPED_TRACE(std::string(name) + " in " + std::to_string(dim) + "-D");
        check(std::move(g));
    };
    named("periodic", periodicBox(dim));
    named("channel", channel(dim));
    named("ball", aroundABall(dim, 0.33));
}
template<int dim> Coefficients coefficients(int phases) { return firstPhases(threePhases(dim, dim == 2 ? 0.05 : 0.12, 2.6), phases); }

inline Terms with(Terms terms, const Terms& more)
{
    terms.insert(terms.end(), more.begin(), more.end());
    return terms;
}
inline const Terms summed{"numberDensity", "summedDensity", "taitOfPhase"}, integrated{"integratedVolume", "continuity", "taitOfPhase"};

/// The number of the particle that an image mirrors.
struct SourceNumber
{
    static constexpr FieldInfo info{"source", "1"};
    template<int dim, class Real = double> struct At
    {
        Real number;
    };
};

/// Fields that all momentum equations read, at every particle and image, by plain sums.
template<int dim> struct Plain
{
    Scene<dim>& s;
    std::vector<double> V, rho, p, M;

    explicit Plain(Scene<dim>& scene) : s(scene)
    {
        const auto& c = s.coefficients;
        const std::size_t all = s.images.nullParticle();
        for (auto* a : {&V, &rho, &p, &M}) a->resize(all);
        for (std::size_t i = 0; i < s.n; ++i)
        {
            double sigma = 0, moment = 0;
            overPairs(s, i,
                      [&](std::size_t, auto x, double, double W, auto gradW)
                      {
                          sigma += W;
                          moment -= dot(x, gradW) / dim;
                      });
            V[i] = 1 / (c.densityScale * sigma);
            rho[i] = s.at(Mass{}, i) / V[i];
            M[i] = moment;
            const auto k = std::size_t(s.at(Phase{}, i));
            p[i] = c.stateEquation[k].B * (std::pow(rho[i] / c.restDensity[k], c.stateEquation[k].n) - 1) + c.backgroundPressure;
        }
        // Images are sought by their source's number, carried in a field that is copied.
        s.store.allocate(SourceNumber{});
        for (std::size_t i = 0; i < s.n; ++i) s.store.component("source", 0)[i] = double(i);
        s.refresh(SourceNumber{});
        for (std::size_t j = s.n; j < all; ++j)
        {
            const auto source = std::size_t(s.at(SourceNumber{}, j));
            for (auto* a : {&V, &rho, &p, &M}) (*a)[j] = (*a)[source];
        }
        s.refresh(Velocity{});
        s.refresh(DynamicViscosity{});
        s.refresh(Phase{});
        if (!s.plan->has("gradientNormalisation")) return;
        std::vector<double> N(all);
        for (std::size_t j = 0; j < all; ++j) N[j] = M[j] * V[j];
        s.N = N;
    }
    double m(std::size_t i) { return s.at(Mass{}, i); }
    Vector<dim> v(std::size_t i) { return s.at(Velocity{}, i); }
    double mu(std::size_t i) { return s.at(DynamicViscosity{}, i); }
};

/// The acceleration of one term alone: `pair(plain, i, j, gradW, dWdrOverR)` is the force on i, without 1/m_i.
template<int dim> void acceleration(const Terms& terms, const auto& pair)
{
    SCOPED_TRACE(terms.back());
    onEveryGeometry<dim>(
        [&](Geometry g)
        {
            Scene<dim> s(std::move(g), coefficients<dim>(3), with(summed, terms));
            Plain<dim> plain(s);
            expectEqual(
                s, Acceleration{},
                [&](std::size_t i)
                {
                    Vector<dim> force;
                    overPairs(s, i,
                              [&](std::size_t j, auto x, double r, double, auto gradW)
                              {
                                  if (j != i) force += pair(plain, i, j, gradW, dot(gradW, x) / (r * r));
                              });
                    return 1 / plain.m(i) * force;
                },
                1e-11);
        });
}

/// Left as it is, and divided by the mean of both particles' second moments.
inline const Terms rawGradient{}, normalisedGradient{"gradientNormalisation"};
/// Number of the wall that each image lies behind, plus 1, by the walls' own distances; 0 on the fluid's side of all of them.
template<int dim> std::vector<int> wallsBehind(Scene<dim>& s)
{
    std::vector<int> wall(s.images.nullParticle());
    for (std::size_t j = 0; j < wall.size(); ++j)
        for (const auto& patch : s.geometry.patches)
            if (patch.shape->foot(in3D(positionOf(s.store, j))).distance < 0) wall[j] = 1 + patch.wall;
    return wall;
}

}
