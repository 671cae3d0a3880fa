#include "packing/Saturation.hpp"
#include "base/noise.hpp"
#include "geometry/components.hpp"
#include "geometry/forEachFoot.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <utility>

namespace sph
{

namespace entry
{
const Word phase{"phase", required, "phase that is given"},
    gas{"gas", required, "phase that is left in the rest, or none: no particles; what holds a third phase keeps it"};
const Scalar value{"value", units::none, required, between(0, 1).saying("a saturation of {:g} is not between 0 and 1"),
                   "share of the void space"};
const Count seed{"seed", 1, anyNumber, "of chance"},
    number{"number", byScene("needed without centres"), atLeast(1).saying("at least one drop is needed"),
           "of drops, at places chosen by chance"};
const ListOf<Vector<3>> centres{"centres", units::m, byScene("chosen by chance"), "of the drops"};
const VectorParameter point{"point", units::m, required, "a point of the layer's middle plane"};
const Direction normal{"normal", required, "across the layer"};
const Choice placement{"placement",
                       {{"contacts", "where the gap between two walls is smallest: pendular water between grains"},
                        {"film", "nearest to the walls"},
                        {"top", "highest"},
                        {"bottom", "lowest"},
                        {"layer", "nearest to a plane"},
                        {"random", "anywhere"},
                        {"drops", "nearest to some centres"}},
                       "contacts",
                       "where the phase is put"};
}

namespace
{
/// Distances to the two nearest patches; infinite where there are fewer.
std::pair<double, double> twoNearest(const Geometry& g, const Vector<3>& x)
{
    const auto first = nearestFoot(g, x), second = nearestFoot(g, x, first.patch);
    return {first.foot.distance, second.foot.distance};
}

double toNearest(const Geometry& g, const std::vector<Vector<3>>& centres, const Vector<3>& x)
{
    double nearest = Box::infinity;
    for (const auto& c : centres)
    {
        const auto d = g.shortest(x - c);
        nearest = std::min(nearest, dot(d, d));
    }
    return nearest;
}
}

EntryList saturationEntries()
{
    return {
        entry::phase,
        entry::gas,
        entry::value,
        {entry::placement,
         {{"layer", {entry::point, entry::normal}}, {"random", {entry::seed}}, {"drops", {entry::centres, entry::number, entry::seed}}}}};
}

Saturation readSaturation(const Dictionary& dict, std::span<const std::string> phases, const Vector<3>& up)
{
    Saturation s;
    s.where = entry::value.where(dict);
    std::vector<std::string> words(phases.begin(), phases.end());
    const auto indexOf = [&](const Word& key)
    { return int(std::find(words.begin(), words.end(), key.among(dict, words)) - words.begin()) % std::max(1, int(words.size())); };
    s.phase = indexOf(entry::phase);
    words.push_back("none");
    s.gas = indexOf(entry::gas);
    if (s.gas == int(phases.size())) s.gas = Saturation::noGas;
    if (s.phase == s.gas && entry::gas.given(dict)) entry::gas.error(dict, "phase and gas are the same");
    s.value = entry::value(dict);
    s.placement = entry::placement(dict);
    s.up = up;
    if (s.placement == "random" || s.placement == "drops") s.seed = entry::seed(dict);
    if (s.placement == "drops")
    {
        if (entry::centres.given(dict)) s.centres = entry::centres.needed(dict);
        else s.number = entry::number.needed(dict);
    }
    if (s.placement == "layer")
    {
        s.point = entry::point(dict);
        s.normal = entry::normal(dict);
    }
    return s;
}

std::vector<char> place(const Saturation& s, const Geometry& g, const Points& points)
{
    const long n = long(points.size());
    auto centres = s.centres;
    if (s.placement == "drops" && centres.empty() && n > 0)
        for (int k = 0; k < s.number; ++k) centres.push_back(points[std::size_t(noise(s.seed, k) * double(n))]);

    if ((s.placement == "contacts" || s.placement == "film") && g.patches.empty())
        throw CaseError(s.where, "placement " + s.placement + " asks for walls, and constant/geometry has none");

    std::vector<double> score(n);
#pragma omp parallel for schedule(static)
    for (long i = 0; i < n; ++i)
    {
        const Vector<3> x = points[i];
        if (s.placement == "contacts")
        {
            const auto [first, second] = twoNearest(g, x);
            score[i] = std::isfinite(second) ? first + second : first;
        }
        else if (s.placement == "film") score[i] = twoNearest(g, x).first;
        else if (s.placement == "bottom") score[i] = dot(x, s.up);
        else if (s.placement == "top") score[i] = -dot(x, s.up);
        else if (s.placement == "layer") score[i] = std::fabs(dot(x - s.point, s.normal));
        else if (s.placement == "drops") score[i] = toNearest(g, centres, x);
        else score[i] = noise(s.seed, i);
    }

    const long wanted = std::lround(s.value * double(n));
    std::vector<long> order(n);
    std::iota(order.begin(), order.end(), 0L);
    std::nth_element(order.begin(), order.begin() + std::min(wanted, n), order.end(),
                     [&](long a, long b) { return score[a] != score[b] ? score[a] < score[b] : a < b; });
    std::vector<char> holds(n, 0);
    for (long k = 0; k < wanted; ++k) holds[order[k]] = 1;
    return holds;
}

}
