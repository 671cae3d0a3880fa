#include "sampling/Conservation.hpp"
#include "parallel/reduce.hpp"
#include "sampling/Norms.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/sharedEntries.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace sph
{

namespace entry
{
const Switch angularMomentum{"angularMomentum", false, "the angular momentum as well"};
}

namespace column
{
const Column mass{"mass_<phase>", "kg", "mass of the phase"}, momentum{"momentum", "kg m/s", "sum m U; a vector"},
    kineticEnergy{"kineticEnergy", "J", "sum m U^2/2"},
    potentialEnergy{"potentialEnergy", "J", "-sum m g.x, and of the body force; not along periodic directions"},
    angularMomentum{"angularMomentum", "kg m^2/s", "sum m (x - origin) x U; a vector"};
}

Conservation::Conservation(const Dictionary& d, const FunctionContext& context)
    : context_(context),
      phases_(context.phases),
      angular_(entry::angularMomentum(d)),
      origin_(entry::origin(d)),
      where_(d.location()),
      isClosed_(context.geometry.patches.empty()),
      anyWork_(std::ranges::any_of(context.geometry.walls, &WallProperties::moves)),
      anyWetting_(std::ranges::any_of(context.geometry.walls, &WallProperties::wets))
{
    if (!angular_ && entry::origin.given(d))
        entry::origin.error(
            d, "origin does nothing without angularMomentum, which counts from it: give `angularMomentum yes`, or leave it out");
}

EntryList Conservation::entries() { return {entry::angularMomentum, entry::origin}; }

TableInfo Conservation::table()
{
    using namespace column;
    return {"conservation",
            "conservation.dat",
            "mass, momentum and energy of what is in the scene; in 2-D per metre of depth",
            {mass, momentum, kineticEnergy, potentialEnergy, angularMomentum}};
}

Conservation::Sums Conservation::sums(const ParticleView& view, const Vector<3>& origin, const Location& where)
{
    const SampledField U(view, "U", where);
    const auto ofHeight = [&](const Vector<3>& a) -> Vector<3>
    {
        if (!view.geometry) return a;
        const auto& periodic = view.geometry->periodic;
        return {periodic[0] ? 0 : a.x, periodic[1] ? 0 : a.y, periodic[2] ? 0 : a.z};
    };
    const auto g = ofHeight(view.gravity), f = ofHeight(view.bodyForce);
    const auto motion =
        sum(view.n,
            [&](std::size_t i)
            {
                if (!view.inScene(i)) return Motion{};
                const double m = view.mass[i];
                const Vector<3> u{U(0, i), U(1, i), U(2, i)}, x = position(view, i);
                return Motion{m * u, m * cross(x - origin, u), 0.5 * m * dot(u, u), -dot(m * g + view.volume[i] * f, x), m * mag(u)};
            });
    return {motion, groupSums(
                        view.n, std::max<std::size_t>(1, view.phases.size()), [&](std::size_t i) { return phaseOf(view, i); },
                        [&](std::size_t i) { return view.inScene(i) ? view.mass[i] : 0; })};
}

Conservation::Motion& Conservation::Motion::operator+=(const Motion& other)
{
    momentum += other.momentum;
    angularMomentum += other.angularMomentum;
    kineticEnergy += other.kineticEnergy;
    potentialEnergy += other.potentialEnergy;
    momentumScale += other.momentumScale;
    return *this;
}

void Conservation::execute(const ParticleView& view)
{
    last_ = sums(view, origin_, where_);
    supply_ = view.supply;
    anyWork_ = anyWork_ || view.heldBy;
    if (!first_)
    {
        first_ = last_;
        firstSupply_ = supply_;
    }
    const auto since = given();
    mostMomentum_ = std::max({mostMomentum_, last_.momentumScale, mag(since.impulse)});
    mostEnergy_ = std::max({mostEnergy_, last_.kineticEnergy, std::abs(since.work), std::abs(since.stored)});
    TableRow row;
    for (std::size_t k = 0; k < last_.mass.size(); ++k) row.add(column::mass.of(k < phases_.size() ? phases_[k] : ""), last_.mass[k]);
    row.add(column::momentum, last_.momentum);
    row.add(column::kineticEnergy, last_.kineticEnergy);
    row.add(column::potentialEnergy, last_.potentialEnergy);
    if (angular_) row.add(column::angularMomentum, last_.angularMomentum);
    if (!table_)
        table_.emplace(context_.file("conservation.dat"),
                       view.dimension == 2 ? std::vector<std::string>{"per metre of depth"} : std::vector<std::string>{}, row.columns);
    table_->row(view.time, row.cells);
}

/// Supply since the first sample.
Supply Conservation::given() const
{
    if (!supply_ || !firstSupply_) return {};
    return {supply_->impulse - firstSupply_->impulse, supply_->work - firstSupply_->work, supply_->stored - firstSupply_->stored};
}

Histories Conservation::histories() const
{
    if (!first_) return {};
    const auto& p = first_->momentum;
    Histories stored{{"firstMass", first_->mass},
                     {"first", {p.x, p.y, p.z, first_->kineticEnergy, first_->potentialEnergy, mostMomentum_, mostEnergy_}}};
    if (firstSupply_)
    {
        const auto& i = firstSupply_->impulse;
        stored["firstSupply"] = {i.x, i.y, i.z, firstSupply_->work, firstSupply_->stored};
    }
    return stored;
}

void Conservation::restore(const Histories& stored)
{
    const auto first = stored.find("first"), mass = stored.find("firstMass");
    if (first == stored.end() || mass == stored.end() || first->second.size() != 7) return;
    const auto& q = first->second;
    Sums sums;
    sums.momentum = {q[0], q[1], q[2]};
    sums.kineticEnergy = q[3];
    sums.potentialEnergy = q[4];
    sums.mass = mass->second;
    first_ = sums;
    mostMomentum_ = q[5];
    mostEnergy_ = q[6];
    const auto supply = stored.find("firstSupply");
    if (supply == stored.end() || supply->second.size() != 5) return;
    const auto& s = supply->second;
    firstSupply_ = Supply{{s[0], s[1], s[2]}, s[3], s[4]};
}

std::string Conservation::report() const
{
    if (!first_) return "";
    const auto total = [](const Sums& s) { return std::accumulate(s.mass.begin(), s.mass.end(), 0.0); };
    const auto mass =
        fmt::format("{}: relative change of mass {:.3g}", context_.name, relativeTo(total(*first_), total(last_) - total(*first_)));
    const auto momentum = last_.momentum - first_->momentum;
    const double motion = last_.kineticEnergy - first_->kineticEnergy;
    if (!supply_)
        return fmt::format("{}; change of momentum {:.3g} kg m/s, of kinetic and potential energy {:.3g} J, by all forces", mass,
                           mag(momentum), motion + last_.potentialEnergy - first_->potentialEnergy);
    const auto since = given();
    const double unbalanced = relativeTo(mostEnergy_, motion + since.stored - since.work);
    const bool counted = !anyWetting_ && (!anyWork_ || supply_->ofBoundaries);
    const char* const others = unbalanced < 0 ? counted ? " (dissipated)" : " (dissipated, or taken by walls and openings)"
                               : counted      ? ""
                                              : " (walls and openings)";
    return fmt::format("{}, of momentum {:.3g} beyond the impulse of gravity and body force{}, of energy {:.3g} beyond their work{}", mass,
                       relativeTo(mostMomentum_, mag(momentum - since.impulse)), isClosed_ ? "" : " (walls and openings)", unbalanced,
                       others);
}

}
