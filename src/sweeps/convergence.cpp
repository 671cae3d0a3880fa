#include "sweeps/convergence.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{

/// Two resolutions nearer than this are the same one: an order between them would be noise.
constexpr double leastRatio = 1.0001;

/// Cost ~ resolution^3 in two dimensions: particles times acoustic steps.
constexpr double usualCostPower = 3;
/// Costs of short runs are mostly start-up and noise; beyond these powers a fit of them foretells nonsense.
constexpr double leastCostPower = 1, largestCostPower = 6;

using Rows = std::vector<const ResultRow*>;

/// Rows of a variant that ended well, coarse first.
Rows ladderOf(std::span<const ResultRow> rows, const std::string& variant)
{
    Rows ladder;
    for (const auto& row : rows)
        if (row.variant == variant && row.status == "ok" && row.wallSeconds > 0 && row.resolution > 0) ladder.push_back(&row);
    std::ranges::sort(ladder, {}, [](const ResultRow* row) { return row->resolution; });
    const auto same = [](const ResultRow* a, const ResultRow* b) { return a->resolution == b->resolution; };
    ladder.erase(std::unique(ladder.begin(), ladder.end(), same), ladder.end());
    return ladder;
}

std::optional<double> costPower(const Rows& ladder)
{
    if (ladder.size() < 2) return {};
    const auto &a = *ladder[ladder.size() - 2], &b = *ladder.back();
    return std::clamp(std::log(b.wallSeconds / a.wallSeconds) / std::log(b.resolution / a.resolution), leastCostPower, largestCostPower);
}

}

void setObservedOrders(std::span<ResultRow> rows)
{
    for (auto& row : rows)
    {
        row.order = ResultRow::unknown;
        if (row.status != "ok" || !(row.error > 0)) continue;
        const ResultRow* coarser = nullptr;
        for (const auto& other : rows)
            if (other.variant == row.variant && other.status == "ok" && other.error > 0 && other.spacing > leastRatio * row.spacing &&
                (!coarser || other.spacing < coarser->spacing))
                coarser = &other;
        if (coarser) row.order = std::log(coarser->error / row.error) / std::log(coarser->spacing / row.spacing);
    }
}

std::optional<PowerLaw> fitPowerLaw(std::span<const double> x, std::span<const double> y)
{
    double meanX = 0, meanY = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        meanX += std::log(x[k]) / double(x.size());
        meanY += std::log(y[k]) / double(x.size());
    }
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        const double dx = std::log(x[k]) - meanX;
        xx += dx * dx;
        xy += dx * (std::log(y[k]) - meanY);
    }
    const double least = std::log(leastRatio);
    if (x.size() < 2 || xx < 0.5 * least * least) return {};
    return PowerLaw{std::exp(meanY - xy / xx * meanX), xy / xx};
}

std::vector<bool> paretoFront(std::span<const ResultRow> rows)
{
    const auto counts = [](const ResultRow& row) { return row.status == "ok" && row.error >= 0 && row.cpuSeconds >= 0; };
    const auto beats = [](const ResultRow& a, const ResultRow& b)
    { return a.error <= b.error && a.cpuSeconds <= b.cpuSeconds && (a.error < b.error || a.cpuSeconds < b.cpuSeconds); };
    std::vector<bool> front;
    for (const auto& row : rows)
        front.push_back(counts(row) &&
                        std::ranges::none_of(rows, [&](const ResultRow& other) { return counts(other) && beats(other, row); }));
    return front;
}

std::optional<double> expectedWallSeconds(std::span<const ResultRow> rows, const std::string& variant, double resolution)
{
    const auto own = ladderOf(rows, variant);
    auto power = costPower(own);
    for (const auto& row : rows)
        if (!power) power = costPower(ladderOf(rows, row.variant));
    const ResultRow* from = own.empty() ? nullptr : own.back();
    const auto apart = [&](const ResultRow& row) { return std::abs(std::log(row.resolution / resolution)); };
    if (!from)
        for (const auto& row : rows)
            if (row.status == "ok" && row.wallSeconds > 0 && row.resolution > 0 && (!from || apart(row) < apart(*from))) from = &row;
    if (!from) return {};
    return from->wallSeconds * std::pow(resolution / from->resolution, power.value_or(usualCostPower));
}

}
