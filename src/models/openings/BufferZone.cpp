#include "models/openings/BufferZone.hpp"

namespace sph
{

namespace
{
/// Lower bound of (rho/rho_0)^n, which a pressure far below 0 would make negative.
constexpr double leastRatio = 1e-3;
}

template<int dim>
BufferZone<dim>::BufferZone(const OpenScene& scene, const std::vector<PlacedOpening>& placed, OpeningAccount<dim>& account, bool restored)
    : scene_(scene),
      placed_(placed),
      account_(account),
      integrates_(std::ranges::any_of(scene.state, [](const Evolving& q) { return q.value.name == Density::info.name; })),
      restored_(restored),
      near_(placed.size())
{}

/// 1 + the opening beyond whose plane a point lies; 0 in the scene. Beside the extents of two that meet, the one within whose own the point lies.
template<int dim> int BufferZone<dim>::holderOf(const Vector<3>& x) const
{
    int beside = 0;
    for (std::size_t k = 0; k < placed_.size(); ++k)
    {
        const auto& opening = placed_[k].opening;
        const double s = opening.distance(x);
        if (!(s < -onPlane * scene_.coefficients.spacing && s > -2 * scene_.bufferDepth && placed_[k].opening.faces(x, dim))) continue;
        if (opening.margin == 0 || opening.opensAt(x - s * opening.normal, dim)) return int(k) + 1;
        if (beside == 0) beside = int(k) + 1;
    }
    return beside;
}

/// 1 + the opening in whose duct a point lies, further beyond its plane than is held there; 0 where there is none.
template<int dim> int BufferZone<dim>::farBeyond(const Vector<3>& x) const
{
    const auto found = std::ranges::find_if(placed_,
                                            [&](const PlacedOpening& each) {
                                                return each.opening.distance(x) <= -2 * scene_.bufferDepth &&
                                                       each.opening.inSight(scene_.geometry, x, scene_.coefficients.spacing);
                                            });
    return found == placed_.end() ? 0 : 1 + int(found - placed_.begin());
}

template<int dim> int BufferZone<dim>::assign(FieldStore<dim>& store, double& holder, std::size_t i, const Vector<3>& x_i, bool predicted)
{
    const int before = int(holder), now = holderOf(x_i);
    if (counts_ && before != now)
    {
        if (before > 0) account_.pass(store, i, std::size_t(before) - 1, 1, predicted);
        if (now > 0) account_.pass(store, i, std::size_t(now) - 1, -1, predicted);
    }
    holder = now;
    return now;
}

template<int dim> std::size_t BufferZone<dim>::exchange(FieldStore<dim>& store, std::size_t owned, bool predicted)
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
        const Opening* const by = now > 0 ? &placed_[std::size_t(now) - 1].opening : nullptr;
        const bool gone = by && (starts || !by->inlet) && by->distance(x_i) < -scene_.bufferDepth;
        if (starts) takenBy[i] = gone ? now : now == 0 ? farBeyond(x_i) : 0;
        if (!gone && !(starts && takenBy[i] > 0)) kept.push_back(int(i));
    }
    if (starts) account_.countStart(store, owned, takenBy);
    if (kept.size() < owned)
    {
        store.sortState(kept);
        owned = kept.size();
    }
    store.resize(owned);
    if (starts) fillFirst(store, owned);
    else
        for (std::size_t k = 0; k < placed_.size(); ++k)
            if (placed_[k].opening.inlet || placed_[k].opening.backflow) refill(store, owned, k);
    counts_ = true;
    return owned;
}

template<int dim> void BufferZone<dim>::locate(FieldStore<dim>& store, std::size_t owned)
{
    const auto x = store.pointers(Position{});
    double* const holder = store.component(Holder::info.name, 0);
    const double reach = scene_.coefficients.support + spareDepth * scene_.coefficients.spacing;
    close_.clear();
    for (std::size_t i = 0; i < owned; ++i)
    {
        const auto x_i = in3D(valueAt<Vector<dim>>(x, i));
        if (holder[i] == Holder::unknown) holder[i] = holderOf(x_i);
        if (holder[i] > 0 ||
            std::ranges::any_of(placed_, [&](const PlacedOpening& each) { return std::fabs(each.opening.distance(x_i)) < reach; }))
            close_.push_back(int(i));
    }
    list(store);
}

template<int dim> void BufferZone<dim>::follow(FieldStore<dim>& store, bool predicted)
{
    const auto x = store.pointers(Position{});
    double* const holder = store.component(Holder::info.name, 0);
    for (const int i : close_) assign(store, holder[i], std::size_t(i), in3D(valueAt<Vector<dim>>(x, std::size_t(i))), predicted);
    list(store);
}

/// Turns a particle on a line that moves inwards into the phase that comes back: what else has left is gone.
template<int dim>
void BufferZone<dim>::replace(FieldStore<dim>& store, std::size_t i, const PlacedOpening& placed, const Vector<3>& x_i) const
{
    const int line = placed.section.lineAt(x_i);
    if (line >= 0 && comesBack(placed.velocity[std::size_t(line)]) && scene_.phasesOf(store)(i) != placed.opening.stream.phase)
        bring(store, i, placed.opening.stream);
}

template<int dim> void BufferZone<dim>::list(FieldStore<dim>& store)
{
    const auto x = store.pointers(Position{});
    const double* const holder = store.component(Holder::info.name, 0);
    held_.clear();
    for (auto& near : near_) near.clear();
    std::vector<std::size_t> numbers(placed_.size(), 0);
    for (const int i : close_)
    {
        const auto x_i = in3D(valueAt<Vector<dim>>(x, std::size_t(i)));
        if (holder[i] > 0)
        {
            held_.push_back(i);
            const auto by = std::size_t(holder[i]) - 1;
            ++numbers[by];
            if (placed_[by].opening.backflow) replace(store, std::size_t(i), placed_[by], x_i);
            imposePressure(store, std::size_t(i), x_i);
            continue;
        }
        for (std::size_t k = 0; k < placed_.size(); ++k)
            if (const double s = placed_[k].opening.distance(x_i);
                s >= 0 && s < scene_.coefficients.support && placed_[k].opening.faces(x_i, dim))
                near_[k].push_back(i);
    }
    account_.countHeld(numbers);
}

template<int dim> void BufferZone<dim>::clearRates(FieldStore<dim>& store) const
{
    const auto clear = [&](const std::string& field)
    {
        const auto found = store.fields().find(field);
        if (found == store.fields().end()) return;
        for (std::size_t c = 0; c < found->second.component.size(); ++c)
            for (const int i : held_) store.component(field, int(c))[i] = 0;
    };
    for (const auto& evolving : scene_.state)
        if (evolving.rate && !evolving.advancedByModel) clear(evolving.rate->name);
    clear(ShiftDirection::info.name);
    clear(TransportAcceleration::info.name);
}

template<int dim> void BufferZone<dim>::soften(FieldStore<dim>& store) const
{
    const double* const holder = store.component(Holder::info.name, 0);
    double* const stiffness = store.component(VolumeStiffness::info.name, 0);
    for (const int i : held_)
        if (!placed_[std::size_t(holder[i]) - 1].opening.inlet) stiffness[i] = 0;
}

/// The pressure of a held particle and, where density is integrated, that of Tait's law for it: free, it goes on from there. What a drip or a flux pushes
/// out at a given velocity has that of its density (BoundaryFit.hpp).
template<int dim> void BufferZone<dim>::imposePressure(FieldStore<dim>& store, std::size_t i, const Vector<3>& x_i) const
{
    const auto& placed = placed_[std::size_t(store.component(Holder::info.name, 0)[i]) - 1];
    const std::size_t k = scene_.phasesOf(store)(i);
    const bool isPiston = placed.opening.inlet && placed.opening.isPart && !placed.opening.pressure && !integrates_;
    const double p = isPiston ? HeldPressure::ofDensity : placed.pressure[k] + placed.slope[k] * placed.opening.distance(x_i);
    store.component(HeldPressure::info.name, 0)[i] = p;
    if (!integrates_) return;
    const auto& equation = scene_.coefficients.stateEquation[k];
    const double least = (1 - leastRatio) * equation.leastPressure();
    store.component(Density::info.name, 0)[i] =
        equation.restDensity * equation.compression(std::max(least, p - scene_.coefficients.backgroundPressure));
}

template<int dim> void BufferZone<dim>::impose(FieldStore<dim>& store, double deltaT) const
{
    const auto x = store.pointers(Position{}), v = store.pointers(Velocity{});
    const double* const holder = store.component(Holder::info.name, 0);
    for (const int i : held_)
    {
        const auto& placed = placed_[std::size_t(holder[i]) - 1];
        const auto x_i = in3D(valueAt<Vector<dim>>(x, std::size_t(i)));
        if (placed.opening.letsFall())
        {
            const auto& n = placed.opening.normal;
            const double inwards = dot(in3D(valueAt<Vector<dim>>(v, std::size_t(i))) + deltaT * scene_.coefficients.g, n);
            sph::store(in<dim>(std::min(0.0, inwards) * n), [&](int c, double q) { v[c][i] = q; });
        }
        else if (const int line = placed.section.lineAt(x_i); line >= 0 && std::isfinite(placed.velocity[std::size_t(line)]))
            sph::store(in<dim>(placed.velocity[std::size_t(line)] * placed.opening.normal), [&](int c, double q) { v[c][i] = q; });
        imposePressure(store, std::size_t(i), x_i);
    }
}

template class BufferZone<2>;
template class BufferZone<3>;

}
