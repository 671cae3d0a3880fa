#include "models/gas/GasBand.hpp"
#include "models/gas/AmbientGas.hpp"
#include "parallel/reduce.hpp"
#include "scene/flowLimit.hpp"
#include "scene/slowDown.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace sph
{

namespace
{
/// Distances [spacings].
constexpr double leastGapOfStanding = 0.9, leastGapOfMoving = 0.6; ///< of gas that joins, to what is there
constexpr double leastGapWithin = 0.45; ///< of gas that comes to stand, to what stands there: with 0.6 and 0.8 the gas before it is stirred
constexpr double hysteresis = 1;        ///< by which gas goes and stands farther out than it joins and moves
constexpr double mostFree = 3;          ///< of the gas beside the liquid that is not ambient
constexpr int cellsOfBlock = 4;         ///< along each side, of what is kept from being crowded or sparse
constexpr double mostOff = 0.75;        ///< particles of a block, too many or too few
/// Share of the way from free to standing gas from which on blocks are kept so: what joins or goes nearer to the liquid leaves a jump of the pressure.
constexpr double keptFrom = 0.4;
}

template<int dim>
GasBand<dim>::GasBand(Particles<dim>& particles, const Numbers& restored, std::size_t gas, double width, const SceneEnds& ends)
    : map_(particles.geometry(), particles.coefficients().spacing, ends),
      gas_(gas),
      spacing_(particles.coefficients().spacing),
      width_(width * particles.coefficients().support / spacing_),
      widthOfMotion_(width_ - particles.coefficients().support / spacing_),
      freeWidth_(std::min(mostFree, widthOfMotion_ - 1)),
      restVolume_(std::pow(spacing_, dim)),
      solvesPressure_(particles.settings().integration.solvesPressure),
      hasOpenings_(bool(ends.nearest))
{
    const auto restore = [&](const char* name, auto& value)
    {
        if (const auto found = restored.find(name); found != restored.end()) value = found->second;
    };
    restore("gasJoined", joined_);
    restore("gasGone", gone_);
    restore("gasAtStart", start_);
}

template<int dim> void GasBand<dim>::save(Numbers& numbers) const
{
    numbers["gasJoined"] = joined_;
    numbers["gasGone"] = gone_;
    if (start_) numbers["gasAtStart"] = *start_;
}

template<int dim> std::vector<Stage<dim>> GasBand<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::exchange)
        return {{"follow the liquid", "gas joins within the band, and goes beyond it",
                 [this](Particles<dim>& p, const Substep&) { exchange(p); }}};
    if (place == JoinPoint::sorted)
        return {{"find standing gas", "gas in the outer support of the band", [this](Particles<dim>& p, const Substep&) { hold(p); }}};
    if (place == JoinPoint::afterEvaluation)
        return {{"hold standing gas", "dU/dt = 0 of it",
                 [this](Particles<dim>& p, const Substep&)
                 {
                     const auto a = p.store().pointers(Acceleration{});
                     const double* const ambient = p.store().component(Ambient::info.name, 0);
#pragma omp parallel for schedule(static)
                     for (std::size_t i = 0; i < p.size(); ++i)
                         for (int c = 0; c < dim; ++c) a[c][i] = ambient[i] == Ambient::stands ? 0 : a[c][i];
                     knowsVolumes_ = true;
                 }}};
    if (place == JoinPoint::afterKick)
        return {{"slow gas",
                 fmt::format("v /= 1 + 0.03 s^2 dt (p_b/rho_0)^(1/2)/dx of ambient gas{}",
                             solvesPressure_ ? "; |v| of gas at most 0.9 of what flow allows for this step, or that of the liquid" : ""),
                 [this](Particles<dim>& p, const Substep& step) { slow(p, step.deltaT); }}};
    if (place == JoinPoint::solve && solvesPressure_)
        return {{"soften gas", "(1 - s) dp/drho of ambient gas; what stands is left out of the products",
                 [](Particles<dim>& p, const Substep&)
                 {
                     const double* const ambient = p.store().component(Ambient::info.name, 0);
                     double* const stiffness = p.store().component(VolumeStiffness::info.name, 0);
#pragma omp parallel for schedule(static)
                     for (std::size_t i = 0; i < p.size(); ++i) stiffness[i] *= 1 - Ambient::share(ambient[i]);
                 }}};
    return {};
}

/// What particles are, until the store is resized.
template<int dim> struct GasBand<dim>::Kinds
{
    double gas;
    const double *phase, *holder, *state; ///< no holder without openings

    Kinds(const GasBand& band, const FieldStore<dim>& store)
        : gas(double(band.gas_)),
          phase(store.component(Phase::info.name, 0)),
          holder(band.hasOpenings_ ? store.component(Holder::info.name, 0) : nullptr),
          state(store.component(Ambient::info.name, 0))
    {}
    bool isGas(std::size_t i) const { return phase[i] == gas; }
    /// Whether an opening holds it.
    bool isHeld(std::size_t i) const { return holder && holder[i] > 0; }
    double ambient(std::size_t i) const { return state[i]; }
};

template<int dim> void GasBand<dim>::slow(Particles<dim>& particles, double deltaT) const
{
    auto& store = particles.store();
    const Kinds kinds(*this, store);
    const auto& k = particles.coefficients();
    const double rate = 0.03 * std::sqrt(std::max(0.0, k.backgroundPressure) / k.restDensity[gas_]) / spacing_;
    slowDown(particles, deltaT, [&](std::size_t i, double) { return 1 / (1 + deltaT * rate * sqr(Ambient::share(kinds.ambient(i)))); });
    if (!solvesPressure_) return;
    const auto v = store.pointers(Velocity{});
    const double ofLiquid = most(particles.size(), [&](std::size_t i) { return kinds.isGas(i) ? 0 : mag(valueAt<Vector<dim>>(v, i)); });
    const double fastest = std::max(0.9 * wayByFlow(particles.settings().integration.factors, k.support) / deltaT, ofLiquid);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        if (!kinds.isGas(i) || kinds.isHeld(i)) continue;
        // Accelerations stay as they are: the limit by force is that of what acts.
        if (const double speed = mag(valueAt<Vector<dim>>(v, i)); speed > fastest)
            for (int c = 0; c < dim; ++c) v[c][i] *= fastest / speed;
    }
}

template<int dim> void GasBand<dim>::hold(Particles<dim>& particles) const
{
    const double* const ambient = particles.store().component(Ambient::info.name, 0);
    std::vector<int> held;
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (ambient[i] == Ambient::stands) held.push_back(int(i));
    particles.hold(*this, std::move(held));
}

template<int dim> void GasBand<dim>::mark(Particles<dim>& particles, std::size_t begin, std::size_t end) const
{
    auto& store = particles.store();
    const auto x = store.pointers(Position{});
    const Kinds kinds(*this, store);
    double* const ambient = store.component(Ambient::info.name, 0);
    std::vector<double*> velocities;
    for (const auto& name :
         {std::string(Velocity::info.name), Evolving{stateField(Velocity{})}.startName(), incrementOf(stateField(Velocity{}))})
        for (int c = 0; store.has(name) && c < dim; ++c) velocities.push_back(store.component(name, c));
#pragma omp parallel for schedule(static)
    for (std::size_t i = begin; i < end; ++i)
    {
        const auto cell = map_.cellOf(in3D(valueAt<Vector<dim>>(x, i)));
        const double outwards = Ambient::isMoving(ambient[i]) ? widthOfMotion_ + hysteresis : widthOfMotion_,
                     d = std::sqrt(map_.squaredDistance(cell));
        ambient[i] = !kinds.isGas(i) || kinds.isHeld(i) || map_.isEnclosed(cell) ? 0
                     : d > outwards                                              ? Ambient::stands
                                    : Ambient::moving(std::clamp((d - freeWidth_) / (widthOfMotion_ - freeWidth_), 0.0, 1.0));
        if (ambient[i] == Ambient::stands)
            for (double* v : velocities) v[i] = 0;
    }
}

template<int dim> void GasBand<dim>::exchange(Particles<dim>& particles)
{
    auto& store = particles.store();
    std::size_t owned = particles.size();
    map_.clear();
    {
        const auto x = store.pointers(Position{});
        const Kinds kinds(*this, store);
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < owned; ++i)
            if (!kinds.isGas(i)) map_.mark(in3D(valueAt<Vector<dim>>(x, i)));
    }
    if (particles.movingWalls().any()) map_.findPlaces();
    map_.measure(width_ + hysteresis);
    mark(particles, 0, owned); // before anything goes: an exchange at the same positions, as a restart makes it, then changes nothing
    const std::size_t kept = remove(store, owned);
    owned = join(particles, kept);
    mark(particles, kept, owned);
    particles.setSize(owned);

    const double* const m = store.component(Mass::info.name, 0);
    const Kinds kinds(*this, store);
    now_ = count(owned, [&](std::size_t i) { return kinds.isGas(i); });
    mass_ = sum(owned, [&](std::size_t i) { return kinds.isGas(i) ? m[i] : 0.0; });
    if (!start_) start_ = mass_ - joined_ + gone_;
}

/// Particles of each cell, as chains.
template<int dim> struct GasBand<dim>::Chains
{
    const LiquidMap& map;
    std::vector<int>& first;
    std::vector<int> next, inCell; ///< of each particle
    std::array<const double*, dim> x;

    /// `room` is for `first`.
    Chains(const LiquidMap& cells, const FieldStore<dim>& store, std::size_t owned, std::vector<int>& room)
        : map(cells), first(room), next(owned), inCell(owned), x(store.pointers(Position{}))
    {
        first.assign(map.cells(), -1);
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < owned; ++i) inCell[i] = int(map.cellOf(at(i)));
        for (std::size_t i = 0; i < owned; ++i) next[i] = std::exchange(first[cellOf(i)], int(i));
    }
    std::size_t cellOf(std::size_t i) const { return std::size_t(inCell[i]); }
    Vector<3> at(std::size_t i) const { return in3D(valueAt<Vector<dim>>(x, i)); }
    /// Whether a particle of which `counts(j)` holds is nearer to a place than `gap`, a cell's width at most [m].
    bool anyWithin(const Vector<3>& place, double gap, const auto& counts) const
    {
        return map.anyWithin(place, gap,
                             [&](std::size_t cell)
                             {
                                 for (int j = first[cell]; j >= 0; j = next[std::size_t(j)])
                                     if (counts(std::size_t(j)) && map.distance(at(std::size_t(j)), place) < gap) return true;
                                 return false;
                             });
    }
    bool anyWithin(const Vector<3>& place, double gap) const
    {
        return anyWithin(place, gap, [](std::size_t) { return true; });
    }
    /// Distance of the nearest particle from a place, at most `reach`, a cell's width at most [m].
    double gap(const Vector<3>& place, double reach) const
    {
        double nearest = reach;
        map.forEachAround(map.cellOf(place),
                          [&](std::size_t cell)
                          {
                              for (int j = first[cell]; j >= 0; j = next[std::size_t(j)])
                                  nearest = std::min(nearest, map.distance(at(std::size_t(j)), place));
                          });
        return nearest;
    }
};

template<int dim> std::size_t GasBand<dim>::remove(FieldStore<dim>& store, std::size_t owned)
{
    const double* const m = store.component(Mass::info.name, 0);
    const Kinds kinds(*this, store);
    const Chains chains(map_, store, owned, room_);
    const auto isPressed = [&](std::size_t i, const auto& counts)
    {
        return chains.anyWithin(chains.at(i), leastGapWithin * spacing_,
                                [&](std::size_t j) { return j != i && kinds.ambient(j) == Ambient::stands && counts(j); });
    };
    // Who goes of those that are pressed against one another hangs on who went before, in the order of their numbers. All threads find the few that it may be.
    enum : std::uint8_t
    {
        stays,
        mayGo,
        isGoing
    };
    std::vector<std::uint8_t> fate(owned, stays), goes(owned, 0);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < owned; ++i)
    {
        if (!kinds.isGas(i)) continue;
        const auto cell = chains.cellOf(i);
        const int d = map_.squaredDistance(cell);
        if (map_.isEnclosed(cell) && !kinds.isHeld(i)) continue;
        if (d > sqr(width_ + hysteresis)) fate[i] = isGoing;
        else if (kinds.ambient(i) > 0 && d > sqr(widthOfMotion_ - 1) && !kinds.isHeld(i) && isPressed(i, [](std::size_t) { return true; }))
            fate[i] = mayGo;
    }
    for (std::size_t i = 0; i < owned; ++i)
        goes[i] = fate[i] == isGoing || (fate[i] == mayGo && isPressed(i, [&](std::size_t j) { return !goes[j]; }));
    // Of a block whose particles are too many for the volume that they fill, the most crowded go.
    for (auto& [block, gas] : blocks(store, chains, owned))
    {
        std::ranges::sort(gas.byVolume);
        const auto tooMany = std::size_t(std::max(0.0, gas.excess + 1 - mostOff));
        for (std::size_t k = 0; k < std::min(tooMany, gas.byVolume.size()); ++k) goes[std::size_t(gas.byVolume[k].second)] = 1;
    }
    std::vector<int> kept;
    kept.reserve(owned);
    double gone = 0;
    for (std::size_t i = 0; i < owned; ++i)
        if (!goes[i]) kept.push_back(int(i));
        else if (!kinds.isHeld(i)) gone += m[i];
    gone_ += ofAllRanks(gone, 0.0, Add{});
    if (kept.size() == owned)
    {
        store.resize(owned); // without images, in whose place something may join
        return owned;
    }
    // Volumes are asked for below, and no state.
    double* const V = store.component(Volume::info.name, 0);
    for (std::size_t k = 0; k < kept.size(); ++k) V[k] = V[std::size_t(kept[k])];
    store.sortState(kept);
    store.resize(kept.size());
    return kept.size();
}

/// Those of the cells whose centres have no particle nearer than `gap` spacings, on any rank.
template<int dim>
std::vector<std::size_t> GasBand<dim>::clear(const std::vector<std::size_t>& cells, const Chains& chains, double gap) const
{
    std::vector<std::uint8_t> taken(cells.size());
#pragma omp parallel for schedule(static)
    for (std::size_t q = 0; q < cells.size(); ++q) taken[q] = chains.anyWithin(map_.centre(cells[q]), gap * spacing_);
    taken = ofAllRanks(taken, std::vector<std::uint8_t>(taken.size(), 0), AddEach{});
    std::vector<std::size_t> all;
    for (std::size_t q = 0; q < cells.size(); ++q)
        if (!taken[q]) all.push_back(cells[q]);
    return all;
}

template<int dim> std::vector<std::size_t> GasBand<dim>::bareCells(const Chains& chains) const
{
    std::vector<std::size_t> candidates;
    for (std::size_t c = 0; c < map_.cells(); ++c)
        if (const int d = map_.squaredDistance(c);
            map_.isHeldUnseen(c) ? d > 1 && d <= sqr(width_)
                                 : map_.isRoom(c) && d > sqr(widthOfMotion_) && (map_.isEnclosed(c) ? map_.isClosing(c) : d <= sqr(width_)))
            candidates.push_back(c);
    return clear(candidates, chains, leastGapOfStanding);
}

/// The widest gaps beside the particles of the largest volumes, of each block whose particles are too few for the volume that they fill; no two beside one another.
template<int dim>
std::vector<std::size_t> GasBand<dim>::sparseCells(const FieldStore<dim>& store, const Chains& chains, std::size_t owned) const
{
    std::vector<std::uint8_t> chosen(map_.cells(), 0);
    const auto isBeside = [&](std::size_t cell)
    {
        bool beside = false;
        map_.forEachAround(cell, [&](std::size_t other) { beside = beside || chosen[other]; });
        return beside;
    };
    const auto widestBeside = [&](std::size_t i)
    {
        double widest = leastGapOfMoving * spacing_;
        std::optional<std::size_t> best;
        map_.forEachAround(chains.cellOf(i),
                           [&](std::size_t cell)
                           {
                               if (!map_.isRoom(cell) || map_.squaredDistance(cell) <= 1 || isBeside(cell)) return;
                               if (const double gap = chains.gap(map_.centre(cell), spacing_); gap > widest)
                               {
                                   widest = gap;
                                   best = cell;
                               }
                           });
        return best;
    };
    for (auto& [block, gas] : blocks(store, chains, owned))
    {
        auto tooFew = std::size_t(std::max(0.0, -gas.excess + 1 - mostOff));
        if (tooFew == 0) continue;
        std::ranges::sort(gas.byVolume, std::greater{});
        for (std::size_t k = 0; tooFew > 0 && k < gas.byVolume.size(); ++k)
            if (const auto cell = widestBeside(std::size_t(gas.byVolume[k].second)))
            {
                chosen[*cell] = 1;
                --tooFew;
            }
    }
    const auto ofAll = ofAllRanks(chosen, std::vector<std::uint8_t>(chosen.size(), 0), AddEach{});
    std::ranges::fill(chosen, 0);
    std::vector<std::size_t> cells;
    for (std::size_t c = 0; c < ofAll.size(); ++c)
        if (ofAll[c] && !isBeside(c))
        {
            chosen[c] = 1;
            cells.push_back(c);
        }
    return clear(cells, chains, leastGapOfMoving);
}

template<int dim>
auto GasBand<dim>::blocks(const FieldStore<dim>& store, const Chains& chains, std::size_t owned) const -> std::map<std::size_t, Block>
{
    std::map<std::size_t, Block> all;
    if (!knowsVolumes_) return all;
    const Kinds kinds(*this, store);
    const double* const V = store.component(Volume::info.name, 0);
    for (std::size_t i = 0; i < owned; ++i)
    {
        if (!Ambient::isMoving(kinds.ambient(i)) || kinds.isHeld(i)) continue;
        const auto cell = chains.cellOf(i);
        if (map_.squaredDistance(cell) <= sqr(freeWidth_ + keptFrom * (widthOfMotion_ - freeWidth_))) continue;
        auto& block = all[map_.blockOf(cell, cellsOfBlock)];
        block.excess += 1 - V[i] / restVolume_;
        block.byVolume.emplace_back(V[i] / restVolume_, int(i));
    }
    return all;
}

/// What joins is at rest, and has the mean of the gas in all else that it carries. The first rank lets it in.
template<int dim> std::size_t GasBand<dim>::join(Particles<dim>& particles, std::size_t owned)
{
    auto& store = particles.store();
    const auto& settings = particles.settings();
    std::vector<std::size_t> cells;
    {
        const Chains chains(map_, store, owned, room_);
        const auto bare = bareCells(chains), sparse = sparseCells(store, chains, owned);
        cells = bare;
        std::ranges::set_difference(sparse, bare, std::back_inserter(cells)); // a gap beside moving gas may be a bare cell
    }
    if (cells.empty()) return owned;

    std::map<std::string, double> values;
    const Kinds kinds(*this, store);
    for (const auto& evolving : settings.state)
    {
        const auto& name = evolving.value.name;
        if (evolving.value.in(dim) != 1) continue;
        if (name == Mass::info.name) values[name] = settings.coefficients.restDensity[gas_] * restVolume_;
        else if (name == Phase::info.name) values[name] = double(gas_);
        else if (name != Ambient::info.name)
        {
            const double* const q = store.component(name, 0);
            const auto all = count(owned, [&](std::size_t i) { return kinds.isGas(i); });
            values[name] = all == 0 ? 0 : sum(owned, [&](std::size_t i) { return kinds.isGas(i) ? q[i] : 0.0; }) / double(all);
        }
    }
    joined_ += double(std::ranges::count_if(cells, [&](std::size_t c) { return map_.isRoom(c); })) * values.at(Mass::info.name);
    if (!isFirstRank()) return owned;
    store.resize(owned + cells.size()); // what is new is 0
    const auto x = store.pointers(Position{});
    for (std::size_t q = 0; q < cells.size(); ++q)
    {
        const std::size_t i = owned + q;
        sph::store(in<dim>(map_.centre(cells[q])), [&](int c, double value) { x[c][i] = value; });
        for (const auto& [name, value] : values) store.component(name, 0)[i] = value;
        if (hasOpenings_) store.component(Holder::info.name, 0)[i] = map_.isRoom(cells[q]) ? 0 : Holder::unknown;
        for (const auto& evolving : settings.state)
            for (int c = 0; store.has(evolving.startName()) && c < evolving.value.in(dim); ++c)
                store.component(evolving.startName(), c)[i] = store.component(evolving.value.name, c)[i];
    }
    return owned + cells.size();
}

template<int dim> std::string GasBand<dim>::introduction() const
{
    std::size_t leftOut = 0;
    for (std::size_t c = 0; c < map_.cells(); ++c)
        leftOut += map_.isRoom(c) && !map_.isEnclosed(c) && map_.squaredDistance(c) > sqr(width_);
    return fmt::format("Gas       : {} particles within {:.3g} spacings of the liquid, standing still beyond {:.3g}; about {} left out\n",
                       now_, width_, widthOfMotion_, leftOut);
}

template<int dim> std::string GasBand<dim>::report(const Particles<dim>&) const
{
    const double before = start_.value_or(0) + joined_ - gone_;
    return fmt::format("gas: {} particles, {:.4g} kg joined, {:.4g} kg gone{}{}\n", now_, joined_, gone_,
                       hasOpenings_ ? "" : fmt::format(", balance off by {:.2g}", mass_ > 0 ? std::fabs(mass_ - before) / mass_ : 0.0),
                       map_.pockets() > 0 ? fmt::format(", {} enclosed", map_.pockets()) : "");
}

template class GasBand<2>;
template class GasBand<3>;

}
