#include "models/suspension/suspension.hpp"
#include "models/suspension/Migration.hpp"
#include "models/suspension/SuspensionConstants.hpp"
#include "models/suspension/ViscosityFlux.hpp"
#include "models/suspension/suspensionTerms.hpp"
#include "schemes/schemeSets.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const SubDictionary suspension{"suspension", required, "powder in the liquid"};
const Scalar phi{"phi", units::none, byScene("the field phi of the time folder"), nonNegative,
                 "volume fraction of the powder at the start"},
    phiMax{"phiMax", units::none, required,
           positiveUpTo(1).saying("{:.6g} is no volume fraction: powder takes up at most the whole volume"), "of the densest packing"},
    exponent{"exponent", units::none, required, positive,
             "exponent of Krieger's viscosity; mu of constant/phaseProperties is that of the binder"},
    phiCritical{"phiCritical", units::none, byScene("0.99 phiMax"), positive, "from where on the viscosity is capped"},
    Dc{"Dc", units::none, required, positive, "D_c of Phillips' fluxes"},
    Deta{"Deta", units::none, required, positive, "D_eta of Phillips' fluxes"},
    diameter{"diameter", units::m, byScene("needed without radius"), positive, "of the powder's particles"},
    radius{"radius", units::m, byScene("needed without diameter"), positive, "of the powder's particles"};
const Choice migration{"migration",
                       {{"explicit", "steps as short as J_eta asks for"}, {"semiImplicit", "J_eta at the end of a step, solved for"}},
                       byScene("semiImplicit where J_eta makes steps 40 times as short as J_c alone, at `phi`; else explicit"),
                       "how the powder's own steps are taken"};
const Choice a{"a", {"diameter", "radius"}, required, "what D_c and D_eta multiply the square of: a factor 4 in time"},
    noSteadyState{"noSteadyState", {"refuse", "warn"}, "refuse", "where D_c/D_eta >= 1, and powder migrates until it is packed"},
    shearRate{"shearRate",
              {{"stress", "|tau|/mu, smooth where the shear rate is not"},
               {"correctedGradient", "of a gradient exact for linear flow"},
               {"gradient", "Kauzlaric et al. (2011), eq. (3.5)"}},
              "stress",
              "what powder migrates by"},
    powderFraction{"powderFraction",
                   {{"atRest", "phi = rho_0 V_phi/m, as in time folders"},
                    {"ofDensity", "phi = rho V_phi/m: Kauzlaric et al. (2011), eq. (3.8)"}},
                   "atRest",
                   "what viscosity and fluxes make of the powder's volume V_phi in a particle"};
const Scalar subParticleShear{"subParticleShear", units::none, 0.025, nonNegative,
                              "alpha of the shear that a particle's own extent adds, with shearRate stress"},
    migrationFactor{"migrationFactor", units::none, 0.25, positive, "of the limit by migration, h^2/D"},
    stepFactor{"stepFactor", units::none, 1, positive, "of all limits"};
const Count migrationSteps{"migrationSteps", byScene("4; 1 with migration semiImplicit"),
                           atLeast(1).saying("migrationSteps is a number of steps, at least 1, not {}"),
                           "steps of the powder's migration to one of the flow, at most"};
}

namespace
{
/// [Pa s]; rock creeps with 1e20.
constexpr double largestViscosity = 1e30;

/// The length a of D_c a^2 [m].
double readLength(const Dictionary& d)
{
    const bool byDiameter = entry::diameter.given(d), byRadius = entry::radius.given(d);
    if (byDiameter == byRadius)
        entry::radius.error(d, byRadius ? "the powder's size is given twice: keep `diameter` or `radius`"
                                        : "the powder's size is missing: give its `diameter` or `radius`");
    double diameter = 1;
    if (byDiameter) diameter = entry::diameter.needed(d);
    if (byRadius) diameter = 2 * entry::radius.needed(d);
    return entry::a(d) == "radius" ? 0.5 * diameter : diameter;
}

Suspension readSuspension(const Dictionary& d)
{
    Suspension s;
    s.phiMax = entry::phiMax(d);
    s.exponent = entry::exponent(d);
    s.phiCritical = entry::phiCritical(d, 0.99 * s.phiMax);
    if (s.phiCritical >= s.phiMax)
        entry::phiCritical.error(d, fmt::format("{:.6g} must be less than phiMax, {:.6g}: there the viscosity is infinite", s.phiCritical,
                                                s.phiMax));
    s.phi = entry::phi.ifGiven(d);
    if (s.phi && *s.phi >= s.phiMax)
        entry::phi.error(d, fmt::format("{:.6g} must be less than phiMax, {:.6g}, at which the powder is packed and does not flow", *s.phi,
                                        s.phiMax));
    const double a = readLength(d), Dc = entry::Dc(d), Deta = entry::Deta(d);
    s.Dc_a2 = Dc * sqr(a);
    s.Deta_a2 = Deta * sqr(a);
    const bool refuses = entry::noSteadyState(d) == "refuse";
    if (Dc >= Deta)
    {
        const auto what =
            fmt::format("Dc/Deta is {:.4g}: from 1 on there is no steady state, powder gathers until it is packed", Dc / Deta);
        if (refuses) entry::Deta.error(d, what + ". Give a larger Deta, or say `noSteadyState warn;`");
        else d.diagnostics().warning(entry::Deta.where(d), what);
    }
    return s;
}

/// constant/transportProperties; false where it has no suspension.
bool readPowder(const Reading& reading)
{
    if (!reading.theCase.has("constant/transportProperties")) return false;
    const auto dict = reading.theCase.dictionary("constant/transportProperties");
    const auto d = entry::suspension(dict);
    if (!entry::suspension.given(dict)) return false;
    const auto s = readSuspension(d);
    auto& c = reading.settings.coefficients;
    if (reading.settings.multiphase()) entry::suspension.error(dict, "goes with one phase alone; constant/phaseProperties lists several");
    if (c.viscosity.empty() || !(c.viscosity[0] > 0))
        entry::suspension.error(dict, "needs the viscosity `mu` of its binder in constant/phaseProperties");
    else if (const double packed = c.viscosity[0] * std::pow(1 - s.phiCritical / s.phiMax, -s.exponent) * std::exp(s.exponent);
             s.phiCritical < s.phiMax && !(packed < largestViscosity))
        entry::exponent.error(
            d, fmt::format("{:.4g} makes the viscosity of packed powder {:.3g} Pa s: more than {:.0g} cannot be computed with. Give a "
                           "smaller exponent, or a smaller phiCritical",
                           s.exponent, packed, largestViscosity));
    c.set(s);
    dict.reportUnused();
    return true;
}

Evolving powderFraction(const Suspension& s)
{
    Evolving powder{stateField(PowderFraction{}), stateField(PowderRate{})};
    powder.advancedByModel = powder.ofMaterial = true;
    powder.amount = "Powder";
    powder.missing = [s](const Loading& loading)
    {
        if (loading.restarted) throw CaseError("the time folder that the run goes on from has no field phi: where the powder is, is lost");
        if (!s.phi)
            throw CaseError({"constant/transportProperties", 0}, "has no `phi`, the powder's volume fraction, and nor has the time folder");
        std::fill_n(loading.values[0], loading.size(), *s.phi);
    };
    powder.check = [s](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i)
            if (const double phi = loading.values[0][i]; !(phi >= 0 && (phi < s.phiMax || loading.restarted)))
                throw CaseError(fmt::format("{} has the volume fraction of powder phi = {:.6g}: it lies from 0 to below phiMax, {:.6g}",
                                            loading.cloud.particle(i), phi, s.phiMax));
    };
    powder.inlet = [s](const Dictionary& d, std::size_t)
    {
        const double phi = entry::phi(d, s.phi.value_or(0));
        if (!entry::phi.given(d) && !s.phi) entry::phi.error(d, "the volume fraction of the powder that comes in is missing");
        if (phi >= s.phiMax)
            entry::phi.error(d, fmt::format("{:.6g} must be less than phiMax, {:.6g}, at which the powder is packed and does not flow", phi,
                                            s.phiMax));
        return phi;
    };
    return powder;
}

void declare(const Reading& reading)
{
    if (const auto* file = "constant/transportProperties";
        reading.theCase.has(file) && entry::suspension.given(reading.theCase.dictionary(file)))
        reading.settings.facts.give(VaryingViscosity{true}, file);
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    if (!readPowder(reading))
    {
        settings.absent[PowderFraction::info.name] = "is the volume fraction of powder, and constant/transportProperties has no suspension";
        return;
    }
    settings.state.push_back(powderFraction(settings.coefficients.of<Suspension>()));
}

/// Near packing J_eta is stiff beside J_c, by 1 + D_eta/D_c phi 1/mu dmu/dphi; a solve takes some ten sums over pairs, and is of first order.
bool solvesForMigration(const Reading& reading, const Dictionary& integration, const Suspension& s)
{
    if (entry::migration.given(integration)) return entry::migration(integration) == "semiImplicit";
    constexpr double worthSolving = 40;
    const double phi = s.phi.value_or(0),
                 stiffness = 1 + s.Deta_a2 / s.Dc_a2 * phi * s.exponent / (s.phiMax - std::min(phi, s.phiCritical));
    if (!(stiffness > worthSolving)) return false;
    reading.settings.reasons.push_back(
        fmt::format("migration semiImplicit: at phi {:.4g} the diffusion by viscosity is {:.3g} times that by collisions", phi, stiffness));
    return true;
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    if (!c.has<Suspension>()) return;
    const auto& dict = reading.schemes;
    auto numbers = c.of<Suspension>();
    const auto rate = reading.choose(entry::shearRate);
    std::vector<std::string> terms;
    if (rate == "stress")
    {
        const double alpha = entry::subParticleShear(dict);
        numbers.shearShare = 0.5 * alpha * c.spacing * c.spacing;
        terms.push_back(alpha > 0 ? "subParticleShear" : "resolvedShear");
    }
    else terms.push_back(rate == "gradient" ? "velocityGradientShear" : "correctedGradientShear");
    const std::string of = reading.choose(entry::powderFraction) == "ofDensity" ? "OfDensity" : "";
    terms.insert(terms.end(), {"kriegerSlope" + of, "phillipsFlux" + of});
    c.set(numbers);
    reading.select("krieger" + of);
    std::set<std::string> changed{Velocity::info.name, PowderFraction::info.name};
    if (!of.empty() && settings.facts.get<IntegratedDensity>().exists) changed.insert(Density::info.name); // by the kick
    const bool corrects = rate != "gradient";
    if (corrects) settings.groups.push_back({ofCorrection, {"gradientCorrection"}});
    const auto integration = dict.subDictOrEmpty("integration");
    MigrationSteps steps;
    steps.solves = solvesForMigration(reading, integration, numbers);
    if (steps.solves) terms.insert(terms.end(), {"diffusivityOfViscosity", "viscosityFluxRate"});
    settings.groups.push_back({ofMigration, terms, changed});
    if (steps.solves)
        settings.groups.push_back({ofMigrationSolve, {"viscosityFluxResponse"}, {PowderChange::info.name}, {}, {PowderChange::info.name}});
    steps.factor = entry::migrationFactor(integration) * entry::stepFactor(integration);
    steps.most = entry::migrationSteps(integration, steps.solves ? 1 : 4);
    settings.shown.insert(settings.shown.end(), {{ShearRate::info.name, ShearRate::info.name}, {DynamicViscosity::info.name, "eta"}});
    settings.runningModels.push_back(running<Migration>(steps, corrects));
}

bool suspends(const Settings& s) { return s.coefficients.has<Suspension>(); }
}

const Model& suspensionModel()
{
    static const Model model{"suspension",
                             "powder in a binder: its viscosity, and its migration under shear",
                             read,
                             suspensionTerms<2>(),
                             suspensionTerms<3>(),
                             prepare,
                             {{"viscosity", [](const Settings& s) { return suspends(s) && !s.facts.get<ViscousForce>().acts; },
                               "none leaves out the viscosity that powder migrates by; take harmonic or cleary"},
                              {"scheme", [](const Settings& s) { return suspends(s) && s.has(entry::scheme, "paper"); },
                               "paper is Barker et al. (2012), who have no powder; take paperPowder, Kauzlaric et al. (2011)"}},
                             {},
                             {{"constant/transportProperties",
                               {{entry::suspension,
                                 {entry::phi, entry::phiMax, entry::exponent, entry::phiCritical, entry::Dc, entry::Deta, entry::diameter,
                                  entry::radius, entry::a, entry::noSteadyState}}},
                               "what moves relative to the flow; without the file there is nothing of it"},
                              {"constant/openings", {{FreeName{"<opening>", "dictionary", ""}, {entry::phi}}}},
                              {"system/sphSchemes", {entry::shearRate, entry::subParticleShear, entry::powderFraction}},
                              {"system/sphSchemes",
                               {{SubDictionary{"integration", notGiven, ""},
                                 {entry::migration, entry::migrationFactor, entry::migrationSteps}}}}},
                             declare};
    return model;
}

}
