#include "solver/readSettings.hpp"
#include "decomposition/readDecomposition.hpp"
#include "integrators/Integrator.hpp"
#include "parallel/Ranks.hpp"
#include "schemes/schemeSets.hpp"
#include "solver/BoundaryWork.hpp"
#include "solver/TimeStepLimits.hpp"
#include "solver/WallForces.hpp"
#include "solver/models.hpp"
#include "solver/particlesAtStart.hpp"
#include "solver/readPhases.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// State that every scene has: positions, velocities, masses, and phases where there are several.
State stateOfAll(const Settings& settings)
{
    const auto& c = settings.coefficients;
    Evolving x{stateField(Position{})}, v{stateField(Velocity{}), stateField(Acceleration{})}, m{stateField(Mass{})};
    const double volume = std::pow(c.spacing, c.dimension);
    const auto massOf = [volume](const Loading& loading, std::size_t i)
    { return loading.coefficients.restDensity[loading.phaseOf(i)] * volume; };
    m.missing = [massOf](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i) loading.values[0][i] = massOf(loading, i);
    };
    m.check = [massOf](const Loading& loading)
    { loading.checkScale("m", "kg", 1e-3, 1e3, [&](std::size_t i) { return massOf(loading, i); }); };
    m.inlet = [rho = c.restDensity, volume](const Dictionary&, std::size_t phase) { return rho[phase] * volume; };
    State state{x, v, m};
    if (!settings.multiphase()) return state;
    Evolving phase{stateField(Phase{})};
    phase.inlet = [](const Dictionary&, std::size_t k) { return double(k); };
    state.push_back(phase);
    return state;
}

std::map<std::string, FieldClass> knownFields(const Settings& settings)
{
    std::map<std::string, FieldClass> classes{{"coordinates", FieldClass::vector}}; // OpenFOAM's, beside the positions
    for (const auto& evolving : settings.state) classes[evolving.value.name] = evolving.value.type(3).fieldClass;
    for (const auto& term : allTerms<3>())
        for (const auto* fields : {&term.results, &term.reads, &term.readsOwn})
            for (const auto& field : *fields) classes[field.name] = field.type.fieldClass;
    return classes;
}

void readRanks(const Case& theCase, Settings& settings)
{
    if (!ranks()) return;
    const auto decomposition = readDecomposition(theCase, ranks()->count());
    settings.maxImbalance = decomposition.maxImbalance;
    if (decomposition.method != Division::rcb)
        settings.reasons.push_back(
            fmt::format("boxes for the ranks: the method of {} is that of decomposeParticles", decompositionDictionary));
}

/// A liquid that leaves a part of its space empty has a free surface, for which the defaults of enclosed fluids are no choice at all.
void chooseSet(const Reading& reading)
{
    const auto& schemes = reading.schemes;
    auto& settings = reading.settings;
    const auto& facts = settings.facts;
    if (entry::scheme.given(schemes)) return;
    if (const auto needed = facts.get<SchemeSet>().word; !needed.empty())
    {
        addSchemeSet(schemes, needed);
        settings.reasons.push_back(fmt::format("scheme {}: {}", needed, wordsOfSet(needed)));
        return;
    }
    const std::string set = "freeSurface";
    if (settings.multiphase() || facts.get<GasLeftOut>().isLeftOut || facts.get<OpenBoundary>().exists ||
        facts.get<VaryingViscosity>().exists || givesWordsOf(set, schemes))
        return;
    const auto share = shareFilled(reading.theCase, reading.geometry, settings.coefficients.spacing);
    if (!share || *share > 0.95) return;
    addSchemeSet(schemes, set);
    settings.reasons.push_back(
        fmt::format("scheme {}, for the liquid fills {:.3g} % of its space: {}", set, 100 * *share, wordsOfSet(set)));
}
}

Settings readSettings(const Case& theCase, const Geometry& geometry)
{
    Settings settings;
    auto& c = settings.coefficients;
    const auto dict = theCase.dictionary("system/sphSchemes");
    settings.resolution = readResolution(dict);
    c.dimension = geometry.dimension;
    c.spacing = settings.resolution.spacing;
    c.support = settings.resolution.H();
    const auto phases = theCase.dictionary("constant/phaseProperties");
    readScene(theCase, phases, settings);
    readRanks(theCase, settings);
    const Reading reading{theCase, geometry, dict, phases, settings, [](const Settings& s, const Measured& m) { return stepLimits(s, m); }};
    for (const auto* model : models())
        if (model->declare) model->declare(reading);
    readPhases(theCase, phases, settings);
    phases.reportUnused();
    if (settings.multiphase() && settings.facts.get<InterfaceEnergy>().largest > 0 && !settings.facts.get<OpenBoundary>().exists)
        if (const auto phase = lonePhase(theCase)) settings.facts.give(LonePhase{*phase}, "the particles of the first time");
    settings.state = stateOfAll(settings);
    settings.fieldClasses = knownFields(settings);
    chooseSet(reading);
    reading.choose(entry::scheme, "suite");
    for (const auto* model : models())
        if (model->prepare) model->prepare(reading);
    for (const auto* model : models()) model->read(reading);
    for (const auto* model : models())
        for (const auto& conflict : model->conflicts)
            if (conflict.applies(settings)) dict.error(conflict.entry, conflict.why);
    askForBoundaryWork(reading);
    askForWallForces(reading);
    checkStepFactors(reading);
    warnOfSoftPhases(theCase, settings);
    dict.reportUnused();
    return settings;
}

}
