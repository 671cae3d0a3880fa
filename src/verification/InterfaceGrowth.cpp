#include "verification/InterfaceGrowth.hpp"
#include "parallel/reduce.hpp"
#include "sampling/ModeFit.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/sharedEntries.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include "verification/PlaneMode.hpp"
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Count waves{"waves", 1, atLeast(1).saying("waves is a whole number, at least 1"), "waves over the domain's length in x"};
const Scalar depth{"depth", units::m, required, positive, "of each layer"},
    interfaceLargest{"largest", Unit{units::none, "wavelengths"}, 0.05, positive, "amplitude up to which samples add to the fit"};
}

InterfaceGrowth::InterfaceGrowth(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : waves_(std::size_t(entry::waves(d))), depth_(entry::depth(d)), largest_(entry::interfaceLargest(d)), history_(d)
{
    if (phases.size() != 2) d.error("name", "an interface lies between two phases");
    if (!geometry.periodic[0]) d.error("name", "waves are measured along x: the domain must be periodic in x");
}

EntryList InterfaceGrowth::entries() { return {entry::waves, entry::depth, entry::interfaceLargest, entry::from, entry::to}; }

Measurement InterfaceGrowth::operator()(const ParticleView& view)
{
    const auto size = view.geometry->high - view.geometry->low;
    const double k = 2 * std::numbers::pi * double(waves_) / size.x, area = size.x * (view.dimension == 3 ? size.z : 1);
    Measurement result;
    const auto phase = [&](std::size_t i) { return phaseOf(view, i); };
    // The wave is measured on the first phase alone.
    const auto wave =
        groupSums(view.n, 1, phase,
                  [&](std::size_t i) { return VolumeMean<>::of(view.mass[i] / view.restDensity[0], std::cos(k * view.x[i])); })[0];
    const double amplitude = 2 / area * wave.amount;
    result.particles = wave.particles;
    const auto height = groupSums(view.n, 2, phase, [&](std::size_t i) { return VolumeMean<>::of(1, view.y[i]); });
    const std::size_t lower = height[0].value() < height[1].value() ? 0 : 1;
    const auto fluid = [&](std::size_t of) { return ModeFluid{view.restDensity[of], view.viscosity[of]}; };
    result.reference = planeMode(k, depth_, -view.g.y, surfaceTensionOf(view), fluid(lower), fluid(1 - lower)).real();

    if (!(std::abs(amplitude) * k > largest_ * 2 * std::numbers::pi)) history_.add(view.time, amplitude);
    const auto found = fitGrowth(history_.times, history_.values, std::abs(result.reference));
    result.value = found.value_or(std::numeric_limits<double>::quiet_NaN());
    if (!found) result.note = "a time of one over the rate is needed for a fit";
    return result;
}

}
