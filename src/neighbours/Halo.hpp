/// The halo of a rank, where ranks share the particles: the box of space that it owns, the particles that it takes over and gives away, and copies of those of
/// others that its own see, directly or in a wall or through a periodic face.
///
///     owned | copies | images of both | null particle
///
/// A copy is what its owner has, at the same place: images of copies are made here as those of owned particles are, by the same rules. Before a pass, what
/// it reads of neighbours is copied anew, all in one message to each rank.
#pragma once
#include "fields/FieldStore.hpp"
#include "neighbours/RankBoxes.hpp"
#include "parallel/WhenToCut.hpp"
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace sph
{

template<int dim> class Halo
{
public:
    /// Copies lie within `reach` [m] of this rank's box, or an image of theirs does. The ranks must outlive it.
    Halo(const Ranks& all, double reach) : all_(all), reach_(reach) {}

    const Ranks& all() const { return all_; }
    /// Costs of the owned particles, in any unit: only ratios count.
    using Costs = std::function<std::vector<float>()>;
    /// Boxes in which the particles cost the same: at first as many of them, and whenever it pays (WhenToCut) by the processor time that each rank's have lately
    /// taken, which `costs` shares out among them.
    void balance(const FieldStore<dim>&, std::size_t owned, double maxImbalance, const Costs& costs);
    /// Brings the state of each particle to the rank in whose box it lies; returns how many this one has then.
    std::size_t migrate(FieldStore<dim>&, std::size_t owned);

    /// f(place, source) of whatever particles of other ranks may see, owned particles and their images, in the order of their sources.
    using Places = std::function<void(const std::function<void(const Vector<dim>&, int source)>&)>;
    /// Finds who needs what, and copies positions behind the owned ones. Returns the number of copies.
    std::size_t build(FieldStore<dim>&, std::size_t owned, const Places&);
    /// Whether this rank's particles may see what lies there.
    bool isNear(const Vector<dim>& x) const { return RankBoxes::squaredDistance(own_, in3D(x)) < reach_ * reach_; }
    /// f(rank) of each other whose particles may.
    template<class F> void forEachOtherNear(const Vector<dim>& x, const F& f) const
    {
        if (RankBoxes::holdsAround(own_, in3D(x), reach_)) return;
        boxes_.forEachNear(in3D(x), reach_,
                           [&](int rank)
                           {
                               if (rank != all_.rank()) f(rank);
                           });
    }
    /// Copies of these fields anew, in two parts: `start` sends what the arrays hold and returns, `finish` waits for the others and writes the copies. Between the two
    /// nobody may read copies, nor resize the store.
    void start(FieldStore<dim>&, std::span<const std::string> fields) const;
    void progress() const
    {
        if (underWay_) underWay_->progress();
    }
    void finish() const;
    void refresh(FieldStore<dim>& store, std::span<const std::string> fields) const
    {
        start(store, fields);
        finish();
    }

    std::size_t count() const { return count_; }
    std::size_t bytesSent() const { return bytesSent_; }
    struct Cuts
    {
        long count = 0;
        double seconds = 0, ///< of wall time, in all but the first: cutting, and what particles then take to their new owners
            last = 0;       ///< in the last, be it the first [s]
        /// Left by cuts by measured cost, soon after each: the sum and the largest, of those of which it is known.
        double sumLeft = 0, mostLeft = 0;
        long known = 0;
    };
    const Cuts& cuts() const { return cuts_; }
    /// Busiest rank over the mean in the time just past; 0 where the last cut was a moment ago.
    double imbalance() const { return whenToCut_.imbalance(); }
    std::size_t bytes() const;

private:
    const Ranks& all_;
    double reach_;
    RankBoxes boxes_;
    RankBox own_; ///< this rank's
    struct Neighbour
    {
        int rank;
        std::vector<int> sources; ///< that it needs
        std::size_t copies;       ///< of its particles, here
    };
    std::vector<Neighbour> neighbours_;
    std::size_t owned_ = 0, count_ = 0;
    mutable std::vector<std::vector<double>> sent_, received_; ///< room for messages
    mutable std::unique_ptr<Ranks::Exchange> underWay_;
    mutable std::vector<double*> refreshed_; ///< by what is under way
    mutable std::size_t bytesSent_ = 0;
    double busyBefore_ = 0; ///< when `balance` was last through [s]
    Cuts cuts_;
    WhenToCut whenToCut_;
    bool hasCut_ = false; ///< and particles have yet to go to their new owners

    void cut(const FieldStore<dim>&, std::size_t owned, std::vector<float> costs);

    int ownerOf(const Vector<dim>&) const;
};

}
