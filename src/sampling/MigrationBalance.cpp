#include "MigrationBalance.hpp"
#include "SampledField.hpp"
#include "sharedEntries.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

namespace entry
{
const Scalar ratio{"ratio", units::none, required, positive, "D_c/D_eta of Phillips' fluxes"},
    leastStress{"leastStress", units::none, 0,
                Range{.low = 0, .high = 1, .highIncluded = false}.saying("is a fraction of the largest shear stress: at 1 no particle would be left"),
                "share of the largest shear stress from which on particles count"};
}

MigrationBalance::MigrationBalance(const Dictionary& d, const Geometry&, const std::vector<std::string>&)
    : r_(1/entry::ratio(d)), leastStress_(entry::leastStress(d)), where_(d.where("name"))
{}

EntryList MigrationBalance::entries() { return {entry::ratio, entry::leastStress}; }

Measurement MigrationBalance::operator()(const ParticleView& view) const
{
    const SampledField phi(view, "phi", where_), gammaDot(view, "gammaDot", where_), mu(view, "eta", where_);
    double largest = 0;
    for (std::size_t i = 0; i < view.n; ++i) largest = std::max(largest, mu(0, i)*gammaDot(0, i));
    std::vector<double> potential;
    for (std::size_t i = 0; i < view.n; ++i)
        if (mu(0, i)*gammaDot(0, i) >= leastStress_*largest) potential.push_back(std::log(phi(0, i)*gammaDot(0, i)) + r_*std::log(mu(0, i)));
    double mean = 0;
    for (const double p : potential) mean += p/double(potential.size());
    Measurement result{0, 0, potential.size(), ""};
    for (const double p : potential) result.value = std::fmax(result.value, std::abs(p - mean));
    if (!std::isfinite(mean))
    {
        result.value = std::numeric_limits<double>::quiet_NaN();
        result.note = "there are particles without shear or powder";
    }
    return result;
}

}
