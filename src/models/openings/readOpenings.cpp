#include "Opening.hpp"
#include "components.hpp"
#include "words.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{
using Words = std::vector<std::string>;

void readInlet(const Dictionary& d, const Coefficients& c, const State& state, Opening& opening)
{
    const auto area = c.dimension == 3 ? units::m2 : units::m;
    if (d.found("velocity")) opening.velocity = d.getPositive("velocity", units::mPerS);
    if (d.found("flowRate")) opening.flowRate = d.getPositive("flowRate", units::mPerS*area);
    if (d.found("pressure")) opening.pressure = d.get("pressure", units::pressure);
    if (opening.velocity && opening.flowRate) d.error("flowRate", "flowRate is given, and velocity too: keep one of them");
    if (!opening.velocity && !opening.flowRate && !opening.pressure)
        d.error("velocity", "what drives the flow is missing: give a velocity, a flowRate or a pressure");
    opening.developed = d.choose("profile", Words{"uniform", "developed"}, "uniform") == "developed";
    const Words own{"type", "point", "normal", "min", "max", "velocity", "flowRate", "pressure", "profile"};
    for (const auto& evolving : state)
        if (std::ranges::find(own, evolving.value.name) != own.end())
            d.error(evolving.value.name,
                    fmt::format("is an entry of every opening, and the name of a field that comes in, too: give the field another name than {}",
                                list(own)));
        else if (evolving.inlet) opening.values[evolving.value.name] = evolving.inlet(d);
}

Opening readOpening(const Dictionary& d, const Geometry& g, const Coefficients& c, const State& state)
{
    Opening opening;
    opening.name = d.keyword();
    opening.where = d.location();
    opening.inlet = d.choose("type", Words{"inlet", "outlet"}) == "inlet";
    opening.point = d.getVector("point", units::m);
    const auto normal = d.getVector("normal", units::none);
    if (!(mag(normal) > 0) && d.found("normal")) d.error("normal", "must have a direction, not (0 0 0)");
    opening.normal = mag(normal) > 0 ? unitVector(normal) : Vector<3>{1, 0, 0};
    if (g.dimension == 2 && opening.normal.z != 0) d.error("normal", "in 2-D the z component of a normal must be 0");
    for (int k = 0; k < g.dimension; ++k)
        if (g.periodic[k] && opening.normal.*component(k) != 0)
            d.error("normal", fmt::format("the domain is periodic in {}: what leaves it there comes in again, and no plane across is an opening",
                                          coordinateNames[k]));
    if (d.found("min")) opening.extent.low = d.getVector("min", units::m);
    if (d.found("max")) opening.extent.high = d.getVector("max", units::m);
    for (int k = 0; k < g.dimension; ++k)
        if (const auto a = component(k); opening.extent.high.*a < opening.extent.low.*a)
            d.error("max", fmt::format("max must not be less than min; in {} it is {} against {}", coordinateNames[k], opening.extent.high.*a,
                                       opening.extent.low.*a));
    opening.extent.low -= c.spacing*Vector<3>{1, 1, 1};
    opening.extent.high += c.spacing*Vector<3>{1, 1, 1};
    if (opening.inlet) readInlet(d, c, state, opening);
    else opening.pressure = d.get("pressure", units::pressure, 0);
    return opening;
}
}

std::vector<Opening> readOpenings(const Case& theCase, const Geometry& geometry, const Coefficients& coefficients, const State& state)
{
    std::vector<Opening> openings;
    if (!theCase.has("constant/openings")) return openings;
    const auto dict = theCase.dictionary("constant/openings");
    for (const auto& name : dict.keys())
        if (dict.isDictionary(name)) openings.push_back(readOpening(dict.subDict(name), geometry, coefficients, state));
        else dict.error(name, fmt::format("opening \"{0}\" must be a dictionary: {0} {{ type inlet; ... }}", name));
    dict.reportUnused();
    return openings;
}

}
