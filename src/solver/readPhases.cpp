#include "readPhases.hpp"
#include "words.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
/// The largest velocity that the scene is expected to see, and what sets it.
struct Expected
{
    double velocity = 0;
    std::string by;
    void consider(double v, const std::string& what)
    {
        if (v > velocity) { velocity = v; by = what; }
    }
};

Expected expectedVelocity(const Dictionary& dict, const Coefficients& c, double rho)
{
    Expected most;
    const auto expected = dict.subDictOrEmpty("expected");
    const double depth = expected.getNonNegative("depth", units::m, 0), radius = expected.getNonNegative("radius", units::m, 0);
    most.consider(expected.getNonNegative("velocity", units::mPerS, 0), "the expected velocity");
    most.consider(std::sqrt(mag(c.g)*depth), "the hydrostatic pressure over the expected depth");
    most.consider(std::sqrt(expected.getNonNegative("pressure", units::pressure, 0)/rho), "the expected pressure difference");
    double gamma = 0;
    for (double s : c.surfaceTension) gamma = std::max(gamma, s);
    if (radius > 0) most.consider(std::sqrt(gamma/(rho*radius)), "the capillary pressure at the expected radius");
    return most;
}
}

void readPhases(const Case& theCase, Settings& settings)
{
    auto& c = settings.coefficients;
    const auto dict = theCase.dictionary("constant/phaseProperties");
    c.phases = dict.get<std::vector<std::string>>("phases");
    if (dict.found("phases") && c.phases.empty()) dict.error("phases", "there must be at least one phase");
    if (theCase.has("constant/g"))
    {
        const auto g = theCase.dictionary("constant/g");
        g.ignore("dimensions");
        c.g = g.getVector("value", units::mPerS2);
        g.reportUnused();
    }
    c.bodyForce = dict.getVector("bodyForce", units::forcePerVolume, {});

    const std::size_t n = c.phases.size();
    c.surfaceTension.assign(n*n, 0.0);
    if (dict.found("sigma"))
        for (const auto& [first, second, value] : dict.pairs("sigma"))
        {
            const auto a = std::find(c.phases.begin(), c.phases.end(), first), b = std::find(c.phases.begin(), c.phases.end(), second);
            for (const auto& [found, word] : {std::pair(a, first), std::pair(b, second)})
                if (found == c.phases.end())
                    dict.error("sigma", fmt::format("phase \"{}\" is unknown. {}", word, suggestion(word, "phases", c.phases)));
            if (value < 0) dict.error("sigma", fmt::format("surface tension of {} and {} must not be negative", first, second));
            if (a == c.phases.end() || b == c.phases.end()) continue;
            const auto k = std::size_t(a - c.phases.begin()), l = std::size_t(b - c.phases.begin());
            if (k == l) dict.error("sigma", fmt::format("\"{}\" has no surface tension with itself", first));
            c.surfaceTension[k*n + l] = c.surfaceTension[l*n + k] = value;
        }
    for (const auto& name : c.phases)
    {
        const auto phase = dict.subDict(name);
        const double rho = phase.getPositive("rho", units::density);
        c.restDensity.push_back(rho);
        c.viscosity.push_back(phase.getNonNegative("mu", units::viscosity, 0));
        double sound = 1;
        const bool automatic = phase.isWord("soundSpeed", "automatic") || !phase.found("soundSpeed");
        if (!automatic) sound = phase.getPositive("soundSpeed", units::mPerS);
        else
        {
            const auto most = expectedVelocity(dict, c, rho);
            sound = 10*most.velocity;
            if (most.velocity > 0)
                settings.reasons.push_back(fmt::format("sound speed of {} {:.4g} m/s: 10 x {:.4g} m/s by {}", name, sound, most.velocity, most.by));
            else
                phase.error("soundSpeed", fmt::format("\"soundSpeed\" of {} is missing, and constant/phaseProperties has no `expected {{ velocity; depth; pressure; "
                                                      "radius; }}` to choose it from", name));
        }
        c.soundSpeed.push_back(sound);
        const double exponent = phase.getPositive("exponent", units::none, 7);
        c.exponent.push_back(exponent);
        c.stiffness.push_back(rho*sqr(sound)/exponent);
    }
    dict.reportUnused();
}

}
