/// Criterion for cutting space anew among ranks: one has for a while been busy for longer than the mean, and the others have waited for it since the last cut for
/// longer than another cut costs. So a load that moves slowly is cut seldom and one that moves fast often, each when it pays; cuts cost at most what waiting
/// would have cost, and 2 % of the time.
///
/// Processor time it is that counts: other programs on the machine take wall time from one rank or another, and hardly that. What they do take of it, by the caches
/// that they fill, the window smooths.
#pragma once
#include <cstddef>
#include <span>

namespace sph
{

class WhenToCut
{
public:
    static constexpr double window =
                                0.3, ///< of busy time that is looked back at, each part of it with a weight that decays as time goes on [s]
        shortest = 0.1,              ///< since the last cut: less says nothing of particles [s]
        mostOfTime = 0.02;           ///< that cuts may take
    static constexpr long fewestTimes = 5; ///< that lists have been made since the last cut

    /// Load of one rank.
    struct Share
    {
        double busy,   ///< since the rule was last asked [s]
            recent,    ///< in the window before
            costOfCut; ///< as last measured, wall time [s]
    };
    Share share(double busy, double costOfCut) const { return {busy, recent_, costOfCut}; }

    /// Whether to cut now, the same on all ranks, who ask at the same time with the shares of all; `me` is this one's place among them.
    bool operator()(std::span<const Share> ofAll, std::size_t me, double maxImbalance);
    /// Restarts the window after a cut.
    void startAnew() { *this = {}; }

    /// The busiest rank over the mean in the window; 0 where that says nothing yet.
    double imbalance() const { return imbalance_; }
    /// Busy time of this rank in the window [s].
    double recent() const { return recent_; }

private:
    double recent_ = 0, imbalance_ = 0,
           elapsed_ = 0, ///< since the last cut, of the mean rank
        lost_ = 0;       ///< by waiting, of that
    long times_ = 0;
};

}
