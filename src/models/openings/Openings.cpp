#include "Openings.hpp"
#include "CaseError.hpp"
#include "OpenPlanes.hpp"
#include "components.hpp"
#include "contains.hpp"
#include "forEachFoot.hpp"
#include "reduce.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{
/// Margin beyond twice the support, and beyond the support on either side of a plane, for the way of particles before lists are rebuilt [spacings].
constexpr double spareDepth = 1;
/// Lower bound of (rho/rho_0)^n, which a pressure far below 0 would make negative.
constexpr double leastRatio = 1e-3;
/// Least distance of a new buffer particle behind an outlet from those that stand there [spacings].
constexpr double leastGap = 0.8;

/// A particle that lies so near to a plane is on it, and in the scene [spacings].
constexpr double onPlane = 1e-6;

/// The plane that an opening is a part of, with all its parts: that from which it is cut out, or its own without the others; of a drip that is cut out of none,
/// all of the duct. None where the opening stands alone.
std::optional<Opening> planeOf(const Opening& opening, const std::vector<Opening>& all)
{
    const auto host = std::ranges::find_if(all, [&](const Opening& other) { return other.leavesOut(opening); });
    if (host == all.end() && opening.without.empty() && !opening.radius) return {};
    auto plane = host == all.end() ? opening : *host;
    plane.point = opening.point;
    plane.without.clear();
    plane.radius.reset();
    return plane;
}

/// Whether a line of an outlet moves inwards, so that it brings fluid back.
bool comesBack(double velocity) { return velocity > 0 && std::isfinite(velocity); }

/// The rate that an inlet is to let in [m^3/s]; none where a pressure alone drives it.
std::optional<double> rateOf(const Opening& opening, const Section& section)
{
    if (opening.flowRate) return opening.flowRate;
    if (opening.velocity) return *opening.velocity * section.area();
    return {};
}

template<int dim> void put(const std::array<double*, dim>& a, std::size_t i, Vector<dim> q)
{
    store(q, [&](int c, double value) { a[c][i] = value; });
}
}

template<int dim>
Openings<dim>::Openings(const std::vector<Opening>& openings, const Geometry& geometry, const Coefficients& coefficients,
                        const State& state, const std::map<std::string, double>& restored, int supports)
    : geometry_(geometry),
      coefficients_(coefficients),
      state_(state),
      phases_(coefficients.restDensity.size()),
      depth_(supports * coefficients.support + spareDepth * coefficients.spacing)
{
    for (const auto& evolving : state)
        if (!evolving.amount.empty())
        {
            counted_.push_back(&evolving);
            amountNames_.push_back(evolving.amount);
        }
    integrates_ = std::any_of(state.begin(), state.end(), [](const Evolving& q) { return q.value.name == Density::info.name; });
    marks_ = std::ranges::any_of(openings, [](const Opening& opening) { return opening.markFrom.has_value(); });
    startMass_.resize(phases_);
    startAmounts_.resize(counted_.size());
    intoHeld_.resize(counted_.size());
    for (const auto& opening : openings)
    {
        const auto plane = planeOf(opening, openings);
        const Section section(opening, geometry, coefficients.spacing, plane ? &*plane : nullptr);
        check(opening, section);
        const auto asked = rateOf(opening, section);
        const double most = asked.value_or(std::numeric_limits<double>::infinity()) / section.carried();
        const double pressure = coefficients.backgroundPressure + (opening.inlet ? 0 : *opening.pressure);
        const std::vector<double> none(phases_, 0.0), nothing(counted_.size(), 0.0);
        gates_.push_back({opening, plane.value_or(opening), section, asked, most, opening.inlet && !opening.pressure ? most : 0,
                          std::vector(phases_, pressure), none, none, nothing, densityOf(opening, section), 0, none,
                          std::vector(section.lines().size(), 0.0)});
        account_.gates.push_back({none, nothing});
    }
    account_.heldAmounts.resize(counted_.size());
    for (const auto& a : gates_)
        for (const auto& b : gates_)
            if (&a != &b && meet(a, b))
                throw CaseError(
                    b.opening.where,
                    fmt::format("opening \"{}\" overlaps \"{}\": the particles that one holds must be out of the other's sight, {:.4g} m "
                                "before its plane and {:.4g} m behind",
                                b.opening.name, a.opening.name, coefficients.support, depth_));
    for (const auto& gate : gates_) checkNormal(gate);
    restored_ = restored.contains(named("openingsStartMass", 0));
    auto wholeAccount = account_;
    eachNumber(*this, wholeAccount,
               [&](const std::string& name, double& value, bool)
               {
                   if (const auto found = restored.find(name); found != restored.end()) value = found->second;
               });
    if (isFirstRank()) account_ = wholeAccount;
}

template<int dim> std::string Openings<dim>::named(const std::string& name, std::size_t phase) const
{
    return phases_ == 1 ? name : name + "_" + coefficients_.phases[phase];
}

template<int dim> void Openings<dim>::eachNumber(auto& self, auto& account, const auto& visit)
{
    for (std::size_t k = 0; k < self.phases_; ++k) visit(self.named("openingsStartMass", k), self.startMass_[k], false);
    if (self.marks_) visit("openingsTime", self.time_, false);
    for (std::size_t q = 0; q < self.counted_.size(); ++q)
    {
        visit("openingsStart" + self.amountNames_[q], self.startAmounts_[q], false);
        visit("openingsHeld" + self.amountNames_[q], account.heldAmounts[q], false);
    }
    for (std::size_t g = 0; g < self.gates_.size(); ++g)
    {
        auto& gate = self.gates_[g];
        auto& passed = account.gates[g];
        const auto& name = gate.opening.name;
        for (std::size_t k = 0; k < self.phases_; ++k)
        {
            visit(self.named(name + "Mass", k), passed.mass[k], false);
            visit(self.named(name + "Taken", k), gate.taken[k], true);
            visit(self.named(name + "Pressure", k), gate.pressure[k], false);
            visit(self.named(name + "Slope", k), gate.slope[k], false);
        }
        for (std::size_t q = 0; q < self.counted_.size(); ++q)
        {
            visit(name + self.amountNames_[q], passed.amounts[q], false);
            visit(name + "Taken" + self.amountNames_[q], gate.takenAmounts[q], true);
        }
        visit(name + "Speed", gate.speed, false);
        visit(name + "Marked", passed.marked.mass, true);
        visit(name + "MarkedTime", passed.marked.time, true);
        visit(name + "MarkedSquare", passed.marked.square, true);
    }
}

template<int dim> std::map<std::string, double> Openings<dim>::state() const
{
    std::map<std::string, double> numbers;
    const auto whole = account();
    eachNumber(*this, whole,
               [&](const std::string& name, double value, bool unlessZero)
               {
                   if (value != 0 || !unlessZero) numbers[name] = value;
               });
    return numbers;
}

/// Rest density of the incoming fluid, the mean over the section [kg/m^3].
template<int dim> double Openings<dim>::densityOf(const Opening& opening, const Section& section) const
{
    const auto& rho = coefficients_.restDensity;
    if (opening.layers.empty()) return rho[opening.stream.phase];
    double sum = 0;
    for (const auto& line : section.lines()) sum += rho[opening.streamAt(line.foot, dim).phase];
    return sum / double(section.lines().size());
}

/// Whether a point lies in the domain, or within `beyond` of it.
template<int dim> bool Openings<dim>::inDomain(const Vector<3>& x, double beyond) const
{
    for (int k = 0; k < dim; ++k)
        if (const auto c = component(k); !geometry_.periodic[k] && (x.*c < geometry_.low.*c - beyond || x.*c > geometry_.high.*c + beyond))
            return false;
    return true;
}

template<int dim> void Openings<dim>::check(const Opening& opening, const Section& section) const
{
    const auto fail = [&](const std::string& what)
    { throw CaseError(opening.where, fmt::format("opening \"{}\" {}", opening.name, what)); };
    const auto& lines = section.lines();
    if (lines.empty()) fail("has no fluid in its plane: it lies inside a wall, or outside the domain");
    if (section.width() < coefficients_.support)
        fail(fmt::format(
            "is {:.4g} m wide, less than the support of the kernel, {:.4g} m: choose a spacing of at most {:.3g} m, or make it wider",
            section.width(), coefficients_.support, section.width() / coefficients_.support * coefficients_.spacing));
    for (const auto& line : lines)
        for (double s = 0; s < depth_; s += coefficients_.spacing)
        {
            const auto x = line.foot - s * opening.normal;
            if (!inDomain(x, coefficients_.support))
                fail(fmt::format("needs {:.4g} m of domain beyond its plane, for the particles that are held there",
                                 depth_ - coefficients_.support));
            if (geometry_.distance(x) < 0.2 * coefficients_.spacing)
                fail(fmt::format("has a wall at ({:.4g} {:.4g} {:.4g}): its duct must go on straight for {:.4g} m beyond the plane", x.x,
                                 x.y, x.z, depth_));
        }
    for (const auto& line : lines)
    {
        if (!opening.developed) break;
        const auto [foot, patch] = nearestFoot(geometry_, line.foot);
        if (foot.distance > coefficients_.spacing) continue;
        const auto& wall = geometry_.walls[std::size_t(geometry_.patches[std::size_t(patch)].wallAt(foot.region))];
        if (wall.slips)
            fail(fmt::format(
                "has the profile of developed flow between walls that hold the fluid, and wall \"{}\" slips: take profile uniform",
                wall.name));
    }
    for (std::size_t k = 0; k < opening.layers.size(); ++k)
        if (std::ranges::none_of(lines, [&](const auto& line) { return &opening.streamAt(line.foot, dim) == &opening.layers[k].stream; }))
            fail(fmt::format("has no fluid in the part {} of its layers: it lies outside of the section, or within the parts before it",
                             k + 1));
}

/// The normal points to the side on which the other openings are and where the scene is deeper than what is held outside of it.
template<int dim> void Openings<dim>::checkNormal(const Gate& gate) const
{
    const auto& opening = gate.opening;
    const auto fail = [&](const std::string& what)
    { throw CaseError(opening.where, fmt::format("opening \"{}\" has {}: its normal must point into the scene", opening.name, what)); };
    for (const auto& other : gates_)
        if (std::ranges::any_of(other.section.lines(),
                                [&](const auto& line) {
                                    return opening.distance(line.foot) <= -2 * depth_ &&
                                           inSight(opening, geometry_, line.foot, coefficients_.spacing);
                                }))
            fail(fmt::format("\"{}\" beyond its plane, and would take away the fluid between them", other.opening.name));
    double deepest = 0;
    for (const auto& line : gate.section.lines())
    {
        const auto at = [&](double s) { return line.foot + s * opening.normal; };
        // Grains of a bed may stand in the way.
        for (double s = 0.5 * coefficients_.spacing; deepest < depth_ && inDomain(at(s), 0); s += coefficients_.spacing)
            if (geometry_.inFluid(at(s))) deepest = std::max(deepest, s + 0.5 * coefficients_.spacing);
    }
    if (deepest < depth_)
        fail(fmt::format("{:.4g} m of scene before its plane, less than the {:.4g} m that it holds beyond", deepest, depth_));
}

template<int dim> bool Openings<dim>::belongs(const Gate& gate, const Vector<3>& x) const
{
    return gate.opening.opensAt(x - gate.opening.distance(x) * gate.opening.normal, dim, gate.opening.margin);
}

/// Whether b holds what a sees.
template<int dim> bool Openings<dim>::meet(const Gate& a, const Gate& b) const
{
    for (const auto& line : a.section.lines())
        for (double s = coefficients_.support; s > -depth_; s -= coefficients_.spacing)
        {
            const auto x = line.foot + s * a.opening.normal;
            if (const double beyond = b.opening.distance(x); beyond < 0 && beyond > -depth_ && belongs(b, x)) return true;
        }
    return false;
}

/// 1 + the opening beyond whose plane a point lies; 0 in the scene. Beside the extents of two that meet, the one within whose own the point lies.
template<int dim> int Openings<dim>::holderOf(const Vector<3>& x) const
{
    int beside = 0;
    for (std::size_t k = 0; k < gates_.size(); ++k)
    {
        const auto& opening = gates_[k].opening;
        const double s = opening.distance(x);
        if (!(s < -onPlane * coefficients_.spacing && s > -2 * depth_ && belongs(gates_[k], x))) continue;
        if (opening.margin == 0 || opening.opensAt(x - s * opening.normal, dim)) return int(k) + 1;
        if (beside == 0) beside = int(k) + 1;
    }
    return beside;
}

/// 1 + the opening in whose duct a point lies, further beyond its plane than is held there; 0 where there is none.
template<int dim> int Openings<dim>::farBeyond(const Vector<3>& x) const
{
    const auto gate = std::ranges::find_if(gates_,
                                           [&](const Gate& each) {
                                               return each.opening.distance(x) <= -2 * depth_ &&
                                                      inSight(each.opening, geometry_, x, coefficients_.spacing);
                                           });
    return gate == gates_.end() ? 0 : 1 + int(gate - gates_.begin());
}

template<int dim> int Openings<dim>::assign(FieldStore<dim>& store, double& holder, std::size_t i, const Vector<3>& x_i, bool predicted)
{
    const int before = int(holder), now = holderOf(x_i);
    const auto pass = [&](int gate, double sign)
    {
        if (gate == 0) return;
        auto& to = account_.gates[std::size_t(gate) - 1];
        to.mass[phasesOf(store)(i)] += sign * store.component(Mass::info.name, 0)[i];
        if (marks_) mark(store, i, gates_[std::size_t(gate) - 1].opening, to.marked, sign);
        for (std::size_t q = 0; q < counted_.size(); ++q) to.amounts[q] += sign * amounts(store, *counted_[q], predicted)(i);
    };
    if (counts_ && before != now)
    {
        pass(before, 1);
        pass(now, -1);
    }
    holder = now;
    return now;
}

/// A particle passes an opening, into the scene with a sign > 0: what comes in is marked by the time, what leaves tells how long it was there.
template<int dim> void Openings<dim>::mark(FieldStore<dim>& store, std::size_t i, const Opening& opening, Transit& marked, double sign)
{
    double& enteredAt = store.component(EntryTime::info.name, 0)[i];
    const double m = store.component(Mass::info.name, 0)[i];
    if (!opening.inlet)
    {
        if (enteredAt >= 0) marked.add(-sign * m, time_ - enteredAt);
        return;
    }
    if (sign > 0 && opening.markFrom && time_ >= *opening.markFrom && opening.brings(phasesOf(store)(i))) enteredAt = time_;
    if (enteredAt >= 0) marked.add(sign * m, 0);
    if (sign < 0) enteredAt = EntryTime::notMarked;
}

template<int dim> void Openings<dim>::bring(FieldStore<dim>& store, std::size_t i, const Stream& stream) const
{
    for (const auto& [field, value] : stream.values) store.component(field, 0)[i] = value;
    if (marks_) store.component(EntryTime::info.name, 0)[i] = EntryTime::notMarked;
}

template<int dim> std::size_t Openings<dim>::exchange(FieldStore<dim>& store, std::size_t owned, bool predicted)
{
    const auto x = store.pointers(Position{});
    double* const holder = store.component(Holder::info.name, 0);
    const bool starts = !restored_ && !counts_;
    std::vector<int> kept, takenBy(starts ? owned : 0, 0);
    kept.reserve(owned);
    for (std::size_t i = 0; i < owned; ++i)
    {
        const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
        const int now = assign(store, holder[i], i, x_i, predicted);
        const Opening* const by = now > 0 ? &gates_[std::size_t(now) - 1].opening : nullptr;
        const bool gone = by && (starts || !by->inlet) && by->distance(x_i) < -depth_;
        if (starts) takenBy[i] = gone ? now : now == 0 ? farBeyond(x_i) : 0;
        if (!gone && !(starts && takenBy[i] > 0)) kept.push_back(int(i));
    }
    if (starts) countStart(store, owned, takenBy);
    if (kept.size() < owned)
    {
        store.sortState(kept);
        owned = kept.size();
    }
    store.resize(owned);
    if (starts) fillFirst(store, owned);
    else
        for (std::size_t k = 0; k < gates_.size(); ++k)
            if (gates_[k].opening.inlet || gates_[k].opening.backflow) refill(store, owned, int(k));
    counts_ = true;
    return owned;
}

/// Distance from the plane of an opening at which the row of the scene next to it stands in the mean [m]; half a row where nothing stands there.
template<int dim> double Openings<dim>::firstRow(const FieldStore<dim>& store, std::size_t owned, const Gate& gate) const
{
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    const double row = gate.section.rowSpacing(), low = -onPlane * coefficients_.spacing;
    std::vector<double> sums(2, 0.0);
    for (std::size_t i = 0; i < owned; ++i)
    {
        const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
        const double s = gate.opening.distance(x_i);
        if (holder[i] > 0 || s < low || s >= low + row || !gate.plane.opensAt(x_i - s * gate.opening.normal, dim)) continue;
        sums[0] += 1;
        sums[1] += s;
    }
    sums = ofAllRanks(sums, std::vector<double>(2, 0.0), AddEach{});
    return sums[0] > 0 ? sums[1] / sums[0] : 0.5 * row;
}

/// Lines that are filled at the start: all of an inlet; of an outlet with parts cut out those that hold nothing but what may come back by it, for the lattice to be one
/// with that of the parts.
template<int dim> std::vector<bool> Openings<dim>::linesToFill(FieldStore<dim>& store, std::size_t owned, int k) const
{
    const auto& gate = gates_[std::size_t(k)];
    const auto lines = gate.section.lines().size();
    if (gate.opening.inlet) return std::vector<bool>(lines, true);
    if (!gate.opening.backflow || gate.opening.without.empty()) return std::vector<bool>(lines, false);
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    std::vector<int> others(lines, 0);
    for (std::size_t i = 0; i < owned; ++i)
        if (int(holder[i]) == k + 1 && phasesOf(store)(i) != gate.opening.stream.phase)
            if (const int line = gate.section.lineAt(in3D(valueAt<Vector<dim>>(x, i))); line >= 0) ++others[std::size_t(line)];
    others = ofAllRanks(others, std::vector<int>(lines, 0), AddEach{});
    std::vector<bool> filled(lines);
    for (std::size_t l = 0; l < lines; ++l) filled[l] = others[l] == 0;
    return filled;
}

/// An inlet's own lattice, which continues the rows of the scene, replaces what is packed beyond it at the first start: a packing that is cut by
/// the plane fits neither its section nor its rate, and two lattices in one another are compressed.
template<int dim> void Openings<dim>::fillFirst(FieldStore<dim>& store, std::size_t& owned)
{
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    std::vector<std::vector<bool>> fills;
    std::vector<double> first;
    for (std::size_t k = 0; k < gates_.size(); ++k)
    {
        fills.push_back(linesToFill(store, owned, int(k)));
        first.push_back(firstRow(store, owned, gates_[k]));
    }
    const auto standsOnALine = [&](std::size_t k, const Vector<3>& x_i)
    {
        const int line = gates_[k].section.lineAt(x_i);
        return line >= 0 && fills[k][std::size_t(line)];
    };
    std::vector<int> kept;
    for (std::size_t i = 0; i < owned; ++i)
    {
        const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
        bool stays = holder[i] == 0;
        if (!stays)
        {
            const auto by = std::size_t(holder[i]) - 1;
            const auto& opening = gates_[by].opening;
            stays = !opening.inlet && !standsOnALine(by, x_i);
            for (std::size_t k = 0; k < gates_.size(); ++k)
                stays = stays && !(opening.leavesOut(gates_[k].opening) && standsOnALine(k, x_i));
        }
        if (stays) kept.push_back(int(i));
    }
    if (kept.size() < owned)
    {
        store.sortState(kept);
        owned = kept.size();
    }
    store.resize(owned);
    for (std::size_t k = 0; k < gates_.size(); ++k)
    {
        const auto& section = gates_[k].section;
        std::vector<Place> places;
        for (std::size_t l = 0; l < section.lines().size(); ++l)
            for (double s = first[k] - section.rowSpacing(); fills[k][l] && s > -depth_; s -= section.rowSpacing())
                places.push_back({section.lines()[l].foot + s * gates_[k].opening.normal, l});
        insert(store, owned, int(k), places);
    }
}

template<int dim>
std::vector<typename Openings<dim>::Place> Openings<dim>::clearOf(const std::vector<Vector<3>>& others,
                                                                  const std::vector<Place>& places) const
{
    std::vector<int> near;
    for (const auto& place : places)
        near.push_back(
            std::ranges::any_of(others, [&](const Vector<3>& other) { return mag(other - place.x) < leastGap * coefficients_.spacing; }));
    near = ofAllRanks(near, std::vector<int>(near.size(), 0), AddEach{});
    std::vector<Place> clear;
    for (std::size_t q = 0; q < places.size(); ++q)
        if (near[q] == 0) clear.push_back(places[q]);
    return clear;
}

/// Fills up lines from behind: of an inlet all; of an outlet those that move inwards, out of the scene's sight and at a distance from what has left, which
/// stands in no lattice.
template<int dim> void Openings<dim>::refill(FieldStore<dim>& store, std::size_t& owned, int k)
{
    const auto& gate = gates_[std::size_t(k)];
    const auto& opening = gate.opening;
    const auto& lines = gate.section.lines();
    const double row = gate.section.rowSpacing();
    std::vector<double> last(lines.size(), 0.5 * row); // the first stands half a row behind the plane
    std::vector<Vector<3>> others;                     // of an outlet, what stands behind the plane, or next to it
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    for (std::size_t i = 0; i < owned; ++i)
    {
        if (int(holder[i]) != k + 1 && opening.inlet) continue;
        const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
        if (!opening.inlet && opening.distance(x_i) < coefficients_.spacing) others.push_back(x_i);
        if (int(holder[i]) != k + 1) continue;
        if (const int line = gate.section.lineAt(x_i); line >= 0)
            last[std::size_t(line)] = std::min(last[std::size_t(line)], opening.distance(x_i));
    }
    last = ofAllRanks(last, last,
                      [](std::vector<double>& least, const std::vector<double>& q)
                      {
                          for (std::size_t l = 0; l < least.size(); ++l) Smaller{}(least[l], q[l]);
                      });
    std::vector<Place> places;
    for (std::size_t l = 0; l < lines.size(); ++l)
        for (double s = (opening.inlet ? last[l] : std::min(last[l], -coefficients_.support)) - row;
             s > -depth_ && (opening.inlet || comesBack(gate.velocity[l])); s -= row)
            places.push_back({lines[l].foot + s * opening.normal, l});
    insert(store, owned, k, opening.inlet ? places : clearOf(others, places));
}

/// Puts in what comes at these places, with the velocities of their lines.
template<int dim> void Openings<dim>::insert(FieldStore<dim>& store, std::size_t& owned, int k, const std::vector<Place>& places)
{
    if (places.empty() || !isFirstRank()) return;
    const auto& gate = gates_[std::size_t(k)];
    const auto& opening = gate.opening;
    store.resize(owned + places.size()); // what is new is 0
    const auto x = store.pointers(Position{});
    const auto v = store.pointers(Velocity{});
    for (std::size_t q = 0; q < places.size(); ++q)
    {
        const std::size_t i = owned + q;
        const auto& line = gate.section.lines()[places[q].line];
        put<dim>(x, i, in<dim>(places[q].x));
        put<dim>(v, i, in<dim>((opening.inlet ? gate.speed * line.profile : gate.velocity[places[q].line]) * opening.normal));
        bring(store, i, opening.streamAt(line.foot, dim));
        for (const auto& evolving : state_)
        {
            if (!store.has(evolving.startName())) continue;
            for (int c = 0; c < evolving.value.in(dim); ++c)
                store.component(evolving.startName(), c)[i] = store.component(evolving.value.name, c)[i];
        }
        store.component(Holder::info.name, 0)[i] = k + 1;
    }
    owned += places.size();
}

template<int dim> void Openings<dim>::locate(FieldStore<dim>& store, std::size_t owned)
{
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    const double reach = coefficients_.support + spareDepth * coefficients_.spacing;
    close_.clear();
    for (std::size_t i = 0; i < owned; ++i)
    {
        const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
        if (holder[i] > 0 || std::ranges::any_of(gates_, [&](const Gate& gate) { return std::fabs(gate.opening.distance(x_i)) < reach; }))
            close_.push_back(int(i));
    }
    list(store);
}

template<int dim> void Openings<dim>::follow(FieldStore<dim>& store, bool predicted)
{
    const auto x = store.pointers(Position{});
    double* const holder = store.component(Holder::info.name, 0);
    for (const int i : close_) assign(store, holder[i], std::size_t(i), in3D(valueAt<Vector<dim>>(x, std::size_t(i))), predicted);
    list(store);
}

/// Turns a particle on a line that moves inwards into the phase that comes back: what else has left is gone.
template<int dim> void Openings<dim>::replace(FieldStore<dim>& store, std::size_t i, const Gate& gate, const Vector<3>& x_i) const
{
    const int line = gate.section.lineAt(x_i);
    if (line >= 0 && comesBack(gate.velocity[std::size_t(line)]) && phasesOf(store)(i) != gate.opening.stream.phase)
        bring(store, i, gate.opening.stream);
}

template<int dim> void Openings<dim>::list(FieldStore<dim>& store)
{
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    held_.clear();
    for (auto& gate : gates_) gate.near.clear();
    for (auto& passed : account_.gates) passed.held = 0;
    for (const int i : close_)
    {
        const auto x_i = in3D(valueAt<Vector<dim>>(x, std::size_t(i)));
        if (holder[i] > 0)
        {
            held_.push_back(i);
            const auto& gate = gates_[std::size_t(holder[i]) - 1];
            ++account_.gates[std::size_t(holder[i]) - 1].held;
            if (gate.opening.backflow) replace(store, std::size_t(i), gate, x_i);
            impose(store, std::size_t(i), x_i);
            continue;
        }
        for (auto& gate : gates_)
            if (const double s = gate.opening.distance(x_i); s >= 0 && s < coefficients_.support && belongs(gate, x_i))
                gate.near.push_back(i);
    }
}

template<int dim> void Openings<dim>::hold(FieldStore<dim>& store)
{
    const double* const m = store.component(Mass::info.name, 0);
    const auto phase = phasesOf(store);
    for (std::size_t q = 0; q < counted_.size(); ++q)
    {
        if (!counted_[q]->rate || counted_[q]->advancedByModel) continue;
        const double* const rate = store.component(counted_[q]->rate->name, 0);
        intoHeld_[q] = 0;
        for (const int i : held_) intoHeld_[q] += rate[i] * m[i] / coefficients_.restDensity[phase(std::size_t(i))];
    }
    const auto clear = [&](const std::string& field)
    {
        const auto found = store.fields().find(field);
        if (found == store.fields().end()) return;
        for (std::size_t c = 0; c < found->second.component.size(); ++c)
            for (const int i : held_) store.component(field, int(c))[i] = 0;
    };
    for (const auto& evolving : state_)
        if (evolving.rate && !evolving.advancedByModel) clear(evolving.rate->name);
    clear(ShiftDirection::info.name);
    clear(TransportAcceleration::info.name);
}

/// The pressure of a held particle and, where density is integrated, that of Tait's law for it: free, it goes on from there.
template<int dim> void Openings<dim>::impose(FieldStore<dim>& store, std::size_t i, const Vector<3>& x_i) const
{
    const auto& gate = gates_[std::size_t(store.component(Holder::info.name, 0)[i]) - 1];
    const std::size_t k = phasesOf(store)(i);
    const double p = gate.pressure[k] + gate.slope[k] * gate.opening.distance(x_i);
    store.component(HeldPressure::info.name, 0)[i] = p;
    if (!integrates_) return;
    const auto& equation = coefficients_.stateEquation[k];
    const double least = (1 - leastRatio) * equation.leastPressure();
    store.component(Density::info.name, 0)[i] =
        equation.restDensity * equation.compression(std::max(least, p - coefficients_.backgroundPressure));
}

template<int dim> void Openings<dim>::drive(FieldStore<dim>& store, double deltaT, double time)
{
    time_ = time;
    for (std::size_t q = 0; q < counted_.size(); ++q) account_.heldAmounts[q] += deltaT * intoHeld_[q];
    const auto x = store.pointers(Position{}), v = store.pointers(Velocity{});
    const double* const holder = store.component(Holder::info.name, 0);
    const auto near = sumsNear(store);
    const auto alongLines = sumsOfLines(store);
    std::size_t ofGate = 0, firstLine = 0;
    for (auto& gate : gates_)
    {
        measure(gate, std::span(near).subspan(ofGate, sumsOfGate()));
        ofGate += sumsOfGate();
        if (!gate.opening.inlet)
        {
            const auto lines = gate.section.lines().size();
            gate.velocity = velocities(gate, std::span(alongLines).subspan(firstLine, lines));
            firstLine += lines;
            continue;
        }
        if (gate.opening.pressure)
        {
            const double behind = *gate.opening.pressure + coefficients_.backgroundPressure;
            const double p = gate.pressure[gate.opening.stream.phase];
            gate.speed = std::clamp(gate.speed + deltaT * (behind - p) / (gate.density * depth_), 0.0, gate.most);
        }
        std::ranges::transform(gate.section.lines(), gate.velocity.begin(), [&](const auto& line) { return gate.speed * line.profile; });
    }
    for (const int i : held_)
    {
        const auto& gate = gates_[std::size_t(holder[i]) - 1];
        const auto x_i = in3D(valueAt<Vector<dim>>(x, std::size_t(i)));
        if (const int line = gate.section.lineAt(x_i); line >= 0 && std::isfinite(gate.velocity[std::size_t(line)]))
            put<dim>(v, std::size_t(i), in<dim>(gate.velocity[std::size_t(line)] * gate.opening.normal));
        impose(store, std::size_t(i), x_i);
    }
}

template class Openings<2>;
template class Openings<3>;

}
