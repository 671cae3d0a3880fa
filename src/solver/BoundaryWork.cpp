#include "solver/BoundaryWork.hpp"
#include "parallel/reduce.hpp"
#include "solver/forcesOfWalls.hpp"
#include <algorithm>

namespace sph
{

namespace
{
constexpr const char* ofHeld = "forces on what openings hold";
constexpr int atRest = -1;
}

void askForBoundaryWork(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& integration = settings.integration;
    const auto& facts = settings.facts;
    const bool moves = std::ranges::any_of(reading.geometry.walls, &WallProperties::moves), opens = facts.get<OpenBoundary>().exists;
    if (!(moves || opens) || facts.get<ConstitutiveStress>().exists || integration.solvesPressure || !integration.moves ||
        integration.maxSubSteps > 1 || (opens && (facts.get<InterfaceForces>().act || settings.coefficients.backgroundPressure != 0)) ||
        functionsOfType(reading.theCase, "conservation").empty())
        return;
    settings.facts.give(BoundaryPower{true}, "conservation of system/controlDict");
    if (moves) askForForcesOfWalls(settings);
    if (opens)
    {
        auto terms = forcesOf(settings);
        terms.push_back(std::ranges::count(settings.terms, "massContinuity") > 0 ? "massContinuity" : "continuity");
        Names names{{Acceleration::info.name, BoundaryAcceleration::info.name}};
        names[DensityRate::info.name] = BoundaryDensityRate::info.name;
        settings.groups.push_back({.name = ofHeld, .terms = terms, .names = names, .sharesBy = {GhostWall::info.name, Holder::info.name}});
    }
    settings.runningModels.push_back(running<BoundaryWork>());
}

template<int dim>
BoundaryWork<dim>::BoundaryWork(Particles<dim>& particles, const Numbers&)
    : solves_(particles.settings().integration.solves), opens_(particles.plan().hasGroup(ofHeld))
{
    const auto& walls = particles.geometry().walls;
    for (const auto& wall : walls)
    {
        const auto first =
            std::ranges::find_if(walls,
                                 [&](const WallProperties& other)
                                 {
                                     return &other == &wall || (!other.load && !wall.load && other.velocity == wall.velocity &&
                                                                other.omega == wall.omega && other.origin == wall.origin);
                                 });
        motionOf_.push_back(wall.moves() ? int(first - walls.begin()) : atRest);
    }
    for (const char* group : {forcesOfWalls, ofHeld})
        if (particles.plan().hasGroup(group)) groups_.push_back(group);
}

template<int dim> std::vector<Stage<dim>> BoundaryWork<dim>::stages(JoinPoint place)
{
    if (place != (solves_ ? JoinPoint::afterKick : JoinPoint::afterEvaluation)) return {};
    return {{"measure work", "P of moving walls and openings", [this](Particles<dim>& p, const Substep&) { measure(p); }, groups_}};
}

template<int dim> void BoundaryWork<dim>::measure(Particles<dim>& particles)
{
    power_ = powerOfHeld_ = 0;
    if (solves_) refreshVelocities(particles);
    for (int motion = 0; motion < int(motionOf_.size()); ++motion)
        if (motionOf_[std::size_t(motion)] == motion) power_ += powerOfWalls(particles, motion);
    if (opens_) powerOfHeld_ = powerOfHeld(particles);
}

template<int dim> double BoundaryWork<dim>::powerOfWalls(Particles<dim>& particles, int motion)
{
    auto& store = particles.store();
    const double* const ghostWall = store.component(GhostWall::info.name, 0);
    const double* const share =
        shareOf(particles, [&](std::size_t j) { return ghostWall[j] > 0 && motionOf_[std::size_t(ghostWall[j]) - 1] == motion; });
    const auto near = particlesWithin(particles, [&](std::size_t j) { return share[j] > 0; });
    particles.evaluateAt(near, forcesOfWalls);

    const auto x = std::as_const(store).pointers(Position{}), a = std::as_const(store).pointers(BoundaryAcceleration{});
    const double* const m = store.component(Mass::info.name, 0);
    return sum(near.size(),
               [&](std::size_t k)
               {
                   const auto i = std::size_t(near[k]);
                   const auto v_w = velocityAt(particles, motion, in3D(valueAt<Vector<dim>>(x, i)));
                   return m[i] * dot(valueAt<Vector<dim>>(a, i), in<dim>(v_w));
               });
}

template<int dim> double BoundaryWork<dim>::powerOfHeld(Particles<dim>& particles)
{
    auto& store = particles.store();
    const auto& images = particles.images();
    if (images.halo()) images.halo()->refresh(store, std::array{std::string(Holder::info.name)});
    Images<dim>::template refresh<Holder>(images, store);
    const double *holder = store.component(Holder::info.name, 0), *ghostWall = store.component(GhostWall::info.name, 0);
    shareOf(particles,
            [&, layers = images.layers() != nullptr](std::size_t j) { return layers && ghostWall[j] > 0 ? false : holder[j] == 0; });
    const auto held = particles.held();
    particles.evaluateAt(held, ofHeld);

    const auto v = std::as_const(store).pointers(Velocity{}), a = std::as_const(store).pointers(BoundaryAcceleration{});
    const double *m = store.component(Mass::info.name, 0), *p = store.component(Pressure::info.name, 0),
                 *rho = store.component(Density::info.name, 0), *rate = store.component(BoundaryDensityRate::info.name, 0);
    return -sum(held.size(),
                [&](std::size_t k)
                {
                    const auto h = std::size_t(held[k]);
                    return m[h] * (dot(valueAt<Vector<dim>>(a, h), valueAt<Vector<dim>>(v, h)) + p[h] / sqr(rho[h]) * rate[h]);
                });
}

template<int dim> Vector<3> BoundaryWork<dim>::velocityAt(const Particles<dim>& particles, int motion, const Vector<3>& x) const
{
    const auto& geometry = particles.geometry();
    double nearest = Box::infinity;
    auto velocity = geometry.wallVelocity(motion, x);
    particles.nearWalls().forEachFoot(x, Box::infinity,
                                      [&](const Foot& foot, const Patch& patch)
                                      {
                                          const int wall = patch.wallAt(foot.region);
                                          if (motionOf_[std::size_t(wall)] != motion || foot.distance >= nearest) return;
                                          nearest = foot.distance;
                                          velocity = geometry.wallVelocity(wall, x - foot.distance * foot.normal);
                                      });
    return velocity;
}

template class BoundaryWork<2>;
template class BoundaryWork<3>;

}
