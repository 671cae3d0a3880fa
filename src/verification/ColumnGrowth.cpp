#include "verification/ColumnGrowth.hpp"
#include "parallel/reduce.hpp"
#include "sampling/ModeFit.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/sharedEntries.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include "verification/ColumnMode.hpp"
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar largest{"largest", Unit{units::none, "radii"}, 0.2, positive, "amplitude up to which samples add to the fit"};
}

ColumnGrowth::ColumnGrowth(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)), largest_(entry::largest(d)), history_(d)
{
    if (phases.size() != 2) d.error("name", "a column stands in a second phase: the scene must have two");
    if (geometry.dimension != 3 || !geometry.periodic[2])
        d.error("name", "the column's waves are measured along z: the domain must be 3-D and periodic in z");
}

EntryList ColumnGrowth::entries() { return {entry::phase, entry::largest, entry::from, entry::to}; }

Measurement ColumnGrowth::operator()(const ParticleView& view)
{
    constexpr double pi = std::numbers::pi;
    const double L = view.geometry->high.z - view.geometry->low.z, k = 2 * pi / L;
    Measurement result;
    const auto wave = sum(view.n,
                          [&](std::size_t i)
                          {
                              if (phaseOf(view, i) != phase_) return VolumeMean<>{};
                              return VolumeMean<>::of(view.mass[i] / view.restDensity[phase_], std::cos(k * view.z[i]));
                          });
    result.particles = wave.particles;
    const double R = std::sqrt(wave.volume / (pi * L)), amplitude = wave.value();
    const auto fluid = [&](std::size_t phase) { return ModeFluid{view.restDensity[phase], view.viscosity[phase]}; };
    result.reference = columnMode(k, R, surfaceTensionOf(view), fluid(phase_), fluid(1 - phase_)).real();

    if (!(std::abs(amplitude) > largest_)) history_.add(view.time, amplitude);
    const auto found = fitGrowth(history_.times, history_.values, std::abs(result.reference));
    result.value = found.value_or(std::numeric_limits<double>::quiet_NaN());
    if (!found) result.note = "a time of one over the rate is needed for a fit";
    return result;
}

}
