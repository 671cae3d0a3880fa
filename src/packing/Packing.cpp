#include "Packing.hpp"
#include "components.hpp"
#include "openFaces.hpp"
#include "reduce.hpp"
#include "wallLayers.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// Particles nearer than this, in spacings, are one particle twice: no kernel sum can tell them apart.
constexpr double coincidence = 0.05;

/// Scatter of the kernel residual, and mean below 0, up to which a relaxation is good, whatever it began with.
constexpr double goodResidual = 0.01;

std::string text(const Vector<3>& a) { return fmt::format("({:.6g} {:.6g} {:.6g})", a.x, a.y, a.z); }

void checkSpacing(const PackingPlan& plan, const Box& box)
{
    const auto& g = plan.geometry;
    const double spacing = plan.lattice.spacing;
    for (int k = 0; k < g.dimension; ++k)
    {
        const double gap = box.high.*component(k) - box.low.*component(k);
        if (!(gap > 0))
            throw CaseError(plan.spacingAt, fmt::format("the walls leave no fluid along {}: see constant/geometry", coordinateNames[k]));
        if (spacing > gap * (1 + 1e-6))
            throw CaseError(plan.spacingAt,
                            fmt::format("spacing {:g} m is larger than the gap of {:g} m along {}", spacing, gap, coordinateNames[k]));
    }
}

Points placesBetweenWalls(const PackingPlan& plan, const Box& box, Packing& packing)
{
    auto lattice = makeLattice(plan.lattice, plan.geometry.dimension, box, plan.geometry.periodic);
    packing.layers = lattice.layers;
    packing.fittedSpacing = lattice.fittedSpacing;
    const long n = long(lattice.points.size());
    std::vector<char> isFluid(n);
#pragma omp parallel for schedule(static)
    for (long i = 0; i < n; ++i) isFluid[i] = plan.geometry.distance(lattice.points[i]) > 0;

    Points places;
    for (long i = 0; i < n; ++i)
        if (isFluid[i]) places.add(lattice.points[i]);
    if (places.size() == 0)
        throw CaseError(plan.spacingAt, fmt::format("no particle of spacing {:g} m fits between the walls: the domain from {} to {} has "
                                                    "no fluid, or its gaps are narrower than the spacing",
                                                    plan.lattice.spacing, text(plan.geometry.low), text(plan.geometry.high)));
    return places;
}

template<int dim> RelaxationResult relaxIn(const PackingPlan& plan, double V0, Points& points)
{
    const double spacing = plan.lattice.spacing;
    const Kernel<dim> kernel(plan.kernel, plan.support);
    RelaxationSettings atRest;
    atRest.steps = 0;
    if (!plan.relaxation) return relax<dim>(plan.geometry, kernel, V0, spacing, atRest, points);
    auto closed = closedBy(openFaces(plan.geometry, spacing), plan.geometry);
    Diagnostics ofLayers; // there are none of planes
    if (!closed.layers.empty()) closed.layers = makeWallLayers(closed, plan.support, spacing, ofLayers);
    return relax<dim>(closed, kernel, V0, spacing, *plan.relaxation, points);
}

void checkRelaxation(const PackingPlan& plan, const RelaxationResult& relaxation)
{
    const auto &before = relaxation.before.overall, &after = relaxation.after.overall;
    const bool uneven = after.scatter > goodResidual && after.scatter > before.scatter,
               thin = after.mean < -goodResidual && after.mean < before.mean;
    if (!uneven && !thin) return;
    throw CaseError(
        plan.relaxAt,
        fmt::format("the relaxation makes the packing worse: in {} steps the scatter of the kernel sums went from {:.3g} to "
                    "{:.3g}, their mean from {:+.3g} to {:+.3g}. The walls leave no room for an even packing at a spacing of "
                    "{:g} m, or its steps are too long: choose a finer spacing, the default bias and coefficient, or leave `relax` out",
                    relaxation.steps, before.scatter, after.scatter, before.mean, after.mean, plan.lattice.spacing));
}

void checkDistances(const PackingPlan& plan, const Packing& packing)
{
    const auto& [i, j] = packing.relaxation.closest;
    const double r = packing.relaxation.closestPair;
    if (r < coincidence * plan.lattice.spacing)
        throw CaseError(plan.latticeAt, fmt::format("particles overlap: {:.3g} spacings between {} and {}. Use less jitter, or relax",
                                                    r / plan.lattice.spacing, text(packing.points[i]), text(packing.points[j])));
}

/// The phase of each place, and the velocity and pressure that a rule gives.
struct Occupation
{
    std::vector<int> phase;
    std::vector<const Vector<3>*> U;
    std::vector<const double*> p;
};

Occupation occupy(const PackingPlan& plan, const Points& places)
{
    const std::size_t n = places.size();
    Occupation o{std::vector<int>(n, plan.fill.empty() ? 0 : FillRule::noPhase), std::vector<const Vector<3>*>(n, nullptr),
                 std::vector<const double*>(n, nullptr)};
    for (std::size_t i = 0; i < n; ++i)
        for (const auto& rule : plan.fill)
            if (rule.region(places[i]))
            {
                o.phase[i] = rule.phase;
                if (rule.U) o.U[i] = &*rule.U;
                if (rule.p) o.p[i] = &*rule.p;
            }
    return o;
}

/// What holds a third phase keeps it: the share is one of the whole void space all the same.
void share(Saturation saturation, const Geometry& g, const Points& places, Occupation& o)
{
    const auto shared = [&](int phase) { return phase == saturation.phase || phase == saturation.gas; };
    Points filled;
    std::size_t all = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        if (shared(o.phase[i])) filled.add(places[i]);
        all += o.phase[i] != FillRule::noPhase;
    }
    const double left = double(filled.size()) / double(std::max<std::size_t>(1, all));
    if (saturation.value > left)
        throw CaseError(saturation.where,
                        fmt::format("a saturation of {:g} is more than the {:.4g} that other phases leave", saturation.value, left));
    if (left > 0) saturation.value /= left;
    const auto holds = place(saturation, g, filled);
    std::size_t k = 0;
    for (auto& phase : o.phase)
        if (shared(phase)) phase = holds[k++] ? saturation.phase : saturation.gas;
}

void checkPhases(const PackingPlan& plan, const Packing& packing)
{
    Diagnostics errors;
    for (std::size_t k = 0; k < plan.phases.size(); ++k)
        if (packing.phases[k].particles == 0 && !plan.allowEmpty)
            errors.error(plan.phases[k].where, fmt::format("phase {} has no particles: no region of system/packParticlesDict puts it "
                                                           "anywhere. If that is meant, write there: allowEmpty yes;",
                                                           plan.phases[k].name));
    errors.throwIfAny();
    if (packing.points.size() == 0) throw CaseError({"system/packParticlesDict", 0}, "all regions together hold no particles");
}
}

Packing pack(const PackingPlan& plan)
{
    const auto& g = plan.geometry;
    Packing packing;
    const Box box = fluidBox(g);
    checkSpacing(plan, box);
    packing.balls = ballsInCell(g);
    packing.points = placesBetweenWalls(plan, box, packing);
    packing.volume = fluidVolume(g, plan.lattice.spacing / 4);
    packing.particleVolume = packing.volume.value / double(packing.points.size());
    const Vector<3> length = box.high - box.low;
    packing.porosity = packing.volume.value / (length.x * length.y * (g.dimension == 3 ? length.z : 1));

    packing.relaxation = g.dimension == 3 ? relaxIn<3>(plan, packing.particleVolume, packing.points)
                                          : relaxIn<2>(plan, packing.particleVolume, packing.points);
    checkDistances(plan, packing);
    checkRelaxation(plan, packing.relaxation);

    auto occupation = occupy(plan, packing.points);
    if (plan.saturation) share(*plan.saturation, g, packing.points, occupation);

    const Points places = std::move(packing.points);
    packing.points = {};
    const bool pressed =
        plan.pressure || std::any_of(plan.fill.begin(), plan.fill.end(), [](const FillRule& rule) { return rule.p.has_value(); });
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const int phase = occupation.phase[i];
        if (phase == FillRule::noPhase) continue;
        const double rho = plan.phases[phase].rho, mass = rho * packing.particleVolume;
        packing.points.add(places[i]);
        packing.phase.push_back(phase);
        packing.rho.push_back(rho);
        packing.mass.push_back(mass);
        if (pressed) packing.p.push_back(occupation.p[i] ? *occupation.p[i] : plan.pressure ? (*plan.pressure)(places[i]) : 0);
        const Vector<3> U = occupation.U[i] ? *occupation.U[i] : plan.velocity ? (*plan.velocity)(places[i]) : Vector<3>{};
        if (g.dimension == 2 && U.z != 0)
            throw CaseError({"system/packParticlesDict", 0},
                            fmt::format("in 2-D the z component of a velocity must be 0, found {} at {}", U.z, text(places[i])));
        packing.velocity.add(U);
    }
    packing.leftEmpty = places.size() - packing.points.size();
    packing.phases = groupSums(
        packing.points.size(), plan.phases.size(), [&](std::size_t i) { return std::size_t(packing.phase[i]); },
        [&](std::size_t i) {
            return PackedPhase{1, packing.mass[i]};
        });
    checkPhases(plan, packing);
    if (plan.saturation) packing.saturation = double(packing.phases[plan.saturation->phase].particles) / double(packing.points.size());
    return packing;
}

}
