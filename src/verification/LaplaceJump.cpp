#include "verification/LaplaceJump.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/sharedEntries.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include "verification/Drop.hpp"
#include <limits>

namespace sph
{

namespace entry
{
const Scalar laplaceRadius{"radius", units::m, byScene("that of a drop of the phase's volume"), nonNegative, "of the drop"},
    sigma{"sigma", units::surfaceTension, byScene("that of the scene"), nonNegative, "surface tension"};
}

LaplaceJump::LaplaceJump(const Dictionary& d, const Geometry&, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)), radius_(entry::laplaceRadius(d, 0)), sigma_(entry::sigma(d, 0))
{}

EntryList LaplaceJump::entries() { return {entry::phase, entry::laplaceRadius, entry::sigma}; }

Measurement LaplaceJump::operator()(const ParticleView& view) const
{
    const Drop drop = dropOrBubble(view, phase_);
    const double R = radius_ > 0 ? radius_ : drop.radius(view.dimension);
    const double gamma = sigma_ > 0 ? sigma_ : surfaceTensionOf(view);
    const SampledField p(view, "p", {});

    enum Side : std::size_t
    {
        inside,
        outside,
        neither
    };
    const auto side = [&](std::size_t i)
    {
        const double r = mag(displacement(view, drop.centre, position(view, i)));
        return drop.has(view, i) ? (r < R - view.support ? inside : neither) : r > R + view.support ? outside : neither;
    };
    const auto mean = groupSums(view.n, neither, side, [&](std::size_t i) { return VolumeMean<>::of(view.volume[i], p(0, i)); });
    Measurement result;
    result.particles = mean[inside].particles + mean[outside].particles;
    result.reference = (view.dimension - 1) * gamma / R;
    if (mean[inside].particles > 0) result.value = mean[inside].value() - (mean[outside].particles > 0 ? mean[outside].value() : 0);
    else
    {
        result.value = std::numeric_limits<double>::quiet_NaN();
        result.note = "no particle of the drop lies deeper than the kernel's support";
    }
    return result;
}

}
