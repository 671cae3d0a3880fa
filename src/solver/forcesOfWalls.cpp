#include "solver/forcesOfWalls.hpp"
#include "solver/models.hpp"
#include <algorithm>
#include <array>

namespace sph
{

std::vector<Dictionary> functionsOfType(const Case& theCase, const std::string& type)
{
    const auto functions = theCase.dictionaryIfPresent("system/controlDict").subDictOrEmpty("functions");
    std::vector<Dictionary> found;
    for (const auto& name : functions.keys())
        if (functions.isDictionary(name) && functions.subDict(name).isWord("type", type)) found.push_back(functions.subDict(name));
    return found;
}

std::vector<std::string> forcesOf(const Settings& settings)
{
    const auto accelerates = [](const auto& term) {
        return term.over == Over::pairs &&
               std::ranges::any_of(term.results, [](const auto& f) { return f.name == Acceleration::info.name; });
    };
    std::vector<std::string> forces;
    for (const auto& name : settings.terms)
        for (const auto* terms : {&allTerms<2>(), &settings.terms2})
            for (const auto& term : *terms)
                if ((term.name == name || Settings::apart(term.name) == name) && accelerates(term)) forces.push_back(term.name);
    return forces;
}

void askForForcesOfWalls(Settings& settings)
{
    if (std::ranges::any_of(settings.groups, [](const Group& group) { return group.name == forcesOfWalls; })) return;
    settings.groups.push_back({.name = forcesOfWalls,
                               .terms = forcesOf(settings),
                               .names = {{Acceleration::info.name, BoundaryAcceleration::info.name}},
                               .sharesBy = {GhostWall::info.name}});
}

template<int dim> void refreshVelocities(Particles<dim>& particles)
{
    auto& store = particles.store();
    const auto& images = particles.images();
    if (images.halo()) images.halo()->refresh(store, std::array{std::string(Velocity::info.name)});
    Images<dim>::template refresh<Velocity>(images, store);
}

template void refreshVelocities(Particles<2>&);
template void refreshVelocities(Particles<3>&);

}
