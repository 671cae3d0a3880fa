/// Where ranks share the particles: the box of space that this one owns, the particles that it takes over and gives away, and copies of those of others
/// that its own see, directly or in a wall or through a periodic face.
///
///   owned | copies | images of both | null particle
///
/// A copy is what its owner has, at the same place: images of copies are made here as those of owned particles are, by the same rules. Before a pass, what
/// it reads of neighbours is copied anew, all in one message to each rank.
#pragma once
#include "FieldStore.hpp"
#include "RankBoxes.hpp"
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
    /// Boxes in which the particles cost the same, by the processor time that each rank's have taken: at first, and once the busiest rank has had
    /// `maxImbalance` times the mean since the last cut.
    void balance(const FieldStore<dim>&, std::size_t owned, double maxImbalance);
    /// Brings the state of each particle to the rank in whose box it lies; returns how many this one has then.
    std::size_t migrate(FieldStore<dim>&, std::size_t owned);

    /// f(place, source) of whatever particles of other ranks may see: owned particles and their images.
    using Places = std::function<void(const std::function<void(const Vector<dim>&, int source)>&)>;
    /// Finds who needs what, and copies positions behind the owned ones. Returns the number of copies.
    std::size_t build(FieldStore<dim>&, std::size_t owned, const Places&);
    /// Whether this rank's particles may see what lies there.
    bool isNear(const Vector<dim>& x) const { return boxes_.squaredDistance(all_.rank(), in3D(x)) < reach_ * reach_; }
    /// f(rank) of each other whose particles may.
    template<class F> void forEachOtherNear(const Vector<dim>& x, const F& f) const
    {
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
        double seconds = 0;   ///< of wall time, in all but the first: cutting, and what particles then take to their new owners
        double imbalance = 1; ///< the largest that was found soon after one of them
    };
    const Cuts& cuts() const { return cuts_; }
    std::size_t bytes() const;

private:
    const Ranks& all_;
    double reach_;
    RankBoxes boxes_;
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
    double busyAtCut_ = 0;
    Cuts cuts_;
    long sinceCut_ = 0;   ///< rebuilds since the last one
    bool judged_ = false; ///< whether the imbalance that it has left is known

    void cut(const FieldStore<dim>&, std::size_t owned, double cost);

    int ownerOf(const Vector<dim>&) const;
};

}
