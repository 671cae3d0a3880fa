#include "Hydrostatic.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

Hydrostatic::Hydrostatic(std::vector<double> heights, std::vector<double> densities, const Vector<3>& g)
    : heights_(std::move(heights)), densities_(std::move(densities)), g_(g), pTop_(0)
{
}

Hydrostatic::Hydrostatic(const Dictionary& d)
    : heights_(d.get<std::vector<double>>("heights")),
      densities_(d.get<std::vector<double>>("densities")),
      g_(d.getVector("g", units::mPerS2, {0, -9.81, 0})),
      origin_(d.get("origin", Vector<3>{})),
      pTop_(d.get("pTop", units::pressure, 0))
{
    if (heights_.size() != densities_.size())
        d.error("densities", fmt::format("{} densities for {} heights: one of each per layer, from the bottom up",
                                         densities_.size(), heights_.size()));
    const auto isNegative = [](double a) { return a < 0; };
    if (std::ranges::any_of(heights_, isNegative))
        d.error("heights", "heights are thicknesses of layers and must not be negative");
    if (std::ranges::any_of(densities_, isNegative)) d.error("densities", "densities must not be negative");
    if (!(mag(g_) > 0)) d.error("g", "g must not be zero: it tells which way is up");
}

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
