#include "verification/DropOscillation.hpp"
#include "parallel/reduce.hpp"
#include "sampling/ModeFit.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/sharedEntries.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include "verification/Drop.hpp"
#include "verification/DropMode.hpp"
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar dropRadius{"radius", units::m, byScene("that of a drop of the phase's volume"), nonNegative,
                        "of the drop at rest; needed with centre"};
const VectorParameter centre{"centre", units::m, byScene("that of the drop"), "of the drop at rest, where planes of symmetry cut it"};
}

namespace
{
using std::numbers::pi;
}

DropOscillation::DropOscillation(const Dictionary& d, const Geometry&, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)), radius_(entry::dropRadius(d, 0)), history_(d)
{
    if (d.found("centre"))
    {
        centre_ = entry::centre(d, {});
        if (radius_ == 0)
            d.error("radius",
                    "of a drop that planes of symmetry cut the volume does not tell the radius: `radius` is needed with `centre`");
    }
    if (phases.size() > 2)
        d.error("name", "a drop oscillates in a second phase, or alone where the gas is left out: the scene has more than two");
}

EntryList DropOscillation::entries() { return {entry::phase, entry::dropRadius, entry::centre, entry::from, entry::to}; }

DropOscillation::Rates DropOscillation::operator()(const ParticleView& view)
{
    const Drop drop(view, phase_);
    const double rho_0 = view.restDensity[phase_];
    const bool flat = view.dimension == 2;
    const auto centre = centre_.value_or(drop.centre);
    const auto moment =
        sum(view.n,
            [&](std::size_t i)
            {
                if (phaseOf(view, i) != phase_) return VolumeMean<>{};
                const auto x = displacement(view, centre, position(view, i));
                const double across = x.x * x.x, along = flat ? x.y * x.y : x.z * x.z;
                return VolumeMean<>::of(view.mass[i] / rho_0, flat ? across - along : 5.0 / 3 * (along - (across + x.y * x.y) / 2));
            });
    const double R = radius_ > 0 ? radius_ : flat ? std::sqrt(moment.volume / pi) : std::cbrt(0.75 * moment.volume / pi);
    history_.add(view.time, moment.value() / R);

    Rates rates;
    rates.measurement.particles = drop.particles;
    const double thin = 1e-6; // gas that is left out, of the liquid's density and viscosity
    const ModeFluid liquid{rho_0, view.viscosity[phase_]},
        around = view.phases.size() == 2 ? ModeFluid{view.restDensity[1 - phase_], view.viscosity[1 - phase_]}
                                         : ModeFluid{thin * liquid.rho, thin * liquid.mu};
    rates.exact = (flat ? dropMode : ballMode)(2, R, surfaceTensionOf(view), liquid, around);
    const auto found = fitOscillation(history_.times, history_.values, rates.exact);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    rates.found = found.value_or(std::complex<double>(nan, nan));
    if (!found) rates.measurement.note = "the samples make no oscillation yet: half a period is needed for a fit";
    return rates;
}

Measurement DropPeriod::operator()(const ParticleView& view)
{
    auto [found, exact, m] = drop(view);
    m.value = 2 * pi / found.imag();
    m.reference = 2 * pi / exact.imag();
    return m;
}

Measurement DropDecay::operator()(const ParticleView& view)
{
    auto [found, exact, m] = drop(view);
    m.value = -found.real();
    m.reference = -exact.real();
    return m;
}

}
