#include "sampling/BedHydrodynamics.hpp"
#include "base/words.hpp"
#include "geometry/wallNames.hpp"
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

namespace column
{
const Column porosity{"porosity", "-", "share of the bed outside of the walls"},
    saturation{"saturation", "-", "volume of the liquid over that of the pores"},
    holdUp{"holdUp", "-", "volume of the liquid over that of the bed"},
    superficial{"superficial_<phase>", "m/s", "velocity over the bed, sum V U/V_bed; a vector"},
    interstitial{"interstitial_<phase>", "m/s", "mean velocity of the phase, sum V U/sum V; a vector"},
    wettedFraction{"wettedFraction", "-", "wetted share of the area of the grains"},
    bond{"Bo", "-", "Bond number of the liquid, rho g length^2/sigma"},
    capillary{"Ca", "-", "capillary number, mu |U|/sigma, U superficial"},
    reynolds{"Re", "-", "Reynolds number, rho |U| length/mu, U superficial"},
    section{"section<n>_<phase>", "m/s", "superficial velocity along `direction` through the n-th plane of `sections`"},
    residenceTime{"residenceTime", "s", "liquid in the bed over its flow along `direction`; not a number where it does not flow that way"},
    markedLeft{"markedLeft", "kg", "marked liquid that has left through the drain"},
    transitTime{"transitTime", "s", "mean time that the marked liquid which has left took"},
    transitDeviation{"transitDeviation", "s", "standard deviation of that time"},
    wallWettedArea{"wettedArea_<wall>", "m^2", "wetted area of the wall in the region; in 2-D a length [m]"},
    wallWettedFraction{"wettedFraction_<wall>", "-", "wetted share of the wall's area in the region"};
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
    grains_ = entry::grains.among(d, wallNames(context.geometry), bodiesOf(context.geometry));
    direction_ = entry::along(d, Vector<3>{});
    if (entry::along.given(d) && mag(direction_ - alongCoordinate(direction_)) > 1e-9) entry::along.error(d, "must be along a coordinate");
}

EntryList BedHydrodynamics::entries()
{
    return {entry::liquid, entry::length, entry::porosity, {entry::region, {entry::min, entry::max}}, entry::samples, entry::sections,
            entry::along,  entry::grains, entry::drain};
}

TableInfo BedHydrodynamics::table()
{
    using namespace column;
    return {
        "bedHydrodynamics",
        "bedHydrodynamics.dat",
        "saturation, flow and wetting of a bed; a column of each wall, of each phase where there are several, of each section, and of what leaves through `drain`",
        {porosity, saturation, holdUp, superficial, interstitial, wettedFraction, bond, capillary, reynolds, section, residenceTime,
         markedLeft, transitTime, transitDeviation, wallWettedArea, wallWettedFraction}};
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
    const double saturation = liquid.volume / (*porosity_ * bed), holdUp = liquid.volume / bed;
    TableRow row;
    row.add(column::porosity, *porosity_);
    row.add(column::saturation, saturation);
    row.add(column::holdUp, holdUp);
    const auto nameOf = [&](std::size_t k) { return k < phases_.size() ? phases_[k] : std::string(); };
    for (std::size_t k = 0; k < phases; ++k)
    {
        const auto& u = content[k];
        row.add(column::superficial.of(nameOf(k)), u.amount / bed);
        row.add(column::interstitial.of(nameOf(k)), u.particles > 0 ? u.value() : Vector<3>{});
    }
    if (!wettedWalls_) wettedWalls_.emplace(view, Box{low_, high_});
    const auto walls = (*wettedWalls_)(view, liquid_);
    WettedWall grains;
    for (std::size_t w = 0; w < walls.size(); ++w)
        if (std::ranges::find(grains_, view.geometry->walls[w].name) != grains_.end()) grains += walls[w];
    if (!walls.empty()) row.add(column::wettedFraction, grains.share());
    if (gamma > 0)
    {
        row.add(column::bond, rho * mag(view.g) * length_ * length_ / gamma);
        row.add(column::capillary, mu * mag(superficial) / gamma);
    }
    if (mu > 0) row.add(column::reynolds, rho * mag(superficial) * length_ / mu);

    for (std::size_t s = 0; s < sections_.size(); ++s)
    {
        const auto through = superficialAt(sections_[s], view, U, phases);
        for (std::size_t k = 0; k < phases; ++k) row.add(column::section.of(fmt::format("{}", s + 1)).of(nameOf(k)), through[k]);
    }
    const auto n = flowDirection(view);
    const double along = std::abs(dot(size, n)), throughput = dot(superficial, n);
    row.add(column::residenceTime, throughput > 0 ? holdUp * along / throughput : std::numeric_limits<double>::quiet_NaN());
    if (!drain_.empty())
    {
        row.add(column::markedLeft, numberOf("marked", view));
        row.add(column::transitTime, numberOf("transitTime", view));
        row.add(column::transitDeviation, numberOf("transitDeviation", view));
    }
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        const auto& name = view.geometry->walls[w].name;
        row.add(column::wallWettedArea.of(name), walls[w].wetted);
        row.add(column::wallWettedFraction.of(name), walls[w].share());
    }

    if (!table_)
        table_.emplace(context_.file("bedHydrodynamics.dat"),
                       std::vector<std::string>{fmt::format("liquid {}; length {} m", nameOf(liquid_), cell(length_))}, row.columns);
    table_->row(view.time, row.cells);
    report_ = fmt::format("{}: saturation {:.4g}, hold-up {:.4g}, superficial velocity {:.4g} m/s", context_.name, saturation, holdUp,
                          mag(superficial));
}

}
