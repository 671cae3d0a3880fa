#include "models/suspension/Migration.hpp"
#include "base/DivergedError.hpp"
#include "models/suspension/SuspensionConstants.hpp"
#include "models/suspension/ViscosityFlux.hpp"
#include "parallel/conjugateGradients.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{
constexpr double hopeless = 1e12; ///< number of steps left at which the run ends: no limit grows as much
/// Upper bound on migration substeps in one flow step. The first step needs a few thousand, because its limit is not known yet.
constexpr int mostSteps = 1000000;

/// Largest relative rise of phi within a spacing towards a place without shear stress, and of phi beyond phi_m; above them the cusp is not resolved.
constexpr double mostRise = 0.3, beyondDensest = 0.01;
/// Shear stress over the next particle's, below which it is taken to vanish between them: 1/3 where the middle lies between two rows.
constexpr double shareOfStress = 0.4;
constexpr double nextParticle = 1.5; ///< largest distance of the next particle [spacings]

/// Largest change of phi over phi_m - phi in a step that solves for J_eta: such steps are of first order in time, and at the start the powder moves fast.
constexpr double mostChange = 0.01;
constexpr double tolerance = 1e-6; ///< relative residual of the solve, in the preconditioned norm
constexpr int mostIterations = 1000;
}

template<int dim>
Migration<dim>::Migration(Particles<dim>&, const Numbers& restored, const MigrationSteps& steps, bool corrects)
    : steps_(steps), corrects_(corrects), limit_(std::numeric_limits<double>::infinity())
{
    if (const auto found = restored.find("powderVolume"); found != restored.end()) startVolume_ = found->second;
    if (const auto found = restored.find("migrationLimit"); found != restored.end()) limit_ = found->second;
}

template<int dim> std::vector<Stage<dim>> Migration<dim>::stages(JoinPoint place)
{
    std::vector<std::string> groups;
    if (corrects_) groups.emplace_back(ofCorrection);
    groups.emplace_back(ofMigration);
    if (place == JoinPoint::complete)
        return {{"rates of powder", "mu, shear rate and dphi/dt", [this](Particles<dim>& p, const Substep&) { look(p); }, groups}};
    if (place != JoinPoint::afterKick) return {};
    if (steps_.solves) groups.push_back(ofMigrationSolve);
    const std::string equation = steps_.solves ? "(1 - dt K_eta) dphi = dt dphi/dt" : "phi += dt dphi/dt";
    return {{"migrate", equation + ", in steps of its own", [this](Particles<dim>& p, const Substep& s) { advance(p, s.deltaT); }, groups}};
}

template<int dim> double Migration<dim>::evaluateRates(Particles<dim>& particles)
{
    particles.evaluate(ofMigration);
    const auto& s = particles.coefficients().template of<Suspension>();
    const auto& store = particles.store();
    const double *phi = store.component(PowderFraction::info.name, 0), *gammaDot = store.component(ShearRate::info.name, 0),
                 *slope = store.component(RelativeViscositySlope::info.name, 0);
    const double *rate = store.component(PowderRate::info.name, 0), capped = s.phiMax - s.phiCritical;
    const auto largest = [&](const auto& of) { return reduce(particles.size(), 0.0, of, Larger{}); };
    const auto byDiffusion = [&](double Deta_a2)
    {
        const double D = largest([&](std::size_t i) { return gammaDot[i] * phi[i] * (s.Dc_a2 + Deta_a2 * phi[i] * slope[i]); });
        return steps_.factor * sqr(0.5 * particles.coefficients().support) / D;
    };
    const double limit = byDiffusion(s.Deta_a2);
    if (!steps_.solves) return limit;
    const double fastest = largest([&](std::size_t i) { return std::fabs(rate[i]) / std::max(s.phiMax - phi[i], capped); });
    return std::min(byDiffusion(0), std::max(limit, mostChange / fastest));
}

template<int dim> double Migration<dim>::complete(Particles<dim>& particles)
{
    if (corrects_) particles.evaluate(ofCorrection);
    return evaluateRates(particles);
}

/// A step goes on by the limit that the migration of the last one has left, whoever looks in between; the first one has none. In creeping flow velocities follow phi,
/// and the limit is that at the new ones, which is the same at each look.
template<int dim> void Migration<dim>::look(Particles<dim>& particles)
{
    const double limit = complete(particles);
    if (!startVolume_ || !particles.settings().integration.moves) limit_ = limit;
    if (!startVolume_) startVolume_ = volume(particles);
}

template<int dim> void Migration<dim>::advance(Particles<dim>& particles, double deltaT)
{
    auto& store = particles.store();
    const std::size_t n = particles.size();
    double* const phi = store.component(PowderFraction::info.name, 0);
    double* const rate = store.component(PowderRate::info.name, 0);
    limit_ = complete(particles);
    for (taken_ = 1;; ++taken_)
    {
        // The remaining time is cut into equal parts, so that no last one is a sliver.
        const double parts = std::max(1.0, std::ceil(deltaT / limit_ - 1e-9)), part = deltaT / parts;
        if (steps_.solves) solve(particles, part);
        particles.withholdRate(PowderFraction::info.name, part);
#pragma omp parallel for simd schedule(static)
        for (std::size_t i = 0; i < n; ++i) phi[i] += part * rate[i];
        if (parts == 1) return;
        if (taken_ == mostSteps || parts > hopeless)
            throw DivergedError(
                fmt::format("{} steps of the powder's migration, at most {:.3g} s each, have not made up one of the flow: phi is no longer "
                            "physical. Choose a smaller `migrationFactor` in `integration`",
                            taken_, limit_));
        deltaT -= part;
        limit_ = evaluateRates(particles);
    }
}

template<int dim> void Migration<dim>::solve(Particles<dim>& particles, double deltaT)
{
    auto& store = particles.store();
    const std::size_t n = particles.size();
    change_.resize(n);
    residual_.resize(n);
    double *const rate = store.component(PowderRate::info.name, 0), *const response = store.component(PowderResponse::info.name, 0),
                  *const p = store.component(PowderChange::info.name, 0);
    const double* const lambda = store.component(PowderRelaxation::info.name, 0);
#pragma omp parallel for simd schedule(static)
    for (std::size_t i = 0; i < n; ++i) residual_[i] = deltaT * rate[i];
    for (const int i : particles.held()) residual_[std::size_t(i)] = 0;
    const auto apply = [&]
    {
        particles.evaluate(ofMigrationSolve);
        for (const int i : particles.held()) response[i] = 0;
    };
    double start = 0;
    const auto done = [&](const ResidualSums<double>& now, int iterations)
    {
        if (iterations == 0) start = now.rz;
        if (!std::isfinite(now.rz) || iterations == mostIterations)
            throw DivergedError(
                fmt::format("the implicit migration of the powder has not converged in {} iterations: the residual is {:.3g} of "
                            "what it was. Choose a smaller `migrationFactor` in `integration`",
                            iterations, std::sqrt(now.rz / start)));
        return now.rz <= sqr(tolerance) * start;
    };
    conjugateGradients(
        LinearSystem<1>{
            "the implicit migration of the powder", n, store.component(Mass::info.name, 0), {change_.data()}, {residual_.data()}, {p}},
        [&](std::size_t i) { return 1 + deltaT * lambda[i]; }, apply, [&](int, std::size_t i) { return p[i] - deltaT * response[i]; },
        [](std::size_t) { return 0.0; }, done);
    // The change is applied as fluxes between pairs, so that powder is kept whatever the tolerance.
    std::copy_n(change_.data(), n, p);
    particles.evaluate(ofMigrationSolve);
#pragma omp parallel for simd schedule(static)
    for (std::size_t i = 0; i < n; ++i) rate[i] += response[i];
}

template<int dim> double Migration<dim>::volume(const Particles<dim>& particles) const
{
    const double *phi = particles.store().component(PowderFraction::info.name, 0), *m = particles.store().component(Mass::info.name, 0);
    const double rho_0 = particles.coefficients().restDensity[0];
    return reduceBlocks(
        particles.size(), 0.0,
        [&](std::size_t begin, std::size_t end)
        {
            double ofBlock = 0;
            for (std::size_t i = begin; i < end; ++i) ofBlock += phi[i] * m[i];
            return ofBlock / rho_0;
        },
        Add{});
}

template<int dim> std::vector<StepLimit> Migration<dim>::limits() const { return {{steps_.most * limit_, "migration"}}; }

template<int dim> Numbers Migration<dim>::columns(const Particles<dim>& particles) const
{
    const auto n = particles.size();
    const double *phi = particles.store().component(PowderFraction::info.name, 0),
                 *mu = particles.store().component(DynamicViscosity::info.name, 0);
    const auto of = [](const double* q) { return [q](std::size_t i) { return q[i]; }; };
    const double powder = volume(particles);
    return {{"minPhi", least(n, of(phi))},      {"maxPhi", most(n, of(phi))},
            {"minViscosity", least(n, of(mu))}, {"maxViscosity", most(n, of(mu))},
            {"powderVolume", powder},           {"powderDrift", startVolume_ && *startVolume_ > 0 ? powder / (*startVolume_) - 1 : 0},
            {"migrationSteps", taken_}};
}

template<int dim> std::string Migration<dim>::report(const Particles<dim>& particles) const
{
    const auto c = columns(particles);
    return fmt::format("powder: phi {:.6g} .. {:.6g}, mu {:.4g} .. {:.4g} Pa s, volume {:.15g} m^3{}, {} steps of migration\n",
                       c.at("minPhi"), c.at("maxPhi"), c.at("minViscosity"), c.at("maxViscosity"), c.at("powderVolume"),
                       particles.holdsAny() ? "" : fmt::format(", changed by {:.2g}", c.at("powderDrift")), taken_);
}

template<int dim> std::string Migration<dim>::warning(const Particles<dim>& particles)
{
    if (warned_) return "";
    struct Rise
    {
        double most = 0, phi = 0;
        Vector<3> at = {};
    };
    const auto& store = particles.store();
    const auto& c = particles.coefficients();
    const Suspension& s = c.template of<Suspension>();
    const auto x = store.pointers(Position{});
    const double *phi = store.component(PowderFraction::info.name, 0), *gammaDot = store.component(ShearRate::info.name, 0),
                 *mu = store.component(DynamicViscosity::info.name, 0);
    const auto larger = [](Rise& total, const Rise& other)
    {
        if (other.most > total.most) total = other;
    };
    const auto rise = reduce(
        particles.size(), Rise{},
        [&](std::size_t i)
        {
            Rise of;
            typename NeighbourLists<dim>::Room room;
            for (const int j : particles.lists().of(i, room))
            {
                if (std::size_t(j) >= particles.size() ||
                    !(phi[i] > phi[j] && phi[j] > 0 && mu[i] * gammaDot[i] < shareOfStress * mu[j] * gammaDot[j]))
                    continue;
                double r2 = 0;
                for (int k = 0; k < dim; ++k) r2 += sqr(x[k][i] - x[k][j]);
                const double r = std::sqrt(r2) / c.spacing;
                if (r < nextParticle) of.most = std::max(of.most, (phi[i] / phi[j] - 1) / std::max(1.0, r));
            }
            if (of.most == 0) return of;
            return Rise{of.most, phi[i], in3D(valueAt<Vector<dim>>(x, i))};
        },
        larger);
    const double densest = most(particles.size(), [&](std::size_t i) { return phi[i]; });
    const bool passesDensest = s.Dc_a2 < s.Deta_a2 && densest > (1 + beyondDensest) * s.phiMax;
    if (!(rise.most > mostRise || passesDensest)) return "";
    warned_ = true;
    if (!(rise.most > mostRise))
        return fmt::format(
            "the powder's volume fraction has passed phiMax, {:.4g}: it is {:.4g}. Where powder gathers the particles are too coarse: take a smaller "
            "spacing than {:.3g} m",
            s.phiMax, densest, c.spacing);
    const double n = s.exponent * (s.Deta_a2 / s.Dc_a2 - 1),
                 spacing = c.spacing * std::pow(mostRise / rise.most, std::max(1.0, 0.5 * (1 + n)));
    return fmt::format(
        "the cusp of the powder is not resolved: where the shear vanishes, near ({:.6g} {:.6g} {:.6g}), phi is {:.3g} and rises by {:.2g} % within a "
        "spacing. From a spacing of about {:.2g} m on it rises by less than {:.2g} %, with which steady channels are right within 2 %",
        rise.at.x, rise.at.y, rise.at.z, rise.phi, 100 * rise.most, spacing, 100 * mostRise);
}

template<int dim> void Migration<dim>::save(Numbers& numbers) const
{
    if (startVolume_) numbers["powderVolume"] = *startVolume_;
    numbers["migrationLimit"] = limit_;
}

template class Migration<2>;
template class Migration<3>;

}
