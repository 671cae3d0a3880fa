#include "verification/CapillaryRise.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/sharedEntries.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include "verification/BosanquetRise.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

namespace entry
{
const SubDictionary slit{"slit", required, "box of the slit"}, reservoir{"reservoir", required, "box of the reservoir beside it"};
const VectorParameter min{"min", units::m, required, "lowest corner"}, max{"max", units::m, required, "highest corner"};
const Scalar foot{"foot", units::m, required, "height of the slit's lower end"},
    level{"level", units::m, required, "height of both surfaces at the start"},
    contactAngle{"contactAngle", degrees, required,
                 Range{.low = 0, .high = 90, .highIncluded = false}.saying(
                     "the liquid rises where its contact angle lies between 0 and 90 degrees"),
                 "of the plates"},
    slipLength{"slipLength", units::m, 0, nonNegative, "of the plates in the reference"};
}

namespace
{

Box readBox(const Dictionary& d)
{
    const Box box{entry::min(d), entry::max(d)};
    if (!(box.high.x > box.low.x && box.high.y > box.low.y)) entry::max.error(d, "max must be greater than min in x and y");
    return box;
}

}

CapillaryRise::CapillaryRise(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)),
      slit_(readBox(entry::slit(d))),
      reservoir_(readBox(entry::reservoir(d))),
      foot_(entry::foot(d)),
      start_(entry::level(d)),
      angle_(entry::contactAngle(d)),
      slipLength_(entry::slipLength(d)),
      where_(d.where("name"))
{
    if (geometry.dimension != 2) d.error("name", "the rise in a slit is measured in 2-D scenes alone");
    if (phases.size() != 2) d.error("name", "the liquid rises in a gas: the scene must have two phases");
    if (start_ < foot_) entry::level.error(d, "the slit must be immersed: level lies below foot");
    if (slipLength_ > 0 && start_ == foot_)
        entry::slipLength.error(d, "friction of the whole tank needs a slit that is immersed: level lies at foot");
    if (slipLength_ > 0 && slipLength_ >= 0.5 * (slit_.high.x - slit_.low.x))
        entry::slipLength.error(d, "must be less than half the width of the slit");
}

EntryList CapillaryRise::entries()
{
    const EntryList box{entry::min, entry::max};
    return {entry::phase, {entry::slit, box}, {entry::reservoir, box}, entry::foot, entry::level, entry::contactAngle, entry::slipLength};
}

Measurement CapillaryRise::operator()(const ParticleView& view) const
{
    Measurement result;
    const double rho_0 = view.restDensity[phase_];
    if (!(surfaceTensionOf(view) > 0))
        throw CaseError(where_, "a liquid rises by surface tension, and constant/phaseProperties gives no sigma");
    if (rho_0 < view.restDensity[1 - phase_]) throw CaseError(where_, "the phase that rises in the slit must be the denser one");
    const auto level = [&](const Box& box)
    {
        const auto isIn = [&](std::size_t i)
        {
            return phaseOf(view, i) == phase_ && view.x[i] >= box.low.x && view.x[i] < box.high.x && view.y[i] >= box.low.y &&
                   view.y[i] < box.high.y;
        };
        result.particles += count(view.n, isIn);
        const double mass = sum(view.n, [&](std::size_t i) { return isIn(i) ? view.mass[i] : 0; });
        return box.low.y + mass / rho_0 / (box.high.x - box.low.x);
    };
    const double w = slit_.high.x - slit_.low.x, W = reservoir_.high.x - reservoir_.low.x;
    const double cosTheta = std::cos(angle_ * std::numbers::pi / 180), gamma = surfaceTensionOf(view);
    const BosanquetRise rise{gamma,
                             cosTheta,
                             rho_0,
                             rho_0 - view.restDensity[1 - phase_],
                             view.viscosity[phase_],
                             -view.g.y,
                             w,
                             start_ - foot_,
                             W,
                             gamma * cosTheta / W,
                             slipLength_};
    result.value = level(slit_) - level(reservoir_);
    result.reference = rise.height(view.time);
    if (std::isnan(result.reference)) result.note = "Bosanquet's equation is too stiff to be followed to this time";
    return result;
}

}
