#include "models/shifting/shifting.hpp"
#include "models/shifting/Shifter.hpp"
#include "models/shifting/TransportVelocity.hpp"
#include "models/shifting/shiftingTerms.hpp"

namespace sph
{

namespace entry
{
const AutomaticScalar shifting{"shifting", units::none, byScene("automatic: 0.5 inside a liquid whose gas is left out, else 0"),
                               nonNegative, "C of particle shifting, 2 to 8 with the speed of each particle; 0: none"};
const Scalar transportVelocity{"transportVelocity", units::none, 0, nonNegative,
                               "background pressure of the transport velocity over rho c^2, 1 in the paper; 0: none"};
const Choice shiftingSpeed{"shiftingSpeed",
                           {{"own", "of the particle"}, {"largest", "of all"}},
                           byScene("own; largest where the gas is left out"),
                           "speed that shifting goes with"},
    shiftingAtSurface{"shiftingAtSurface", {"any", {"tangential", "never out of a free surface"}}, "any", "direction of shifting"},
    shiftingAtInterface{"shiftingAtInterface",
                        {"any", {"none", "fades out towards other phases, and never points to them"}},
                        byScene("none where there are several phases"),
                        "shifting near other phases"},
    transportPressure{"transportPressure",
                      {"uniform", {"local", "at most 10 |p| of the particle"}},
                      "uniform",
                      "of the transport velocity"};
}

namespace
{
/// C of a liquid alone where the case gives none, by the largest speed (README.md).
constexpr double ofLiquidAlone = 0.5;

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& dict = reading.schemes;
    const bool alone = settings.facts.get<GasLeftOut>().isLeftOut;
    const double C = entry::shifting(dict).value_or(alone && settings.integration.moves ? ofLiquidAlone : 0);
    const bool largest = reading.choose(entry::shiftingSpeed, alone ? "largest" : "own") == "largest";
    const double transport = entry::transportVelocity(dict);
    const bool tangential = reading.choose(entry::shiftingAtSurface) == "tangential";
    const bool within = reading.choose(entry::shiftingAtInterface, settings.multiphase() ? "none" : "any") == "none";
    const bool local = reading.choose(entry::transportPressure) == "local";
    reading.belongs(entry::shiftingAtSurface, entry::shifting);
    reading.belongs(entry::shiftingAtInterface, entry::shifting);
    reading.belongs(entry::shiftingSpeed, entry::shifting);
    reading.belongs(entry::transportPressure, entry::transportVelocity);
    if (transport > 0 && C > 0)
        entry::transportVelocity.error(dict, "keeps particles evenly spaced, and so does shifting: take one of them");
    if (C > 0 && !settings.integration.moves)
        entry::shifting.error(dict, "moves particles, which quasiSteady leaves where they are: take 0, or integration scheme semiImplicit");
    if (transport > 0 && settings.integration.solves)
        entry::transportVelocity.error(
            dict, "goes with steps that sound limits; semiImplicit and implicit take longer ones, in which particles are thrown apart");
    if (entry::shiftingAtInterface.given(dict) && !settings.multiphase())
        entry::shiftingAtInterface.error(dict, "is between phases, and constant/phaseProperties lists one: leave this out");
    if (alone)
        for (const Parameter* entry : {&entry::shiftingAtSurface, &entry::shiftingAtInterface})
            reading.doesNothing(*entry, "with `gas none;` shifting fades out towards the free surface");
    if (C > 0)
    {
        if (alone) reading.select("interiorShifting");
        else if (tangential)
        {
            reading.select("surfaceShifting");
            reading.select(within ? "concentrationWithinPhase" : "concentrationGradient");
        }
        else reading.select(within ? "interfaceShifting" : "particleShifting");
        settings.runningModels.push_back(running<Shifter>(C, largest));
    }
    if (transport > 0)
    {
        settings.coefficients.set(TransportNumber{transport});
        reading.select(local ? "localTransportVelocity" : "transportVelocity");
        reading.select("transportStress");
        settings.state.push_back({stateField(TransportVelocity{})});
        settings.state.push_back({stateField(TransportAcceleration{})}); // of the last evaluation
        settings.facts.give(DriftVelocity{TransportVelocity::info.name}, "transportVelocity of system/sphSchemes");
        settings.runningModels.push_back(running<Transporter>());
    }
}
}

const Model& shiftingModel()
{
    static const Model model{"shifting",
                             "particle shifting and transport velocity: what keeps particles evenly spaced",
                             read,
                             shiftingTerms<2>(),
                             shiftingTerms<3>(),
                             nullptr,
                             {},
                             {},
                             {{"system/sphSchemes",
                               {entry::shifting, entry::shiftingSpeed, entry::shiftingAtSurface, entry::shiftingAtInterface,
                                entry::transportVelocity, entry::transportPressure}}}};
    return model;
}

}
