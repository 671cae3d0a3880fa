#include "solver/WallForces.hpp"
#include "case/forcesOnWalls.hpp"
#include "parallel/reduce.hpp"
#include "solver/forcesOfWalls.hpp"
#include <algorithm>
#include <set>

namespace sph
{

void askForWallForces(const Reading& reading)
{
    auto& settings = reading.settings;
    std::set<std::string> walls;
    for (const auto& d : functionsOfType(reading.theCase, forcesType))
    {
        const auto& i = settings.integration;
        if (i.solvesPressure || !i.moves || i.maxSubSteps > 1)
            d.error(
                "type",
                "forces are those of one evaluation a step: there are none with pressure within the step, in creeping flow, and with several substeps");
        for (const auto& patch : entry::patches(d)) walls.insert(patch);
    }
    if (walls.empty()) return;
    askForForcesOfWalls(settings);
    settings.runningModels.push_back(running<WallForces>(std::vector<std::string>(walls.begin(), walls.end())));
}

template<int dim>
WallForces<dim>::WallForces(Particles<dim>& particles, const Numbers&, std::vector<std::string> walls)
    : solves_(particles.settings().integration.solves)
{
    const auto& all = particles.geometry().walls;
    for (std::size_t w = 0; w < all.size(); ++w)
        if (std::ranges::find(walls, all[w].name) != walls.end()) walls_.push_back(int(w));
    forces_.resize(walls_.size());
    near_.resize(walls_.size());
}

template<int dim> std::vector<Stage<dim>> WallForces<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::sorted)
        return {{"walls of forces", "particles near walls whose forces are asked for",
                 [this](Particles<dim>&, const Substep&) { listed_ = false; }}};
    if (place != (solves_ ? JoinPoint::afterKick : JoinPoint::afterEvaluation)) return {};
    return {{"forces on walls",
             "F = -sum m dv/dt by the ghosts of a wall",
             [this](Particles<dim>& p, const Substep&) { measure(p); },
             {forcesOfWalls}}};
}

template<int dim> void WallForces<dim>::measure(Particles<dim>& particles)
{
    if (solves_) refreshVelocities(particles);
    auto& store = particles.store();
    const double* const ghostWall = store.component(GhostWall::info.name, 0);
    for (std::size_t k = 0; k < walls_.size(); ++k)
    {
        const auto counts = [&, wall = 1.0 + walls_[k]](std::size_t j) { return ghostWall[j] == wall; };
        shareOf(particles, counts);
        // Images beside an edge may have no weight yet, and have some before lists are built again.
        if (!listed_) near_[k] = particlesWithin(particles, counts);
        particles.evaluateAt(near_[k], forcesOfWalls);
        const auto a = std::as_const(store).pointers(BoundaryAcceleration{});
        const double* const m = store.component(Mass::info.name, 0);
        forces_[k] = -sum(near_[k].size(),
                          [&](std::size_t n)
                          {
                              const auto i = std::size_t(near_[k][n]);
                              return m[i] * valueAt<Vector<dim>>(a, i);
                          });
    }
    listed_ = true;
}

template<int dim> Numbers WallForces<dim>::columns(const Particles<dim>& particles) const
{
    Numbers numbers;
    for (std::size_t k = 0; k < walls_.size(); ++k)
    {
        const auto F = in3D(forces_[k]);
        const auto& wall = particles.geometry().walls[std::size_t(walls_[k])].name;
        numbers[forceOnWall(wall, 0)] = F.x;
        numbers[forceOnWall(wall, 1)] = F.y;
        numbers[forceOnWall(wall, 2)] = F.z;
    }
    return numbers;
}

template class WallForces<2>;
template class WallForces<3>;

}
