#include "solids/entries/SizeDistribution.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

namespace sph
{

namespace entry
{
const Choice distribution{"distribution",
                          {"fixed",
                           "uniform",
                           "normal",
                           "lognormal",
                           "list",
                           {"RosinRammler", "1 - exp(-(size/d)^n) is finer than a size"},
                           {"sieves", "what passes each of a set of sieves"}},
                          "fixed",
                          "of the sizes"};
const Scalar sizeValue{"value", units::m, required, positive, "the size"}, sizeMin{"min", units::m, required, positive, "smallest size"},
    sizeMax{"max", units::m, required, positive, "largest size"}, sizeMean{"mean", units::m, required, positive, "of all sizes"},
    sizeMedian{"median", units::m, required, positive, "half of the solids are smaller"},
    sizeDeviation{"standardDeviation", units::m, required, positive, "of all sizes"},
    geometricDeviation{"geometricStandardDeviation", units::none, required,
                       Range{.low = 1, .lowIncluded = false}.saying("geometricStandardDeviation {} must be above 1"),
                       "e to the standard deviation of ln d"},
    characteristicSize{"d", units::m, required, positive, "63.2 % is finer than this size"},
    spread{"n", units::none, required, positive, "exponent: the larger, the narrower; crushed ore has 0.7 to 1.5"};
const ListOf<double> sizes{"sizes", units::m, required, "each > 0"}, fractions{"fractions", required, "share of each size; their sum is 1"};
const ListOf<std::vector<double>> passing{
    "passing", required, "rows of a sieve [m] and the share of the mass that passes it, from 0 to 1: ((0.004 0) (0.008 0.4) (0.016 1))"};
const Choice fractionsOf{"fractionsOf", {"mass", "number"}, "mass", "what the fractions are shares of"},
    fractionsOfNumber{"fractionsOf", {"mass", "number"}, "number", "what the distribution gives shares of"},
    fractionsOfMass{"fractionsOf", {"mass", "number"}, "mass", "what the distribution gives shares of"};
}

namespace
{

/// Share of a normal distribution below x.
double normalBelow(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

double cube(double d) { return d * d * d; }

}

double SizeDistribution::finer(double d) const
{
    switch (kind)
    {
    case Kind::normal:
        return normalBelow((d - middle) / width);
    case Kind::lognormal:
        return normalBelow((std::log(d) - middle) / width);
    case Kind::RosinRammler:
        return 1 - std::exp(-std::pow(d / middle, width));
    case Kind::sieves:
    {
        const auto next = std::size_t(std::ranges::upper_bound(sizes, d) - sizes.begin());
        if (next == 0 || next == sizes.size()) return next == 0 ? 0 : 1;
        return std::lerp(upTo[next - 1], upTo[next], std::log(d / sizes[next - 1]) / std::log(sizes[next] / sizes[next - 1]));
    }
    default:
        return (d - low) / (high - low);
    }
}

double SizeDistribution::quantile(double p) const
{
    if (kind == Kind::fixed) return low;
    if (kind == Kind::uniform) return low + p * (high - low);
    if (kind == Kind::list)
        return sizes[std::size_t(std::min(std::ranges::upper_bound(upTo, p) - upTo.begin(), std::ptrdiff_t(sizes.size()) - 1))];
    const double target = finer(low) + p * share();
    double a = low, b = high;
    for (int k = 0; k < 60; ++k)
    {
        const double d = 0.5 * (a + b);
        (finer(d) < target ? a : b) = d;
    }
    return 0.5 * (a + b);
}

std::vector<double> SizeDistribution::ofGrainsByMass(int n) const
{
    // Shares by mass and by number up to the nodes of a fine division of ln d, to which the sieves belong. Within a cell the mass is even in ln d.
    constexpr int cells = 4000;
    std::vector<double> nodes;
    for (int k = 0; k <= cells; ++k) nodes.push_back(k == cells ? high : low * std::pow(high / low, double(k) / cells));
    if (kind == Kind::sieves) nodes.insert(nodes.end(), sizes.begin() + 1, sizes.end() - 1);
    std::ranges::sort(nodes);
    std::vector<double> mass{0}, number{0};
    for (std::size_t k = 1; k < nodes.size(); ++k)
    {
        const double a = nodes[k - 1], b = nodes[k], part = (finer(b) - finer(a)) / share();
        mass.push_back(mass.back() + part);
        const double each = b > a ? (1 / cube(a) - 1 / cube(b)) / (3 * std::log(b / a)) : 1 / cube(a); // mean of 1/d^3
        number.push_back(number.back() + part * each);
    }
    const double all = number.back();
    std::vector<double> grains;
    double before = 0;
    for (std::size_t k = 1, cell = 1; k <= std::size_t(n); ++k)
    {
        const double upTo_k = all * double(k) / n;
        while (cell + 1 < nodes.size() && number[cell] < upTo_k) ++cell;
        const double inCell =
            number[cell] > number[cell - 1] ? std::min(1.0, (upTo_k - number[cell - 1]) / (number[cell] - number[cell - 1])) : 1;
        const double massUpTo = k == std::size_t(n) ? 1 : std::lerp(mass[cell - 1], mass[cell], inCell);
        grains.push_back(std::cbrt((massUpTo - before) * n / all));
        before = massUpTo;
    }
    std::ranges::sort(grains); // those of one cell differ by rounding
    return grains;
}

std::vector<double> SizeDistribution::ofGrains(int n) const
{
    if (byMass) return ofGrainsByMass(n);
    std::vector<double> grains;
    for (int k = 0; k < n; ++k) grains.push_back(quantile((k + 0.5) / n));
    return grains;
}

double SizeDistribution::mean(int n) const
{
    double sum = 0;
    for (const double d : ofGrains(n)) sum += d;
    return sum / n;
}

double SizeDistribution::meanVolume(int n) const
{
    double sum = 0;
    for (const double d : ofGrains(n)) sum += std::pow(d, 3);
    return std::numbers::pi / 6 * sum / n;
}

double SizeDistribution::passing(double d) const
{
    if (d >= high) return 1;
    if (d < low) return 0;
    if (byMass) return (finer(d) - finer(low)) / share();
    constexpr int grains = 10'000;
    double below = 0, all = 0;
    for (const double each : ofGrains(grains))
    {
        all += cube(each);
        if (each <= d) below += cube(each);
    }
    return below / all;
}

double SizeDistribution::share() const { return finer(high) - finer(low); }

namespace
{

void readList(const Dictionary& dict, SizeDistribution& s)
{
    s.sizes = entry::sizes(dict);
    auto shares = entry::fractions(dict);
    const bool byMass = entry::fractionsOf(dict) == "mass";
    if (s.sizes.size() != shares.size() || s.sizes.empty())
    {
        entry::fractions.error(dict, fmt::format("there are {} sizes and {} fractions", s.sizes.size(), shares.size()));
        s = SizeDistribution{};
        return;
    }
    if (std::ranges::any_of(s.sizes, [](double d) { return !(d > 0); })) entry::sizes.error(dict, "each size must be positive");
    const double together = std::accumulate(shares.begin(), shares.end(), 0.0);
    if (std::ranges::any_of(shares, [](double f) { return f < 0; }) || std::abs(together - 1) > 1e-6)
        entry::fractions.error(dict, fmt::format("fractions must not be negative, and their sum must be 1: it is {:g}", together));
    if (byMass)
        for (std::size_t k = 0; k < shares.size(); ++k) shares[k] /= std::pow(s.sizes[k], 3);
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    double sum = 0;
    for (const double f : shares) s.upTo.push_back((sum += f) / all);
    s.low = std::ranges::min(s.sizes);
    s.high = std::ranges::max(s.sizes);
}

/// What is wrong with the rows of a table of sieves, and what to do; empty where nothing is.
std::string mistakeIn(const std::vector<std::vector<double>>& rows)
{
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (rows[k].size() != 2)
            return fmt::format("row {} has {} numbers: a sieve [m] and the share that passes it are needed", k + 1, rows[k].size());
    if (rows.size() < 2) return "two sieves are needed at least: one that nothing passes and one that all passes";
    if (const double all = rows.back()[1]; std::abs(all - 100) < 1e-6) return "the shares are in percent: write 1 for 100";
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        const double d = rows[k][0], share = rows[k][1];
        if (!(d > 0)) return fmt::format("row {}: the sieve is {:g} m wide, and must be wider than 0", k + 1, d);
        if (k > 0 && !(d > rows[k - 1][0]))
            return fmt::format("row {}: the sieve of {:g} m follows one of {:g} m: list them from the finest to the coarsest", k + 1, d,
                               rows[k - 1][0]);
        if (k > 0 && share < rows[k - 1][1])
            return fmt::format(
                "row {}: {:g} passes {:g} m, and {:g} the finer sieve of {:g} m: what passes must grow from row to row. Are these the shares that "
                "the sieves retain? Then add them up",
                k + 1, share, d, rows[k - 1][1], rows[k - 1][0]);
    }
    if (rows.front()[1] != 0)
        return fmt::format("{:g} passes the finest sieve, of {:g} m: add a row with the size that nothing passes, and 0", rows.front()[1],
                           rows.front()[0]);
    if (std::abs(rows.back()[1] - 1) > 1e-6)
        return fmt::format("{:g} passes the coarsest sieve, of {:g} m: add a row with the size that all passes, and 1", rows.back()[1],
                           rows.back()[0]);
    return "";
}

void readSieves(const Dictionary& dict, SizeDistribution& s)
{
    const auto rows = entry::passing(dict);
    if (!entry::passing.given(dict)) return;
    if (const auto mistake = mistakeIn(rows); !mistake.empty())
    {
        entry::passing.error(dict, mistake);
        s = SizeDistribution{};
        return;
    }
    // Between sieves below which nothing lies, or above which nothing does, there are no sizes.
    for (std::size_t k = 0; k < rows.size(); ++k)
    {
        const bool isEmpty = (k + 1 < rows.size() && rows[k + 1][1] == 0) || (k > 0 && rows[k - 1][1] >= 1);
        if (isEmpty) continue;
        s.sizes.push_back(rows[k][0]);
        s.upTo.push_back(std::min(1.0, rows[k][1]));
    }
    s.low = s.sizes.front();
    s.high = s.sizes.back();
    s.byMass = true;
}

}

SizeDistribution readSizes(const Dictionary& dict)
{
    SizeDistribution s;
    s.where = dict.location();
    const auto word = entry::distribution(dict);
    s.kind = SizeDistribution::Kind(entry::distribution.indexOf(word));
    if (word == "fixed") s.low = s.high = entry::sizeValue(dict);
    else if (word == "list") readList(dict, s);
    else if (word == "sieves") readSieves(dict, s);
    else
    {
        s.low = entry::sizeMin(dict);
        s.high = entry::sizeMax(dict);
        if (entry::sizeMin.given(dict) && entry::sizeMax.given(dict) && s.high <= s.low)
            entry::sizeMax.error(dict, fmt::format("max {} must be greater than min {}", s.high, s.low));
        if (word == "normal")
        {
            s.middle = entry::sizeMean(dict);
            s.width = entry::sizeDeviation(dict);
        }
        if (word == "lognormal")
        {
            s.middle = std::log(entry::sizeMedian(dict));
            s.width = std::log(entry::geometricDeviation(dict));
        }
        if (word == "RosinRammler")
        {
            s.middle = entry::characteristicSize(dict);
            s.width = entry::spread(dict);
        }
        if (word != "uniform")
        {
            s.byMass = (word == "RosinRammler" ? entry::fractionsOfMass : entry::fractionsOfNumber)(dict) == "mass";
            if (s.high > s.low && !(s.share() > 1e-9))
                entry::sizeMin.error(dict, fmt::format("the distribution has nothing between min {:g} and max {:g}", s.low, s.high));
        }
    }
    return s;
}

EntryList sizeEntries()
{
    using namespace entry;
    return {{distribution,
             {{"fixed", {sizeValue}},
              {"uniform", {sizeMin, sizeMax}},
              {"normal", {sizeMin, sizeMax, sizeMean, sizeDeviation, fractionsOfNumber}},
              {"lognormal", {sizeMin, sizeMax, sizeMedian, geometricDeviation, fractionsOfNumber}},
              {"list", {sizes, fractions, fractionsOf}},
              {"RosinRammler", {sizeMin, sizeMax, characteristicSize, spread, fractionsOfMass}},
              {"sieves", {passing}}}}};
}

}
