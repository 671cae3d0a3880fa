#include "decomposition/estimate.hpp"
#include "decomposition/divide.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace sph
{

namespace
{
using Places = std::span<const Vector<3>>;

struct PartBox
{
    Vector<3> low, high;
};

/// Boxes of the parts, with half a spacing around the particles: the cut between two parts lies in the middle.
std::vector<PartBox> boxesOf(int dimension, Places places, const std::vector<int>& part, std::size_t parts, double spacing)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<PartBox> boxes(parts, {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}});
    for (std::size_t i = 0; i < places.size(); ++i)
        for (int k = 0; k < dimension; ++k)
        {
            auto& [low, high] = boxes[std::size_t(part[i])];
            const auto c = component(k);
            low.*c = std::min(low.*c, places[i].*c - 0.5 * spacing);
            high.*c = std::max(high.*c, places[i].*c + 0.5 * spacing);
        }
    return boxes;
}

/// Particles by the cells of a lattice, each as wide as the reach.
class Cells
{
    int dimension_;
    double width_;
    Vector<3> low_;
    std::array<long, 3> count_{1, 1, 1};
    std::vector<std::size_t> first_, members_;

    long along(int k, double q) const
    {
        return std::clamp(long(std::floor((q - low_.*component(k)) / width_)), 0L, count_[std::size_t(k)] - 1);
    }
    std::size_t cellOf(const Vector<3>& x) const
    {
        std::size_t cell = 0;
        for (int k = dimension_ - 1; k >= 0; --k)
            cell = cell * std::size_t(count_[std::size_t(k)]) + std::size_t(along(k, x.*component(k)));
        return cell;
    }

public:
    Cells(int dimension, Places places, double width) : dimension_(dimension), width_(width), low_(places[0])
    {
        auto high = low_;
        for (const auto& x : places)
            for (int k = 0; k < dimension; ++k)
            {
                const auto c = component(k);
                low_.*c = std::min(low_.*c, x.*c);
                high.*c = std::max(high.*c, x.*c);
            }
        // A few particles far apart need no more cells than there are particles.
        const auto cells = [&]
        {
            double all = 1;
            for (int k = 0; k < dimension; ++k) all *= std::floor((high.*component(k) - low_.*component(k)) / width_) + 1;
            return all;
        };
        while (cells() > 2.0 * double(places.size()) + 8) width_ *= 2;
        for (int k = 0; k < dimension; ++k)
            count_[std::size_t(k)] = long(std::floor((high.*component(k) - low_.*component(k)) / width_)) + 1;
        first_.assign(std::size_t(count_[0] * count_[1] * count_[2]) + 1, 0);
        for (const auto& x : places) ++first_[cellOf(x) + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        auto next = first_;
        members_.resize(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) members_[next[cellOf(places[i])]++] = i;
    }

    /// f(i) of particles in all cells that meet [low, high].
    void forEachIn(const Vector<3>& low, const Vector<3>& high, const auto& f) const
    {
        std::array<long, 3> from{}, to{};
        for (int k = 0; k < dimension_; ++k)
        {
            const auto c = component(k);
            if (high.*c < low_.*c || low.*c > low_.*c + double(count_[std::size_t(k)]) * width_) return;
            from[std::size_t(k)] = along(k, low.*c);
            to[std::size_t(k)] = along(k, high.*c);
        }
        for (long z = from[2]; z <= to[2]; ++z)
            for (long y = from[1]; y <= to[1]; ++y)
            {
                const auto row = std::size_t((z * count_[1] + y) * count_[0]);
                for (auto at = first_[row + std::size_t(from[0])]; at < first_[row + std::size_t(to[0]) + 1]; ++at) f(members_[at]);
            }
    }
};

/// Shifts at which a periodic domain has the same particles again, 0 included.
std::vector<Vector<3>> shiftsOf(const Geometry& g)
{
    std::vector<Vector<3>> shifts{{}};
    for (int k = 0; k < g.dimension; ++k)
    {
        if (!g.periodic[std::size_t(k)]) continue;
        const auto before = shifts;
        for (const double by : {-g.length(k), g.length(k)})
            for (auto shift : before)
            {
                shift.*component(k) = by;
                shifts.push_back(shift);
            }
    }
    return shifts;
}

double squaredDistance(int dimension, const Vector<3>& x, const PartBox& box)
{
    double squared = 0;
    for (int k = 0; k < dimension; ++k)
    {
        const auto c = component(k);
        const double beyond = std::max({0.0, box.low.*c - x.*c, x.*c - box.high.*c});
        squared += beyond * beyond;
    }
    return squared;
}
}

RankLoad loadOf(const Geometry& g, Places places, std::size_t parts, double reach, double spacing)
{
    const auto part = divide(Division::rcb, g.dimension, places, parts);
    const auto boxes = boxesOf(g.dimension, places, part, parts, spacing);
    const Cells cells(g.dimension, places, reach);
    const auto shifts = shiftsOf(g);
    RankLoad load{std::vector<double>(parts), std::vector<double>(parts), std::vector<double>(parts)};
    for (const int k : part) ++load.particles[std::size_t(k)];
    std::vector<std::pair<int, int>> meetings;
    std::vector<std::size_t> copies;
    std::vector<int> owners;
    for (std::size_t r = 0; r < parts; ++r)
    {
        copies.clear();
        for (const auto& shift : shifts)
        {
            const PartBox box{boxes[r].low - shift, boxes[r].high - shift};
            const Vector<3> around{reach, reach, reach};
            cells.forEachIn(box.low - around, box.high + around,
                            [&](std::size_t i)
                            {
                                if (part[i] != int(r) && squaredDistance(g.dimension, places[i], box) < reach * reach) copies.push_back(i);
                            });
        }
        if (shifts.size() > 1)
        {
            std::ranges::sort(copies);
            copies.erase(std::ranges::unique(copies).begin(), copies.end());
        }
        load.copies[r] = double(copies.size());
        owners.clear();
        for (const auto i : copies) owners.push_back(part[i]);
        std::ranges::sort(owners);
        owners.erase(std::ranges::unique(owners).begin(), owners.end());
        for (const int owner : owners) meetings.insert(meetings.end(), {{int(r), owner}, {owner, int(r)}});
    }
    std::ranges::sort(meetings);
    meetings.erase(std::ranges::unique(meetings).begin(), meetings.end());
    for (const auto& [rank, _] : meetings) ++load.neighbours[std::size_t(rank)];
    return load;
}

double shareOfCommunication(const Costs& costs, double particles, double copies, double neighbours)
{
    const double messages = costs.refreshes * neighbours * costs.latency + sizeof(double) * costs.values * copies / costs.bandwidth;
    return messages / (messages + particles * costs.secondsPerParticle);
}

Scaled scaledTo(const RankLoad& load, double total, int dimension, double reach, double spacing)
{
    const auto mean = [](const std::vector<double>& q) { return std::accumulate(q.begin(), q.end(), 0.0) / double(q.size()); };
    const auto sideOf = [&](double particles) { return spacing * std::pow(particles, 1.0 / dimension); };
    const auto shell = [&](double L)
    {
        constexpr double pi = std::numbers::pi;
        return dimension == 2 ? 4 * L * reach + pi * sqr(reach)
                              : 6 * sqr(L) * reach + 3 * pi * L * sqr(reach) + 4.0 / 3 * pi * sqr(reach) * reach;
    };
    const double now = mean(load.particles), then = total / double(load.particles.size());
    const double neighbours = mean(load.neighbours), ofABox = std::pow(3, dimension) - 1;
    return {then, mean(load.copies) * shell(sideOf(then)) / shell(sideOf(now)),
            sideOf(then) > reach ? std::min(neighbours, ofABox) : neighbours};
}

}
