#include "shifting.hpp"
#include "Shifter.hpp"
#include "TransportVelocity.hpp"
#include "shiftingTerms.hpp"

namespace sph
{

namespace
{
using Words = std::vector<std::string>;

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& dict = reading.schemes;
    const double C = dict.getNonNegative("shifting", units::none, 0);
    const bool largest = dict.choose("shiftingSpeed", Words{"own", "largest"}, "own") == "largest";
    const double transport = dict.getNonNegative("transportVelocity", units::none, 0);
    const bool tangential = reading.choose("shiftingAtSurface", Words{"any", "tangential"}, "any") == "tangential";
    const bool local = reading.choose("transportPressure", Words{"uniform", "local"}, "uniform") == "local";
    reading.belongs("shiftingAtSurface", "shifting");
    reading.belongs("shiftingSpeed", "shifting");
    reading.belongs("transportPressure", "transportVelocity");
    if (transport > 0 && C > 0) dict.error("transportVelocity", "keeps particles evenly spaced, and so does shifting: take one of them");
    if (C > 0 && !settings.integration.moves)
        dict.error("shifting", "moves particles, which quasiSteady leaves where they are: take 0, or integration scheme semiImplicit");
    if (transport > 0 && settings.integration.solves)
        dict.error("transportVelocity", "goes with steps that sound limits; semiImplicit may take longer ones, in which particles are thrown apart");
    if (C > 0)
    {
        reading.select(tangential ? "surfaceShifting" : "particleShifting");
        settings.parts.push_back(partOf<Shifter>(C, largest));
    }
    if (transport > 0)
    {
        settings.coefficients.set(TransportNumber{transport});
        reading.select(local ? "localTransportVelocity" : "transportVelocity");
        reading.select("transportStress");
        settings.state.push_back({stateField(TransportVelocity{})});
        settings.state.push_back({stateField(TransportAcceleration{})}); // of the last evaluation
        settings.carriers.push_back(TransportVelocity::info.name);
        settings.parts.push_back(partOf<Transporter>());
    }
}
}

const Model& shiftingModel()
{
    static const Model model{"shifting", "particle shifting and transport velocity: what keeps particles evenly spaced", read, shiftingTerms<2>(),
                             shiftingTerms<3>()};
    return model;
}

}
