#include "Conservation.hpp"
#include "Norms.hpp"
#include "SampledField.hpp"
#include "reduce.hpp"
#include "sharedEntries.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace sph
{

namespace entry
{
const Switch angularMomentum{"angularMomentum", false, "the angular momentum as well"};
}

Conservation::Conservation(const Dictionary& d, const FunctionContext& context)
    : context_(context), phases_(context.phases), angular_(entry::angularMomentum(d)), origin_(entry::origin(d)), where_(d.location())
{}

EntryList Conservation::entries() { return {entry::angularMomentum, entry::origin}; }

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
                const double m = view.mass[i];
                const Vector<3> u{U(0, i), U(1, i), U(2, i)}, x = position(view, i);
                return Motion{m * u, m * cross(x - origin, u), 0.5 * m * dot(u, u), -dot(m * g + view.volume[i] * f, x), m * mag(u)};
            });
    return {motion, groupSums(
                        view.n, std::max<std::size_t>(1, view.phases.size()), [&](std::size_t i) { return phaseOf(view, i); },
                        [&](std::size_t i) { return view.mass[i]; })};
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
    if (!first_) first_ = last_;
    largestKinetic_ = std::max(largestKinetic_, last_.kineticEnergy);
    if (!table_)
    {
        std::vector<std::string> columns;
        for (std::size_t k = 0; k < last_.mass.size(); ++k) columns.push_back(k < phases_.size() ? "mass_" + phases_[k] : "mass");
        columns.insert(columns.end(), {"momentum", "kineticEnergy", "potentialEnergy"});
        if (angular_) columns.push_back("angularMomentum");
        table_.emplace(context_.file("conservation.dat"),
                       std::vector<std::string>{
                           "mass [kg], momentum [kg m/s], energy [J], angular momentum [kg m^2/s]; per metre of depth in 2-D"},
                       columns);
    }
    std::vector<std::string> cells;
    for (const double m : last_.mass) cells.push_back(cell(m));
    cells.insert(cells.end(), {cell(last_.momentum), cell(last_.kineticEnergy), cell(last_.potentialEnergy)});
    if (angular_) cells.push_back(cell(last_.angularMomentum));
    table_->row(view.time, cells);
}

Histories Conservation::histories() const
{
    if (!first_) return {};
    const auto& p = first_->momentum;
    return {{"firstMass", first_->mass},
            {"first", {p.x, p.y, p.z, first_->kineticEnergy, first_->potentialEnergy, first_->momentumScale, largestKinetic_}}};
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
    sums.momentumScale = q[5];
    sums.mass = mass->second;
    first_ = sums;
    largestKinetic_ = q[6];
}

std::string Conservation::report() const
{
    if (!first_) return "";
    const auto total = [](const Sums& s) { return std::accumulate(s.mass.begin(), s.mass.end(), 0.0); };
    const double energy = last_.kineticEnergy + last_.potentialEnergy - first_->kineticEnergy - first_->potentialEnergy;
    return fmt::format("{}: relative change of mass {:.3g}, momentum {:.3g}, energy {:.3g}", context_.name,
                       relativeTo(total(*first_), total(last_) - total(*first_)),
                       relativeTo(std::max(first_->momentumScale, last_.momentumScale), mag(last_.momentum - first_->momentum)),
                       relativeTo(largestKinetic_, energy));
}

}
