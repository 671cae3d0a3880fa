#include "models/pressure/pressure.hpp"
#include "models/pressure/CompressionEnergy.hpp"
#include "models/pressure/pressureTerms.hpp"
#include "models/pressure/stableSound.hpp"
#include "scene/TwoLevels.hpp"
#include "scene/flowLimit.hpp"
#include "scene/soundDamping.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace sph
{

namespace entry
{
const Choice pressureGradient{"pressureGradient",
                              {{"huAdams", "gradient of an energy"},
                               {"densityWeighted", "the same sound speed in phases of any density"},
                               "monaghan",
                               {"massWeighted", "p/rho^2 of both: Kauzlaric et al. (2011), eq. (3.2)"},
                               {"difference", "no force where p is uniform; does not conserve momentum"},
                               {"correctedDifference", "the same, exact for a linear p"},
                               {"tensileControlled", "for free surfaces"}},
                              "huAdams",
                              "form of the acceleration by pressure"};
const Scalar pMin{"pMin", units::pressure, notGiven, "tension at which a fluid without a gas parts, 0 or less"};
const AutomaticScalar backgroundPressure{"backgroundPressure", units::pressure,
                                         byScene("automatic: 0.8 sigma/spacing with surface tension, else 0"), anyNumber,
                                         "the same in all phases: keeps the particles of an interface together"};
}

namespace
{
void prepare(const Reading& reading)
{
    auto& c = reading.settings.coefficients;
    const auto& dict = reading.schemes;
    if (const auto least = entry::pMin.ifGiven(dict)) c.leastPressure = *least;
    if (c.leastPressure > 0)
        entry::pMin.error(dict, fmt::format("is the tension at which the fluid parts, 0 or less, not {:.4g} Pa", c.leastPressure));
    const bool alone = reading.settings.facts.get<GasLeftOut>().isLeftOut;
    if (alone && entry::pMin.given(dict))
        entry::pMin.error(dict, "does nothing with `gas none;`, which bounds the tension of spray by itself: leave this out");
    else if (c.leastPressure > -1e299) reading.settings.facts.give(FreeSurface{true}, "pMin of system/sphSchemes");

    const auto& gradient = reading.choose(entry::pressureGradient);
    using Form = PressureForce::Form;
    reading.settings.facts.give(PressureForce{gradient == "huAdams"           ? Form::huAdams
                                              : gradient == "densityWeighted" ? Form::densityWeighted
                                                                              : Form::other},
                                "pressureGradient of system/sphSchemes");
}

/// So that the tension of an interface band does not tear the particles apart.
void readBackground(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    if (const auto given = entry::backgroundPressure(reading.schemes)) c.backgroundPressure = *given;
    else if (settings.facts.get<InterfaceForces>().act && !settings.facts.get<GasLeftOut>().isLeftOut)
    {
        c.backgroundPressure = 0.8 * settings.facts.get<InterfaceEnergy>().largest / c.spacing;
        settings.reasons.push_back(
            fmt::format("background pressure {:.4g} Pa: 0.8 gamma/spacing, so that the tension of the interface band does not "
                        "tear the particles apart",
                        c.backgroundPressure));
    }
}

/// The swing of the pressure in a drop off the lattice, 8 spacings to the radius, gas of 1/100 of its viscosity, explicit steps: it decays at 3:1 for
/// Laplace numbers of 10 and 27, and grows for 1000 and 72000, and for all four at 10:1, 100:1 and 1000:1.
void warnOfWeighing(const Reading& reading)
{
    auto& settings = reading.settings;
    settings.facts.give(EnergyAdvice{"`pressureGradient huAdams`"}, "pressureGradient of system/sphSchemes");
    const auto [least, most] = std::minmax_element(settings.coefficients.restDensity.begin(), settings.coefficients.restDensity.end());
    if (*most == *least) return;
    reading.schemes.diagnostics().warning(
        entry::pressureGradient.where(reading.schemes),
        fmt::format("densityWeighted has no energy between phases of densities 1 : {:.4g}: what is at rest sets itself in motion "
                    "where viscosity does not prevent it. huAdams, the default, has one",
                    *most / (*least)));
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    readBackground(reading);
    if (settings.facts.get<ConstitutiveStress>().exists) return;
    settings.runningModels.push_back(running<CompressionEnergy>());
    const bool prescribed = std::any_of(settings.state.begin(), settings.state.end(),
                                        [](const Evolving& e) { return e.value.name == HeldPressure::info.name; });
    reading.select(std::string(settings.multiphase() ? "taitOfPhase" : "tait") + (prescribed ? "OrHeld" : "") +
                   (settings.facts.get<PhaseInPart>().phase >= 0 ? "OrAmbient" : ""));
    const auto& gradient = settings.chosen.at(entry::pressureGradient.keyword());
    if (settings.facts.get<PhaseInPart>().phase < 0 && settings.facts.get<CalmPhase>().phase < 0)
        reading.select(settings.force(gradient + "Pressure", pressureTerms<2>(), pressureTerms<3>()));
    if (!settings.separateSums.empty()) reading.select("addPressure");
    if (gradient == "densityWeighted") warnOfWeighing(reading);
    if (!settings.integration.solvesPressure) return;
    reading.select(settings.multiphase() ? "volumeStiffness" : "uniformVolumeStiffness");
    reading.select("pressureRate");
    for (const char* response : {"repulsionOfChange", "pressureResponse"}) settings.integration.responses.push_back(response);
}
}

namespace
{
/// c dt/h up to which what damps sound beside viscosity holds it, where the density is integrated by rates of half a step on; 0.85 of what holds on a lattice at
/// rest: at 0.9 and 0.95 of it water that sloshes, 8 spacings deep, is shaken to pieces with the kernels that are narrow beside their support (src/kernels/README.md).
double heldSound(const Settings& settings)
{
    const auto& c = settings.coefficients;
    const bool damped = c.has<DiffusionNumber>() || c.has<ArtificialNumber>();
    if (!settings.facts.get<IntegratedDensity>().exists || !settings.integration.predicts || c.has<TwoLevels>() || !damped)
        return std::numeric_limits<double>::infinity();
    const double sound = *std::max_element(c.soundSpeed.begin(), c.soundSpeed.end());
    DampedSound wave{settings.resolution.kernel, settings.resolution.support, c.dimension};
    if (c.has<DiffusionNumber>())
    {
        wave.delta = c.of<DiffusionNumber>().delta;
        wave.renormalised = c.of<DiffusionNumber>().renormalised;
    }
    if (c.has<ArtificialNumber>()) wave.alpha = c.of<ArtificialNumber>().mu / (0.5 * c.support * sound * c.restDensity[0]);
    wave.extrapolates = settings.integration.keepsRates;
    // asked for at each step
    static thread_local std::pair<DampedSound, double> last;
    if (last.first != wave) last = {wave, 0.85 * stableSoundStep(wave)};
    return last.second;
}

/// s h/|v|, s = 0.2, where pressure is solved for. Else s h/(c + |v|), s = 0.4 and at most what is held (above); or s nu/c^2, at most 0.2 h/|v|, s = 0.25, where that is longer: an Euler step
/// of implicit viscosity damps the waves that it does not resolve; stable to 2, within 1 % to 0.5; nu the least.
std::optional<StepLimit> soundLimit(const Settings& settings, const Measured& measured)
{
    const auto& c = settings.coefficients;
    const auto& integration = settings.integration;
    const auto& s = integration.factors;
    if (settings.facts.get<ConstitutiveStress>().exists) return {};
    if (integration.solvesPressure) return StepLimit{wayByFlow(s, c.support) / measured.maxSpeed, "flow", false, &Velocity::info};
    const double h = 0.5 * c.support, sound = *std::max_element(c.soundSpeed.begin(), c.soundSpeed.end());
    const double soundStep = s.sound * std::min(1.0, heldSound(settings) / StepFactors{}.sound) * h / (sound + measured.maxSpeed);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < c.phases.size(); ++k) least = std::min(least, c.viscosity[k] / c.restDensity[k]);
    if (measured.leastViscosity) least = *measured.leastViscosity / c.restDensity[0];
    const double byViscosity = s.dampedSound * least / sqr(sound), ofWay = 0.5 * s.sound * h / measured.maxSpeed;
    const double damped = std::min(byViscosity, ofWay);
    if (integration.solves && integration.theta == 1 && damped > soundStep)
        return StepLimit{integration.maxSubSteps * damped, "damped sound", true, ofWay < byViscosity ? &Velocity::info : nullptr};
    return StepLimit{integration.maxSubSteps * soundStep, "sound", true, measured.maxSpeed > sound ? &Velocity::info : nullptr};
}

/// s h/c_eff, c_eff = sqrt(max(rho c^2)/min(rho)), s = 1.2, for the Hu-Adams pressure between phases: it pushes the light particle with the heavy
/// side's stiffness.
std::optional<StepLimit> stiffnessLimit(const Settings& settings, const Measured&)
{
    using Form = PressureForce::Form;
    const auto form = settings.facts.get<PressureForce>().form;
    if (!settings.multiphase() || form == Form::none || form == Form::densityWeighted || settings.integration.solvesPressure) return {};
    const auto& c = settings.coefficients;
    double stiffest = 0;
    for (std::size_t k = 0; k < c.phases.size(); ++k) stiffest = std::max(stiffest, c.restDensity[k] * sqr(c.soundSpeed[k]));
    const double step = settings.integration.factors.stiffness * 0.5 * c.support /
                        std::sqrt(stiffest / (*std::min_element(c.restDensity.begin(), c.restDensity.end())));
    return StepLimit{settings.integration.maxSubSteps * step, "stiffness", true};
}
}

const Model& pressureModel()
{
    static const Model model{
        "pressureGradient",
        "state equation, and the acceleration by pressure",
        read,
        pressureTerms<2>(),
        pressureTerms<3>(),
        prepare,
        {{"integration",
          [](const Settings& s) {
              return s.integration.solvesPressure &&
                     (s.facts.get<IntegratedDensity>().exists || !s.has(entry::pressureGradient, "huAdams"));
          },
          "implicit solves for the pressure of an energy: it needs `density numberDensity` and `pressureGradient huAdams`"}},
        {soundLimit, stiffnessLimit},
        {{"system/sphSchemes", {entry::pressureGradient, entry::backgroundPressure, entry::pMin}}}};
    return model;
}

}
