/// Filling of buffers: at the first start, and line by line as their particles move on.
#include "models/openings/BufferZone.hpp"
#include "parallel/reduce.hpp"

namespace sph
{

namespace
{
/// Least distance of a new buffer particle behind an outlet from those that stand there [spacings].
constexpr double leastGap = 0.8;
}

/// Distance from the plane of an opening at which the row of the scene next to it stands in the mean [m]; half a row where nothing stands there.
template<int dim> double BufferZone<dim>::firstRow(const FieldStore<dim>& store, std::size_t owned, const PlacedOpening& placed) const
{
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    const double row = placed.section.rowSpacing(), low = -onPlane * scene_.coefficients.spacing;
    std::vector<double> sums(2, 0.0);
    for (std::size_t i = 0; i < owned; ++i)
    {
        const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
        const double s = placed.opening.distance(x_i);
        if (holder[i] > 0 || s < low || s >= low + row || !placed.plane.opensAt(x_i - s * placed.opening.normal, dim)) continue;
        sums[0] += 1;
        sums[1] += s;
    }
    sums = ofAllRanks(sums, std::vector<double>(2, 0.0), AddEach{});
    return sums[0] > 0 ? sums[1] / sums[0] : 0.5 * row;
}

/// Lines that are filled at the start: all of an inlet; of an outlet with parts cut out those that hold nothing but what may come back by it, for the lattice to be one
/// with that of the parts.
template<int dim> std::vector<bool> BufferZone<dim>::linesToFill(const FieldStore<dim>& store, std::size_t owned, std::size_t k) const
{
    const auto& placed = placed_[k];
    const auto lines = placed.section.lines().size();
    if (placed.opening.inlet) return std::vector<bool>(lines, true);
    if (!placed.opening.backflow || placed.opening.without.empty()) return std::vector<bool>(lines, false);
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    const auto phase = scene_.phasesOf(store);
    std::vector<int> others(lines, 0);
    for (std::size_t i = 0; i < owned; ++i)
        if (std::size_t(holder[i]) == k + 1 && phase(i) != placed.opening.stream.phase)
            if (const int line = placed.section.lineAt(in3D(valueAt<Vector<dim>>(x, i))); line >= 0) ++others[std::size_t(line)];
    others = ofAllRanks(others, std::vector<int>(lines, 0), AddEach{});
    std::vector<bool> filled(lines);
    for (std::size_t l = 0; l < lines; ++l) filled[l] = others[l] == 0;
    return filled;
}

/// An inlet's own lattice, which continues the rows of the scene, replaces what is packed beyond it at the first start: a packing that is cut by
/// the plane fits neither its section nor its rate, and two lattices in one another are compressed.
template<int dim> void BufferZone<dim>::fillFirst(FieldStore<dim>& store, std::size_t& owned) const
{
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    std::vector<std::vector<bool>> fills;
    std::vector<double> first;
    for (std::size_t k = 0; k < placed_.size(); ++k)
    {
        fills.push_back(linesToFill(store, owned, k));
        first.push_back(firstRow(store, owned, placed_[k]));
    }
    const auto standsOnALine = [&](std::size_t k, const Vector<3>& x_i)
    {
        const int line = placed_[k].section.lineAt(x_i);
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
            const auto& opening = placed_[by].opening;
            stays = !opening.inlet && !standsOnALine(by, x_i);
            for (std::size_t k = 0; k < placed_.size(); ++k)
                stays = stays && !(opening.leavesOut(placed_[k].opening) && standsOnALine(k, x_i));
        }
        if (stays) kept.push_back(int(i));
    }
    if (kept.size() < owned)
    {
        store.sortState(kept);
        owned = kept.size();
    }
    store.resize(owned);
    for (std::size_t k = 0; k < placed_.size(); ++k)
    {
        const auto& section = placed_[k].section;
        std::vector<Place> places;
        for (std::size_t l = 0; l < section.lines().size(); ++l)
            for (double s = first[k] - section.rowSpacing(); fills[k][l] && s > -scene_.bufferDepth; s -= section.rowSpacing())
                places.push_back({section.lines()[l].foot + s * placed_[k].opening.normal, l});
        insert(store, owned, k, places);
    }
}

/// Places that have none of `others` nearer than 0.8 spacings, on any rank.
template<int dim>
std::vector<typename BufferZone<dim>::Place> BufferZone<dim>::clearOf(const std::vector<Vector<3>>& others,
                                                                      const std::vector<Place>& places) const
{
    std::vector<int> near;
    for (const auto& place : places)
        near.push_back(std::ranges::any_of(others, [&](const Vector<3>& other)
                                           { return mag(other - place.x) < leastGap * scene_.coefficients.spacing; }));
    near = ofAllRanks(near, std::vector<int>(near.size(), 0), AddEach{});
    std::vector<Place> clear;
    for (std::size_t q = 0; q < places.size(); ++q)
        if (near[q] == 0) clear.push_back(places[q]);
    return clear;
}

/// Fills up lines from behind: of an inlet all; of an outlet those that move inwards, out of the scene's sight and at a distance from what has left, which
/// stands in no lattice.
template<int dim> void BufferZone<dim>::refill(FieldStore<dim>& store, std::size_t& owned, std::size_t k) const
{
    const auto& placed = placed_[k];
    const auto& opening = placed.opening;
    const auto& lines = placed.section.lines();
    const double row = placed.section.rowSpacing();
    std::vector<double> last(lines.size(), 0.5 * row); // the first stands half a row behind the plane
    std::vector<Vector<3>> others;                     // of an outlet, what stands behind the plane, or next to it
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    for (std::size_t i = 0; i < owned; ++i)
    {
        const bool held = std::size_t(holder[i]) == k + 1;
        if (!held && opening.inlet) continue;
        const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
        if (!opening.inlet && opening.distance(x_i) < scene_.coefficients.spacing) others.push_back(x_i);
        if (!held) continue;
        if (const int line = placed.section.lineAt(x_i); line >= 0)
            last[std::size_t(line)] = std::min(last[std::size_t(line)], opening.distance(x_i));
    }
    last = ofAllRanks(last, last,
                      [](std::vector<double>& least, const std::vector<double>& q)
                      {
                          for (std::size_t l = 0; l < least.size(); ++l) Smaller{}(least[l], q[l]);
                      });
    std::vector<Place> places;
    for (std::size_t l = 0; l < lines.size(); ++l)
        for (double s = (opening.inlet ? last[l] : std::min(last[l], -scene_.coefficients.support)) - row;
             s > -scene_.bufferDepth && (opening.inlet || comesBack(placed.velocity[l])); s -= row)
            places.push_back({lines[l].foot + s * opening.normal, l});
    insert(store, owned, k, opening.inlet ? places : clearOf(others, places));
}

/// Puts in what comes at these places, with the velocities of their lines.
template<int dim>
void BufferZone<dim>::insert(FieldStore<dim>& store, std::size_t& owned, std::size_t k, const std::vector<Place>& places) const
{
    if (places.empty() || !isFirstRank()) return;
    const auto& placed = placed_[k];
    const auto& opening = placed.opening;
    store.resize(owned + places.size()); // what is new is 0
    const auto x = store.pointers(Position{}), v = store.pointers(Velocity{});
    for (std::size_t q = 0; q < places.size(); ++q)
    {
        const std::size_t i = owned + q;
        const auto& line = placed.section.lines()[places[q].line];
        const double speed = opening.inlet ? placed.speed * line.profile : placed.velocity[places[q].line];
        sph::store(in<dim>(places[q].x), [&](int c, double value) { x[c][i] = value; });
        sph::store(in<dim>(speed * opening.normal), [&](int c, double value) { v[c][i] = value; });
        bring(store, i, opening.streamAt(line.foot, dim));
        for (const auto& evolving : scene_.state)
        {
            if (!store.has(evolving.startName())) continue;
            for (int c = 0; c < evolving.value.in(dim); ++c)
                store.component(evolving.startName(), c)[i] = store.component(evolving.value.name, c)[i];
        }
        store.component(Holder::info.name, 0)[i] = double(k + 1);
    }
    owned += places.size();
}

template<int dim> void BufferZone<dim>::bring(FieldStore<dim>& store, std::size_t i, const Stream& stream) const
{
    for (const auto& [field, value] : stream.values) store.component(field, 0)[i] = value;
    if (account_.marks()) store.component(EntryTime::info.name, 0)[i] = EntryTime::notMarked;
}

template class BufferZone<2>;
template class BufferZone<3>;

}
