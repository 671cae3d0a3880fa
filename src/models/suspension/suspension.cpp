#include "suspension.hpp"
#include "Migration.hpp"
#include "Suspension.hpp"
#include "suspensionTerms.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
using Words = std::vector<std::string>;

/// [Pa s]; rock creeps with 1e20.
constexpr double largestViscosity = 1e30;

/// The length a of D_c a^2 [m].
double readLength(const Dictionary& d)
{
    const bool byDiameter = d.found("diameter"), byRadius = d.found("radius");
    if (byDiameter == byRadius)
        d.error("radius", byRadius ? "the powder's size is given twice: keep `diameter` or `radius`"
                                   : "the powder's size is missing: give its `diameter` or `radius`");
    double diameter = 1;
    if (byDiameter) diameter = d.getPositive("diameter", units::m);
    if (byRadius) diameter = 2*d.getPositive("radius", units::m);
    return d.choose("a", Words{"diameter", "radius"}) == "radius" ? 0.5*diameter : diameter;
}

Suspension readSuspension(const Dictionary& d)
{
    Suspension s;
    s.phiMax = d.getPositive("phiMax", units::none);
    if (s.phiMax > 1) d.error("phiMax", fmt::format("{:.6g} is no volume fraction: powder takes up at most the whole volume", s.phiMax));
    s.exponent = d.getPositive("exponent", units::none);
    s.phiCritical = d.getPositive("phiCritical", units::none, 0.99*s.phiMax);
    if (s.phiCritical >= s.phiMax)
        d.error("phiCritical", fmt::format("{:.6g} must be less than phiMax, {:.6g}: there the viscosity is infinite", s.phiCritical, s.phiMax));
    if (d.found("phi")) s.phi = d.getNonNegative("phi", units::none, 0);
    if (s.phi && *s.phi >= s.phiMax)
        d.error("phi", fmt::format("{:.6g} must be less than phiMax, {:.6g}, at which the powder is packed and does not flow", *s.phi, s.phiMax));
    const double a = readLength(d), Dc = d.getPositive("Dc", units::none), Deta = d.getPositive("Deta", units::none);
    s.Dc_a2 = Dc*sqr(a);
    s.Deta_a2 = Deta*sqr(a);
    const bool refuses = d.choose("noSteadyState", Words{"refuse", "warn"}, "refuse") == "refuse";
    if (Dc >= Deta)
    {
        const auto what = fmt::format("Dc/Deta is {:.4g}: from 1 on there is no steady state, powder gathers until it is packed", Dc/Deta);
        if (refuses) d.error("Deta", what + ". Give a larger Deta, or say `noSteadyState warn;`");
        else d.diagnostics().warning(d.where("Deta"), what);
    }
    return s;
}

/// constant/transportProperties; false where it has no suspension.
bool readPowder(const Reading& reading)
{
    if (!reading.theCase.has("constant/transportProperties")) return false;
    const auto dict = reading.theCase.dictionary("constant/transportProperties");
    const auto d = dict.subDict("suspension");
    if (!dict.found("suspension")) return false;
    const auto s = readSuspension(d);
    auto& c = reading.settings.coefficients;
    if (reading.settings.multiphase()) dict.error("suspension", "goes with one phase alone; constant/phaseProperties lists several");
    if (c.viscosity.empty() || !(c.viscosity[0] > 0)) dict.error("suspension", "needs the viscosity `mu` of its binder in constant/phaseProperties");
    else if (const double packed = c.viscosity[0]*std::pow(1 - s.phiCritical/s.phiMax, -s.exponent)*std::exp(s.exponent);
             s.phiCritical < s.phiMax && !(packed < largestViscosity))
        d.error("exponent", fmt::format("{:.4g} makes the viscosity of packed powder {:.3g} Pa s: more than {:.0g} cannot be computed with. Give a "
                                        "smaller exponent, or a smaller phiCritical", s.exponent, packed, largestViscosity));
    c.set(s);
    dict.reportUnused();
    return true;
}

int readCount(const Dictionary& dict, const char* key, int fallback)
{
    const int count = dict.get<int>(key, fallback);
    if (count < 1) dict.error(key, fmt::format("{} is a number of steps, at least 1, not {}", key, count));
    return count;
}

Evolving powderFraction(const Suspension& s)
{
    Evolving powder{stateField(PowderFraction{}), stateField(PowderRate{})};
    powder.advancedByModel = true;
    powder.amount = "Powder";
    powder.missing = [s](const Loading& loading)
    {
        if (loading.restarted) throw CaseError("the time folder that the run goes on from has no field phi: where the powder is, is lost");
        if (!s.phi) throw CaseError({"constant/transportProperties", 0}, "has no `phi`, the powder's volume fraction, and nor has the time folder");
        std::fill_n(loading.values[0], loading.size(), *s.phi);
    };
    powder.check = [s](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i)
            if (const double phi = loading.values[0][i]; !(phi >= 0 && (phi < s.phiMax || loading.restarted)))
                throw CaseError(fmt::format("{} has the volume fraction of powder phi = {:.6g}: it lies from 0 to below phiMax, {:.6g}", loading.particle(i),
                                            phi, s.phiMax));
    };
    powder.inlet = [s](const Dictionary& d)
    {
        const double phi = d.getNonNegative("phi", units::none, s.phi.value_or(0));
        if (!d.found("phi") && !s.phi) d.error("phi", "the volume fraction of the powder that comes in is missing");
        if (phi >= s.phiMax)
            d.error("phi", fmt::format("{:.6g} must be less than phiMax, {:.6g}, at which the powder is packed and does not flow", phi, s.phiMax));
        return phi;
    };
    return powder;
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    if (!readPowder(reading))
    {
        settings.absent[PowderFraction::info.name] = "is the volume fraction of powder, and constant/transportProperties has no suspension";
        return;
    }
    settings.variableViscosity = true;
    settings.state.push_back(powderFraction(settings.coefficients.of<Suspension>()));
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    if (!c.has<Suspension>()) return;
    const auto& dict = reading.schemes;
    auto numbers = c.of<Suspension>();
    const auto rate = reading.choose("shearRate", Words{"stress", "correctedGradient", "gradient"}, reading.paper() ? "gradient" : "stress");
    Words terms;
    if (rate == "stress")
    {
        const double alpha = dict.getNonNegative("subParticleShear", units::none, 0.025);
        numbers.shearShare = 0.5*alpha*c.spacing*c.spacing;
        terms.push_back(alpha > 0 ? "subParticleShear" : "resolvedShear");
    }
    else terms.push_back(rate == "gradient" ? "velocityGradientShear" : "correctedGradientShear");
    terms.push_back("phillipsFlux");
    c.set(numbers);
    reading.select("krieger");
    const std::set<std::string> changed{Velocity::info.name, PowderFraction::info.name};
    const bool corrects = rate != "gradient";
    if (corrects) settings.groups.push_back({ofCorrection, {"gradientCorrection"}});
    settings.groups.push_back({ofMigration, terms, changed});

    const auto integration = dict.subDictOrEmpty("integration");
    MigrationSteps steps;
    steps.factor = integration.getPositive("migrationFactor", units::none, steps.factor)*integration.getPositive("stepFactor", units::none, 1);
    steps.most = readCount(integration, "migrationSteps", steps.most);
    settings.shown.insert(settings.shown.end(), {{ShearRate::info.name, ShearRate::info.name}, {DynamicViscosity::info.name, "eta"}});
    settings.parts.push_back(partOf<Migration>(steps, corrects));
}

bool suspends(const Settings& s) { return s.coefficients.has<Suspension>(); }
}

const Model& suspensionModel()
{
    static const Model model{"suspension", "powder in a binder: its viscosity, and its migration under shear", read, suspensionTerms<2>(), suspensionTerms<3>(),
                             prepare,
                             {{"viscosity", [](const Settings& s) { return suspends(s) && s.has("viscosity", "none"); },
                               "none leaves out the viscosity that powder migrates by; take harmonic or cleary"}}};
    return model;
}

}
