#include "models/soil/PoreWaterStep.hpp"
#include "models/soil/Seepage.hpp"
#include "models/soil/SoilFields.hpp"
#include "operators/VelocityGradient.hpp"
#include "parallel/conjugateGradients.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// Continuation of the pore pressure through a wall, q = d_g/d ratio of the distances:
///
///   p_g = p_w - q (p - p_w)                                    behind a wall that drains, at the pressure p_w
///   p_g = p - (1 + q) d (rho_w n.g - j/kappa)                  behind one that lets j [m/s] into the soil, or nothing
///
/// d [m] distance of the source, n normal into the soil. Of second order at a plane wall.
template<int dim> class ContinuedPorePressure final : public GhostRule<double, dim>
{
    const PoreWater& water_;
    const Vector<3>& g_;

public:
    ContinuedPorePressure(const PoreWater& water, const Coefficients& c) : water_(water), g_(c.g) {}
    double operator()(double p, std::size_t, const Reflection<dim>& r) const override
    {
        const auto& wall = water_.walls[std::size_t(r.wall)];
        if (wall.pressure) return *wall.pressure - r.ratio * (p - *wall.pressure);
        const double inflow = wall.flux != 0 ? wall.flux / water_.mobility() : 0;
        return p - (1 + r.ratio) * r.distance * (water_.density * dot(r.normal, in<dim>(g_)) - inflow);
    }
    double change(double dp, const Reflection<dim>& r) const override
    {
        return water_.walls[std::size_t(r.wall)].pressure ? -r.ratio * dp : dp;
    }
};

/// What conjugate gradients have no further sums for.
struct Nothing
{
    Nothing& operator+=(const Nothing&) { return *this; }
};
}

template<int dim>
PoreWaterStep<dim>::PoreWaterStep(Particles<dim>& particles, const Numbers&) : water_(particles.coefficients().template of<PoreWater>())
{
    if (!particles.geometry().patches.empty())
        particles.images().rules().set(PorePressure{}, std::make_unique<ContinuedPorePressure<dim>>(water_, particles.coefficients()));
}

template<int dim> std::vector<Stage<dim>> PoreWaterStep<dim>::stages(JoinPoint place)
{
    if (place != JoinPoint::afterKick) return {};
    return {{"pore pressure",
             "(n/K_w/dt - kappa lap - dt/rho lap') dp = -div v + kappa lap p, conjugate gradients; p += dp, v += dt a(dp)",
             [this](Particles<dim>& p, const Substep& s) { advance(p, s.deltaT); },
             {ofStrain, ofSeepage, ofSeepageChange, ofPoreForce}}};
}

template<int dim> void PoreWaterStep<dim>::advance(Particles<dim>& particles, double deltaT)
{
    particles.evaluate(ofStrain);
    particles.evaluate(ofSeepage);
    auto& store = particles.store();
    const std::size_t n = particles.size();
    const auto L = std::as_const(store).pointers(VelocityGradient{});
    const double* const lap = store.component(PoreLaplacian::info.name, 0);
    const double* const V = store.component(Volume::info.name, 0);
    double* const p = store.component(PorePressure::info.name, 0);
    const double* const alpha = store.component(SurfaceDrainage::info.name, 0);
    const double kappa = water_.mobility(), throughSurface = water_.surfaceDrains ? kappa : 0;
    change_.resize(n);
    residual_.resize(n);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
        residual_[i] = -trace(valueAt<Tensor<dim>>(L, i)) + kappa * lap[i] - throughSurface * alpha[i] * p[i];
    solve(particles, deltaT);
    // The divergence is that before the water answers, an upper bound of what the pressure does.
    const auto poreStress = store.pointers(PoreStress{});
    const double* const dp = change_.data();
    power_ = sum(n,
                 [&](std::size_t i)
                 {
                     const double divergence = trace(valueAt<Tensor<dim>>(L, i));
                     const double mean = p[i] + 0.5 * dp[i];
                     p[i] += dp[i];
                     sph::store(-dp[i] * identity(SymmTensor<dim>{}), [&](int c, double q) { poreStress[std::size_t(c)][i] = q; });
                     return V[i] * mean * divergence;
                 });
    particles.evaluate(ofPoreForce);
    const auto v = store.pointers(Velocity{});
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < dim; ++c) v[c][i] += deltaT * store.component(poreAcceleration, c)[i];
}

template<int dim> void PoreWaterStep<dim>::solve(Particles<dim>& particles, double deltaT)
{
    auto& store = particles.store();
    const std::size_t n = particles.size();
    const double storage = water_.storage() / deltaT, ofGrains = deltaT / particles.coefficients().restDensity[0];
    const double diffusivity = water_.mobility() + ofGrains, atSurface = (water_.surfaceDrains ? water_.mobility() : 0) + ofGrains;
    const double* const alpha = store.component(SurfaceDrainage::info.name, 0);
    const double* const ofOthers = store.component(SeepageDiagonal::info.name, 0);
    const double* const lap = store.component(LaplacianOfChange::info.name, 0);
    double* const direction = store.component(PorePressureChange::info.name, 0);
    const auto diagonal = [=](std::size_t i) { return storage + diffusivity * ofOthers[i] + atSurface * alpha[i]; };
    const auto applied = [=](int, std::size_t i) { return (storage + atSurface * alpha[i]) * direction[i] - diffusivity * lap[i]; };
    const auto apply = [&] { particles.evaluate(ofSeepageChange); };
    double start = 0;
    const auto done = [&](const ResidualSums<Nothing>& now, int iterations)
    {
        if (iterations == 0) start = now.rz;
        if (!std::isfinite(now.rz))
            throw DivergedError(
                fmt::format("the pore pressure is no longer finite after {} iterations. Choose a smaller step", iterations));
        if (now.rz <= sqr(water_.tolerance) * start) return true;
        if (iterations == water_.maxIter)
            throw StepTooLong(fmt::format("the pore pressure has not converged in {} iterations: the residual is {:.3g} of that at the "
                                          "start, the tolerance {:.3g}. Choose a smaller step",
                                          iterations, std::sqrt(now.rz / start), water_.tolerance));
        return false;
    };
    const LinearSystem<1> system{"the pore pressure", n,          store.component(Volume::info.name, 0), {change_.data()},
                                 {residual_.data()},  {direction}};
    iterations_ = conjugateGradients(
        system, diagonal, apply, applied, [](std::size_t) { return Nothing{}; }, done);
}

template<int dim> Numbers PoreWaterStep<dim>::columns(const Particles<dim>& particles) const
{
    if (particles.total() == 0) return {};
    const auto p = [of = particles.store().component(PorePressure::info.name, 0)](std::size_t i) { return of[i]; };
    return {{"minPorePressure", least(particles.size(), p)},
            {"maxPorePressure", most(particles.size(), p)},
            {"poreIterations", double(iterations_)}};
}

template<int dim> std::string PoreWaterStep<dim>::report(const Particles<dim>& particles) const
{
    const auto of = columns(particles);
    return of.empty() ? "" : fmt::format("pore water: {:.6g} .. {:.6g} Pa\n", of.at("minPorePressure"), of.at("maxPorePressure"));
}

template<int dim> std::string PoreWaterStep<dim>::note() const
{
    return iterations_ > 0 ? fmt::format("  pore pressure {} iterations", iterations_) : "";
}

template class PoreWaterStep<2>;
template class PoreWaterStep<3>;

}
