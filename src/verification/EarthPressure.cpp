#include "verification/EarthPressure.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include <cmath>

namespace sph
{

namespace entry
{
static const VectorParameter gravity{"g", units::mPerS2, Vector<3>{0, -9.81, 0}, "gravity"};
static const Scalar K{"K", units::none, required, positive, "the exact ratio of lateral to vertical stress"};
}

namespace
{
constexpr double leftOut = 0.1; ///< of the height, below and above
}

SoilLayer::SoilLayer(const Dictionary& d) : g_(entry::gravity(d)), where_(d.where("name"))
{
    if (!(mag(g_) > 0)) entry::gravity.error(d, "(0 0 0) points nowhere: gravity says which stress is vertical");
}

EntryList SoilLayer::entries() { return {entry::gravity}; }

Measurement SoilLayer::compare(const ParticleView& view, double reference, const Value& valueOf) const
{
    const SampledField sigma(view, "sigma", where_), rho(view, "rho", where_);
    const auto up = -1 / mag(g_) * g_;
    const auto height = [&](std::size_t i) { return dot(up, position(view, i)); };
    const double top = most(view.n, height) + 0.5 * view.spacing, base = least(view.n, height) - 0.5 * view.spacing;
    const auto valueAt = [&](std::size_t i) -> std::optional<double>
    {
        if (const double y = (height(i) - base) / (top - base); y < leftOut || y > 1 - leftOut) return {};
        const SymmTensor<3> s{sigma(0, i), sigma(1, i), sigma(2, i), sigma(3, i), sigma(4, i), sigma(5, i)};
        return valueOf(s, -dot(up, s * up), (top - height(i)) * rho(0, i) * mag(g_));
    };
    const auto mean = sum(view.n,
                          [&](std::size_t i)
                          {
                              const auto value = valueAt(i);
                              return value ? VolumeMean<>::of(view.volume[i], *value) : VolumeMean<>{};
                          });
    const auto norms = sum(view.n,
                           [&](std::size_t i)
                           {
                               const auto value = valueAt(i);
                               return value ? NormSum(view.volume[i], std::abs(*value - reference)) : NormSum{};
                           });
    return {mean.value(), reference, mean.particles, "", norms.norms()};
}

EarthPressure::EarthPressure(const Dictionary& d, const Geometry&, const std::vector<std::string>&) : SoilLayer(d), K_(entry::K(d)) {}

EntryList EarthPressure::entries() { return SoilLayer::entries() + EntryList{entry::K}; }

Measurement EarthPressure::operator()(const ParticleView& view) const
{
    return compare(view, K_,
                   [&](SymmTensor<3> s, double vertical, double)
                   {
                       const double lateral = view.dimension == 2 ? -s.xx - s.yy - vertical : 0.5 * (-trace(s) - vertical);
                       return lateral / vertical;
                   });
}

Measurement Overburden::operator()(const ParticleView& view) const
{
    return compare(view, 1, [](SymmTensor<3>, double vertical, double weight) { return vertical / weight; });
}

}
