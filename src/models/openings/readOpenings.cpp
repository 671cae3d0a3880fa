#include "base/words.hpp"
#include "geometry/components.hpp"
#include "geometry/contains.hpp"
#include "models/openings/Opening.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const FreeName opening{"<opening>", "dictionary", "an opening of the case's own name"};
const Choice type{"type",
                  {{"inlet", "fluid comes in through a duct"},
                   {"outlet", "fluid leaves, and may come back with `backflow`"},
                   {"drip", "liquid comes in at points of a plane that is open to gas"},
                   {"flux", "liquid comes in through a part of a plane that is open to gas"}},
                  required,
                  "of the opening"},
    profile{"profile",
            {{"uniform", "the same velocity everywhere"}, {"developed", "that of developed flow in the section"}},
            "developed",
            "of the velocity"};
const VectorParameter point{"point", units::m, required, "a point of the plane"},
    min{"min", units::m, byScene("endless"), "the plane is open within this box alone; what leaves up to a spacing beside it leaves by it"},
    max{"max", units::m, byScene("endless"), "highest corner of that box"};
const ListOf<Vector<3>> points{"points", units::m, required, "of the plane, each an opening: <opening>1, <opening>2 ..."};
const Direction normal{"normal", required, "into the scene"};
const Scalar radius{"radius", units::m, required, positive, "of what falls from each point; in 2-D half of its width"},
    velocity{"velocity", units::mPerS, notGiven, positive, "mean over the section: of a flux the superficial velocity"},
    flowRate{"flowRate", units::m3 / units::s, notGiven, positive, "in place of velocity; of a drip at each point; in 2-D [m^2/s]"},
    pressure{"pressure", units::pressure, notGiven, "alone: drives the flow; beside velocity or flowRate: the most that they may need"},
    pressureOutside{"pressure", units::pressure, 0, "at the plane"},
    markFrom{"markFrom", units::s, notGiven, nonNegative,
             "what comes in from this time on is marked by it: the log tells how long it takes to each outlet"};
const Word phase{"phase", byScene("the only one; with several required"), "that comes in"},
    backflow{"backflow", notGiven, "phase that comes in where the flow is inwards; without it there fluid stands still"},
    phaseOfLayer{"phase", required, "that comes in there"};
const DictionaryList layers{"layers", byScene("none"), "parts of the section through which other phases come in"};
const VectorParameter low{"min", units::m, byScene("endless"), "lowest corner of the part"},
    high{"max", units::m, byScene("endless"), "highest corner of the part"};
}

bool Opening::opensAt(const Vector<3>& x, int dimension, double beside) const
{
    const Vector<3> by = beside * Vector<3>{1, 1, 1};
    return contains({extent.low - by, extent.high + by}, x, dimension) && (!radius || mag(x - point) <= *radius) &&
           std::ranges::none_of(without, [&](const Opening& other) { return other.opensAt(x, dimension); });
}

bool Opening::leavesOut(const Opening& part) const
{
    return std::ranges::any_of(without, [&](const Opening& other) { return other.name == part.name; });
}

bool Opening::brings(std::size_t phase) const
{
    return stream.phase == phase || std::ranges::any_of(layers, [&](const Layer& layer) { return layer.stream.phase == phase; });
}

const Stream& Opening::streamAt(const Vector<3>& x, int dimension) const
{
    const auto layer = std::ranges::find_if(layers, [&](const Layer& each) { return contains(each.extent, x, dimension); });
    return layer == layers.end() ? stream : layer->stream;
}

namespace
{
/// Whether two openings have the same plane, to round-off.
bool inOnePlane(const Opening& a, const Opening& b, double spacing)
{
    return mag(a.normal - b.normal) < 1e-9 && std::abs(a.distance(b.point)) < 1e-6 * spacing;
}

struct Reader
{
    const Geometry& geometry;
    const Coefficients& coefficients;
    const State& state;

    Opening readPlane(const Dictionary&) const;
    void readExtent(const Dictionary&, Opening&) const;
    void readDrive(const Dictionary&, Opening&) const;
    void readStream(const Dictionary&, Opening&) const;
    Stream streamOf(const Dictionary&, std::size_t phase) const;
    std::size_t phaseOf(const Dictionary&, const Word&) const;
    std::vector<Opening> operator()(const Dictionary&) const;
};

std::size_t Reader::phaseOf(const Dictionary& d, const Word& phase) const
{
    const auto& phases = coefficients.phases;
    if (!phase.given(d) && phases.size() > 1)
    {
        phase.error(d, fmt::format("\"{}\" is missing: there are several phases, and which comes in must be said. Known phases: {}",
                                   phase.keyword(), list(phases)));
        return 0;
    }
    return std::size_t(std::ranges::find(phases, phase.among(d, phases, phases[0])) - phases.begin()) % phases.size();
}

Stream Reader::streamOf(const Dictionary& d, std::size_t phase) const
{
    Stream stream{phase};
    static const std::vector<std::string> own{"type",     "point",    "points",  "normal", "min",    "max",      "velocity",
                                              "flowRate", "pressure", "profile", "radius", "layers", "markFrom", "backflow"};
    for (const auto& evolving : state)
        if (std::ranges::find(own, evolving.value.name) != own.end())
            d.error(
                evolving.value.name,
                fmt::format("is an entry of every opening, and the name of a field that comes in, too: give the field another name than {}",
                            list(own)));
        else if (evolving.inlet) stream.values[evolving.value.name] = evolving.inlet(d, phase);
    return stream;
}

void Reader::readDrive(const Dictionary& d, Opening& opening) const
{
    opening.velocity = entry::velocity.ifGiven(d);
    opening.flowRate = entry::flowRate.in(units::mPerS * (coefficients.dimension == 3 ? units::m2 : units::m)).ifGiven(d);
    if (opening.velocity && opening.flowRate) entry::flowRate.error(d, "flowRate is given, and velocity too: keep one of them");
}

void Reader::readStream(const Dictionary& d, Opening& opening) const
{
    opening.stream = streamOf(d, phaseOf(d, entry::phase));
    opening.markFrom = entry::markFrom.ifGiven(d);
}

Opening Reader::readPlane(const Dictionary& d) const
{
    Opening opening;
    opening.name = d.keyword();
    opening.where = d.location();
    opening.normal = entry::normal(d);
    entry::normal.checkPlane(d, opening.normal, geometry.dimension);
    for (int k = 0; k < geometry.dimension; ++k)
        if (geometry.periodic[k] && opening.normal.*component(k) != 0)
            entry::normal.error(
                d, fmt::format("the domain is periodic in {}: what leaves it there comes in again, and no plane across is an opening",
                               coordinateNames[k]));
    return opening;
}

void Reader::readExtent(const Dictionary& d, Opening& opening) const
{
    opening.point = entry::point(d);
    opening.extent.low = entry::min(d, opening.extent.low);
    opening.extent.high = entry::max(d, opening.extent.high);
    for (int k = 0; k < geometry.dimension; ++k)
        if (const auto a = component(k); opening.extent.high.*a < opening.extent.low.*a)
            entry::max.error(d, fmt::format("max must not be less than min; in {} it is {} against {}", coordinateNames[k],
                                            opening.extent.high.*a, opening.extent.low.*a));
    const auto roundOff = 1e-6 * coefficients.spacing * Vector<3>{1, 1, 1};
    opening.extent.low -= roundOff;
    opening.extent.high += roundOff;
    if (!opening.inlet) opening.margin = coefficients.spacing;
}

std::vector<Opening> Reader::operator()(const Dictionary& d) const
{
    const auto known = entry::type.known(d);
    if (!known) return {};
    const auto& type = *known;
    auto opening = readPlane(d);
    opening.inlet = type != "outlet";
    if (type != "drip") readExtent(d, opening);
    if (type == "outlet")
    {
        opening.pressure = entry::pressureOutside(d);
        opening.backflow = entry::backflow.given(d);
        if (opening.backflow) opening.stream = streamOf(d, phaseOf(d, entry::backflow));
        return {opening};
    }
    readDrive(d, opening);
    readStream(d, opening);
    if (type == "inlet")
    {
        opening.pressure = entry::pressure.ifGiven(d);
        opening.developed = entry::profile(d) == "developed";
        for (const auto& layer : entry::layers(d))
        {
            const Box part{entry::low(layer, Box{}.low), entry::high(layer, Box{}.high)};
            opening.layers.push_back({part, streamOf(d, phaseOf(layer, entry::phaseOfLayer))});
        }
    }
    if (!opening.velocity && !opening.flowRate && !opening.pressure)
        entry::velocity.error(d, type == "inlet" ? "what drives the flow is missing: give a velocity, a flowRate or a pressure"
                                                 : "how much comes in is missing: give a velocity or a flowRate");
    if (type != "drip") return {opening};

    opening.radius = entry::radius(d);
    std::vector<Opening> drips;
    for (const auto& point : entry::points(d))
    {
        drips.push_back(opening);
        drips.back().name += std::to_string(drips.size());
        drips.back().point = point;
    }
    if (drips.empty()) entry::points.error(d, "there must be a point at least");
    return drips;
}
}

EntryList openingEntries()
{
    using namespace entry;
    const EntryList ofPlane{point, min, max}, ofDrive{entry::velocity, flowRate}, ofStream{phase, markFrom};
    const Cases byType{{"inlet",
                        ofPlane + ofDrive + EntryList{pressure, profile} + ofStream + EntryList{{layers, {phaseOfLayer, low, high}}}},
                       {"outlet", ofPlane + EntryList{pressureOutside, backflow}},
                       {"drip", EntryList{points, radius} + ofDrive + ofStream},
                       {"flux", ofPlane + ofDrive + ofStream}};
    return {{opening, {{type, byType}, normal}}};
}

namespace
{
std::vector<Opening> readAll(const Dictionary& dict, const Reader& read, const std::map<std::string, std::string>& absent)
{
    std::vector<Opening> openings;
    std::vector<std::string> others; // names of those that are not cut out of an open plane
    for (const auto& name : dict.keys())
    {
        if (!dict.isDictionary(name))
        {
            dict.error(name, fmt::format("opening \"{0}\" must be a dictionary: {0} {{ type inlet; ... }}", name));
            continue;
        }
        const auto d = dict.subDict(name);
        const auto all = read(d);
        openings.insert(openings.end(), all.begin(), all.end());
        for (const auto& [field, why] : absent)
            if ((all.empty() || all[0].inlet) && d.found(field)) d.error(field, why);
        if (entry::type.is(d, "inlet") || entry::type.is(d, "outlet")) others.push_back(name);
    }
    const auto isOther = [&](const Opening& o) { return std::ranges::find(others, o.name) != others.end(); };
    const auto before = openings;
    for (auto& opening : openings)
        for (const auto& part : before)
            if (isOther(opening) && !isOther(part) && inOnePlane(opening, part, read.coefficients.spacing)) opening.without.push_back(part);
    return openings;
}
}

std::vector<Opening> readOpenings(const Case& theCase, const Geometry& geometry, const Coefficients& coefficients, const State& state,
                                  const std::map<std::string, std::string>& absent)
{
    if (!theCase.has("constant/openings")) return {};
    const auto dict = theCase.dictionary("constant/openings");
    auto openings = readAll(dict, {geometry, coefficients, state}, absent);
    dict.reportUnused();
    return openings;
}

std::vector<Opening> readOpeningPlanes(const Case& theCase, const Geometry& geometry, const Coefficients& coefficients)
{
    if (!theCase.has("constant/openings")) return {};
    return readAll(theCase.dictionary("constant/openings"), {geometry, coefficients, State{}}, {});
}

}
