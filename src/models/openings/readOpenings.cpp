#include "base/words.hpp"
#include "geometry/contains.hpp"
#include "models/openings/Opening.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Choice profile{"profile",
                     {{"uniform", "the same velocity everywhere"}, {"developed", "that of developed flow in the section"}},
                     "developed",
                     "of the velocity"};
const Scalar velocity{"velocity", units::mPerS, notGiven, positive, "mean over the section: of a flux the superficial velocity"},
    flowRate{"flowRate", units::m3 / units::s, notGiven, positive, "in place of velocity; of a drip at each point; in 2-D [m^2/s]"},
    pressure{"pressure", units::pressure, notGiven, "alone: drives the flow; beside velocity or flowRate: the most that they may need"},
    pressureOutside{"pressure", units::pressure, byScene("0; with `gas none;` what has left falls freely"), "at the plane"},
    markFrom{"markFrom", units::s, notGiven, nonNegative,
             "what comes in from this time on is marked by it: the log tells how long it takes to each outlet"};
const Word phase{"phase", byScene("the only one; with several required"), "that comes in"},
    backflow{"backflow", notGiven, "phase that comes in where the flow is inwards; without it there fluid stands still"},
    phaseOfLayer{"phase", required, "that comes in there"};
const DictionaryList layers{"layers", byScene("none"), "parts of the section through which other phases come in"};
const VectorParameter low{"min", units::m, byScene("endless"), "lowest corner of the part"},
    high{"max", units::m, byScene("endless"), "highest corner of the part"};
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
struct Reader
{
    const Coefficients& coefficients;
    const State& state;
    bool alone;

    void readDrive(const Dictionary&, Opening&) const;
    void readStream(const Dictionary&, Opening&) const;
    Stream streamOf(const Dictionary&, std::size_t phase) const;
    std::size_t phaseOf(const Dictionary&, const Word&) const;
    Opening operator()(const Dictionary&, const OpenPlane&) const;
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

Opening Reader::operator()(const Dictionary& d, const OpenPlane& plane) const
{
    Opening opening{plane};
    if (!opening.inlet)
    {
        opening.pressure = entry::pressureOutside.ifGiven(d);
        if (!alone) opening.pressure = opening.pressure.value_or(0);
        opening.backflow = entry::backflow.given(d);
        if (opening.backflow) opening.stream = streamOf(d, phaseOf(d, entry::backflow));
        return opening;
    }
    readDrive(d, opening);
    readStream(d, opening);
    if (!opening.isPart)
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
        entry::velocity.error(d, opening.isPart ? "how much comes in is missing: give a velocity or a flowRate"
                                                : "what drives the flow is missing: give a velocity, a flowRate or a pressure");
    return opening;
}
}

EntryList openingEntries()
{
    using namespace entry;
    const EntryList ofDrive{entry::velocity, flowRate}, ofStream{phase, markFrom};
    return openPlaneEntries({.ofInlet = ofDrive + EntryList{pressure, profile} + ofStream + EntryList{{layers, {phaseOfLayer, low, high}}},
                             .ofOutlet = {pressureOutside, backflow},
                             .ofDrip = ofDrive + ofStream,
                             .ofFlux = ofDrive + ofStream});
}

std::vector<Opening> readOpenings(const Case& theCase, const Geometry& geometry, const Coefficients& coefficients, const State& state,
                                  const std::map<std::string, std::string>& absent, bool alone)
{
    if (!theCase.has("constant/openings")) return {};
    const auto dict = theCase.dictionary("constant/openings");
    const Reader read{coefficients, state, alone};
    std::vector<Opening> openings;
    for (const auto& d : openingDictionaries(dict))
    {
        const auto planes = readOpenPlanes(d, geometry, coefficients.spacing);
        if (!planes.empty())
        {
            auto opening = read(d, planes[0]);
            for (const auto& plane : planes)
            {
                static_cast<OpenPlane&>(opening) = plane;
                openings.push_back(opening);
            }
        }
        for (const auto& [field, why] : absent)
            if ((planes.empty() || planes[0].inlet) && d.found(field)) d.error(field, why);
    }
    cutOutParts(openings, coefficients.spacing);
    dict.reportUnused();
    return openings;
}

}
