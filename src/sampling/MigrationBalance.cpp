#include "sampling/MigrationBalance.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/sharedEntries.hpp"
#include <cmath>
#include <limits>

namespace sph
{

namespace entry
{
const Scalar ratio{"ratio", units::none, required, positive, "D_c/D_eta of Phillips' fluxes"},
    leastStress{"leastStress", units::none, 0,
                Range{.low = 0, .high = 1, .highIncluded = false}.saying(
                    "is a fraction of the largest shear stress: at 1 no particle would be left"),
                "share of the largest shear stress from which on particles count"};
}

MigrationBalance::MigrationBalance(const Dictionary& d, const Geometry&, const std::vector<std::string>&)
    : r_(1 / entry::ratio(d)), leastStress_(entry::leastStress(d)), where_(d.where("name"))
{}

EntryList MigrationBalance::entries() { return {entry::ratio, entry::leastStress}; }

Measurement MigrationBalance::operator()(const ParticleView& view) const
{
    const SampledField phi(view, "phi", where_), gammaDot(view, "gammaDot", where_), mu(view, "eta", where_);
    const auto stress = [&](std::size_t i) { return mu(0, i) * gammaDot(0, i); };
    const double largest = most(view.n, stress);
    const auto isLeft = [&](std::size_t i) { return stress(i) < leastStress_ * largest; };
    const auto potential = [&](std::size_t i) { return std::log(phi(0, i) * gammaDot(0, i)) + r_ * std::log(mu(0, i)); };
    const auto all = sum(view.n, [&](std::size_t i) { return isLeft(i) ? VolumeMean<>{} : VolumeMean<>::of(1, potential(i)); });
    const double mean = all.value();
    Measurement result{most(view.n, [&](std::size_t i) { return isLeft(i) ? 0 : std::abs(potential(i) - mean); }), 0, all.particles, ""};
    if (!std::isfinite(mean))
    {
        result.value = std::numeric_limits<double>::quiet_NaN();
        result.note = std::isnan(mean) ? "phi, gammaDot or eta of a particle is no number" : "there are particles without shear or powder";
    }
    return result;
}

}
