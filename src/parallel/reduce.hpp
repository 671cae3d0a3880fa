/// Reductions of particles to a number: the only way, and the same bits on any number of threads. Blocks of particles are taken by threads and
/// combined in their order, and then those of all ranks in theirs: each rank has to ask, and all get the same. NaN and infinity go through it: `smaller` and
/// `larger` keep a NaN that they meet.
#pragma once
#include "parallel/Ranks.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace sph
{

/// Values of all ranks, in their order: of numbers and structures of them, and of vectors of those that are as long on all.
template<class T> struct OfRanks
{
    static_assert(std::is_trivially_copyable_v<T>, "say how it goes from rank to rank: OfRanks<T>");
    static std::vector<T> gather(const Ranks& all, const T& part)
    {
        std::vector<T> parts(std::size_t(all.count()));
        all.gatherAll(std::as_bytes(std::span(&part, 1)), std::as_writable_bytes(std::span(parts)));
        return parts;
    }
};
template<class T> struct OfRanks<std::vector<T>>
{
    static std::vector<std::vector<T>> gather(const Ranks& all, const std::vector<T>& part)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        std::vector<T> joined(part.size() * std::size_t(all.count()));
        all.gatherAll(std::as_bytes(std::span(part)), std::as_writable_bytes(std::span(joined)));
        std::vector<std::vector<T>> parts;
        for (auto from = joined.begin(); parts.size() < std::size_t(all.count()); from += long(part.size()))
            parts.emplace_back(from, from + long(part.size()));
        return parts;
    }
};

/// `combine(total, part)` over the parts of all ranks, from `start`.
template<class T, class Combine> T ofAllRanks(const T& mine, T start, const Combine& combine)
{
    const auto* const all = ranks();
    if (!all) return mine;
    for (const auto& part : OfRanks<T>::gather(*all, mine)) combine(start, part);
    return start;
}

/// Sum of the values of the ranks before this one.
inline std::size_t sumOfRanksBefore(std::size_t mine)
{
    const auto* const all = ranks();
    if (!all) return 0;
    const auto parts = OfRanks<std::size_t>::gather(*all, mine);
    return std::accumulate(parts.begin(), parts.begin() + all->rank(), std::size_t(0));
}

/// `combine(total, part)` over the blocks of 0 .. n - 1 in their order, from `start`; `ofBlock(begin, end)` gives each part.
template<class T, class OfBlock, class Combine> T reduceBlocks(std::size_t n, T start, const OfBlock& ofBlock, const Combine& combine)
{
    const std::size_t block = 1024, blocks = (n + block - 1) / block;
    std::vector<T> parts(blocks, start);
#pragma omp parallel for schedule(static)
    for (std::size_t b = 0; b < blocks; ++b) parts[b] = ofBlock(b * block, std::min(n, (b + 1) * block));
    auto total = start;
    for (const auto& part : parts) combine(total, part);
    return ofAllRanks(total, std::move(start), combine);
}

/// Reduction of single particles: `combine(total, value(i))` within blocks, and of blocks.
template<class T, class Value, class Combine> T reduce(std::size_t n, const T& start, const Value& value, const Combine& combine)
{
    return reduceBlocks(
        n, start,
        [&](std::size_t begin, std::size_t end)
        {
            T part = start;
            for (std::size_t i = begin; i < end; ++i) combine(part, value(i));
            return part;
        },
        combine);
}

struct Add
{
    void operator()(auto& total, const auto& q) const { total += q; }
};
/// Sum of vectors of one length, element by element.
struct AddEach
{
    template<class T> void operator()(std::vector<T>& total, const std::vector<T>& q) const
    {
        for (std::size_t k = 0; k < total.size(); ++k) total[k] += q[k];
    }
};
struct Smaller
{
    void operator()(double& least, double q) const { least = q < least || std::isnan(q) ? q : least; }
};
struct Larger
{
    void operator()(double& most, double q) const { most = q > most || std::isnan(q) ? q : most; }
};

/// sum_i value(i)
template<class Value> auto sum(std::size_t n, const Value& value) { return reduce(n, decltype(value(n)){}, value, Add{}); }
/// The number of particles of which `condition(i)` holds.
template<class Condition> std::size_t count(std::size_t n, const Condition& condition)
{
    return sum(n, [&](std::size_t i) { return std::size_t(condition(i)); });
}
/// Infinite without particles.
template<class Value> double least(std::size_t n, const Value& value)
{
    return reduce(n, std::numeric_limits<double>::infinity(), value, Smaller{});
}
/// Minus infinite without particles.
template<class Value> double most(std::size_t n, const Value& value)
{
    return reduce(n, -std::numeric_limits<double>::infinity(), value, Larger{});
}

/// sum_i value(i) of each of so many groups, phases or slabs; what is in a group(i) beyond the last adds to none.
template<class Group, class Value> auto groupSums(std::size_t n, std::size_t groups, const Group& group, const Value& value)
{
    using Sums = std::vector<decltype(value(n))>;
    return reduceBlocks(
        n, Sums(groups),
        [&](std::size_t begin, std::size_t end)
        {
            Sums part(groups);
            for (std::size_t i = begin; i < end; ++i)
                if (const std::size_t g = group(i); g < groups) part[g] += value(i);
            return part;
        },
        AddEach{});
}

}
