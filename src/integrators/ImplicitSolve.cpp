#include "integrators/ImplicitSolve.hpp"
#include "base/StepTooLong.hpp"
#include "integrators/averageInBoxes.hpp"
#include "parallel/conjugateGradients.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace sph
{

namespace
{
/// Size of the boxes that the residual is averaged over [supports of the kernel]. Measured on a drop that falls above a pool (test/accuracy fallingDrop), by its
/// velocity at 0.1 s and the largest of the gas: single particles 0.999, 3.1 m/s; 1: 0.994, 2.5; 2: 0.993, 1.6; 4: 0.995, 1.4; all together 0.952, 1.2.
constexpr double boxSize = 2;

/// Steps from one measurement of gamma, a sum over pairs, to the next, of another component. A particle moves by 0.2 h a step at most.
constexpr long stepsBetween = 6;

/// Growth of the mean square of the accelerations from one solve to the next beyond which the tolerance is a share of what it was, down to the least; and by what it goes back.
constexpr double mostGrowth = 2.25, tightening = 3, leastShare = 0.03, relaxation = 1.1;

/// dt |dv| of a particle at most [h], for the linear response to hold.
constexpr double furthestLeap = 0.5;

constexpr const char *toleranceShare = "toleranceShare", *forcesOfSolve = "meanSquareAcceleration";
constexpr const char* wallRateNames[] = {"wallRateX", "wallRateY", "wallRateZ"};

struct Norms
{
    double rr = 0, vv = 0; ///< r.r and v_1.v_1, weighed by mass
    Norms& operator+=(const Norms& b)
    {
        rr += b.rr;
        vv += b.vv;
        return *this;
    }
};

/// Largest speed through walls over that along them, at most; the relaxed packings of pipes reach 0.12 at 9 particles across and 0.04 at 19
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
            particles.nearWalls().forEachFoot(in3D(x_i), c.spacing,
                                              [&](const Foot& foot, const Patch& patch)
                                              {
                                                  const auto relative =
                                                      in3D(v_i) -
                                                      particles.geometry().wallVelocity(patch.wallAt(foot.region),
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

/// A = inertia - theta dt L - theta^2 dt^2 K and its diagonal, of the direction p that VelocityChange holds; 0 at what is held: buffer particles have a residual of 0 and keep it, and the equations of the
/// others remain, with a symmetric matrix.
template<int dim> class ImplicitSolve<dim>::Matrix
{
public:
    Matrix(Particles<dim>& particles, bool viscous, bool withPressure, double inertia, double deltaT)
        : p(particles.store().pointers(VelocityChange{})), inertia_(inertia), implicit_(particles.settings().integration.theta * deltaT)
    {
        auto& store = particles.store();
        if (viscous)
        {
            lambda_ = store.component(ViscousRate::info.name, 0);
            Lp_ = store.pointers(ViscousResponse{});
        }
        if (!withPressure) return;
        kappa_ = store.component(StiffRate::info.name, 0);
        Kp_ = store.pointers(StiffResponse{});
    }
    std::array<double*, dim> p;

    double diagonal(std::size_t i) const
    {
        return inertia_ + (lambda_ ? implicit_ * lambda_[i] : 0) + (kappa_ ? sqr(implicit_) * kappa_[i] : 0);
    }
    /// Readies `applied`, by a pass over all pairs but those of the particles left out.
    void apply(Particles<dim>& particles, std::span<const std::uint8_t> leftOut) const
    {
        particles.evaluate(ofSolver, 0, leftOut);
        for (const auto& response : {Lp_, Kp_})
            for (double* component : response)
                if (component)
                    for (const int i : particles.held()) component[i] = 0;
    }
    /// (A p)_i
    double applied(int c, std::size_t i) const
    {
        return inertia_ * p[c][i] - (lambda_ ? implicit_ * Lp_[c][i] : 0) - (kappa_ ? sqr(implicit_) * Kp_[c][i] : 0);
    }

private:
    double inertia_, implicit_;
    const double *lambda_ = nullptr, *kappa_ = nullptr;
    std::array<double*, dim> Lp_{}, Kp_{};
};

template<int dim>
ImplicitSolve<dim>::ImplicitSolve(Particles<dim>& particles, const Numbers& restored)
    : withPressure_(particles.settings().integration.solvesPressure),
      viscous_(particles.plan().provides(ViscousResponse::info.name)),
      followsForces_(withPressure_ && particles.settings().facts.template get<CalmPhase>().phase >= 0)
{
    if (const auto share = restored.find(toleranceShare); share != restored.end())
    {
        share_ = share->second;
        forces_ = restored.at(forcesOfSolve);
    }
    const auto steps = restored.find("implicitSteps");
    if (steps == restored.end()) return;
    steps_ = long(steps->second);
    for (int c = 0; c < dim; ++c) wallRate_[c] = restored.at(wallRateNames[c]);
}

template<int dim> std::vector<Stage<dim>> ImplicitSolve<dim>::stages(JoinPoint place)
{
    if (place != JoinPoint::solve) return {};
    const std::string equation =
        fmt::format("(1{}{}) dv = dt a{}", viscous_ ? " - theta dt L" : "", withPressure_ ? " - theta^2 dt^2 K" : "",
                    withPressure_ ? " + what the last step has left" : "");
    Stage<dim> stage{"solve",
                     equation + ", conjugate gradients",
                     [this](Particles<dim>& p, const Substep& s)
                     {
                         if (p.settings().integration.moves) solve(p, s.deltaT);
                         else solveSteady(p);
                     },
                     {ofSolver}};
    if (!withPressure_) return {stage};
    return {std::move(stage).undoneBy([this](Particles<dim>& p, const Substep& s) { takeBack(p, s.deltaT); })};
}

template<int dim> std::string ImplicitSolve<dim>::note() const
{
    return iterations_ > 0 ? fmt::format("  {} {} iterations", withPressure_ ? "pressure" : "viscosity", iterations_) : "";
}

template<int dim> void ImplicitSolve<dim>::followForces(const Particles<dim>& particles)
{
    const auto a = particles.store().pointers(Acceleration{});
    const std::size_t n = particles.size();
    const auto meanSquare = sum(n,
                                [&](std::size_t i)
                                {
                                    double square = 0;
                                    for (int c = 0; c < dim; ++c) square += sqr(a[c][i]);
                                    return square;
                                }) /
                            double(std::max<std::size_t>(1, particles.total()));
    if (forces_ > 0) share_ = std::clamp(share_ * (meanSquare > mostGrowth * forces_ ? 1 / tightening : relaxation), leastShare, 1.0);
    forces_ = meanSquare;
}

template<int dim> void ImplicitSolve<dim>::solve(Particles<dim>& particles, double deltaT)
{
    if (followsForces_) followForces(particles);
    solveForChange(particles, 1, deltaT);
    if (!withPressure_) addResidual(particles);
    else
    {
        refuseLeaps(particles, deltaT);
        delayResidual(particles, deltaT);
    }
    const auto a = particles.store().pointers(Acceleration{});
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (int c = 0; c < dim; ++c) a[c][i] = change_[c][i] / deltaT;
}

template<int dim> void ImplicitSolve<dim>::findLeftOut(const Particles<dim>& particles)
{
    leftOut_.clear();
    if (!withPressure_) return;
    const double* const stiffness = particles.store().component(VolumeStiffness::info.name, 0);
    for (const int i : particles.held())
    {
        if (stiffness[i] != 0) continue; // its pressure changes, which others feel
        leftOut_.resize(particles.size());
        leftOut_[std::size_t(i)] = 1;
    }
}

template<int dim> void ImplicitSolve<dim>::refuseLeaps(const Particles<dim>& particles, double deltaT) const
{
    const double largest = most(particles.size(), [&](std::size_t i) { return mag(valueAt<Vector<dim>>(change_, i)); });
    const double leap = deltaT * largest, h = 0.5 * particles.coefficients().support;
    if (leap > furthestLeap * h)
        throw StepTooLong(fmt::format(
            "the implicit pressure throws a particle {:.3g} h in a step of {:.3g} s, with h = {:.3g} m, and linear responses hold to {:.3g} h. "
            "Choose a smaller step",
            leap / h, deltaT, h, furthestLeap));
}

template<int dim> void ImplicitSolve<dim>::takeBack(Particles<dim>& particles, double deltaT)
{
    const Matrix A(particles, viscous_, withPressure_, 1, deltaT);
    const std::size_t n = particles.size();
    const auto a = particles.store().pointers(Acceleration{}), r = particles.store().pointers(DelayedImpulse{});
    for (int c = 0; c < dim; ++c) std::copy_n(change_[c].data(), n, A.p[c]);
    A.apply(particles, leftOut_);
    for (int c = 0; c < dim; ++c)
    {
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < n; ++i) r[c][i] += A.applied(c, i) - deltaT * a[c][i];
        for (const int i : particles.held()) r[c][i] = 0;
    }
}

template<int dim> void ImplicitSolve<dim>::addResidual(const Particles<dim>& particles)
{
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (int c = 0; c < dim; ++c) change_[c][i] += residual_[c][i];
}

template<int dim> void ImplicitSolve<dim>::measureWallRates(Particles<dim>& particles, double mass)
{
    const std::size_t n = particles.size();
    const double* const m = particles.store().component(Mass::info.name, 0);
    const auto p = particles.store().pointers(VelocityChange{}), Lp = particles.store().pointers(ViscousResponse{});
    const auto ask = [&](int c)
    {
        for (int k = 0; k < dim; ++k) std::fill_n(p[k], n, k == c ? 1 : 0);
        particles.evaluate(ofSolver);
        wallRate_[c] = std::max(0.0, -sum(n, [&](std::size_t i) { return m[i] * Lp[c][i]; }) / mass);
    };
    if (steps_ == 0)
        for (int c = 0; c < dim; ++c) ask(c);
    else if (steps_ % stepsBetween == 0) ask(steps_ / stepsBetween % dim);
    ++steps_;
}

template<int dim> void ImplicitSolve<dim>::delayResidual(Particles<dim>& particles, double deltaT)
{
    const auto& store = std::as_const(particles).store();
    const auto r = particles.store().pointers(DelayedImpulse{});
    const double* const m = store.component(Mass::info.name, 0);
    const std::size_t n = particles.size();
    const double mass = sum(n, [&](std::size_t i) { return m[i]; });
    std::array<double, dim> mean;
    for (int c = 0; c < dim; ++c) mean[c] = sum(n, [&](std::size_t i) { return m[i] * r[c][i]; }) / mass;
    if (viscous_ && !particles.geometry().patches.empty()) measureWallRates(particles, mass);
    for (int c = 0; c < dim; ++c)
    {
        const double added = mean[c] / (1 + particles.settings().integration.theta * deltaT * wallRate_[c]);
#pragma omp parallel for simd schedule(static)
        for (std::size_t i = 0; i < n; ++i)
        {
            change_[c][i] += added;
            r[c][i] -= added;
        }
        for (const int i : particles.held()) change_[c][i] = 0;
    }
    averageInBoxes<dim>(r, store.pointers(Position{}), m, n, boxSize * particles.coefficients().support);
}

template<int dim> void ImplicitSolve<dim>::solveSteady(Particles<dim>& particles)
{
    solveForChange(particles, 0, 1 / particles.settings().integration.theta);
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

/// (inertia - theta dt L - theta^2 dt^2 K) dv = dt a
template<int dim> void ImplicitSolve<dim>::solveForChange(Particles<dim>& particles, double inertia, double deltaT)
{
    auto& store = particles.store();
    const auto& settings = particles.settings().integration;
    const std::size_t n = particles.size();
    const double* const m = store.component(Mass::info.name, 0);
    const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{});
    const Matrix A(particles, viscous_, withPressure_, inertia, deltaT);
    std::array<double*, dim> dv, r;
    for (int c = 0; c < dim; ++c)
    {
        change_[c].resize(n);
        if (!withPressure_) residual_[c].resize(n);
        dv[c] = change_[c].data();
        r[c] = withPressure_ ? store.component(DelayedImpulse::info.name, c) : residual_[c].data();
#pragma omp parallel for simd schedule(static)
        for (std::size_t i = 0; i < n; ++i) r[c][i] = (withPressure_ ? r[c][i] : 0) + deltaT * a[c][i];
        for (const int i : particles.held()) r[c][i] = 0;
    }
    findLeftOut(particles);
    const auto diagonal = [A](std::size_t i) { return A.diagonal(i); };
    const auto applied = [A](int c, std::size_t i) { return A.applied(c, i); };
    const auto norms = [=](std::size_t i)
    {
        double r2 = 0, v2 = 0;
        for (int c = 0; c < dim; ++c)
        {
            r2 += sqr(r[c][i]);
            v2 += sqr(v[c][i] + dv[c][i]);
        }
        return Norms{m[i] * r2 / (inertia > 0 ? 1 : sqr(diagonal(i))), m[i] * v2};
    };
    const auto apply = [&] { A.apply(particles, leftOut_); };
    const char* const name = withPressure_ ? "the implicit pressure" : "the implicit viscosity";
    const double tolerance = share_ * settings.tolerance;
    double start = 0;
    std::string history;
    const auto done = [&](const ResidualSums<Norms>& now, int iterations)
    {
        if (iterations == 0) start = now.rz;
        const double rr = now.further.rr, vv = now.further.vv;
        // Infinite forces would be within any share of themselves, and a residual within any share of infinite velocities.
        if (!(std::isfinite(now.rz) && std::isfinite(rr) && std::isfinite(vv)))
            throw DivergedError(
                fmt::format("{} has met forces or velocities that are no longer finite, after {} iterations{}. Choose a smaller step", name,
                            iterations, history));
        // The residual is relative to the velocity, or with pressure, whose forces balance one another, to its value at the start.
        if (withPressure_ ? now.rz <= sqr(tolerance) * start : rr <= sqr(tolerance) * vv) return true;
        const double residual = withPressure_ ? std::sqrt(now.rz / start) : std::sqrt(rr / vv);
        if (iterations == settings.maxIter)
            throw StepTooLong(
                fmt::format("{} has not converged in {} iterations: the residual is {:.3g} of the {}, the tolerance {:.3g}{}. Choose a "
                            "smaller step, or a larger `maxIter` or `tolerance` in `integration`",
                            name, iterations, residual, withPressure_ ? "forces" : "velocity", tolerance, history));
        if (iterations > 0 && iterations % std::max(1, settings.maxIter / 4) == 0)
            history += fmt::format("; after {} it was {:.3g}", iterations, residual);
        return false;
    };
    iterations_ = conjugateGradients(LinearSystem<dim>{name, n, m, dv, r, A.p}, diagonal, apply, applied, norms, done);
}

template<int dim> void ImplicitSolve<dim>::save(Numbers& numbers) const
{
    if (followsForces_)
    {
        numbers[toleranceShare] = share_;
        numbers[forcesOfSolve] = forces_;
    }
    if (steps_ == 0) return;
    numbers["implicitSteps"] = double(steps_);
    for (int c = 0; c < dim; ++c) numbers[wallRateNames[c]] = wallRate_[c];
}

template<int dim> std::size_t ImplicitSolve<dim>::bytes() const
{
    std::size_t n = 0;
    for (const auto* arrays : {&change_, &residual_})
        for (const auto& array : *arrays) n += array.capacity() * sizeof(double);
    return n + leftOut_.capacity();
}

template class ImplicitSolve<2>;
template class ImplicitSolve<3>;

}
