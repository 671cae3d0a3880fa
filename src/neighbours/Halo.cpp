#include "neighbours/Halo.hpp"
#include "base/CaseError.hpp"
#include "base/Clock.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <utility>

namespace sph
{

namespace
{
template<int dim> std::vector<double*> stateOf(FieldStore<dim>& store)
{
    std::vector<double*> arrays;
    for (const auto& [name, field] : store.fields())
        for (std::size_t c = 0; field.state && c < field.component.size(); ++c) arrays.push_back(store.component(name, int(c)));
    return arrays;
}

/// Boxes of a scene without a particle to cut by: the first rank has all of space, and the others none.
std::vector<RankBox> allToFirst(int ranks)
{
    constexpr double all = std::numeric_limits<double>::infinity();
    std::vector<RankBox> boxes(std::size_t(ranks), {{all, all, all}, {all, all, all}});
    boxes[0].low = {-all, -all, -all};
    return boxes;
}
}

template<int dim> void Halo<dim>::cut(const FieldStore<dim>& store, std::size_t owned, std::vector<float> costs)
{
    const Clock clock;
    const auto x = store.pointers(Position{});
    std::vector<double> places(3 * owned, 0.0);
    for (std::size_t i = 0; i < owned; ++i)
        for (int c = 0; c < dim; ++c) places[3 * i + std::size_t(c)] = x[std::size_t(c)][i];
    const bool isEmpty = ofAllRanks(owned, std::size_t(0), Add{}) == 0;
    boxes_ = RankBoxes(isEmpty ? allToFirst(all_.count()) : all_.cut(dim, places, costs));
    own_ = boxes_.of(all_.rank());
    cuts_.last = clock.clockTime();
    ++cuts_.count;
    hasCut_ = true;
    whenToCut_.startAnew();
}

template<int dim> void Halo<dim>::balance(const FieldStore<dim>& store, std::size_t owned, double maxImbalance, const Costs& costs)
{
    if (boxes_.count() == 0) return cut(store, owned, std::vector<float>(owned, 1));
    const bool wasKnown = whenToCut_.imbalance() > 0;
    const double busy = busyTime();
    const bool pays = whenToCut_(OfRanks<WhenToCut::Share>::gather(all_, whenToCut_.share(busy - busyBefore_, cuts_.last)),
                                 std::size_t(all_.rank()), maxImbalance);
    busyBefore_ = busy;
    if (const double left = whenToCut_.imbalance(); left > 0 && !wasKnown && cuts_.count > 1)
    {
        cuts_.sumLeft += left;
        Larger{}(cuts_.mostLeft, left);
        ++cuts_.known;
    }
    if (!pays) return;
    auto shares = costs();
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (float& share : shares) share *= float(whenToCut_.recent() / total);
    cut(store, owned, std::move(shares));
}

template<int dim> int Halo<dim>::ownerOf(const Vector<dim>& x) const
{
    const auto at = in3D(x);
    if (RankBoxes::holds(own_, at)) return all_.rank();
    const int owner = boxes_.owner(at);
    if (owner < 0) throw CaseError(fmt::format("a particle at ({:.6g} {:.6g} {:.6g}) lies in the box of no rank", at.x, at.y, at.z));
    return owner;
}

template<int dim> std::size_t Halo<dim>::migrate(FieldStore<dim>& store, std::size_t owned)
{
    const Clock clock;
    const auto x = std::as_const(store).pointers(Position{});
    auto arrays = stateOf(store);
    std::vector<std::vector<double>> parts(std::size_t(all_.count()));
    std::vector<int> kept;
    for (std::size_t i = 0; i < owned; ++i)
        if (const int owner = ownerOf(valueAt<Vector<dim>>(x, i)); owner == all_.rank()) kept.push_back(int(i));
        else
            for (const double* a : arrays) parts[std::size_t(owner)].push_back(a[i]);
    const auto come = exchangeParts<double>(all_, parts);
    if (kept.size() < owned) store.sortState(kept);
    std::size_t n = kept.size();
    for (const auto& part : come) n += part.size() / arrays.size();
    store.resize(std::max(n, store.size()), n);
    arrays = stateOf(store);
    std::size_t i = kept.size();
    for (const auto& part : come)
        for (auto from = part.begin(); from != part.end(); ++i)
            for (double* a : arrays) a[i] = *from++;
    if (std::exchange(hasCut_, false))
    {
        cuts_.last += clock.clockTime();
        if (cuts_.count > 1) cuts_.seconds += cuts_.last;
        busyBefore_ = busyTime(); // a cut's own time says nothing of particles
    }
    return n;
}

template<int dim> std::size_t Halo<dim>::build(FieldStore<dim>& store, std::size_t owned, const Places& places)
{
    owned_ = owned;
    std::vector<std::vector<int>> needed(std::size_t(all_.count()));
    places(
        [&](const Vector<dim>& x, int source)
        {
            forEachOtherNear(x,
                             [&](int r)
                             {
                                 auto& sources = needed[std::size_t(r)];
                                 if (sources.empty() || sources.back() != source) sources.push_back(source);
                             });
        });
    std::vector<std::size_t> counts;
    for (const auto& sources : needed) counts.push_back(sources.size());
    const auto copiesOf = all_.exchangeCounts(counts);
    neighbours_.clear();
    count_ = 0;
    for (std::size_t r = 0; r < needed.size(); ++r)
    {
        const std::size_t copies = copiesOf[r];
        count_ += copies;
        if (copies > 0 || !needed[r].empty()) neighbours_.push_back({int(r), std::move(needed[r]), copies});
    }
    sent_.resize(neighbours_.size());
    received_.resize(neighbours_.size());
    store.resize(std::max(owned + count_ + 1, store.size()), owned);
    const std::string positions = Position::info.name;
    refresh(store, {&positions, 1});
    return count_;
}

template<int dim> void Halo<dim>::start(FieldStore<dim>& store, std::span<const std::string> fields) const
{
    auto& arrays = refreshed_;
    arrays.clear();
    for (const auto& name : fields)
        for (std::size_t c = 0; c < store.fields().at(name).component.size(); ++c) arrays.push_back(store.component(name, int(c)));
    std::vector<Ranks::Message> send, receive;
    for (std::size_t k = 0; k < neighbours_.size(); ++k)
    {
        const auto& [rank, sources, copies] = neighbours_[k];
        sent_[k].resize(sources.size() * arrays.size());
        received_[k].resize(copies * arrays.size());
        auto to = sent_[k].begin();
        for (const double* a : arrays)
            for (const int i : sources) *to++ = a[i];
        send.push_back({rank, std::as_writable_bytes(std::span(sent_[k]))});
        receive.push_back({rank, std::as_writable_bytes(std::span(received_[k]))});
        bytesSent_ += send.back().bytes.size();
    }
    underWay_ = all_.start(send, receive);
}

template<int dim> void Halo<dim>::finish() const
{
    underWay_.reset();
    std::size_t first = owned_;
    for (std::size_t k = 0; k < neighbours_.size(); ++k)
    {
        auto from = received_[k].begin();
        for (double* a : refreshed_)
        {
            std::copy_n(from, neighbours_[k].copies, a + first);
            from += long(neighbours_[k].copies);
        }
        first += neighbours_[k].copies;
    }
}

template<int dim> std::size_t Halo<dim>::bytes() const
{
    std::size_t n = 0;
    for (const auto& neighbour : neighbours_) n += neighbour.sources.capacity() * sizeof(int);
    for (const auto* messages : {&sent_, &received_})
        for (const auto& message : *messages) n += message.capacity() * sizeof(double);
    return n;
}

template class Halo<2>;
template class Halo<3>;

}
