#include "estimateReport.hpp"
#include "case/Cloud.hpp"
#include "case/FieldFile.hpp"
#include "kernels/skin.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace sph
{

namespace
{
struct Spread
{
    double least, mean, most;
};
Spread spreadOf(const std::vector<double>& q)
{
    const auto [least, most] = std::ranges::minmax(q);
    return {least, std::accumulate(q.begin(), q.end(), 0.0) / double(q.size()), most};
}

std::string line(const std::string& what, const std::vector<double>& q, double factor = 1)
{
    const auto [least, mean, most] = spreadOf(q);
    return fmt::format("    {:<28} {:>12.6g} {:>12.6g} {:>12.6g}\n", what, factor * least, factor * mean, factor * most);
}
}

std::string estimateReport(const Case& theCase, const std::string& time, int ranks, const Costs& costs, std::optional<double> scaleTo)
{
    const auto geometry = readDomain(theCase);
    const auto resolution = readResolution(theCase.dictionary("system/sphSchemes"));
    const auto positions = readPositions(theCase.folder(), time + "/lagrangian/sph/positions", theCase.diagnostics());
    theCase.diagnostics().throwIfAny();
    const auto &x = positions->x, &y = positions->y, &z = positions->z;
    if (x.size() < std::size_t(ranks)) throw CaseError(fmt::format("{} ranks for {} particles: take fewer", ranks, x.size()));
    std::vector<Vector<3>> places;
    for (std::size_t i = 0; i < x.size(); ++i) places.push_back({x[i], y[i], z[i]});
    const double reach = resolution.H() + skinInSpacings * resolution.spacing;
    const auto load = loadOf(geometry, places, std::size_t(ranks), reach, resolution.spacing);

    std::vector<double> shares;
    for (std::size_t r = 0; r < load.particles.size(); ++r)
        shares.push_back(100 * shareOfCommunication(costs, load.particles[r], load.copies[r], load.neighbours[r]));
    const double bytes = sizeof(double) * costs.values;
    const auto particles = spreadOf(load.particles);
    auto report = fmt::format("Time = {}: {} particles on {} ranks in boxes (rcb), halo of {:.4g} m\n", time, x.size(), ranks, reach) +
                  fmt::format("    {:<28} {:>12} {:>12} {:>12}\n", "of a rank", "least", "mean", "most") +
                  line("particles", load.particles) + line("copies in the halo", load.copies) +
                  line("messages of a refresh", load.neighbours) + line("bytes of a refresh, mean", load.copies, bytes / costs.refreshes) +
                  line("bytes of a step", load.copies, bytes) + line("communication [% of time]", shares) +
                  fmt::format("    imbalance {:.3f}\n", particles.most / particles.mean);
    if (scaleTo)
    {
        const auto s = scaledTo(load, *scaleTo, geometry.dimension, reach, resolution.spacing);
        report += fmt::format(
            "{:.6g} particles of the same shape on {} ranks, of a rank: {:.6g} particles, {:.6g} copies, {:.4g} messages and {:.6g} "
            "bytes of a refresh, {:.6g} bytes of a step, {:.3g} % of the time in communication\n",
            *scaleTo, ranks, s.particles, s.copies, s.neighbours, s.copies * bytes / costs.refreshes, s.copies * bytes,
            100 * shareOfCommunication(costs, s.particles, s.copies, s.neighbours));
    }
    return report +
           fmt::format(
               "with {:.3g} s a message, {:.3g} bytes/s, {:.3g} s a particle and step, {} numbers of a copy in {} refreshes a step\n",
               costs.latency, costs.bandwidth, costs.secondsPerParticle, costs.values, costs.refreshes);
}

}
