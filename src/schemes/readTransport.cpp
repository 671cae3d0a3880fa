#include "readTransport.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const SubDictionary suspension{"suspension", required, "powder in the liquid"};
const Scalar phi{"phi", units::none, byScene("the field phi of the time folder"), nonNegative, "volume fraction of the powder at the start"},
    phiMax{"phiMax", units::none, required, positiveUpTo(1).saying("{:.6g} is no volume fraction: powder takes up at most the whole volume"),
           "of the densest packing"},
    exponent{"exponent", units::none, required, positive, "exponent of Krieger's viscosity; mu of constant/phaseProperties is that of the binder"},
    phiCritical{"phiCritical", units::none, byScene("0.99 phiMax"), positive, "from where on the viscosity is capped"},
    Dc{"Dc", units::none, required, positive, "D_c of Phillips' fluxes"}, Deta{"Deta", units::none, required, positive, "D_eta of Phillips' fluxes"},
    diameter{"diameter", units::m, byScene("needed without radius"), positive, "of the powder's particles"},
    radius{"radius", units::m, byScene("needed without diameter"), positive, "of the powder's particles"};
const Choice a{"a", {"diameter", "radius"}, required, "what D_c and D_eta multiply the square of: a factor 4 in time"},
    noSteadyState{"noSteadyState", {"refuse", "warn"}, "refuse", "where D_c/D_eta >= 1, and powder migrates until it is packed"};
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
    if (byRadius) diameter = 2*entry::radius.needed(d);
    return entry::a(d) == "radius" ? 0.5*diameter : diameter;
}

Suspension readSuspension(const Dictionary& d)
{
    Suspension s;
    s.phiMax = entry::phiMax(d);
    s.exponent = entry::exponent(d);
    s.phiCritical = entry::phiCritical(d, 0.99*s.phiMax);
    if (s.phiCritical >= s.phiMax)
        entry::phiCritical.error(d, fmt::format("{:.6g} must be less than phiMax, {:.6g}: there the viscosity is infinite", s.phiCritical, s.phiMax));
    s.phi = entry::phi.ifGiven(d);
    if (s.phi && *s.phi >= s.phiMax)
        entry::phi.error(d,
                         fmt::format("{:.6g} must be less than phiMax, {:.6g}, at which the powder is packed and does not flow", *s.phi, s.phiMax));
    const double a = readLength(d), Dc = entry::Dc(d), Deta = entry::Deta(d);
    s.Dc_a2 = Dc*sqr(a);
    s.Deta_a2 = Deta*sqr(a);
    const bool refuses = entry::noSteadyState(d) == "refuse";
    if (Dc >= Deta)
    {
        const auto what = fmt::format("Dc/Deta is {:.4g}: from 1 on there is no steady state, powder gathers until it is packed", Dc/Deta);
        if (refuses) entry::Deta.error(d, what + ". Give a larger Deta, or say `noSteadyState warn;`");
        else d.diagnostics().warning(entry::Deta.where(d), what);
    }
    return s;
}
}

EntryList transportEntries()
{
    using namespace entry;
    return {{suspension, {phi, phiMax, exponent, phiCritical, Dc, Deta, diameter, radius, entry::a, noSteadyState}}};
}

void readTransport(const Case& theCase, Settings& settings)
{
    if (!theCase.has("constant/transportProperties")) return;
    const auto dict = theCase.dictionary("constant/transportProperties");
    const auto d = entry::suspension(dict);
    settings.coefficients.suspension.emplace();
    if (!entry::suspension.given(dict)) return;
    settings.coefficients.suspension = readSuspension(d);
    if (settings.multiphase()) entry::suspension.error(dict, "goes with one phase alone; constant/phaseProperties lists several");
    if (!(settings.coefficients.viscosity[0] > 0))
        entry::suspension.error(dict, "needs the viscosity `mu` of its binder in constant/phaseProperties");
    const auto& s = *settings.coefficients.suspension;
    const double packed = settings.coefficients.viscosity[0]*std::pow(1 - s.phiCritical/s.phiMax, -s.exponent)*std::exp(s.exponent);
    if (s.phiCritical < s.phiMax && !(packed < largestViscosity))
        entry::exponent.error(d,
                              fmt::format("{:.4g} makes the viscosity of packed powder {:.3g} Pa s: more than {:.0g} cannot be computed with. Give a "
                                          "smaller exponent, or a smaller phiCritical",
                                          s.exponent, packed, largestViscosity));
    dict.reportUnused();
}

}
