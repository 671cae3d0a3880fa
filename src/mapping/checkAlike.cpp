#include "mapping/checkAlike.hpp"
#include "base/words.hpp"
#include "geometry/components.hpp"
#include "geometry/wallNames.hpp"
#include "mapping/Sight.hpp"
#include "sampling/SampledField.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace
{
/// Difference of corners of two domains that are the same, in extents: digits of a dictionary.
constexpr double sameCorner = 1e-9;

std::string text(const Vector<3>& x) { return fmt::format("({:.10g} {:.10g} {:.10g})", x.x, x.y, x.z); }

std::string extentText(const Geometry& g)
{
    const auto corner = [&](const Vector<3>& x) { return text({x.x, x.y, g.dimension == 3 ? x.z : 0}); };
    return fmt::format("from {} to {}", corner(g.low), corner(g.high));
}

std::string periodicText(const Geometry& g)
{
    std::string directions;
    for (int k = 0; k < g.dimension; ++k)
        if (g.periodic[std::size_t(k)]) directions += std::string(directions.empty() ? "" : " ") + coordinateNames[k];
    return "(" + directions + ")";
}

bool differ(const Geometry& a, const Geometry& b)
{
    for (int k = 0; k < a.dimension; ++k)
        for (const auto corner : {&Geometry::low, &Geometry::high})
            if (std::fabs((a.*corner).*component(k) - (b.*corner).*component(k)) > sameCorner * a.length(k)) return true;
    return false;
}

std::vector<std::string> sortedWallNames(const Geometry& g)
{
    auto names = wallNames(g);
    std::ranges::sort(names);
    return names;
}

void checkGeometry(const Dictionary& d, const Geometry& of, const Geometry& source, const std::string& sourceName)
{
    if (of.dimension != source.dimension)
        return d.error("dimension", fmt::format("the case has {} dimensions, and {} has {}", of.dimension, sourceName, source.dimension));
    if (differ(of, source))
        d.error("domain", fmt::format("the domain {} is not that of {}, {}", extentText(of), sourceName, extentText(source)));
    if (of.periodic != source.periodic)
        d.error("domain",
                fmt::format("the domain is periodic in {}, and that of {} in {}", periodicText(of), sourceName, periodicText(source)));
    if (const auto names = sortedWallNames(of), others = sortedWallNames(source); names != others)
        d.error("walls",
                fmt::format("the walls ({}) are not those of {}, ({})", fmt::join(names, " "), sourceName, fmt::join(others, " ")));
}

void checkPhases(const Dictionary& d, const Coefficients& of, const Coefficients& source, const std::string& sourceName)
{
    auto names = of.phases, others = source.phases;
    std::ranges::sort(names);
    std::ranges::sort(others);
    if (names != others)
        return d.error("phases", fmt::format("the phases ({}) are not those of {}, ({})", fmt::join(of.phases, " "), sourceName,
                                             fmt::join(source.phases, " ")));
    for (std::size_t k = 0; k < of.phases.size(); ++k)
    {
        const auto other = std::size_t(std::ranges::find(source.phases, of.phases[k]) - source.phases.begin());
        if (std::fabs(of.restDensity[k] - source.restDensity[other]) > 1e-9 * of.restDensity[k])
            d.subDict(of.phases[k])
                .error("rho", fmt::format("{} has {:g} kg/m^3 at rest, and {:g} in {}: its mass and its volume cannot both be kept",
                                          of.phases[k], of.restDensity[k], source.restDensity[other], sourceName));
    }
}
}

void checkAlike(const Case& target, const StoredCase& of, const StoredCase& source, const std::string& sourceName)
{
    checkGeometry(target.dictionary("constant/geometry"), of.geometry(), source.geometry(), sourceName);
    checkPhases(target.dictionary("constant/phaseProperties"), of.settings().coefficients, source.settings().coefficients, sourceName);
}

void checkOutOfSolid(const ParticleView& source, const Geometry& target, const std::string& sourceName)
{
    const Sight sight(target, source.spacing);
    std::vector<double> toWall(source.n);
#pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t j = 0; j < source.n; ++j) toWall[j] = sight.toWall(position(source, j));
    const auto deepest = std::ranges::min_element(toWall);
    if (deepest == toWall.end() || *deepest > -0.5 * source.spacing) return;
    const auto count = std::ranges::count_if(toWall, [&](double d) { return d <= -0.5 * source.spacing; });
    throw CaseError(
        {"constant/geometry", 0},
        fmt::format("{} particles of {} lie in the solid of this case, the deepest at {}, by {:.4g} m: walls of the same names are not "
                    "the same",
                    count, sourceName, text(position(source, std::size_t(deepest - toWall.begin()))), -*deepest));
}

}
