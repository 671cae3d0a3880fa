#include "CapillaryRise.hpp"
#include "BosanquetRise.hpp"
#include "SampledField.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

namespace
{

Box readBox(const Dictionary& d)
{
    const Box box{d.get<Vector<3>>("min"), d.get<Vector<3>>("max")};
    if (!(box.high.x > box.low.x && box.high.y > box.low.y)) d.error("max", "max must be greater than min in x and y");
    return box;
}

}

CapillaryRise::CapillaryRise(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : phase_(readPhase(d, "phase", phases)),
      slit_(readBox(d.subDict("slit"))),
      reservoir_(readBox(d.subDict("reservoir"))),
      foot_(d.get("foot", units::m)),
      start_(d.get("level", units::m)),
      angle_(d.get("contactAngle", units::none)),
      slipLength_(d.getNonNegative("slipLength", units::m, 0)),
      where_(d.where("name"))
{
    if (geometry.dimension != 2) d.error("name", "the rise in a slit is measured in 2-D scenes alone");
    if (phases.size() != 2) d.error("name", "the liquid rises in a gas: the scene must have two phases");
    if (!(angle_ >= 0 && angle_ < 90)) d.error("contactAngle", "the liquid rises where its contact angle lies between 0 and 90 degrees");
    if (start_ < foot_) d.error("level", "the slit must be immersed: level lies below foot");
    if (slipLength_ > 0 && start_ == foot_) d.error("slipLength", "friction of the whole tank needs a slit that is immersed: level lies at foot");
    if (slipLength_ > 0 && slipLength_ >= 0.5 * (slit_.high.x - slit_.low.x)) d.error("slipLength", "must be less than half the width of the slit");
}

Measurement CapillaryRise::operator()(const ParticleView& view) const
{
    Measurement result;
    const double rho_0 = view.restDensity[phase_];
    if (!(view.surfaceTension > 0)) throw CaseError(where_, "a liquid rises by surface tension, and constant/phaseProperties gives no sigma");
    if (rho_0 < view.restDensity[1 - phase_]) throw CaseError(where_, "the phase that rises in the slit must be the denser one");
    const auto level = [&](const Box& box)
    {
        double volume = 0;
        for (std::size_t i = 0; i < view.n; ++i)
            if (phaseOf(view, i) == phase_ && view.x[i] >= box.low.x && view.x[i] < box.high.x && view.y[i] >= box.low.y &&
                view.y[i] < box.high.y)
            {
                volume += view.mass[i] / rho_0;
                ++result.particles;
            }
        return box.low.y + volume / (box.high.x - box.low.x);
    };
    const double w = slit_.high.x - slit_.low.x, W = reservoir_.high.x - reservoir_.low.x;
    const double cosTheta = std::cos(angle_ * std::numbers::pi / 180), gamma = view.surfaceTension;
    const BosanquetRise rise{gamma, cosTheta, rho_0, rho_0 - view.restDensity[1 - phase_], view.viscosity[phase_], -view.g.y,
                             w, start_ - foot_, W, gamma * cosTheta / W, slipLength_};
    result.value = level(slit_) - level(reservoir_);
    result.reference = rise.height(view.time);
    if (std::isnan(result.reference)) result.note = "Bosanquet's equation is too stiff to be followed to this time";
    return result;
}

}
