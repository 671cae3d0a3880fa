#include "solver/WallWork.hpp"
#include "parallel/reduce.hpp"
#include "solver/models.hpp"
#include <algorithm>
#include <array>

namespace sph
{

namespace
{
constexpr const char* ofWalls = "forces of moving walls";
constexpr int atRest = -1;

bool asksForBalance(const Case& theCase)
{
    const auto functions = theCase.dictionaryIfPresent("system/controlDict").subDictOrEmpty("functions");
    return std::ranges::any_of(functions.keys(), [&](const std::string& name)
                               { return functions.isDictionary(name) && functions.subDict(name).isWord("type", "conservation"); });
}

/// Terms of pairs that accelerate; of one whose sum is separate, the term that it was made of.
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
}

void askForWallWork(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& integration = settings.integration;
    const auto& facts = settings.facts;
    if (!std::ranges::any_of(reading.geometry.walls, &WallProperties::moves) || facts.get<OpenBoundary>().exists ||
        facts.get<ConstitutiveStress>().exists || integration.solvesPressure || !integration.moves || integration.maxSubSteps > 1 ||
        !asksForBalance(reading.theCase))
        return;
    settings.facts.give(BoundaryPower{true}, "conservation of system/controlDict");
    settings.groups.push_back({.name = ofWalls,
                               .terms = forcesOf(settings),
                               .names = {{Acceleration::info.name, BoundaryAcceleration::info.name}},
                               .bySharesGiven = true});
    settings.runningModels.push_back(running<WallWork>());
}

template<int dim> WallWork<dim>::WallWork(Particles<dim>& particles, const Numbers&) : solves_(particles.settings().integration.solves)
{
    const auto& walls = particles.geometry().walls;
    for (const auto& wall : walls)
    {
        const auto first =
            std::ranges::find_if(walls, [&](const WallProperties& other)
                                 { return other.velocity == wall.velocity && other.omega == wall.omega && other.origin == wall.origin; });
        motionOf_.push_back(wall.moves() ? int(first - walls.begin()) : atRest);
    }
}

template<int dim> std::vector<Stage<dim>> WallWork<dim>::stages(JoinPoint place)
{
    if (place != (solves_ ? JoinPoint::afterKick : JoinPoint::afterEvaluation)) return {};
    return {
        {"measure work", "P = sum_i m_i a_iw.v_w of moving walls", [this](Particles<dim>& p, const Substep&) { measure(p); }, {ofWalls}}};
}

template<int dim> void WallWork<dim>::measure(Particles<dim>& particles)
{
    power_ = 0;
    if (solves_) // its velocities are those of the end of the step
    {
        auto& store = particles.store();
        const auto& images = particles.images();
        if (images.halo()) images.halo()->refresh(store, std::array{std::string(Velocity::info.name)});
        Images<dim>::template refresh<Velocity>(images, store);
    }
    for (int motion = 0; motion < int(motionOf_.size()); ++motion)
        if (motionOf_[std::size_t(motion)] == motion) power_ += powerOf(particles, motion);
}

template<int dim> double WallWork<dim>::powerOf(Particles<dim>& particles, int motion)
{
    auto& store = particles.store();
    const std::size_t null = particles.images().nullParticle();
    const double* const ghostWall = store.component(GhostWall::info.name, 0);
    const double* const weight = store.has(ImageWeight{}) ? store.component(ImageWeight::info.name, 0) : nullptr;
    double* const share = store.component(BoundaryShare::info.name, 0);
    for (std::size_t j = 0; j < null; ++j)
    {
        const bool counts = ghostWall[j] > 0 && motionOf_[std::size_t(ghostWall[j]) - 1] == motion;
        share[j] = counts ? weight ? weight[j] : 1 : 0;
    }
    share[null] = 0;

    std::vector<int> near;
    typename NeighbourLists<dim>::Room room;
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (std::ranges::any_of(particles.lists().of(i, room), [&](int j) { return share[j] > 0; })) near.push_back(int(i));
    particles.evaluateAt(near, ofWalls);

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

template<int dim> Vector<3> WallWork<dim>::velocityAt(const Particles<dim>& particles, int motion, const Vector<3>& x) const
{
    const auto& geometry = particles.geometry();
    double nearest = Box::infinity;
    auto velocity = geometry.wallVelocity(motion, x);
    particles.nearWalls().forEachFoot(x,
                                      [&](const Foot& foot, const Patch& patch)
                                      {
                                          const int wall = patch.wallAt(foot.region);
                                          if (motionOf_[std::size_t(wall)] != motion || foot.distance >= nearest) return;
                                          nearest = foot.distance;
                                          velocity = geometry.wallVelocity(wall, x - foot.distance * foot.normal);
                                      });
    return velocity;
}

template class WallWork<2>;
template class WallWork<3>;

}
