#include "solver/WallForces.hpp"
#include "case/forcesOnWalls.hpp"
#include "dictionary/Expression.hpp"
#include "geometry/components.hpp"
#include "parallel/reduce.hpp"
#include "solver/forcesOfWalls.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace sph
{

namespace
{
double loadAt(const WallProperties& wall, double t)
{
    try
    {
        return wall.load->at(t);
    }
    catch (const ExpressionError& e)
    {
        throw CaseError(wall.where, fmt::format("load of wall \"{}\" at {:.6g} s: \"{}\": {}", wall.name, t, wall.load->force, e.what()));
    }
}
}

void askForWallForces(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& i = settings.integration;
    const bool known = !(i.solvesPressure || !i.moves || i.maxSubSteps > 1);
    constexpr const char* why =
        "forces are those of one evaluation a step: there are none with pressure within the step, in creeping flow, and with several substeps";
    std::set<std::string> walls;
    for (const auto& d : functionsOfType(reading.theCase, forcesType))
    {
        if (!known) d.error("type", why);
        for (const auto& patch : entry::patches(d)) walls.insert(patch);
    }
    for (const auto& wall : reading.geometry.walls)
    {
        if (!wall.load) continue;
        if (!known)
            reading.theCase.diagnostics().error(wall.where, fmt::format("wall \"{}\" cannot go by a load here: {}", wall.name, why));
        walls.insert(wall.name);
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
    anyLoad_ = std::ranges::any_of(all, [](const WallProperties& wall) { return wall.load.has_value(); });
    forces_.resize(walls_.size());
    swings_.resize(walls_.size());
    near_.resize(walls_.size());
}

template<int dim> std::vector<Stage<dim>> WallForces<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::sorted)
        return {{"walls of forces", "particles near walls whose forces are asked for",
                 [this](Particles<dim>&, const Substep&) { listed_ = false; }}};
    std::vector<Stage<dim>> all;
    if (place == (solves_ ? JoinPoint::afterKick : JoinPoint::afterEvaluation))
        all.push_back({"forces on walls",
                       "F = -sum m dv/dt by the ghosts of a wall",
                       [this](Particles<dim>& p, const Substep&) { measure(p); },
                       {forcesOfWalls}});
    if (place == JoinPoint::afterKick && anyLoad_)
        all.push_back({"push walls", "v_w += dt (F(t + dt/2) + F_w.d - m_w c v_w)/m_w d",
                       [this](Particles<dim>& p, const Substep& s) { push(p, s); }});
    return all;
}

template<int dim> bool WallForces<dim>::Swing::hasGrown(double acceleration)
{
    // Half a period of what swings by itself has more steps than `longest`; a load that comes at once makes fewer turns than `fewest`.
    constexpr int longest = 4, fewest = 4;
    constexpr double beyondDoubt = 100;
    const double change = acceleration - last;
    ++steps;
    if (change * (last - turn) < 0)
    {
        const double swing = std::abs(last - turn);
        if (steps > longest || swing < widest || widest == 0)
        {
            first = swing;
            turns = 0;
        }
        ++turns;
        widest = swing;
        turn = last;
        steps = 0;
    }
    last = acceleration;
    return turns > fewest && widest > beyondDoubt * first;
}

template<int dim> void WallForces<dim>::push(Particles<dim>& particles, const Substep& step)
{
    for (std::size_t k = 0; k < walls_.size(); ++k)
    {
        const auto& wall = particles.geometry().walls[std::size_t(walls_[k])];
        if (!wall.load) continue;
        const auto& [_, d, mass, damping] = *wall.load;
        const double a = (loadAt(wall, step.time + 0.5 * step.deltaT) + dot(in3D(forces_[k]), d)) / mass;
        if (swings_[k].hasGrown(a))
            throw CaseError(
                wall.where,
                fmt::format(
                    "wall \"{}\" under load and what it pushes throw one another to and fro, in swings of a few steps that have grown a hundredfold: its mass, {:.4g} kg, is less "
                    "than what moves with it at once, as water in pores does. Give it several times as much; at rest it counts for nothing",
                    wall.name, mass));
        particles.pushWall(walls_[k], (dot(wall.velocity, d) + step.deltaT * a) / (1 + step.deltaT * damping) * d);
    }
}

template<int dim> void WallForces<dim>::checkMass(const Particles<dim>& particles, std::size_t k) const
{
    const auto& wall = particles.geometry().walls[std::size_t(walls_[k])];
    if (!wall.load) return;
    const auto x = particles.store().pointers(Position{});
    const double* const m = particles.store().component(Mass::info.name, 0);
    const double row = sum(near_[k].size(),
                           [&](std::size_t n)
                           {
                               const auto i = std::size_t(near_[k][n]);
                               bool touches = false;
                               particles.nearWalls().forEachFoot(in3D(valueAt<Vector<dim>>(x, i)), particles.coefficients().spacing,
                                                                 [&](const Foot& foot, const Patch& patch)
                                                                 { touches = touches || patch.wallAt(foot.region) == walls_[k]; });
                               return touches ? m[i] : 0.0;
                           });
    if (constexpr double rounding = 1e-9; wall.load->mass < (1 - rounding) * row)
        throw CaseError(
            wall.where,
            fmt::format(
                "wall \"{}\" is under load and has a mass of {:.4g} kg, less than the {:.4g} kg of the particles within a spacing of it: "
                "wall and particles would throw one another to and fro. Give it at least as much; at rest it counts for nothing",
                wall.name, wall.load->mass, row));
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
        if (!listed_)
        {
            near_[k] = particlesWithin(particles, counts);
            checkMass(particles, k);
        }
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
        const auto& wall = particles.geometry().walls[std::size_t(walls_[k])];
        const auto force = in3D(forces_[k]);
        for (int c = 0; c < 3; ++c) numbers[forceOnWall(wall.name, c)] = force.*component(c);
        if (!wall.load) continue;
        const auto& displacement = particles.movingWalls().displacement(walls_[k]);
        for (int c = 0; c < 3; ++c) numbers[displacementOfWall(wall.name, c)] = displacement.*component(c);
    }
    return numbers;
}

template class WallForces<2>;
template class WallForces<3>;

}
