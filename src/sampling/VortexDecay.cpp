#include "sampling/VortexDecay.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/sharedEntries.hpp"
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
    : start_(d), rate_(8 * sqr(std::numbers::pi / entry::period(d)) * entry::nu(d))
{}

EntryList VortexDecay::entries() { return EntryList{entry::nu} + TaylorGreen::entries(); }

Measurement VortexDecay::operator()(const ParticleView& view) const
{
    const SampledField u(view, "U", {});
    const auto e = [&](std::size_t i) { return start_.velocity(position(view, i), 0); };
    const double along = sum(view.n,
                             [&](std::size_t i) {
                                 return view.volume[i] * dot(Vector<3>{u(0, i), u(1, i), 0}, e(i));
                             }),
                 exact = sum(view.n, [&](std::size_t i) { return view.volume[i] * dot(e(i), e(i)); });
    Measurement result{std::numeric_limits<double>::quiet_NaN(), rate_, view.n, ""};
    if (!(view.time > 0)) result.note = "no time has passed";
    else if (along <= 0) result.note = "nothing is left of the vortices";
    else result.value = -std::log(along / exact) / view.time;
    return result;
}

}
