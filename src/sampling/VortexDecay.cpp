#include "VortexDecay.hpp"
#include "SampledField.hpp"
#include "sharedEntries.hpp"
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar period{"period", units::m, required, positive, "of the vortices"};
}

VortexDecay::VortexDecay(const Dictionary& d, const Geometry&, const std::vector<std::string>&)
    : start_(d), rate_(8*sqr(std::numbers::pi/entry::period(d))*entry::nu(d))
{}

EntryList VortexDecay::entries() { return EntryList{entry::nu} + TaylorGreen::entries(); }

Measurement VortexDecay::operator()(const ParticleView& view) const
{
    const SampledField u(view, "U", {});
    double along = 0, exact = 0;
    for (std::size_t i = 0; i < view.n; ++i)
    {
        const auto e = start_.velocity(position(view, i), 0);
        along += view.volume[i]*(u(0, i)*e.x + u(1, i)*e.y);
        exact += view.volume[i]*dot(e, e);
    }
    Measurement result{std::numeric_limits<double>::quiet_NaN(), rate_, view.n, ""};
    if (!(view.time > 0)) result.note = "no time has passed";
    else if (!(along > 0)) result.note = "nothing is left of the vortices";
    else result.value = -std::log(along/exact)/view.time;
    return result;
}

}
