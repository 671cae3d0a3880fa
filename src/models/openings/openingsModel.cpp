#include "models/openings/openingsModel.hpp"
#include "models/openings/RunningOpenings.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{
void declare(const Reading& reading)
{
    const char* const file = "constant/openings";
    if (!reading.theCase.has(file)) return;
    const auto openings = reading.theCase.dictionary(file);
    const bool isDriven = std::ranges::any_of(openings.keys(),
                                              [&](const std::string& name)
                                              {
                                                  if (!openings.isDictionary(name)) return false;
                                                  const auto d = openings.subDict(name);
                                                  return d.isWord("type", "inlet") && d.found("pressure");
                                              });
    reading.settings.facts.give(OpenBoundary{true, isDriven}, file);
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    if (!settings.facts.get<OpenBoundary>().exists) return;
    Evolving holder{stateField(Holder{})}, pressure{stateField(HeldPressure{})};
    holder.written = pressure.written = false; // by where particles lie
    settings.state.push_back(holder);
    settings.state.push_back(pressure);
}

/// Time at which a particle came in, as a field that evolves: a new particle is not marked.
Evolving mark()
{
    Evolving enteredAt{stateField(EntryTime{})};
    enteredAt.missing = [](const Loading& loading) { std::fill_n(loading.values[0], loading.size(), EntryTime::notMarked); };
    return enteredAt;
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto openings = readOpenings(reading.theCase, reading.geometry, settings.coefficients, settings.state, settings.absent,
                                       settings.facts.get<GasLeftOut>().isLeftOut);
    for (const auto& opening : openings)
        if (settings.integration.solvesPressure && opening.inlet && opening.pressure)
            reading.theCase.diagnostics().error(
                opening.where,
                fmt::format("opening \"{}\" has a pressure, which drives the plug that it holds at the start of a step: integration scheme "
                            "implicit takes steps that are longer than the plug bears; leave the pressure out, or take semiImplicit",
                            opening.name));
        else if (!settings.integration.moves)
            reading.theCase.diagnostics().error(
                opening.where,
                fmt::format("opening \"{}\" needs particles that move, which integration scheme quasiSteady leaves where they "
                            "are; take semiImplicit",
                            opening.name));
    const int gas = settings.facts.get<PhaseInPart>().phase;
    for (const auto& opening : openings)
        if (gas >= 0 && opening.inlet && opening.brings(std::size_t(gas)))
            reading.theCase.diagnostics().error(
                opening.where,
                fmt::format(
                    "opening \"{}\" lets {} in, which `gas band;` of system/sphSchemes keeps within some supports of the liquid alone: what "
                    "drives a gas needs all of it, `gas whole;`",
                    opening.name, settings.coefficients.phases[std::size_t(gas)]));
    if (std::ranges::any_of(openings, [](const Opening& opening) { return opening.markFrom.has_value(); }))
        settings.state.push_back(mark());
    if (!openings.empty()) settings.runningModels.push_back(running<RunningOpenings>(openings));
}
}

const Model& openingsModel()
{
    static const Model model{"openings",
                             "inlets and outlets: planes across ducts",
                             read,
                             {},
                             {},
                             prepare,
                             {},
                             {},
                             {{"constant/openings", openingEntries(), "inlets and outlets; without the file there are none"}},
                             declare};
    return model;
}

}
