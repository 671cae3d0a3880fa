#include "models/porousMedium/porousMedium.hpp"
#include "geometry/components.hpp"
#include "models/porousMedium/PorousDrag.hpp"

namespace sph
{

namespace
{
constexpr const char* file = "constant/porousMedium";

namespace entry
{
const Scalar d{"d", units::none / units::m2, required, nonNegative, "one over the permeability"},
    f{"f", units::none / units::m, 0, nonNegative, "Forchheimer's coefficient"};
const VectorParameter min{"min", units::m, byScene("low corner of the domain"), "low corner of the box that the medium fills"},
    max{"max", units::m, byScene("high corner of the domain"), "its high corner"};
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    if (!reading.theCase.has(file)) return;
    const auto dict = reading.theCase.dictionary(file);
    const PorousMedium medium{entry::d(dict), entry::f(dict), entry::min(dict, reading.geometry.low),
                              entry::max(dict, reading.geometry.high)};
    for (int c = 0; c < settings.coefficients.dimension; ++c)
        if (!(medium.min.*component(c) < medium.max.*component(c))) entry::max.error(dict, "lies below `min`: the box has no volume");
    if (settings.multiphase())
        reading.schemes.diagnostics().error(
            {file, 0}, "a porous medium is that of one fluid: leave it out, or all phases but one of constant/phaseProperties");
    dict.reportUnused();

    settings.coefficients.set(medium);
    settings.define<PorousDrag>(PorousDrag::name,
                                [](const Coefficients& c) {
                                    return PorousDrag{c.of<PorousMedium>(), c.viscosity[0] / c.restDensity[0]};
                                });
    reading.select(PorousDrag::name);
}

/// A step is half as long as the time in which the resistance stops the fastest particle: explicit steps are stable until twice that time.
std::optional<StepLimit> limit(const Settings& settings, const Measured& measured)
{
    const auto& c = settings.coefficients;
    if (!c.has<PorousMedium>()) return {};
    const auto& medium = c.of<PorousMedium>();
    const double rate = c.viscosity[0] / c.restDensity[0] * medium.d + 0.5 * measured.maxSpeed * medium.f;
    if (rate <= 0) return {};
    return StepLimit{0.5 / rate, "porous medium"};
}
}

const Model& porousMediumModel()
{
    static const Model model{.word = "porousMedium",
                             .meaning = "resistance of a porous medium that the particles do not resolve",
                             .read = read,
                             .terms2 = {},
                             .terms3 = {},
                             .limits = {limit},
                             .entries = {
                                 {file, {entry::d, entry::f, entry::min, entry::max}, "a porous medium; without the file there is none"}}};
    return model;
}

}
