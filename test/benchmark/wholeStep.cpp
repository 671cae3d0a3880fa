#include "wholeStep.hpp"
#include "images/Images.hpp"
#include "neighbours/NeighbourLists.hpp"
#include "packing/Packing.hpp"
#include "solver/Simulation.hpp"
#include "solver/readSettings.hpp"
#include <algorithm>
#include <memory>
#include <omp.h>

namespace sph
{

namespace
{
Cloud cloudOf(const Packing& packing)
{
    Cloud cloud{"", packing.points.x, packing.points.y, packing.points.z, {}};
    cloud.fields["U"] = {FieldClass::vector, {packing.velocity.x, packing.velocity.y, packing.velocity.z}};
    cloud.fields["m"] = {FieldClass::scalar, {packing.mass}};
    cloud.fields["rho"] = {FieldClass::scalar, {packing.rho}};
    cloud.fields["phase"] = {FieldClass::label, {packing.phase}};
    return cloud;
}

/// Mean number within the support of the present positions, images included, the particle itself left out.
double neighboursWithinSupport(const AnySimulation& simulation, const Settings& settings, const Geometry& geometry)
{
    const double H = settings.resolution.H();
    const std::size_t n = simulation.size();
    FieldStore<3> store;
    store.allocate(Position{});
    store.resize(n);
    const auto from = simulation.positions();
    for (int c = 0; c < 3; ++c) std::copy_n(from.component[c], n, store.component("positions", c));
    Images<3> images(geometry, H, settings.resolution.spacing);
    images.build(store, n);
    const auto x = store.pointers(Position{});
    NeighbourLists<3> lists;
    lists.build({x[0], x[1], x[2]}, n, images.nullParticle(), H);
    return double(lists.pairs()) / double(n) - 1;
}

/// A case, packed in memory, after its first step.
struct PackedCase
{
    Case theCase;
    Geometry geometry;
    Settings settings;
    std::unique_ptr<AnySimulation> simulation;

    PackedCase(const std::filesystem::path& folder, bool mixed)
        : theCase(folder),
          geometry(readGeometry(theCase.dictionary("constant/geometry"), readResolution(theCase.dictionary("system/sphSchemes")),
                                supportsOfSolver)),
          settings(readSettings(theCase, geometry))
    {
        const auto plan = readPackingPlan(theCase);
        settings.mixedPrecision = mixed;
        theCase.diagnostics().throwIfAny();
        simulation = makeSimulation(settings, geometry, cloudOf(pack(plan)), {});
        advance(1);
    }
    void advance(int steps) const
    {
        for (int s = 0; s < steps; ++s) simulation->step(0, simulation->stepLimit().deltaT);
    }
};
}

Figures wholeStep(const std::filesystem::path& caseFolder, const std::string& name, PairLimit& limit, int stepsATurn, int turns, bool mixed)
{
    const PackedCase packed(caseFolder, mixed);
    const auto& simulation = packed.simulation;
    double best = 1e9, bestOfLimit = 1e9, passes = 0;
    const long rebuildsBefore = simulation->rebuilds();
    for (int turn = 0; turn < turns; ++turn)
    {
        bestOfLimit = std::min(bestOfLimit, secondsOf([&] { limit.evaluate(); }));
        const long before = simulation->pairPassesRun();
        const double seconds = secondsOf([&] { packed.advance(stepsATurn); });
        const double passesOfTurn = double(simulation->pairPassesRun() - before);
        if (passes > 0 && seconds / passesOfTurn >= best / passes)
            continue; // turns differ in parts of their steps and in iterations: the best by the pass
        best = seconds / stepsATurn;
        passes = passesOfTurn / stepsATurn;
    }
    const double steps = double(turns) * stepsATurn, particles = double(simulation->size());
    const double neighbours = neighboursWithinSupport(*simulation, packed.settings, packed.geometry);
    const double limitRate = double(limit.list.size()) / bestOfLimit;
    return {{name + "Particles", particles, "1"},
            {name + "ImagesPerParticle", double(simulation->images()) / particles, "1"},
            {name + "Neighbours", neighbours, "1"},
            {name + "PairPasses", passes, "1"},
            {name + "ParticleSteps", particles / best / 1e6, "million particle-steps/s/core"},
            {name + "StepOfPairLimit", neighbours * passes * particles / best / limitRate, "1"},
            {name + "ParticleStepsAt345", particles / best / 1e6 * 345e6 / limitRate,
             "million particle-steps/s/core where the limit is 345 million pairs/s"},
            {name + "StepsPerListBuild", steps / double(std::max(1L, simulation->rebuilds() - rebuildsBefore)), "1"},
            {name + "BytesPerParticle", simulation->bytesPerParticle(), "bytes an owned particle, images and records included"}};
}

Figures twoThreads(const std::filesystem::path& caseFolder, const std::string& name, int stepsATurn, int turns)
{
    const PackedCase packed(caseFolder, false);
    double best[] = {1e9, 1e9}; // [s] a pass
    for (int turn = 0; turn < turns; ++turn)
        for (const int threads : {1, 2})
        {
            omp_set_num_threads(threads);
            const long before = packed.simulation->pairPassesRun();
            const double seconds = secondsOf([&] { packed.advance(stepsATurn); });
            double& known = best[threads - 1];
            known = std::min(known, seconds / double(packed.simulation->pairPassesRun() - before));
        }
    omp_set_num_threads(1);
    return {{name + "OnTwoThreads", best[0] / best[1], "1"}};
}

}
