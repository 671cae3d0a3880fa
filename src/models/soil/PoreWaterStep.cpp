#include "models/soil/PoreWaterStep.hpp"
#include "base/CaseError.hpp"
#include "models/soil/Seepage.hpp"
#include "models/soil/SoilFields.hpp"
#include "operators/BalancedGradient.hpp"
#include "operators/VelocityGradient.hpp"
#include "parallel/conjugateGradients.hpp"
#include "soilLaws/soilLaws.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// Continuation of the pore pressure through a wall, q = d_g/d ratio of the distances:
///
///   p_g = p_w - q (p - p_w)                                    behind a wall that drains, at the pressure p_w; below a level at that of water at rest
///   p_g = p - (1 + q) d (rho_w n.g - j/(k_r kappa))            behind one that lets j [m/s] into the soil, or nothing
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
        if (const auto held = heldAt(r)) return *held - r.ratio * (p - *held);
        const double inflow = wall.flux != 0 ? wall.flux / (water_.mobility() * water_.relativePermeability(p, mag(g_))) : 0;
        return p - (1 + r.ratio) * r.distance * (water_.density * dot(r.normal, in<dim>(g_)) - inflow);
    }
    double change(double dp, const Reflection<dim>& r) const override { return heldAt(r) ? -r.ratio * dp : dp; }

private:
    /// The pressure that the wall has where the particle is mirrored; none where no water stands behind it.
    std::optional<double> heldAt(const Reflection<dim>& r) const
    {
        const auto& wall = water_.walls[std::size_t(r.wall)];
        if (!wall.level) return wall.pressure;
        const double g = mag(g_), p = water_.density * (g * wall.level->now + dot(g_, r.foot));
        return p > 0 ? std::optional(p) : std::nullopt;
    }
};

/// What conjugate gradients have no further sums for.
struct Nothing
{
    Nothing& operator+=(const Nothing&) { return *this; }
};

/// Accelerations by a change of the pore pressure.
template<int dim> std::array<const double*, dim> accelerations(const FieldStore<dim>& store)
{
    std::array<const double*, dim> a;
    for (int c = 0; c < dim; ++c) a[std::size_t(c)] = store.component(poreAcceleration, c);
    return a;
}

/// Calls f with each level of water.
void forEachLevel(PoreWater& water, const auto& f)
{
    if (water.level) f(*water.level);
    for (auto& wall : water.walls)
        if (wall.level) f(*wall.level);
}
}

template<int dim>
PoreWaterStep<dim>::PoreWaterStep(Particles<dim>& particles, const Numbers& restored)
    : water_(particles.template numbersOf<PoreWater>()), g_(particles.coefficients().g)
{
    groups_ = {ofStrain, ofSeepage, ofPoreForce};
    if (water_.sumsChange()) groups_.emplace_back(ofSeepageChange);
    if (water_.projects) groups_.emplace_back(ofDivergence);
    const auto time = restored.find(levelTime);
    setLevels(time == restored.end() ? 0 : time->second);
    if (!particles.geometry().patches.empty())
        particles.images().rules().set(PorePressure{}, std::make_unique<ContinuedPorePressure<dim>>(water_, particles.coefficients()));
}

template<int dim> std::vector<Stage<dim>> PoreWaterStep<dim>::stages(JoinPoint place)
{
    const auto rise = [&](const char* name, const char* equation, double share) -> Stage<dim> {
        return {name, equation, [this, share](Particles<dim>&, const Substep& s) { setLevels(s.time + share * s.deltaT); }};
    };
    if (place == JoinPoint::beforeDrift && levelsVary_) return {rise("water level", "level(t + dt/2)", 0.5)};
    if (place == JoinPoint::atEnd && levelsVary_) return {rise("water level on", "level(t + dt)", 1)};
    if (place != JoinPoint::afterKick) return {};
    const bool drains = water_.unsaturated.has_value();
    const auto equation = fmt::format("{} dp/dt - {} dp {} = {}, conjugate gradients; p += dp, v += dt a(dp)", drains ? "C" : "n/K_w",
                                      drains ? "kappa div k_r grad" : "kappa lap",
                                      water_.projects ? "+ dt div a(dp)"
                                      : drains        ? "- dt/rho div chi grad dp"
                                                      : "- dt/rho lap' dp",
                                      drains ? "-chi div v + kappa div k_r (grad p - rho_w g)" : "-div v + kappa div (grad p - rho_w g)");
    return {{"pore pressure", equation, [this](Particles<dim>& p, const Substep& s) { advance(p, s.deltaT); }, groups_}};
}

template<int dim> void PoreWaterStep<dim>::checkYield(double deltaT) const
{
    if (!water_.unsaturated) return;
    const double head = water_.density * mag(g_) * water_.unsaturated->capillaryHead;
    const double least = leastYield * water_.mobility() * deltaT * head / sqr(water_.lattice.spacing);
    if (head > 0 && water_.unsaturated->specificYield < least)
        throw CaseError(
            {soilProperties, 0},
            fmt::format("specificYield {:.3g} of `unsaturated` is so small that in a step of {:.3g} s the water table would leap to "
                        "and fro. Choose {:.2g} or more, which comes to the same steady state; a smaller permeability or capillaryHead "
                        "allows less",
                        water_.unsaturated->specificYield, deltaT, least));
}

template<int dim> void PoreWaterStep<dim>::advance(Particles<dim>& particles, double deltaT)
{
    checkYield(deltaT);
    particles.evaluate(ofStrain);
    particles.evaluate(ofSeepage);
    auto& store = particles.store();
    const std::size_t n = particles.size();
    const auto L = std::as_const(store).pointers(VelocityGradient{});
    const double* const lap = store.component(PoreLaplacian::info.name, 0);
    const double* const V = store.component(Volume::info.name, 0);
    double* const p = store.component(PorePressure::info.name, 0);
    const auto x = std::as_const(store).pointers(Position{});
    const double* const out = store.component(SurfaceOutflow::info.name, 0);
    const double* const target = store.component(SurfaceTarget::info.name, 0);
    const double kappa = water_.mobility();
    change_.resize(n);
    residual_.resize(n);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
        residual_[i] = -water_.acts(p[i]) * trace(valueAt<Tensor<dim>>(L, i)) + kappa * (lap[i] - out[i] * (p[i] - target[i]));
    solve(particles, deltaT);
    const double* const dp = change_.data();
    accelerate(particles, [&](std::size_t i) { return water_.acts(p[i] + dp[i]) * (p[i] + dp[i]) - water_.acts(p[i]) * p[i]; });
    // The divergence is that before the water answers, an upper bound of what the pressure does.
    const auto v = store.pointers(Velocity{});
    const OuterWater standing(particles.coefficients());
    power_ =
        sum(n,
            [&](std::size_t i)
            {
                const double divergence = trace(valueAt<Tensor<dim>>(L, i));
                const double mean = p[i] + 0.5 * dp[i], acts = water_.acts(p[i]);
                p[i] += dp[i];
                return V[i] * (acts * mean * divergence - dot(standing.gradient(valueAt<Vector<dim>>(x, i)), valueAt<Vector<dim>>(v, i)));
            });
    outflow_ = kappa * sum(n, [&](std::size_t i) { return V[i] * out[i] * (p[i] - target[i]); });
    const auto a = accelerations(store);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < dim; ++c) v[c][i] += deltaT * a[c][i];
}

template<int dim> void PoreWaterStep<dim>::accelerate(Particles<dim>& particles, const auto& change)
{
    const auto S = particles.store().pointers(PoreStress{});
    const std::size_t n = particles.size();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) store(-change(i) * identity(SymmTensor<dim>{}), [&](int c, double q) { S[std::size_t(c)][i] = q; });
    particles.evaluate(ofPoreForce);
}

template<int dim> void PoreWaterStep<dim>::solve(Particles<dim>& particles, double deltaT)
{
    auto& store = particles.store();
    const std::size_t n = particles.size();
    const double kappa = water_.mobility(), ofGrains = deltaT / particles.coefficients().restDensity[0], g = mag(g_);
    const double* const p = store.component(PorePressure::info.name, 0);
    const double* const alpha = store.component(SurfaceDrainage::info.name, 0);
    const double* const out = store.component(SurfaceOutflow::info.name, 0);
    const double* const flow = water_.sumsChange() ? store.component(LaplacianOfChange::info.name, 0) : nullptr;
    const double* const flowDiagonal = store.component(SeepageDiagonal::info.name, 0);
    const double* const grains = water_.projects ? nullptr : water_.unsaturated ? store.component(GrainsOfChange::info.name, 0) : flow;
    const double* const grainDiagonal = water_.unsaturated ? store.component(GrainDiagonal::info.name, 0) : flowDiagonal;
    if (!water_.sumsChange()) direction_.resize(n);
    double* const direction = water_.sumsChange() ? store.component(PorePressureChange::info.name, 0) : direction_.data();
    const double* const divergence = water_.projects ? store.component(DivergenceOfChange::info.name, 0) : nullptr;
    const auto own = [=, this](std::size_t i) { return water_.capacity(p[i], g) / deltaT + kappa * out[i]; };
    const auto diagonal = [=](std::size_t i) { return own(i) + kappa * flowDiagonal[i] + ofGrains * (alpha[i] + grainDiagonal[i]); };
    const auto applied = [=, this](int, std::size_t i)
    {
        const double giveWay = divergence ? water_.acts(p[i]) * divergence[i] : ofGrains * (alpha[i] * direction[i] - grains[i]);
        return own(i) * direction[i] - (flow ? kappa * flow[i] : 0) + giveWay;
    };
    const auto apply = [&]
    {
        if (divergence) project(particles, deltaT, direction);
        if (flow) particles.evaluate(ofSeepageChange);
    };
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

template<int dim> void PoreWaterStep<dim>::project(Particles<dim>& particles, double deltaT, const double* change)
{
    auto& store = particles.store();
    const double* const p = store.component(PorePressure::info.name, 0);
    accelerate(particles, [&](std::size_t i) { return water_.acts(p[i]) * change[i]; });
    const std::size_t n = particles.size();
    const auto a = accelerations(store);
    const auto dv = store.pointers(VelocityChange{});
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < dim; ++c) dv[c][i] = deltaT * a[c][i];
    particles.evaluate(ofDivergence);
}

template<int dim> void PoreWaterStep<dim>::setLevels(double t)
{
    levelTime_ = t;
    forEachLevel(
        water_,
        [&](WaterLevel& level)
        {
            levelsVary_ = levelsVary_ || level.varies();
            try
            {
                level.now = level.at(t);
            }
            catch (const ExpressionError& e)
            {
                throw CaseError({soilProperties, 0}, fmt::format("waterLevel \"{}\" at {:.6g} s: {}", level.expression, t, e.what()));
            }
        });
}

template<int dim> void PoreWaterStep<dim>::save(Numbers& numbers) const
{
    if (levelsVary_) numbers[levelTime] = levelTime_;
}

template<int dim> Numbers PoreWaterStep<dim>::columns(const Particles<dim>& particles) const
{
    if (particles.total() == 0) return {};
    const auto p = [of = particles.store().component(PorePressure::info.name, 0)](std::size_t i) { return of[i]; };
    return {{"minPorePressure", least(particles.size(), p)},
            {"maxPorePressure", most(particles.size(), p)},
            {"surfaceOutflow", outflow_},
            {"poreIterations", double(iterations_)}};
}

template<int dim> std::string PoreWaterStep<dim>::report(const Particles<dim>& particles) const
{
    const auto of = columns(particles);
    return of.empty() ? ""
                      : fmt::format("pore water: {:.6g} .. {:.6g} Pa, {:.6g} m^3/s through free surfaces\n", of.at("minPorePressure"),
                                    of.at("maxPorePressure"), outflow_);
}

template<int dim> std::string PoreWaterStep<dim>::note() const
{
    return iterations_ > 0 ? fmt::format("  pore pressure {} iterations", iterations_) : "";
}

template class PoreWaterStep<2>;
template class PoreWaterStep<3>;

}
