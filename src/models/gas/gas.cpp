#include "models/gas/gas.hpp"
#include "models/gas/AmbientGas.hpp"
#include "models/gas/CalmGas.hpp"
#include "models/gas/GasBand.hpp"
#include "models/gas/gasTerms.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Choice gas{
    "gas",
    {{"whole", "wherever there is no liquid"},
     {"calm",
      "as `whole`, and without the lattice of its background pressure far from the liquid: it stays at rest where nothing moves it"},
     {"band", "within some supports of the liquid, at a constant pressure beyond: where nothing asks for the motion of the gas"}},
    "whole",
    "where the lightest phase is"};
const Scalar gasBand{"gasBand", Unit{units::none, "supports"}, 3, atLeast(2.5),
                     "width of the band, with `gas band;`: its outer support stands still"};
}

namespace
{
void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    const auto& gas = reading.choose(entry::gas);
    if (gas != "band" && entry::gasBand.given(reading.schemes))
        entry::gasBand.error(reading.schemes, "is the width of `gas band;`: give that, or leave this out");
    if (gas == "whole") return;
    if (!settings.multiphase())
        return entry::gas.error(reading.schemes, gas + " is of the lightest of several phases, and constant/phaseProperties lists one");
    const auto phase = std::size_t(std::ranges::min_element(c.restDensity) - c.restDensity.begin());
    if (gas == "calm")
    {
        Evolving share{stateField(Ambient{})};
        share.written = false;
        settings.state.push_back(share);
        return settings.facts.give(CalmPhase{int(phase)}, "gas of system/sphSchemes");
    }
    c.set(GasAtRest::of(c.restDensity[phase], settings.resolution.kernel, c.dimension, c.support, c.spacing));
    settings.state.push_back({stateField(Ambient{})});
    settings.facts.give(PhaseInPart{int(phase)}, "gas of system/sphSchemes");
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const int inPart = settings.facts.get<PhaseInPart>().phase, calm = settings.facts.get<CalmPhase>().phase;
    if (inPart < 0 && calm < 0) return;
    reading.select(settings.force("ambientPressure", gasTerms<2>(), gasTerms<3>()));
    settings.runningModels.push_back(inPart < 0 ? running<CalmGas>(std::size_t(calm))
                                                : running<GasBand>(std::size_t(inPart), entry::gasBand(reading.schemes)));
}

bool isInPart(const Settings& settings) { return settings.facts.get<PhaseInPart>().phase >= 0; }
bool isCalm(const Settings& settings) { return settings.facts.get<CalmPhase>().phase >= 0; }
}

const Model& gasModel()
{
    static const Model model{
        "gas",
        "where the gas is: everywhere, or in a band around the liquid; and how calm",
        read,
        gasTerms<2>(),
        gasTerms<3>(),
        prepare,
        {{"gas",
          [](const Settings& s)
          { return (isInPart(s) || isCalm(s)) && (!s.facts.get<PressureForce>().hasEnergy() || s.facts.get<IntegratedDensity>().exists); },
          "band and calm go with `density numberDensity` and `pressureGradient huAdams`"},
         {"gas", [](const Settings& s) { return isInPart(s) && s.facts.get<OpenBoundary>().exists; },
          "band is for scenes without constant/openings: gas that stands behind their planes, and liquid that passes them through it, stirred one another; "
          "take `gas whole;`"},
         {"gas", [](const Settings& s) { return isCalm(s) && s.facts.get<OpenBoundary>().exists; },
          "calm is for scenes without constant/openings: beside drips, whose pressures are prescribed, the gas was fed; take `gas whole;`"},
         {"gas", [](const Settings& s) { return isCalm(s) && !(s.coefficients.backgroundPressure > 0); },
          "calm leaves out a backgroundPressure above 0, and there is none"},
         {"gas", [](const Settings& s) { return isInPart(s) && !(s.coefficients.backgroundPressure > 0); },
          "band needs a backgroundPressure above 0, which is that of the gas beyond it"}},
        {},
        {{"system/sphSchemes", {entry::gas, entry::gasBand}}}};
    return model;
}

}
