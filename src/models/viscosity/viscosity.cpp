#include "models/viscosity/viscosity.hpp"
#include "models/viscosity/ArtificialViscosity.hpp"
#include "models/viscosity/viscosityTerms.hpp"
#include "scene/TwoLevels.hpp"
#include <algorithm>

namespace sph
{

namespace entry
{
const Choice viscosity{"viscosity",
                       {{"newtonian", "the whole stress, mu (grad v + (grad v)^T)"},
                        {"harmonic", "div(mu grad v), harmonic mean of a pair"},
                        {"clearyMonaghan", "as harmonic, by the product of the volumes: Kauzlaric et al. (2011), eq. (3.4)"},
                        {"cleary", "the whole stress, along the line of centres"},
                        "none"},
                       byScene("newtonian between phases of unequal mu and with `gas none;`, else harmonic where a phase has mu"),
                       "form of the viscous acceleration"};
const Scalar artificialViscosity{"artificialViscosity", units::none, 0, nonNegative,
                                 "alpha of Monaghan and Gingold, about 0.02 for free surfaces"};
}

namespace
{
/// Along the line of centres compression is resisted by 3 mu: nu (laplacian v + 2 grad div v).
void prepare(const Reading& reading)
{
    if (entry::viscosity.is(reading.schemes, "cleary")) reading.settings.integration.factors.viscous /= 3;
}

/// s h^2/nu, s = 0.125, unless it is implicit; nu the largest pair viscosity over the smaller density.
std::optional<StepLimit> viscousLimit(const Settings& settings, const Measured& measured)
{
    const auto& c = settings.coefficients;
    if (settings.has(entry::viscosity, "none")) return {};
    const double h = 0.5 * c.support;
    double nu = 0;
    for (std::size_t k = 0; k < c.phases.size(); ++k)
        for (std::size_t l = 0; l < c.phases.size(); ++l)
            if (const double sum = c.viscosity[k] + c.viscosity[l]; sum > 0)
                nu = std::max(nu, 2 * c.viscosity[k] * c.viscosity[l] / sum / std::min(c.restDensity[k], c.restDensity[l]));
    if (measured.largestViscosity) nu = *measured.largestViscosity / c.restDensity[0];
    if (!(nu > 0) || (settings.integration.solves && !settings.integration.viscosityAtStart)) return {};
    return StepLimit{settings.integration.maxSubSteps * (settings.integration.factors.viscous * h * h / nu), "viscosity", true,
                     measured.largestViscosity ? &DynamicViscosity::info : nullptr};
}

/// Takes viscosity out of the solve of an implicit step of first order where something else, surface tension as a rule, allows no longer steps than viscosity
/// does: an iteration then sums over fewer numbers of each pair, and the step is as long and as stable (README.md).
void takeOutOfSolve(const Reading& reading)
{
    const auto& settings = reading.settings;
    auto& integration = reading.settings.integration;
    if (!integration.solvesPressure || integration.theta < 1 || settings.facts.get<VaryingViscosity>().exists) return;
    const auto others = reading.limits(settings, {});
    integration.viscosityAtStart = true;
    const auto limit = viscousLimit(settings, {});
    integration.viscosityAtStart =
        limit && std::ranges::any_of(others, [&](const StepLimit& other) { return other.deltaT <= limit->deltaT; });
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    const bool viscous = std::any_of(c.viscosity.begin(), c.viscosity.end(), [](double mu) { return mu > 0; });
    const bool unequal = std::any_of(c.viscosity.begin(), c.viscosity.end(), [&](double mu) { return mu != c.viscosity[0]; });
    const bool hasFreeStress = (unequal && !reading.paper()) || settings.facts.get<GasLeftOut>().isLeftOut;
    const auto& form = reading.choose(entry::viscosity, !viscous ? "none" : hasFreeStress ? "newtonian" : "harmonic");
    settings.facts.give(ViscousForce{form != "none"}, "viscosity of system/sphSchemes");
    if (!viscous && form != "none") reading.doesNothing(entry::viscosity, "no phase of constant/phaseProperties has mu");
    const bool variable = settings.hasViscosityField(), central = form == "cleary", product = form == "clearyMonaghan";
    const std::string kind = central    ? variable ? "cleary" : "singlePhaseCleary"
                             : product  ? variable ? "clearyMonaghan" : "singlePhaseClearyMonaghan"
                             : variable ? "harmonic"
                                        : "singlePhase";
    if (form != "none") reading.select(kind + "Viscosity");
    if (form == "newtonian")
    {
        reading.select(variable ? "viscousGradient" : "singlePhaseViscousGradient");
        reading.select(variable ? "transposedViscosity" : "singlePhaseTransposedViscosity");
    }
    if (settings.multiphase() && form != "none") reading.select("viscosityOfPhase");
    const std::string name = central ? kind : kind + "Viscous";
    if (form != "none") takeOutOfSolve(reading);
    if (form != "none" && settings.integration.solves && !settings.integration.viscosityAtStart)
    {
        settings.integration.responses.push_back(name + "Response");
        reading.select(name + "Rate");
    }

    const double alpha = entry::artificialViscosity(reading.schemes);
    if (!(alpha > 0)) return;
    c.set(ArtificialNumber{alpha * (0.5 * c.support) * (*std::max_element(c.soundSpeed.begin(), c.soundSpeed.end())) * c.restDensity[0]});
    reading.select("artificialViscosity");
}

/// s h/(2 alpha c) from two levels, s their stable decay; from one, sound binds first.
std::optional<StepLimit> artificialLimit(const Settings& settings, const Measured&)
{
    const auto& c = settings.coefficients;
    if (!c.has<TwoLevels>() || !c.has<ArtificialNumber>()) return {};
    return StepLimit{c.of<TwoLevels>().stableDecay() * 0.5 * sqr(0.5 * c.support) * c.restDensity[0] / c.of<ArtificialNumber>().mu,
                     "artificial viscosity", true};
}
}

const Model& viscosityModel()
{
    static const Model model{"viscosity",
                             "acceleration by viscosity, physical and artificial",
                             read,
                             viscosityTerms<2>(),
                             viscosityTerms<3>(),
                             prepare,
                             {{"integration",
                               [](const Settings& s)
                               { return s.has(entry::viscosity, "none") && s.integration.solves && !s.integration.solvesPressure; },
                               "semiImplicit and quasiSteady solve for viscosity, and there is none"}},
                             {viscousLimit, artificialLimit},
                             {{"system/sphSchemes", {entry::viscosity, entry::artificialViscosity}}}};
    return model;
}

}
