#include "BedHydrodynamics.hpp"
#include "Measurement.hpp"
#include "SampledField.hpp"
#include "readBox.hpp"
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace entry
{
const Word liquid{"liquid", byScene("the first of constant/phaseProperties"), "phase whose saturation and flow are measured"};
const Scalar length{"length", units::m, byScene("the shortest period of the domain, else its length in x"), positive,
                    "length of Bond and Reynolds number"},
    porosity{"porosity", units::none, byScene("the share of sampled points outside of the walls"),
             positiveUpTo(1).saying("porosity is a fraction of the bed, above 0 and at most 1"), "share of the pores in the bed"};
const Count samples{"samples", 64, atLeast(2), "points in each direction by which porosity and wall area are found"};
const SubDictionary region{"region", byScene("the domain"), "the bed"};
}

namespace
{

/// The wall nearest to a point.
Foot nearestFoot(const Geometry& geometry, const Vector<3>& x)
{
    Foot nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    for (const auto& patch : geometry.patches)
        if (const auto foot = patch.shape->foot(x); foot.distance < nearest.distance) nearest = foot;
    return nearest;
}

/// Area of the wall below a volume V in a layer of that thickness at the foot's distance; 0 outside the layer.
double wallAreaBelow(const Foot& f, double V, double layer)
{
    if (f.distance < 0 || f.distance >= layer) return 0;
    const double growth = (1 - f.k1 * f.distance) * (1 - f.k2 * f.distance);
    return growth > 0 ? V / (layer * growth) : 0;
}

double defaultLength(const Geometry& g)
{
    const auto size = g.high - g.low;
    double shortest = std::numeric_limits<double>::infinity();
    if (g.periodic[0]) shortest = std::min(shortest, size.x);
    if (g.periodic[1]) shortest = std::min(shortest, size.y);
    if (g.periodic[2] && g.dimension == 3) shortest = std::min(shortest, size.z);
    return std::isfinite(shortest) ? shortest : size.x;
}

}

BedHydrodynamics::BedHydrodynamics(const Dictionary& d, const FunctionContext& context)
    : context_(context),
      phases_(context.phases),
      liquid_(readPhase(d, entry::liquid, context.phases)),
      length_(entry::length(d, defaultLength(context.geometry))),
      porosity_(entry::porosity.ifGiven(d)),
      samples_(entry::samples(d)),
      where_(d.location())
{
    const auto region = entry::region(d);
    low_ = entry::min(region, context.geometry.low);
    high_ = entry::max(region, context.geometry.high);
    const auto size = high_ - low_;
    if (!(size.x > 0 && size.y > 0 && (size.z > 0 || context.geometry.dimension == 2)))
        entry::region.error(d, "min must lie below max in each direction");
}

EntryList BedHydrodynamics::entries()
{
    return {entry::liquid, entry::length, entry::porosity, {entry::region, {entry::min, entry::max}}, entry::samples};
}

bool BedHydrodynamics::inBed(const Vector<3>& x) const
{
    return x.x >= low_.x && x.x <= high_.x && x.y >= low_.y && x.y <= high_.y &&
           (context_.geometry.dimension == 2 || (x.z >= low_.z && x.z <= high_.z));
}

void BedHydrodynamics::sampleBed(double layer)
{
    const auto size = high_ - low_;
    const bool flat = context_.geometry.dimension == 2;
    const double cellVolume = size.x / samples_ * size.y / samples_ * (flat ? 1 : size.z / samples_);
    const double thickness = std::max(layer, 1.5 * std::max({size.x, size.y, flat ? 0 : size.z}) / samples_);
    long pores = 0, all = 0;
    double area = 0;
    for (int k = 0; k < (flat ? 1 : samples_); ++k)
        for (int j = 0; j < samples_; ++j)
            for (int i = 0; i < samples_; ++i)
            {
                const Vector<3> x{low_.x + (i + 0.5) * size.x / samples_, low_.y + (j + 0.5) * size.y / samples_,
                                  flat ? 0 : low_.z + (k + 0.5) * size.z / samples_};
                const auto foot = nearestFoot(context_.geometry, x);
                ++all;
                pores += foot.distance > 0;
                area += wallAreaBelow(foot, cellVolume, thickness);
            }
    if (!porosity_) porosity_ = double(pores) / double(all);
    wallArea_ = area;
}

void BedHydrodynamics::execute(const ParticleView& view)
{
    const bool flat = view.dimension == 2;
    if (!porosity_ || (view.phases.size() < 2 && !wallArea_)) sampleBed(view.spacing);

    const SampledField U(view, "U", where_);
    const auto size = high_ - low_;
    const double bed = size.x * size.y * (flat ? 1 : size.z);
    std::vector<double> volume(std::max<std::size_t>(1, view.phases.size()), 0.0);
    std::vector<Vector<3>> flux(volume.size());
    double wetted = 0, area = 0;
    for (std::size_t i = 0; i < view.n; ++i)
    {
        const auto x = position(view, i);
        if (!inBed(x)) continue;
        const auto k = phaseOf(view, i);
        volume.at(k) += view.volume[i];
        flux[k] += view.volume[i] * Vector<3>{U(0, i), U(1, i), U(2, i)};
        if (view.geometry->patches.empty()) continue;
        const double a = wallAreaBelow(nearestFoot(*view.geometry, x), view.volume[i], view.spacing);
        area += a;
        if (k == liquid_) wetted += a;
    }
    if (view.phases.size() < 2) area = *wallArea_;

    const double rho = view.restDensity.at(liquid_), mu = view.viscosity.at(liquid_), gamma = view.surfaceTension;
    const auto superficial = flux.at(liquid_) / bed;
    std::vector<std::string> columns{"porosity", "saturation", "holdUp"};
    std::vector<double> scalars{*porosity_, volume.at(liquid_) / (*porosity_ * bed), volume.at(liquid_) / bed};
    std::vector<std::string> cells;
    for (const double s : scalars) cells.push_back(cell(s));
    for (std::size_t k = 0; k < flux.size(); ++k)
    {
        const auto phase = k < phases_.size() ? "_" + phases_[k] : std::string();
        columns.insert(columns.end(), {"superficial" + phase, "interstitial" + phase});
        cells.insert(cells.end(), {cell(flux[k] / bed), cell(volume[k] > 0 ? flux[k] / volume[k] : Vector<3>{})});
    }
    const auto add = [&](const char* name, double value)
    {
        columns.push_back(name);
        cells.push_back(cell(value));
    };
    if (!view.geometry->patches.empty()) add("wettedFraction", area > 0 ? wetted / area : 0);
    if (gamma > 0)
    {
        add("Bo", rho * mag(view.g) * length_ * length_ / gamma);
        add("Ca", mu * mag(superficial) / gamma);
    }
    if (mu > 0) add("Re", rho * mag(superficial) * length_ / mu);

    if (!table_)
        table_.emplace(context_.file("bedHydrodynamics.dat"),
                       std::vector<std::string>{fmt::format("velocities [m/s]; liquid {}; length {} m",
                                                            liquid_ < phases_.size() ? phases_[liquid_] : "", cell(length_))},
                       columns);
    table_->row(view.time, cells);
    report_ = fmt::format("{}: saturation {:.4g}, hold-up {:.4g}, superficial velocity {:.4g} m/s", context_.name, scalars[1],
                          scalars[2], mag(superficial));
}

}
