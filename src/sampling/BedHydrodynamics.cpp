#include "sampling/BedHydrodynamics.hpp"
#include "base/words.hpp"
#include "parallel/reduce.hpp"
#include "sampling/Measurement.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/readBox.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include <algorithm>
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
const Count samples{"samples", 64, atLeast(2), "points in each direction by which the porosity is found"};
const ListOf<double> sections{"sections", units::m, std::vector<double>{},
                              "coordinates, along `direction`, of planes that flow is measured through"};
const Direction along{"direction", byScene("that of gravity, else x"),
                      "of the flow, for the sections and the residence time; along a coordinate"};
const Choices grains{
    "grains", "walls", {}, byScene("those with fluid around them; all where there are none"), "walls whose wetted area is the bed's"};
const Word drain{"drain", byScene("none"), "outlet by which the way of marked liquid is measured"};
const SubDictionary region{"region", byScene("the domain"), "the bed"};
}

namespace
{

/// Half width of the hat function about a section [spacings].
constexpr double halfWidth = 2;

/// The direction of the largest component.
Vector<3> alongCoordinate(const Vector<3>& v)
{
    const auto sign = [](double q) { return q < 0 ? -1.0 : 1.0; };
    const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
    if (x >= y && x >= z) return {sign(v.x), 0, 0};
    return y >= z ? Vector<3>{0, sign(v.y), 0} : Vector<3>{0, 0, sign(v.z)};
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

/// Names of the walls with fluid around them; of all where there are none.
std::vector<std::string> bodiesOf(const Geometry& g)
{
    std::vector<std::string> bodies, all;
    for (std::size_t w = 0; w < g.walls.size(); ++w)
    {
        all.push_back(g.walls[w].name);
        if (std::any_of(g.patches.begin(), g.patches.end(),
                        [&](const Patch& p)
                        {
                            const bool has = p.walls.empty() ? p.wall == int(w) : std::ranges::find(p.walls, int(w)) != p.walls.end();
                            return has && !p.shape->enclosesFluid();
                        }))
            bodies.push_back(all.back());
    }
    return bodies.empty() ? all : bodies;
}

}

BedHydrodynamics::BedHydrodynamics(const Dictionary& d, const FunctionContext& context)
    : context_(context),
      phases_(context.phases),
      liquid_(readPhase(d, entry::liquid, context.phases)),
      length_(entry::length(d, defaultLength(context.geometry))),
      porosity_(entry::porosity.ifGiven(d)),
      samples_(entry::samples(d)),
      sections_(entry::sections(d)),
      drain_(entry::drain.ifGiven(d).value_or("")),
      where_(d.location())
{
    const auto region = entry::region(d);
    low_ = entry::min(region, context.geometry.low);
    high_ = entry::max(region, context.geometry.high);
    const auto size = high_ - low_;
    if (!(size.x > 0 && size.y > 0 && (size.z > 0 || context.geometry.dimension == 2)))
        entry::region.error(d, "min must lie below max in each direction");
    std::vector<std::string> walls;
    for (const auto& wall : context.geometry.walls) walls.push_back(wall.name);
    grains_ = entry::grains.among(d, walls, bodiesOf(context.geometry));
    direction_ = entry::along(d, Vector<3>{});
    if (entry::along.given(d) && mag(direction_ - alongCoordinate(direction_)) > 1e-9) entry::along.error(d, "must be along a coordinate");
}

EntryList BedHydrodynamics::entries()
{
    return {entry::liquid, entry::length, entry::porosity, {entry::region, {entry::min, entry::max}}, entry::samples, entry::sections,
            entry::along,  entry::grains, entry::drain};
}

bool BedHydrodynamics::inBed(const Vector<3>& x) const
{
    return x.x >= low_.x && x.x <= high_.x && x.y >= low_.y && x.y <= high_.y &&
           (context_.geometry.dimension == 2 || (x.z >= low_.z && x.z <= high_.z));
}

double BedHydrodynamics::sampledPorosity() const
{
    const auto size = high_ - low_;
    const bool flat = context_.geometry.dimension == 2;
    const auto n = std::size_t(samples_), all = n * n * (flat ? 1 : n);
    const auto inPore = count(all,
                              [&](std::size_t at)
                              {
                                  const double i = double(at % n), j = double(at / n % n), k = double(at / (n * n));
                                  const Vector<3> x{low_.x + (i + 0.5) * size.x / samples_, low_.y + (j + 0.5) * size.y / samples_,
                                                    flat ? 0 : low_.z + (k + 0.5) * size.z / samples_};
                                  return context_.geometry.inFluid(x);
                              });
    return double(inPore) / double(all);
}

Vector<3> BedHydrodynamics::flowDirection(const ParticleView& view) const
{
    return mag(direction_) > 0 ? direction_ : mag(view.g) > 0 ? alongCoordinate(view.g) : Vector<3>{1, 0, 0};
}

std::vector<double> BedHydrodynamics::superficialAt(double at, const ParticleView& view, const SampledField& U, std::size_t phases) const
{
    const auto n = flowDirection(view);
    const Vector<3> coordinate{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const auto size = high_ - low_;
    const double width = halfWidth * view.spacing;
    const double area = size.x * size.y * (view.dimension == 3 ? size.z : 1) / dot(size, coordinate);
    return groupSums(
        view.n, phases, [&](std::size_t i) { return inBed(position(view, i)) ? phaseOf(view, i) : phases; },
        [&](std::size_t i)
        {
            const double hat = std::max(0.0, 1 - std::abs(dot(position(view, i), coordinate) - at) / width) / width;
            return hat > 0 ? view.volume[i] * dot(Vector<3>{U(0, i), U(1, i), U(2, i)}, n) * hat / area : 0.0;
        });
}

double BedHydrodynamics::numberOf(const char* what, const ParticleView& view) const
{
    const auto found = view.numbers.find(fmt::format("{}({})", what, drain_));
    if (found != view.numbers.end()) return found->second;
    std::vector<std::string> drains;
    for (const auto& [name, _] : view.numbers)
        if (name.starts_with("transitTime(")) drains.push_back(name.substr(12, name.size() - 13));
    throw CaseError(where_, drains.empty()
                                ? "drain needs liquid that an inlet of constant/openings marks (`markFrom 0;` there), and is known while a "
                                  "case runs alone"
                                : fmt::format("drain \"{}\" is unknown. {}", drain_, suggestion(drain_, "outlets", drains)));
}

void BedHydrodynamics::execute(const ParticleView& view)
{
    const bool flat = view.dimension == 2;
    if (!porosity_) porosity_ = sampledPorosity();

    const SampledField U(view, "U", where_);
    const auto size = high_ - low_;
    const double bed = size.x * size.y * (flat ? 1 : size.z);
    const auto phases = std::max<std::size_t>(1, view.phases.size());
    const auto content = groupSums(
        view.n, phases, [&](std::size_t i) { return view.inScene(i) && inBed(position(view, i)) ? phaseOf(view, i) : phases; },
        [&](std::size_t i) {
            return VolumeMean<Vector<3>>::of(view.volume[i], {U(0, i), U(1, i), U(2, i)});
        });

    const auto& liquid = content.at(liquid_);
    const double rho = view.restDensity.at(liquid_), mu = view.viscosity.at(liquid_), gamma = surfaceTensionOf(view);
    const auto superficial = liquid.amount / bed;
    std::vector<std::string> columns{"porosity", "saturation", "holdUp"};
    std::vector<double> scalars{*porosity_, liquid.volume / (*porosity_ * bed), liquid.volume / bed};
    std::vector<std::string> cells;
    for (const double s : scalars) cells.push_back(cell(s));
    for (std::size_t k = 0; k < phases; ++k)
    {
        const auto& u = content[k];
        const auto phase = k < phases_.size() ? "_" + phases_[k] : std::string();
        columns.insert(columns.end(), {"superficial" + phase, "interstitial" + phase});
        cells.insert(cells.end(), {cell(u.amount / bed), cell(u.particles > 0 ? u.value() : Vector<3>{})});
    }
    const auto add = [&](const std::string& name, double value)
    {
        columns.push_back(name);
        cells.push_back(cell(value));
    };
    if (!wettedWalls_) wettedWalls_.emplace(view, Box{low_, high_});
    const auto walls = (*wettedWalls_)(view, liquid_);
    WettedWall grains;
    for (std::size_t w = 0; w < walls.size(); ++w)
        if (std::ranges::find(grains_, view.geometry->walls[w].name) != grains_.end()) grains += walls[w];
    if (!walls.empty()) add("wettedFraction", grains.share());
    if (gamma > 0)
    {
        add("Bo", rho * mag(view.g) * length_ * length_ / gamma);
        add("Ca", mu * mag(superficial) / gamma);
    }
    if (mu > 0) add("Re", rho * mag(superficial) * length_ / mu);

    for (std::size_t s = 0; s < sections_.size(); ++s)
    {
        const auto through = superficialAt(sections_[s], view, U, phases);
        for (std::size_t k = 0; k < phases; ++k)
            add(fmt::format("section{}{}", s + 1, k < phases_.size() ? "_" + phases_[k] : ""), through[k]);
    }
    const auto n = flowDirection(view);
    const double along = std::abs(dot(size, n)), throughput = dot(superficial, n);
    add("residenceTime", throughput > 0 ? liquid.volume / bed * along / throughput : std::numeric_limits<double>::quiet_NaN());
    if (!drain_.empty())
    {
        add("markedLeft", numberOf("marked", view));
        add("transitTime", numberOf("transitTime", view));
        add("transitDeviation", numberOf("transitDeviation", view));
    }
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        add("wettedArea_" + view.geometry->walls[w].name, walls[w].wetted);
        add("wettedFraction_" + view.geometry->walls[w].name, walls[w].share());
    }

    if (!table_)
        table_.emplace(context_.file("bedHydrodynamics.dat"),
                       std::vector<std::string>{fmt::format("velocities [m/s], areas [m^2], times [s]; liquid {}; length {} m",
                                                            liquid_ < phases_.size() ? phases_[liquid_] : "", cell(length_))},
                       columns);
    table_->row(view.time, cells);
    report_ = fmt::format("{}: saturation {:.4g}, hold-up {:.4g}, superficial velocity {:.4g} m/s", context_.name, scalars[1], scalars[2],
                          mag(superficial));
}

}
