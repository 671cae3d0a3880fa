#include "solver/shareFilled.hpp"
#include "case/Cloud.hpp"
#include "case/FieldFile.hpp"
#include "decomposition/processorFolders.hpp"
#include "geometry/fluidFraction.hpp"
#include <cmath>
#include <limits>

namespace sph
{

namespace
{
/// Number of particles in the first time folder that has some: of the case or, where it has none, of all its processor folders.
std::size_t particlesAtStart(const Case& theCase)
{
    const auto count = [&](const std::string& time)
    {
        Diagnostics ofReader; // who loads the cloud reports what is wrong with it
        constexpr Slice none{0, std::numeric_limits<std::size_t>::max()};
        const auto positions = readPositions(theCase.folder(), time + "/lagrangian/sph/positions", ofReader, none);
        return positions ? positions->count : 0;
    };
    for (const auto& time : theCase.times())
        if (hasCloud(theCase.folder(), time, "sph")) return count(time);
    const auto times = theCase.times(processorFolder(0));
    std::size_t all = 0;
    for (int part = 0; !times.empty() && theCase.has(processorFolder(part)); ++part)
        all += count(processorFolder(part) + "/" + times.front());
    return all;
}
}

std::optional<double> shareFilled(const Case& theCase, const Geometry& g, double spacing)
{
    const int points = 20000;
    const auto particles = particlesAtStart(theCase);
    double space = fluidFraction(g, points);
    for (int k = 0; k < g.dimension; ++k) space *= g.length(k);
    if (particles == 0 || !(space > 0)) return {};
    return double(particles) * std::pow(spacing, g.dimension) / space;
}

}
