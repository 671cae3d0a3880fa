#include "parallel/WhenToCut.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

bool WhenToCut::operator()(std::span<const Share> ofAll, std::size_t me, double maxImbalance)
{
    const double count = double(ofAll.size());
    double mean = 0, cost = 0;
    for (const auto& share : ofAll)
    {
        mean += share.busy / count;
        cost = std::max(cost, share.costOfCut);
    }
    const double kept = std::exp(-mean / window);
    double meanRecent = 0, largest = 0;
    for (const auto& share : ofAll)
    {
        const double recent = kept * share.recent + share.busy;
        meanRecent += recent / count;
        largest = std::max(largest, recent);
    }
    recent_ = kept * ofAll[me].recent + ofAll[me].busy;
    elapsed_ += mean;
    if (++times_ < fewestTimes || elapsed_ < shortest) return false;
    // Time that was too early to be judged counts as the window now says.
    const double judged = imbalance_ == 0 ? elapsed_ : mean;
    imbalance_ = largest / meanRecent;
    lost_ += (imbalance_ - 1) * judged;
    // Chance is the greater the less of the window is filled since the last cut: with its root, and the limit goes with it.
    const double empty = std::exp(-elapsed_ / window), limit = 1 + (maxImbalance - 1) / std::sqrt((1 - empty) / (1 + empty));
    return imbalance_ > limit && lost_ > cost && cost < mostOfTime * elapsed_;
}

}
