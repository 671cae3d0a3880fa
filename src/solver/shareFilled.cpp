#include "shareFilled.hpp"
#include "Cloud.hpp"
#include "FieldFile.hpp"
#include "fluidFraction.hpp"
#include <cmath>

namespace sph
{

std::optional<double> shareFilled(const Case& theCase, const Geometry& g, double spacing)
{
    const int points = 20000;
    for (const auto& time : theCase.times())
    {
        if (!hasCloud(theCase.folder(), time, "sph")) continue;
        Diagnostics ofReader; // who loads the cloud reports what is wrong with it
        const auto positions = readPositions(theCase.folder(), time + "/lagrangian/sph/positions", ofReader);
        double space = fluidFraction(g, points);
        for (int k = 0; k < g.dimension; ++k) space *= g.length(k);
        if (!positions || positions->x.empty() || !(space > 0)) return {};
        return double(positions->x.size()) * std::pow(spacing, g.dimension) / space;
    }
    return {};
}

}
