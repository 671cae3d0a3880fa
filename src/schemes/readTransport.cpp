#include "readTransport.hpp"
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
}

void readTransport(const Case& theCase, Settings& settings)
{
    if (!theCase.has("constant/transportProperties")) return;
    const auto dict = theCase.dictionary("constant/transportProperties");
    const auto d = dict.subDict("suspension");
    settings.coefficients.suspension.emplace();
    if (!dict.found("suspension")) return;
    settings.coefficients.suspension = readSuspension(d);
    if (settings.multiphase()) dict.error("suspension", "goes with one phase alone; constant/phaseProperties lists several");
    if (!(settings.coefficients.viscosity[0] > 0)) dict.error("suspension", "needs the viscosity `mu` of its binder in constant/phaseProperties");
    const auto& s = *settings.coefficients.suspension;
    const double packed = settings.coefficients.viscosity[0]*std::pow(1 - s.phiCritical/s.phiMax, -s.exponent)*std::exp(s.exponent);
    if (s.phiCritical < s.phiMax && !(packed < largestViscosity))
        d.error("exponent", fmt::format("{:.4g} makes the viscosity of packed powder {:.3g} Pa s: more than {:.0g} cannot be computed with. Give a "
                                           "smaller exponent, or a smaller phiCritical", s.exponent, packed, largestViscosity));
    dict.reportUnused();
}

}
