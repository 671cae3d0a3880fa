/// Loading of particles: arrays of the state, and the numbers of a time folder in them.
#include "base/CaseError.hpp"
#include "scene/Particles.hpp"
#include <algorithm>
#include <cassert>
#include <fmt/format.h>

namespace sph
{

namespace
{
std::string at(Vector<3> x) { return fmt::format("({:.6g} {:.6g} {:.6g})", x.x, x.y, x.z); }

/// The numbers of the file `name` (readCloud sees to its class), each to its place. Throws CaseError where one has no place in this scene: what a
/// vector gives along z would come to nothing in 2-D.
void copyNumbers(const Cloud& cloud, const std::string& name, const ValueType& type, const std::vector<double*>& values)
{
    const auto& field = cloud.fields.at(name);
    assert(field.type == type.fieldClass);
    const auto names = componentNames(type.fieldClass);
    for (std::size_t k = 0; k < field.component.size(); ++k)
    {
        const auto& numbers = field.component[k];
        const auto place = std::find(type.place.begin(), type.place.begin() + type.components, int(k)) - type.place.begin();
        if (place < type.components)
        {
            std::copy(numbers.begin(), numbers.end(), values[std::size_t(place)]);
            continue;
        }
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (numbers[i] != 0)
                throw CaseError({cloud.folder + "/" + name, 0},
                                fmt::format("{} has {}_{} = {}: in 2-D it must be 0", cloud.particle(i), name, names[k], numbers[i]));
    }
}
}

void Loading::checkScale(const std::string& name, const std::string& unit, double least, double most,
                         const std::function<double(std::size_t)>& atRest) const
{
    for (std::size_t i = 0; i < size(); ++i)
        if (const double value = values[0][i], rest = atRest(i); !(value >= least * rest && value <= most * rest))
            throw CaseError(
                {cloud.fields.contains(name) ? cloud.folder + "/" + name : cloud.folder, 0},
                fmt::format("{} has {} = {:.6g} {}: at rest it has {:.6g} {}, and {:.3g} to {:.3g} times that can be computed with",
                            cloud.particle(i), name, value, unit, rest, unit, least, most));
}

template<int dim> void Particles<dim>::allocateState()
{
    const auto allocate = [&](const StateField& f, const std::string& name) { store_.allocateState(name, f.info, f.type(dim)); };
    for (const auto& evolving : settings_.state)
    {
        allocate(evolving.value, evolving.value.name);
        if (!evolving.rate || evolving.advancedByModel) continue;
        if (settings_.integration.predicts) allocate(evolving.value, evolving.startName());
    }
    for (const auto& rate : settings_.keptRates()) allocate(rate, rate.name);
}

template<int dim> void Particles<dim>::load(Cloud cloud, bool restarted)
{
    store_.resize(owned_ + 1, owned_);
    const auto phases = phasesOf(cloud, coefficients_.phases.size());
    const auto arraysOf = [&](const StateField& field)
    {
        std::vector<double*> arrays;
        for (int c = 0; c < field.in(dim); ++c) arrays.push_back(store_.component(field.name, c));
        return arrays;
    };
    const auto x = store_.pointers(Position{});
    std::copy(cloud.x.begin(), cloud.x.end(), x[0]);
    std::copy(cloud.y.begin(), cloud.y.end(), x[1]);
    if constexpr (dim == 3) std::copy(cloud.z.begin(), cloud.z.end(), x[2]);
    for (const auto& evolving : settings_.state)
    {
        const Loading loading{cloud, coefficients_, phases, restarted, arraysOf(evolving.value)};
        if (evolving.value.name == Position::info.name) continue;
        if (evolving.written && cloud.fields.contains(evolving.fileName()))
            copyNumbers(cloud, evolving.fileName(), evolving.value.type(dim), loading.values);
        else if (evolving.missing) evolving.missing(loading);
        if (evolving.loaded) evolving.loaded(loading);
        if (evolving.check) evolving.check(loading);
    }
    for (const auto& rate : settings_.keptRates())
        if (restarted && cloud.fields.contains(rate.name)) copyNumbers(cloud, rate.name, rate.type(dim), arraysOf(rate));
}

/// Nothing parts two particles at one place: every sum takes x_ij = 0.
template<int dim> void Particles<dim>::checkApart() const
{
    const double closest = 1e-9 * coefficients_.spacing;
    typename NeighbourLists<dim>::Room room;
    for (std::size_t i = 0; i < owned_; ++i)
        for (const int j : lists_.of(i, room))
            if (std::size_t(j) > i && std::size_t(j) < owned_ && mag(position(i) - position(j)) < closest)
                throw CaseError(fmt::format("two particles lie at the same place, {}", at(in3D(position(i)))));
}

template<int dim> Vector<dim> Particles<dim>::position(std::size_t i) const
{
    return valueAt<Vector<dim>>(store_.fields().at(Position::info.name).component, i);
}

template class Particles<2>;
template class Particles<3>;

}
