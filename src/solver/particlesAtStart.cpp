#include "solver/particlesAtStart.hpp"
#include "case/Cloud.hpp"
#include "case/FieldFile.hpp"
#include "decomposition/processorFolders.hpp"
#include "geometry/fluidFraction.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace sph
{

namespace
{
/// The folders of the cloud at its first time: that of the case or, where it has none, those of all its processor folders.
std::vector<std::string> cloudsAtStart(const Case& theCase)
{
    const auto cloudOf = [](const std::string& time) { return time + "/lagrangian/sph/"; };
    for (const auto& time : theCase.times())
        if (hasCloud(theCase.folder(), time, "sph")) return {cloudOf(time)};
    const auto times = theCase.times(processorFolder(0));
    std::vector<std::string> clouds;
    for (int part = 0; !times.empty() && theCase.has(processorFolder(part)); ++part)
        clouds.push_back(cloudOf(processorFolder(part) + "/" + times.front()));
    return clouds;
}

/// Number of particles in the folder of a cloud. What is wrong with it is reported by who loads it.
std::size_t particlesIn(const std::string& cloud, const Case& theCase)
{
    Diagnostics ofReader;
    constexpr Slice none{0, std::numeric_limits<std::size_t>::max()};
    const auto positions = readPositions(theCase.folder(), cloud + "positions", ofReader, none);
    return positions ? positions->count : 0;
}
}

std::optional<double> shareFilled(const Case& theCase, const Geometry& g, double spacing)
{
    const int points = 20000;
    std::size_t particles = 0;
    for (const auto& cloud : cloudsAtStart(theCase)) particles += particlesIn(cloud, theCase);
    double space = fluidFraction(g, points);
    for (int k = 0; k < g.dimension; ++k) space *= g.length(k);
    if (particles == 0 || !(space > 0)) return {};
    return double(particles) * std::pow(spacing, g.dimension) / space;
}

std::optional<int> lonePhase(const Case& theCase)
{
    std::optional<double> phase;
    for (const auto& cloud : cloudsAtStart(theCase))
    {
        const auto n = particlesIn(cloud, theCase);
        if (n == 0) continue;
        Diagnostics ofReader;
        const auto field = readField(theCase.folder(), cloud + "phase", n, {}, ofReader);
        if (!field) return {};
        const auto& values = field->component[0];
        if (!phase) phase = values[0];
        if (std::ranges::any_of(values, [&](double k) { return k != *phase; })) return {};
    }
    if (!phase) return {};
    return int(*phase);
}

}
