#include "InterfaceGrowth.hpp"
#include "ModeFit.hpp"
#include "PlaneMode.hpp"
#include "SampledField.hpp"
#include "sharedEntries.hpp"
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Count waves{"waves", 1, atLeast(1).saying("waves is a whole number, at least 1"), "waves over the domain's length in x"};
const Scalar depth{"depth", units::m, required, positive, "of each layer"},
    largest{"largest", Unit{units::none, "wavelengths"}, 0.05, positive, "amplitude up to which samples add to the fit"};
}

InterfaceGrowth::InterfaceGrowth(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : waves_(std::size_t(entry::waves(d))), depth_(entry::depth(d)), largest_(entry::largest(d)), history_(d)
{
    if (phases.size() != 2) d.error("name", "an interface lies between two phases");
    if (!geometry.periodic[0]) d.error("name", "waves are measured along x: the domain must be periodic in x");
}

EntryList InterfaceGrowth::entries() { return {entry::waves, entry::depth, entry::largest, entry::from}; }

Measurement InterfaceGrowth::operator()(const ParticleView& view)
{
    const auto size = view.geometry->high - view.geometry->low;
    const double k = 2 * std::numbers::pi * double(waves_) / size.x, area = size.x * (view.dimension == 3 ? size.z : 1);
    Measurement result;
    double amplitude = 0;
    for (std::size_t i = 0; i < view.n; ++i)
        if (phaseOf(view, i) == 0)
        {
            amplitude += 2 / area * view.mass[i] / view.restDensity[0] * std::cos(k * view.x[i]);
            ++result.particles;
        }
    double mean[2]{}, count[2]{};
    for (std::size_t i = 0; i < view.n; ++i)
    {
        mean[phaseOf(view, i)] += view.y[i];
        ++count[phaseOf(view, i)];
    }
    const std::size_t lower = mean[0] * count[1] < mean[1] * count[0] ? 0 : 1;
    const auto fluid = [&](std::size_t phase) { return ModeFluid{view.restDensity[phase], view.viscosity[phase]}; };
    result.reference = planeMode(k, depth_, -view.g.y, view.surfaceTension, fluid(lower), fluid(1 - lower)).real();

    if (std::abs(amplitude) * k <= largest_ * 2 * std::numbers::pi) history_.add(view.time, amplitude);
    const auto found = fitGrowth(history_.times, history_.amplitudes, std::abs(result.reference));
    result.value = found.value_or(std::numeric_limits<double>::quiet_NaN());
    if (!found) result.note = "a time of one over the rate is needed for a fit";
    return result;
}

}
