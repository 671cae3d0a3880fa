#include "verification/Hydrostatic.hpp"
#include "sampling/sharedEntries.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const ListOf<double> heights{"heights", units::m, required, "thicknesses of the layers, from the bottom up"},
    densities{"densities", units::density, required, "densities of the layers"};
const VectorParameter g{"g", units::mPerS2, Vector<3>{0, -9.81, 0}, "gravity"};
const Scalar pTop{"pTop", units::pressure, 0, "pressure above the uppermost layer"};
}

Hydrostatic::Hydrostatic(std::vector<double> heights, std::vector<double> densities, const Vector<3>& g)
    : heights_(std::move(heights)), densities_(std::move(densities)), g_(g), pTop_(0)
{}

Hydrostatic::Hydrostatic(const Dictionary& d)
    : heights_(entry::heights(d)), densities_(entry::densities(d)), g_(entry::g(d)), origin_(entry::origin(d)), pTop_(entry::pTop(d))
{
    if (heights_.size() != densities_.size())
        entry::densities.error(d, fmt::format("{} densities for {} heights: one of each per layer, from the bottom up", densities_.size(),
                                              heights_.size()));
    const auto isNegative = [](double a) { return a < 0; };
    if (std::ranges::any_of(heights_, isNegative)) entry::heights.error(d, "heights are thicknesses of layers and must not be negative");
    if (std::ranges::any_of(densities_, isNegative)) entry::densities.error(d, "densities must not be negative");
    if (!(mag(g_) > 0)) entry::g.error(d, "g must not be zero: it tells which way is up");
}

EntryList Hydrostatic::entries() { return {entry::heights, entry::densities, entry::g, entry::origin, entry::pTop}; }

double Hydrostatic::pressure(const Vector<3>& x, double) const
{
    const double g = mag(g_), y = -dot(x - origin_, g_) / g;
    double p = pTop_, bottom = 0;
    for (std::size_t k = 0; k < heights_.size(); ++k)
    {
        const double top = bottom + heights_[k];
        p += g * densities_[k] * std::max(0.0, top - (k == 0 ? y : std::max(y, bottom)));
        bottom = top;
    }
    return p;
}

}
