#include "mapping/choosePhases.hpp"
#include <algorithm>
#include <limits>

namespace sph
{

namespace
{
constexpr int undecided = std::numeric_limits<int>::min();
}

PhaseChoice choosePhases(const std::vector<std::vector<double>>& shares, const std::vector<double>& volume,
                         const std::vector<double>& wanted, const std::vector<int>& order, int rest)
{
    PhaseChoice choice{std::vector<int>(volume.size(), undecided), std::vector<double>(shares.size(), 1),
                       std::vector<double>(shares.size(), 0)};
    std::vector<std::size_t> places;
    for (const int k : order)
    {
        if (k == rest) continue;
        const auto& share = shares[std::size_t(k)];
        places.clear();
        for (std::size_t i = 0; i < volume.size(); ++i)
            if (choice.phase[i] == undecided && share[i] > 0) places.push_back(i);
        std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) { return share[a] > share[b]; });
        double missing = wanted[std::size_t(k)];
        auto next = places.begin();
        for (; next != places.end() && missing > 0.5 * volume[*next]; ++next)
        {
            choice.phase[*next] = k;
            choice.leastShare[std::size_t(k)] = share[*next];
            missing -= volume[*next];
        }
        if (next == places.end() && !volume.empty()) choice.unplaced[std::size_t(k)] = std::max(missing, 0.0);
    }
    for (auto& phase : choice.phase)
        if (phase == undecided) phase = rest;
    return choice;
}

}
