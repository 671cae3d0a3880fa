#include "models/soil/Excavation.hpp"
#include "base/CaseError.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
constexpr const char *massGone = "excavatedMass", *particlesGone = "excavatedParticles", *timeOfDigging = "excavationTime";
}

ExpressionProgram::Kind kindInDigging(const std::string& name)
{
    if (name == "x" || name == "y" || name == "z" || name == "t") return ExpressionProgram::Kind::number;
    throw ExpressionError("$" + name + " is unknown here. Known: $x, $y, $z, $t");
}

template<int dim> Excavation<dim>::Excavation(Particles<dim>&, const Numbers& restored, const Digging& digging) : digging_(digging)
{
    for (auto [name, number] : {std::pair(massGone, &gone_), std::pair(particlesGone, &particles_), std::pair(timeOfDigging, &time_)})
        if (const auto found = restored.find(name); found != restored.end()) *number = found->second;
}

template<int dim> std::vector<Stage<dim>> Excavation<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::beforeDrift)
        return {{"look where soil is dug out", "sorted anew where some is",
                 [this](Particles<dim>& p, const Substep& s) { look(p, s.time + 0.5 * s.deltaT); }}};
    if (place == JoinPoint::exchange) return {{"dig", "particles go", [this](Particles<dim>& p, const Substep&) { dig(p); }}};
    return {};
}

template<int dim> std::vector<std::uint8_t> Excavation<dim>::within(const Particles<dim>& particles, double time) const
{
    const auto x = particles.store().pointers(Position{});
    std::vector<ExpressionProgram::Values> values;
    for (const auto& name : digging_.where.names())
    {
        const int k = name[0] - 'x';
        if (name == "t") values.push_back({{}, {time, 0, 0}});
        else if (k < dim) values.push_back({{x[std::size_t(k)]}, {}});
        else values.emplace_back();
    }
    std::vector<double> result(particles.size());
    digging_.where(0, particles.size(), values, {result.data()});
    std::vector<std::uint8_t> goes(particles.size());
    for (std::size_t i = 0; i < goes.size(); ++i)
    {
        const auto at = in3D(valueAt<Vector<dim>>(x, i));
        if (!std::isfinite(result[i]))
            throw CaseError(digging_.at, fmt::format("at {:.6g} s and ({:.6g} {:.6g} {:.6g}) m this has no value", time, at.x, at.y, at.z));
        goes[i] = result[i] != 0;
    }
    return goes;
}

template<int dim> void Excavation<dim>::look(Particles<dim>& particles, double time)
{
    time_ = time;
    const auto goes = within(particles, time);
    const bool some = std::ranges::find(goes, 1) != goes.end();
    if (ofAllRanks(int(some), 0, Add{}) > 0) particles.moved(2 * particles.skin()); // lists are then too old
}

template<int dim> void Excavation<dim>::dig(Particles<dim>& particles)
{
    const auto goes = within(particles, time_);
    auto& store = particles.store();
    const double* const m = store.component(Mass::info.name, 0);
    std::vector<int> kept;
    double gone = 0;
    for (std::size_t i = 0; i < goes.size(); ++i)
        if (goes[i]) gone += m[i];
        else kept.push_back(int(i));
    gone_ += ofAllRanks(gone, 0.0, Add{});
    particles_ += double(ofAllRanks(goes.size() - kept.size(), std::size_t(0), Add{}));
    if (ofAllRanks(kept.size(), std::size_t(0), Add{}) == 0)
        throw CaseError(digging_.at, fmt::format("at {:.6g} s this leaves no soil", time_));
    if (kept.size() == goes.size()) return;
    store.sortState(kept);
    store.resize(kept.size());
    particles.setSize(kept.size());
}

template<int dim> std::string Excavation<dim>::report(const Particles<dim>&) const
{
    return fmt::format("excavation: {} particles, {:.4g} kg gone\n", particles_, gone_);
}

template<int dim> void Excavation<dim>::save(Numbers& numbers) const
{
    numbers[massGone] = gone_;
    numbers[particlesGone] = particles_;
    numbers[timeOfDigging] = time_;
}

template class Excavation<2>;
template class Excavation<3>;

}
