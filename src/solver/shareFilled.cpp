#include "shareFilled.hpp"
#include "Cloud.hpp"
#include "FieldFile.hpp"
#include "components.hpp"
#include "forEachFoot.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
/// By the middles of at least some ten thousand cells, and none smaller than a particle.
double spaceBetweenWalls(const Geometry& g, double spacing)
{
    const double cells = 20000;
    double box = 1;
    for (int k = 0; k < g.dimension; ++k) box *= g.length(k);
    const double step = std::max(spacing, std::pow(box/cells, 1.0/g.dimension));
    long n[3] = {1, 1, 1};
    for (int k = 0; k < g.dimension; ++k) n[k] = std::max(1L, std::lround(g.length(k)/step));
    long inFluid = 0;
    for (long c = 0; c < n[0]*n[1]*n[2]; ++c)
    {
        const long place[3] = {c%n[0], c/n[0]%n[1], c/n[0]/n[1]};
        Vector<3> x;
        for (int k = 0; k < g.dimension; ++k) x.*component(k) = g.low.*component(k) + (double(place[k]) + 0.5)/double(n[k])*g.length(k);
        inFluid += g.patches.empty() || nearestFoot(g, x).foot.distance > 0;
    }
    return box*double(inFluid)/double(n[0]*n[1]*n[2]);
}
}

std::optional<double> shareFilled(const Case& theCase, const Geometry& g, double spacing)
{
    for (const auto& time : theCase.times())
    {
        if (!hasCloud(theCase.folder(), time, "sph")) continue;
        Diagnostics ofReader; // who loads the cloud reports what is wrong with it
        const auto positions = readPositions(theCase.folder(), time + "/lagrangian/sph/positions", ofReader);
        const double space = spaceBetweenWalls(g, spacing);
        if (!positions || positions->x.empty() || !(space > 0)) return {};
        return double(positions->x.size())*std::pow(spacing, g.dimension)/space;
    }
    return {};
}

}
