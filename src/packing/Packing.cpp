#include "packing/Packing.hpp"
#include "geometry/components.hpp"
#include "geometry/crevice.hpp"
#include "geometry/makeWallLayers.hpp"
#include "packing/openFaces.hpp"
#include "packing/overFluid.hpp"
#include "parallel/reduce.hpp"
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

/// Places that are relaxed around what is filled [spacings]: what lies farther off has no part in it.
constexpr double relaxedAround = 10;
/// Share of the lattice in filled boxes below which places elsewhere are counted only.
constexpr double sparse = 0.125;

/// The cells of the lattice that fill rules put particles in.
std::vector<CellRange> filledCells(const PackingPlan& plan, const Lattice& lattice)
{
    if (plan.fill.empty()) return {lattice.all()};
    std::vector<CellRange> filled;
    double count = 0;
    for (const auto& rule : plan.fill)
        if (rule.phase != FillRule::noPhase)
            for (const auto& box : rule.region.within)
            {
                filled.push_back(lattice.cellsIn(box));
                count += double(lattice.count(filled.back()));
            }
    if (count > sparse * double(lattice.count(lattice.all()))) return {lattice.all()};
    return filled;
}

/// Whether a place of the lattice lies in a solid, in a crevice that no particle fits into, or in the fluid.
class Room
{
    const Geometry& g_;
    double narrowest_;

public:
    enum class At : char
    {
        solid,
        crevice,
        fluid
    };
    Room(const Geometry& g, double spacing) : g_(g), narrowest_(narrowestCrevice * spacing) {}
    At operator()(const Vector<3>& x) const
    {
        const double d = g_.distance(x);
        if (!(d > 0)) return At::solid;
        return 2 * d < narrowest_ && creviceAt(g_, g_.grid->near(x), x, narrowest_).width < narrowest_ ? At::crevice : At::fluid;
    }
};

/// Places of a lattice between the walls.
struct PlaceCount
{
    std::size_t fluid = 0, crevices = 0;
    PlaceCount operator+(const PlaceCount& other) const { return {fluid + other.fluid, crevices + other.crevices}; }
};

/// The places that may be filled.
struct Places
{
    Points points;
    Points around;  ///< beyond them, within reach of the kernel
    PlaceCount all; ///< wherever
};

/// The points that have room for a particle. `count` grows by them, and by those in crevices.
Points withRoom(const Room& room, const Points& points, PlaceCount& count)
{
    const long n = long(points.size());
    std::vector<Room::At> at(n);
#pragma omp parallel for schedule(static)
    for (long i = 0; i < n; ++i) at[i] = room(points[i]);
    Points inside;
    for (long i = 0; i < n; ++i)
    {
        if (at[i] == Room::At::fluid) inside.add(points[i]);
        count.crevices += at[i] == Room::At::crevice;
    }
    count.fluid += inside.size();
    return inside;
}

PlaceCount placesBetweenWalls(const Geometry& g, const Lattice& lattice, const Room& room)
{
    return overFluid<PlaceCount>(
        g, lattice.cells, lattice.all(), lattice.farthestOff(),
        [&](const CellRange& range) {
            return PlaceCount{lattice.count(range), 0};
        },
        [&](const std::array<long, 3>& cell, const Vector<3>&)
        {
            const auto at = lattice.holds(cell) ? room(lattice.particle(cell)) : Room::At::solid;
            return PlaceCount{std::size_t(at == Room::At::fluid), std::size_t(at == Room::At::crevice)};
        });
}

Places findPlaces(const PackingPlan& plan, const Lattice& lattice)
{
    const auto& g = plan.geometry;
    const auto filled = filledCells(plan, lattice);
    const Room room(g, plan.lattice.spacing);
    Places places;
    if (filled == std::vector{lattice.all()}) places.points = withRoom(room, lattice.points(), places.all);
    else
    {
        const auto moving = lattice.grown(filled, plan.relaxation ? relaxedAround * plan.lattice.spacing : 0);
        const auto seen = lattice.grown(moving, plan.support + plan.lattice.spacing);
        PlaceCount ofThese;
        places.points = withRoom(room, lattice.points(moving), ofThese);
        places.around = withRoom(room, lattice.points(seen, moving), ofThese);
        places.all = placesBetweenWalls(g, lattice, room);
    }
    if (places.all.fluid == 0)
        throw CaseError(plan.spacingAt, fmt::format("no particle of spacing {:g} m fits between the walls: the domain from {} to {} has "
                                                    "no fluid, or its gaps are narrower than the spacing",
                                                    plan.lattice.spacing, text(g.low), text(g.high)));
    return places;
}

template<int dim> RelaxationResult relaxIn(const PackingPlan& plan, double V0, const Points& around, Points& points, bool correctsPockets)
{
    const double spacing = plan.lattice.spacing;
    const Kernel<dim> kernel(plan.kernel, plan.support);
    RelaxationSettings atRest;
    atRest.steps = 0;
    if (!plan.relaxation) return relax<dim>(plan.geometry, kernel, V0, spacing, atRest, around, points);
    auto closed = closedBy(openFaces(plan.geometry, spacing), plan.geometry);
    Diagnostics ofLayers; // there are none of planes
    if (!closed.layers.empty()) closed.layers = makeWallLayers(closed, plan.support, spacing, ofLayers);
    auto settings = *plan.relaxation;
    settings.correctsPockets = correctsPockets;
    return relax<dim>(closed, kernel, V0, spacing, settings, around, points);
}

/// Relaxes, and again where sealed pockets have got or lost particles, so many times at most.
constexpr int mostRelaxations = 5;

/// `places` becomes their number by then; the volume of a particle is that of the fluid, `volume` [m^dim], over it. The results are of the last relaxation, but for what was before and for sums.
RelaxationResult relaxAll(const PackingPlan& plan, double volume, std::size_t& places, const Points& around, Points& points)
{
    RelaxationResult all;
    for (int k = 1;; ++k)
    {
        const double V0 = volume / double(places);
        const bool mayCorrect = k < mostRelaxations;
        auto one = plan.geometry.dimension == 3 ? relaxIn<3>(plan, V0, around, points, mayCorrect)
                                                : relaxIn<2>(plan, V0, around, points, mayCorrect);
        places += one.sealed.added - one.sealed.takenOut;
        const bool isLast = one.sealed.added + one.sealed.takenOut == 0;
        if (k > 1)
        {
            one.before = all.before;
            one.steps += all.steps;
            one.centreOfMassDrift += all.centreOfMassDrift;
            one.sealed = {std::max(all.sealed.pockets, one.sealed.pockets), all.sealed.added + one.sealed.added,
                          all.sealed.takenOut + one.sealed.takenOut};
        }
        all = std::move(one);
        if (isLast) return all;
    }
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

void checkDistances(const PackingPlan& plan, const RelaxationResult& relaxation, const Points& points)
{
    const auto& [i, j] = relaxation.closest;
    const double r = relaxation.closestPair;
    if (r < coincidence * plan.lattice.spacing)
        throw CaseError(plan.latticeAt, fmt::format("particles overlap: {:.3g} spacings between {} and {}. Use less jitter, or relax",
                                                    r / plan.lattice.spacing, text(points[i]), text(points[j])));
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

/// Places of a third phase stay with it: the share is one of the whole void space all the same.
void share(Saturation saturation, const Geometry& g, const Points& places, Occupation& o)
{
    const auto shared = [&](int phase) { return phase == saturation.phase || phase == saturation.gas; };
    Points filled;
    std::size_t all = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        if (shared(o.phase[i])) filled.add(places[i]);
        all += o.phase[i] != FillRule::noPhase || saturation.gas == Saturation::noGas;
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
    if (packing.points.size() == 0 && !plan.allowEmpty)
        throw CaseError({"system/packParticlesDict", 0}, "all regions together hold no particles");
}
}

Packing pack(const PackingPlan& plan)
{
    const auto& g = plan.geometry;
    Packing packing;
    const Box box = fluidBox(g);
    checkSpacing(plan, box);
    packing.balls = ballsInCell(g);
    const Lattice lattice(plan.lattice, g.dimension, box, g.periodic);
    packing.layers = lattice.layers;
    packing.fittedSpacing = lattice.fittedSpacing;
    auto [relaxed, around, allPlaces] = findPlaces(plan, lattice);
    packing.volume = fluidVolume(g, plan.lattice.spacing / 4);
    packing.inCrevices = allPlaces.crevices;
    packing.shareOfCrevices = double(allPlaces.crevices) / double(allPlaces.fluid + allPlaces.crevices);
    const Vector<3> length = box.high - box.low;
    packing.porosity = packing.volume.value / (length.x * length.y * (g.dimension == 3 ? length.z : 1));

    packing.relaxation = relaxAll(plan, packing.volume.value, allPlaces.fluid, around, relaxed);
    packing.particleVolume = packing.volume.value / double(allPlaces.fluid);
    checkDistances(plan, packing.relaxation, relaxed);
    checkRelaxation(plan, packing.relaxation);

    auto occupation = occupy(plan, relaxed);
    if (plan.saturation) share(*plan.saturation, g, relaxed, occupation);

    for (const auto& [i, residual] : packing.relaxation.crowded)
    {
        if (occupation.phase[i] == FillRule::noPhase) continue;
        ++packing.crowd.particles;
        if (residual <= packing.crowd.residual) continue;
        packing.crowd.residual = residual;
        packing.crowd.at = relaxed[i];
    }

    const bool pressed =
        plan.pressure || std::any_of(plan.fill.begin(), plan.fill.end(), [](const FillRule& rule) { return rule.p.has_value(); });
    for (std::size_t i = 0; i < relaxed.size(); ++i)
    {
        const int phase = occupation.phase[i];
        if (phase == FillRule::noPhase) continue;
        const double rho = plan.phases[phase].rho, mass = rho * packing.particleVolume;
        packing.points.add(relaxed[i]);
        packing.phase.push_back(phase);
        packing.rho.push_back(rho);
        packing.mass.push_back(mass);
        if (pressed) packing.p.push_back(occupation.p[i] ? *occupation.p[i] : plan.pressure ? (*plan.pressure)(relaxed[i]) : 0);
        const Vector<3> U = occupation.U[i] ? *occupation.U[i] : plan.velocity ? (*plan.velocity)(relaxed[i]) : Vector<3>{};
        if (g.dimension == 2 && U.z != 0)
            throw CaseError({"system/packParticlesDict", 0},
                            fmt::format("in 2-D the z component of a velocity must be 0, found {} at {}", U.z, text(relaxed[i])));
        packing.velocity.add(U);
    }
    packing.leftEmpty = allPlaces.fluid - packing.points.size();
    packing.phases = groupSums(
        packing.points.size(), plan.phases.size(), [&](std::size_t i) { return std::size_t(packing.phase[i]); },
        [&](std::size_t i) {
            return PackedPhase{1, packing.mass[i]};
        });
    checkPhases(plan, packing);
    if (plan.saturation)
    {
        const std::size_t empty = plan.saturation->gas == Saturation::noGas ? packing.leftEmpty : 0;
        packing.saturation = double(packing.phases[plan.saturation->phase].particles) / double(packing.points.size() + empty);
    }
    return packing;
}

}
