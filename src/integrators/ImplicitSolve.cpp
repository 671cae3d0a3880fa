#include "ImplicitSolve.hpp"
#include "DivergedError.hpp"
#include "reduce.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
struct Sums
{
    double rz = 0, rr = 0, vv = 0; ///< r.z, r.r and v_1.v_1, weighed by mass
    Sums& operator+=(const Sums& b)
    {
        rz += b.rz;
        rr += b.rr;
        vv += b.vv;
        return *this;
    }
};

/// Of the speed along walls; the relaxed packings of pipes reach 0.12 at 9 particles across and 0.04 at 19
/// (tutorials/powderMoulding/circularPipe), a lattice jittered by a tenth of a spacing 0.8.
constexpr double mostThroughWalls = 0.5;

/// Largest speed through the walls over the largest along them, of particles within a spacing of one. In a steady flow no fluid goes through walls;
/// where particles stay where they are, no pressure builds up that would see to it.
template<int dim> double shareThroughWalls(const Particles<dim>& particles)
{
    const auto x = particles.store().pointers(Position{}), v = particles.store().pointers(Velocity{});
    const auto& c = particles.coefficients();
    struct Speeds
    {
        double through = 0, along = 0;
    };
    const Larger larger;
    const auto largest = reduce(
        particles.size(), Speeds{0, 1e-9 * c.soundSpeed[0]},
        [&](std::size_t i) // round-off of a fluid at rest
        {
            Vector<dim> x_i, v_i;
            fetch(x_i, [&](int k) { return x[k][i]; });
            fetch(v_i, [&](int k) { return v[k][i]; });
            Speeds speeds;
            particles.images().forEachWallNear(x_i,
                                               [&](const Foot& foot, const Patch& patch)
                                               {
                                                   if (foot.distance > c.spacing) return;
                                                   const auto relative =
                                                       in3D(v_i) -
                                                       particles.geometry().wallVelocity(patch.wall,
                                                                                         in3D(x_i) - foot.distance * foot.normal);
                                                   const double normal = dot(relative, foot.normal);
                                                   larger(speeds.through, std::fabs(normal));
                                                   larger(speeds.along, mag(relative - normal * foot.normal));
                                               });
            return speeds;
        },
        [&](Speeds& total, const Speeds& speeds)
        {
            larger(total.through, speeds.through);
            larger(total.along, speeds.along);
        });
    return largest.through / largest.along;
}
}

template<int dim> std::vector<Stage<dim>> ImplicitSolve<dim>::stages(Place place)
{
    if (place != Place::solve) return {};
    const std::string equation = withPressure_ ? "(1 - dt L - dt^2 K) dv = dt a" : "(1 - theta dt L) dv = dt a";
    return {{"solve",
             equation + ", conjugate gradients",
             [this](Particles<dim>& p, const Substep& s)
             {
                 if (p.settings().integration.moves) solve(p, s.deltaT);
                 else solveSteady(p);
             },
             {ofSolver}}};
}

template<int dim> std::string ImplicitSolve<dim>::note() const
{
    return iterations_ > 0 ? fmt::format("  {} {} iterations", withPressure_ ? "pressure" : "viscosity", iterations_) : "";
}

template<int dim> void ImplicitSolve<dim>::solve(Particles<dim>& particles, double deltaT)
{
    conjugateGradients(particles, 1, deltaT);
    if (!withPressure_) addResidual(particles);
    else if (particles.geometry().patches.empty()) addMeanResidual(particles);
    const auto a = particles.store().pointers(Acceleration{});
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (int c = 0; c < dim; ++c) a[c][i] = change_[c][i] / deltaT;
}

template<int dim> void ImplicitSolve<dim>::addResidual(const Particles<dim>& particles)
{
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (int c = 0; c < dim; ++c) change_[c][i] += residual_[c][i];
}

template<int dim> void ImplicitSolve<dim>::addMeanResidual(const Particles<dim>& particles)
{
    const double* const m = particles.store().fields().at(Mass::info.name).component[0].data();
    const std::size_t n = particles.size();
    const double mass = sum(n, [&](std::size_t i) { return m[i]; });
    for (int c = 0; c < dim; ++c)
    {
        const double mean = sum(n, [&](std::size_t i) { return m[i] * residual_[c][i]; }) / mass;
#pragma omp parallel for simd schedule(static)
        for (std::size_t i = 0; i < n; ++i) change_[c][i] += mean;
    }
}

template<int dim> void ImplicitSolve<dim>::solveSteady(Particles<dim>& particles)
{
    conjugateGradients(particles, 0, 1 / particles.settings().integration.theta);
    const auto v = particles.store().pointers(Velocity{});
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (int c = 0; c < dim; ++c) v[c][i] += change_[c][i];
    if (const double share = shareThroughWalls(particles); share > mostThroughWalls)
        throw CaseError({"system/sphSchemes", 0},
                        fmt::format("scheme quasiSteady leaves particles where they are, and the flow beside the walls goes into them, "
                                    "with {:.2g} of its speed along them: it is driven by particles that lie unevenly, or by a force that "
                                    "only pressure could balance. Start from an even lattice, with a force along the walls, or take "
                                    "semiImplicit",
                                    share));
}

/// (inertia - theta dt L - dt^2 K) dv = dt a
template<int dim> void ImplicitSolve<dim>::conjugateGradients(Particles<dim>& particles, double inertia, double deltaT)
{
    auto& store = particles.store();
    const auto& settings = particles.settings().integration;
    const std::size_t n = particles.size();
    const double* const m = store.component("m", 0);
    const double* const lambda = viscous_ ? store.component(ViscousRate::info.name, 0) : nullptr;
    const double* const kappa = withPressure_ ? store.component(StiffRate::info.name, 0) : nullptr;
    const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{}), p = store.pointers(VelocityChange{});
    const auto Lp = viscous_ ? store.pointers(ViscousResponse{}) : decltype(v){},
               Kp = withPressure_ ? store.pointers(StiffResponse{}) : decltype(v){};
    const double implicit = settings.theta * deltaT, stiff = sqr(deltaT);
    std::array<double*, dim> dv, r;
    for (int c = 0; c < dim; ++c)
    {
        change_[c].resize(n);
        residual_[c].resize(n);
        dv[c] = change_[c].data();
        r[c] = residual_[c].data();
    }
    const auto diagonal = [=](std::size_t i) { return inertia + (lambda ? implicit * lambda[i] : 0) + (kappa ? stiff * kappa[i] : 0); };
    const auto applied = [=](int c, std::size_t i)
    { return inertia * p[c][i] - (lambda ? implicit * Lp[c][i] : 0) - (kappa ? stiff * Kp[c][i] : 0); };
    const auto sums = [&](std::size_t i)
    {
        double r2 = 0, v2 = 0;
        for (int c = 0; c < dim; ++c)
        {
            r2 += sqr(r[c][i]);
            v2 += sqr(v[c][i] + dv[c][i]);
        }
        return Sums{m[i] * r2 / diagonal(i), m[i] * r2 / (inertia > 0 ? 1 : sqr(diagonal(i))), m[i] * v2};
    };
    Sums now = sum(n,
                   [&](std::size_t i)
                   {
                       for (int c = 0; c < dim; ++c)
                       {
                           dv[c][i] = 0;
                           r[c][i] = deltaT * a[c][i];
                           p[c][i] = r[c][i] / diagonal(i);
                       }
                       return sums(i);
                   });
    const double start = now.rz;
    // Share of the residual: of the velocity, or with pressure, whose forces balance one another, of what they were before.
    const auto residual = [&] { return withPressure_ ? std::sqrt(now.rz / start) : std::sqrt(now.rr / now.vv); };
    const auto converged = [&]
    { return withPressure_ ? now.rz <= sqr(settings.tolerance) * start : now.rr <= sqr(settings.tolerance) * now.vv; };
    // Infinite forces would be within any share of themselves, and a residual within any share of infinite velocities.
    const auto finite = [&] { return std::isfinite(now.rz) && std::isfinite(now.rr) && std::isfinite(now.vv); };
    std::string history;
    for (iterations_ = 0; !finite() || !converged(); ++iterations_)
    {
        if (!finite())
            throw DivergedError(fmt::format(
                "the implicit {} has met forces or velocities that are no longer finite, after {} iterations{}. Choose a smaller step",
                withPressure_ ? "pressure" : "viscosity", iterations_, history));
        if (iterations_ == settings.maxIter)
            throw DivergedError(fmt::format(
                "the implicit {} has not converged in {} iterations: the residual is {:.3g} of the {}, the tolerance {:.3g}{}. Choose a "
                "smaller step, or a larger `maxIter` or `tolerance` in `integration`",
                withPressure_ ? "pressure" : "viscosity", iterations_, residual(), withPressure_ ? "forces" : "velocity",
                settings.tolerance, history));
        if (iterations_ > 0 && iterations_ % std::max(1, settings.maxIter / 4) == 0)
            history += fmt::format("; after {} it was {:.3g}", iterations_, residual());
        particles.evaluate(ofSolver);
        // What is held has a residual of 0 and keeps it: the others' equations remain, with a symmetric matrix.
        for (const auto& response : {Lp, Kp})
            for (double* component : response)
                if (component)
                    for (const int i : particles.held()) component[i] = 0;
        const double pAp = sum(n,
                               [&](std::size_t i)
                               {
                                   double sum = 0;
                                   for (int c = 0; c < dim; ++c) sum += p[c][i] * applied(c, i);
                                   return Sums{m[i] * sum};
                               })
                               .rz;
        const double alpha = now.rz / pAp;
        const Sums next = sum(n,
                              [&](std::size_t i)
                              {
                                  for (int c = 0; c < dim; ++c)
                                  {
                                      dv[c][i] += alpha * p[c][i];
                                      r[c][i] -= alpha * applied(c, i);
                                  }
                                  return sums(i);
                              });
        const double beta = next.rz / now.rz;
        now = next;
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < n; ++i)
            for (int c = 0; c < dim; ++c) p[c][i] = r[c][i] / diagonal(i) + beta * p[c][i];
    }
}

template<int dim> std::size_t ImplicitSolve<dim>::bytes() const
{
    std::size_t n = 0;
    for (const auto* arrays : {&change_, &residual_})
        for (const auto& array : *arrays) n += array.capacity() * sizeof(double);
    return n;
}

template class ImplicitSolve<2>;
template class ImplicitSolve<3>;

}
