#include "Opening.hpp"
#include "components.hpp"
#include "words.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const FreeName opening{"<opening>", "dictionary", "an opening of the case's own name"};
const Choice type{"type", {"inlet", "outlet"}, required, "of the opening"},
    profile{"profile",
            {{"uniform", "the same velocity everywhere"}, {"developed", "that of developed flow in the section"}},
            "developed",
            "of the velocity"};
const VectorParameter point{"point", units::m, required, "a point of the plane"},
    min{"min", units::m, byScene("endless"), "the plane is open within this box alone, to a spacing"},
    max{"max", units::m, byScene("endless"), "highest corner of that box"};
const Direction normal{"normal", required, "into the scene"};
const Scalar velocity{"velocity", units::mPerS, notGiven, positive, "mean over the section"},
    flowRate{"flowRate", units::m3 / units::s, notGiven, positive, "in place of velocity; in 2-D [m^2/s]"},
    pressure{"pressure", units::pressure, notGiven, "alone: drives the flow; beside velocity or flowRate: the most that they may need"},
    pressureOutside{"pressure", units::pressure, 0, "at the plane"};
}

namespace
{
void readInlet(const Dictionary& d, const Coefficients& c, const State& state, Opening& opening)
{
    const auto area = c.dimension == 3 ? units::m2 : units::m;
    opening.velocity = entry::velocity.ifGiven(d);
    opening.flowRate = entry::flowRate.in(units::mPerS * area).ifGiven(d);
    opening.pressure = entry::pressure.ifGiven(d);
    if (opening.velocity && opening.flowRate) entry::flowRate.error(d, "flowRate is given, and velocity too: keep one of them");
    if (!opening.velocity && !opening.flowRate && !opening.pressure)
        entry::velocity.error(d, "what drives the flow is missing: give a velocity, a flowRate or a pressure");
    opening.developed = entry::profile(d) == "developed";
    static const std::vector<std::string> own{"type", "point", "normal", "min", "max", "velocity", "flowRate", "pressure", "profile"};
    for (const auto& evolving : state)
        if (std::ranges::find(own, evolving.value.name) != own.end())
            d.error(
                evolving.value.name,
                fmt::format("is an entry of every opening, and the name of a field that comes in, too: give the field another name than {}",
                            list(own)));
        else if (evolving.inlet) opening.values[evolving.value.name] = evolving.inlet(d);
}

Opening readOpening(const Dictionary& d, const Geometry& g, const Coefficients& c, const State& state)
{
    Opening opening;
    opening.name = d.keyword();
    opening.where = d.location();
    opening.inlet = entry::type(d) == "inlet";
    opening.point = entry::point(d);
    opening.normal = entry::normal(d);
    entry::normal.checkPlane(d, opening.normal, g.dimension);
    for (int k = 0; k < g.dimension; ++k)
        if (g.periodic[k] && opening.normal.*component(k) != 0)
            entry::normal.error(
                d, fmt::format("the domain is periodic in {}: what leaves it there comes in again, and no plane across is an opening",
                               coordinateNames[k]));
    opening.extent.low = entry::min(d, opening.extent.low);
    opening.extent.high = entry::max(d, opening.extent.high);
    for (int k = 0; k < g.dimension; ++k)
        if (const auto a = component(k); opening.extent.high.*a < opening.extent.low.*a)
            entry::max.error(d, fmt::format("max must not be less than min; in {} it is {} against {}", coordinateNames[k],
                                            opening.extent.high.*a, opening.extent.low.*a));
    opening.extent.low -= c.spacing * Vector<3>{1, 1, 1};
    opening.extent.high += c.spacing * Vector<3>{1, 1, 1};
    if (opening.inlet) readInlet(d, c, state, opening);
    else opening.pressure = entry::pressureOutside(d);
    return opening;
}
}

EntryList openingEntries()
{
    using namespace entry;
    const Cases byType{{"inlet", {entry::velocity, flowRate, pressure, profile}}, {"outlet", {pressureOutside}}};
    return {{opening, {{type, byType}, point, normal, min, max}}};
}

std::vector<Opening> readOpenings(const Case& theCase, const Geometry& geometry, const Coefficients& coefficients, const State& state,
                                  const std::map<std::string, std::string>& absent)
{
    std::vector<Opening> openings;
    if (!theCase.has("constant/openings")) return openings;
    const auto dict = theCase.dictionary("constant/openings");
    for (const auto& name : dict.keys())
        if (dict.isDictionary(name)) openings.push_back(readOpening(dict.subDict(name), geometry, coefficients, state));
        else dict.error(name, fmt::format("opening \"{0}\" must be a dictionary: {0} {{ type inlet; ... }}", name));
    for (const auto& opening : openings)
        for (const auto& [field, why] : absent)
            if (const auto d = dict.subDict(opening.name); opening.inlet && d.found(field)) d.error(field, why);
    dict.reportUnused();
    return openings;
}

}
