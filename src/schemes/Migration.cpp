#include "Migration.hpp"
#include "DivergedError.hpp"
#include "overBlocks.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{
constexpr int mostSteps = 1000000; ///< of migration in one of the flow: the first, whose limit is not known beforehand, takes a few thousand

/// What the evaluation of the flow leaves: positions and volumes with their images, and velocities.
std::set<std::string> state(bool normalised, bool corrected)
{
    std::set<std::string> fields{Position::info.name, Velocity::info.name,       Mass::info.name,
                                 Volume::info.name,   PowderFraction::info.name, GhostWall::info.name};
    if (normalised) fields.insert(GradientScale::info.name);
    if (corrected) fields.insert(CorrectionTensor::info.name);
    return fields;
}
std::set<std::string> current(bool normalised)
{
    std::set<std::string> fields{Position::info.name, Volume::info.name, GhostWall::info.name};
    if (normalised) fields.insert(GradientScale::info.name);
    return fields;
}
std::vector<std::string> correction(const Settings& settings)
{
    return settings.correctedShear ? std::vector<std::string>{"gradientCorrection"} : std::vector<std::string>{};
}
}

template<int dim>
Migration<dim>::Migration(const Settings& settings, const Catalogue<dim>& catalogue, FieldStore<dim>& store)
    : settings_(settings),
      correction_(catalogue, correction(settings), state(false, false), current(false)),
      rates_(catalogue, settings.migrationTerms, state(store.has(GradientScale{}), settings.correctedShear), current(store.has(GradientScale{}))),
      limit_(std::numeric_limits<double>::infinity())
{
    correction_.allocate(store);
    rates_.allocate(store);
}

template<int dim> void Migration<dim>::bind(FieldStore<dim>& store, const Coefficients& coefficients)
{
    correction_.bind(store, coefficients);
    rates_.bind(store, coefficients);
}

template<int dim> std::set<std::string> Migration<dim>::readAtNeighbours() const
{
    auto fields = correction_.readAtNeighbours();
    fields.merge(rates_.readAtNeighbours());
    return fields;
}

template<int dim>
void Migration<dim>::evaluateRates(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists, const Kernel<dim>& kernel)
{
    rates_.evaluate(store, images, lists, kernel, Plan<dim>::Candidates::kept);
    const auto& s = *settings_.coefficients.suspension;
    const double *phi = store.component(PowderFraction::info.name, 0), *gammaDot = store.component(ShearRate::info.name, 0),
                 *slope = store.component(RelativeViscositySlope::info.name, 0);
    double fastest = 0;
    for (const double D : overBlocks(store.owned(), [&](std::size_t begin, std::size_t end)
                                     {
                                         double most = 0;
                                         for (std::size_t i = begin; i < end; ++i)
                                             most = std::max(most, gammaDot[i]*phi[i]*(s.Dc_a2 + s.Deta_a2*phi[i]*slope[i]));
                                         return most;
                                     }))
        fastest = std::max(fastest, D);
    limit_ = settings_.factors.migration*sqr(0.5*settings_.coefficients.support)/fastest;
}

template<int dim>
void Migration<dim>::evaluate(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists, const Kernel<dim>& kernel)
{
    correction_.evaluate(store, images, lists, kernel, Plan<dim>::Candidates::kept);
    evaluateRates(store, images, lists, kernel);
}

template<int dim>
double Migration<dim>::advance(FieldStore<dim>& store, const Images<dim>& images, NeighbourLists<dim>& lists, const Kernel<dim>& kernel, double deltaT,
                               std::span<const int> held)
{
    const std::size_t n = store.owned();
    double* const phi = store.component(PowderFraction::info.name, 0);
    double* const rate = store.component(PowderRate::info.name, 0);
    const double* const m = store.component(Mass::info.name, 0);
    double intoHeld = 0;
    evaluate(store, images, lists, kernel);
    for (steps_ = 1;; ++steps_)
    {
        // What is left is cut into equal parts, so that no last one is a sliver.
        const double parts = std::max(1.0, std::ceil(deltaT/limit_ - 1e-9)), part = deltaT/parts;
        for (const int i : held)
        {
            intoHeld += part*rate[i]*m[i]/settings_.coefficients.restDensity[0];
            rate[i] = 0;
        }
        #pragma omp parallel for simd schedule(static)
        for (std::size_t i = 0; i < n; ++i) phi[i] += part*rate[i];
        if (parts == 1) return intoHeld;
        if (steps_ == mostSteps)
            throw DivergedError(fmt::format("{} steps of the powder's migration, at most {:.3g} s each, have not made up one of the flow: phi is no longer "
                                            "physical. Choose a smaller `migrationFactor` in `integration`", steps_, limit_));
        deltaT -= part;
        evaluateRates(store, images, lists, kernel);
    }
}

template class Migration<2>;
template class Migration<3>;

}
