#include "Saturation.hpp"
#include "PatchGrid.hpp"
#include "components.hpp"
#include "noise.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <utility>

namespace sph
{

namespace
{
/// Distances to the two nearest patches; infinite where there are fewer.
std::pair<double, double> twoNearest(const Geometry& g, const Vector<3>& x)
{
    double first = Box::infinity, second = Box::infinity;
    const auto look = [&](const Patch& patch)
    {
        const double d = patch.shape->foot(x).distance;
        if (d < first)
            second = std::exchange(first, d);
        else
            second = std::min(second, d);
    };
    if (g.grid)
        for (const int p : g.grid->near(x)) look(g.patches[p]);
    if (second <= g.reach && g.grid) return {first, second};

    // The grid answers for patches within its reach alone.
    first = second = Box::infinity;
    for (const auto& patch : g.patches) look(patch);
    return {first, second};
}

double toNearest(const Geometry& g, const std::vector<Vector<3>>& centres, const Vector<3>& x)
{
    double nearest = Box::infinity;
    for (const auto& c : centres)
    {
        Vector<3> d = x - c;
        for (int k = 0; k < g.dimension; ++k)
            if (g.periodic[k]) d.*component(k) -= g.length(k)*std::round(d.*component(k)/g.length(k));
        nearest = std::min(nearest, dot(d, d));
    }
    return nearest;
}
}

const std::vector<std::string>& placementNames()
{
    static const std::vector<std::string> names{"contacts", "film", "top", "bottom", "layer", "random", "drops"};
    return names;
}

Saturation readSaturation(const Dictionary& dict, std::span<const std::string> phases, const Vector<3>& up)
{
    Saturation s;
    s.where = dict.where("value");
    const auto indexOf = [&](const std::string& key)
    {
        return int(std::find(phases.begin(), phases.end(), dict.choose(key, phases)) - phases.begin()) %
               std::max(1, int(phases.size()));
    };
    s.phase = indexOf("phase");
    s.gas = indexOf("gas");
    if (s.phase == s.gas && dict.found("gas")) dict.error("gas", "phase and gas are the same");
    s.value = dict.get<double>("value");
    if (s.value < 0 || s.value > 1) dict.error("value", fmt::format("a saturation of {:g} is not between 0 and 1", s.value));
    s.placement = dict.choose("placement", placementNames(), "contacts");
    s.up = up;
    if (s.placement == "random" || s.placement == "drops") s.seed = dict.get<int>("seed", 1);
    if (s.placement == "drops")
    {
        if (dict.found("centres"))
            s.centres = dict.get<std::vector<Vector<3>>>("centres");
        else
            s.number = dict.get<int>("number");
        if (s.number < 1) dict.error("number", "at least one drop is needed");
    }
    if (s.placement == "layer")
    {
        s.point = dict.get<Vector<3>>("point");
        s.normal = dict.get<Vector<3>>("normal");
        if (mag(s.normal) > 0)
            s.normal = s.normal/mag(s.normal);
        else if (dict.found("normal"))
            dict.error("normal", "normal has no length, and so no direction");
    }
    return s;
}

std::vector<char> place(const Saturation& s, const Geometry& g, const Points& points)
{
    const long n = long(points.size());
    auto centres = s.centres;
    if (s.placement == "drops" && centres.empty() && n > 0)
        for (int k = 0; k < s.number; ++k) centres.push_back(points[std::size_t(noise(s.seed, k)*double(n))]);

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
        else if (s.placement == "film")
            score[i] = twoNearest(g, x).first;
        else if (s.placement == "bottom")
            score[i] = dot(x, s.up);
        else if (s.placement == "top")
            score[i] = -dot(x, s.up);
        else if (s.placement == "layer")
            score[i] = std::fabs(dot(x - s.point, s.normal));
        else if (s.placement == "drops")
            score[i] = toNearest(g, centres, x);
        else
            score[i] = noise(s.seed, i);
    }

    const long wanted = std::lround(s.value*double(n));
    std::vector<long> order(n);
    std::iota(order.begin(), order.end(), 0L);
    std::nth_element(order.begin(), order.begin() + std::min(wanted, n), order.end(),
                     [&](long a, long b) { return score[a] != score[b] ? score[a] < score[b] : a < b; });
    std::vector<char> holds(n, 0);
    for (long k = 0; k < wanted; ++k) holds[order[k]] = 1;
    return holds;
}

}
