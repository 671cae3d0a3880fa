#include "models/gas/gas.hpp"
#include "models/gas/AmbientGas.hpp"
#include "models/gas/GasBand.hpp"
#include "models/gas/gasTerms.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Choice gas{"gas",
                 {{"whole", "wherever there is no liquid"},
                  {"band",
                   "within some supports of the liquid, at a constant pressure beyond: where nothing asks for the motion of the gas"}},
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
    if (reading.choose(entry::gas) != "band")
    {
        if (entry::gasBand.given(reading.schemes))
            entry::gasBand.error(reading.schemes, "is the width of `gas band;`: give that, or leave this out");
        return;
    }
    if (!settings.multiphase())
        return entry::gas.error(reading.schemes, "leaves out the lightest of several phases, and constant/phaseProperties lists one");
    const auto phase = std::size_t(std::ranges::min_element(c.restDensity) - c.restDensity.begin());
    c.set(GasAtRest::of(c.restDensity[phase], settings.resolution.kernel, c.dimension, c.support, c.spacing));
    settings.state.push_back({stateField(Ambient{})});
    settings.facts.give(PhaseInPart{int(phase)}, "gas of system/sphSchemes");
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const int phase = settings.facts.get<PhaseInPart>().phase;
    if (phase < 0) return;
    reading.select(settings.force("ambientPressure", gasTerms<2>(), gasTerms<3>()));
    settings.runningModels.push_back(running<GasBand>(std::size_t(phase), entry::gasBand(reading.schemes)));
}

bool isInPart(const Settings& settings) { return settings.facts.get<PhaseInPart>().phase >= 0; }
}

const Model& gasModel()
{
    static const Model model{
        "gas",
        "where the gas is: everywhere, or in a band around the liquid",
        read,
        gasTerms<2>(),
        gasTerms<3>(),
        prepare,
        {{"gas",
          [](const Settings& s)
          { return isInPart(s) && (!s.facts.get<PressureForce>().hasEnergy() || s.facts.get<IntegratedDensity>().exists); },
          "band goes with `density numberDensity` and `pressureGradient huAdams`"},
         {"gas", [](const Settings& s) { return isInPart(s) && s.facts.get<OpenBoundary>().exists; },
          "band is for scenes without constant/openings: gas that stands behind their planes, and liquid that passes them through it, stirred one another; "
          "take `gas whole;`"},
         {"gas", [](const Settings& s) { return isInPart(s) && !(s.coefficients.backgroundPressure > 0); },
          "band needs a backgroundPressure above 0, which is that of the gas beyond it"}},
        {},
        {{"system/sphSchemes", {entry::gas, entry::gasBand}}}};
    return model;
}

}
