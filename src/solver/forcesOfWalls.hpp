/// Forces of pairs of particles and ghosts behind walls: what the work of walls in motion and the forces on walls are made of.
#pragma once
#include "scene/Model.hpp"
#include "scene/Particles.hpp"

namespace sph
{

/// The group of the plan that sums accelerations by chosen ghosts into BoundaryAcceleration.
inline constexpr const char* forcesOfWalls = "forces of walls";

/// Terms of pairs that accelerate; of one whose sum is separate, the term that it was made of.
std::vector<std::string> forcesOf(const Settings&);
/// Adds the group forcesOfWalls to the plan, once.
void askForForcesOfWalls(Settings&);
/// The function objects of that type in system/controlDict.
std::vector<Dictionary> functionsOfType(const Case&, const std::string&);

/// Refreshes the velocities of images where they have arrays, those of several ranks or layers: the velocities of a step that solves for viscosity are of its end, and images have those of its start there.
template<int dim> void refreshVelocities(Particles<dim>&);

/// BoundaryShare of those neighbours that count in the sums of a group of given shares, 0 of all others.
template<int dim> const double* shareOf(Particles<dim>& particles, const auto& counts)
{
    auto& store = particles.store();
    const std::size_t null = particles.images().nullParticle();
    const double* const weight = store.has(ImageWeight{}) ? store.component(ImageWeight::info.name, 0) : nullptr;
    double* const share = store.component(BoundaryShare::info.name, 0);
    for (std::size_t j = 0; j < null; ++j) share[j] = counts(j) ? weight ? weight[j] : 1 : 0;
    share[null] = 0;
    return share;
}

/// The particles that have a neighbour which counts.
template<int dim> std::vector<int> particlesWithin(const Particles<dim>& particles, const auto& counts)
{
    std::vector<int> near;
    typename NeighbourLists<dim>::Room room;
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (std::ranges::any_of(particles.lists().of(i, room), [&](int j) { return counts(std::size_t(j)); })) near.push_back(int(i));
    return near;
}

}
