#include "scene/Particles.hpp"
#include "base/CaseError.hpp"
#include "kernels/skin.hpp"
#include "parallel/reduce.hpp"
#include "scene/planOfScene.hpp"
#include <utility>

namespace sph
{

template<int dim>
Particles<dim>::Particles(const Settings& settings, const Geometry& geometry, const Catalogue<dim>& catalogue, Cloud cloud,
                          const Numbers& restored)
    : settings_(settings),
      geometry_(geometry),
      movingWalls_(geometry_),
      catalogue_(catalogue),
      coefficients_(settings.coefficients),
      plan_(catalogue, groupsOf(settings), givenOf(settings), rulesOf<dim>(settings)),
      halo_(ranks() ? std::make_unique<Halo<dim>>(*ranks(), settings.searchReach() + skinInSpacings * settings.resolution.spacing)
                    : nullptr),
      images_(geometry_, settings.searchReach() + skinInSpacings * settings.resolution.spacing, settings.resolution.spacing,
              skinInSpacings * settings.resolution.spacing, halo_.get(), settings.facts.get<WallReach>().supports * settings.resolution.H(),
              movingWalls_.any() ? 0 : recalledWithin(geometry_, settings.resolution.spacing)),
      leakGuard_(geometry_, settings.resolution.spacing, settings.resolution.H(), settings.facts.get<LeakedParticles>().action),
      kernel_(settings.resolution.kernel, settings.resolution.H()),
      owned_(cloud.size()),
      skin_(skinInSpacings * settings.resolution.spacing)
{
    plan_.allocate(store_);
    allocateState();
    if (halo_) lists_.partInterior();
    if (movingWalls_.any() && !geometry_.layers.empty())
        throw CaseError({"constant/geometry", 0},
                        "walls that move across themselves go with `walls reflected;` of system/sphSchemes: layers stay where they are");
    movingWalls_.restore(geometry_, restored);
    if (!geometry_.layers.empty()) images_.setLayers({geometry_, kernel_, settings.searchReach() + skin_, settings.resolution.spacing});
    if (settings.facts.get<InterfacesBehindWalls>().straight) images_.continueInterfaces();
    if (images_.layers() ? images_.layers()->weighted() : geometry_.bends()) store_.allocate(ImageWeight{});
    if (images_.recalls()) store_.allocateState(ImagesMade{});
    for (const auto& maker : settings.runningModels) runningModels_.push_back(maker.template make<dim>()(*this, restored));
    for (const auto place : withinStages) joined_[place] = stages(place);
    store_.keepImagesOf(plan_.imaged(images_));
    load(std::move(cloud), !restored.empty());
    run(JoinPoint::loaded);
    rebuild();
    checkApart();
    if (restored.empty()) evaluate();
    run(JoinPoint::start);
    if (restored.empty() && plan_.hasGroup(onceAStep)) evaluate(onceAStep);
    if (restored.empty()) run(JoinPoint::complete);
    else observe();
}

template<int dim> std::vector<Stage<dim>> Particles<dim>::stages(JoinPoint place) const
{
    std::vector<Stage<dim>> all;
    for (const auto& model : runningModels_)
        for (auto& stage : model->stages(place)) all.push_back(std::move(stage));
    return all;
}

template<int dim> void Particles<dim>::run(JoinPoint place)
{
    for (const auto& stage : joined_.at(place))
    {
        stage.run(*this, {});
        ++joinedRuns_[stage.name];
    }
}

template<int dim> void Particles<dim>::rebuild()
{
    // While lists are still those of the particles as they stand.
    if (halo_) halo_->balance(store_, owned_, settings_.maxImbalance, [this] { return costs(); });
    run(JoinPoint::exchange);
    owned_ = leakGuard_(store_, owned_, nearWalls());
    if (halo_) owned_ = halo_->migrate(store_, owned_);
    {
        CellList<dim> cells;
        cells.build(std::as_const(store_).pointers(Position{}), owned_, 0.5 * (settings_.searchReach() + skin_));
        store_.sortState(cells.order(), plan_.idle());
    }
    makeLists();
    run(JoinPoint::sorted);
    travelled_ = 0;
    ++rebuilds_;
}

template<int dim> std::vector<float> Particles<dim>::costs() const
{
    // Costs in sums over one neighbour; they are estimates, which a rank's measured time then scales.
    constexpr float ofParticle = 20, ofImage = 12;
    std::vector<float> costs(owned_);
    for (std::size_t i = 0; i < owned_; ++i) costs[i] = ofParticle + float(lists_.sizeOf(i));
    images_.forEachSource(
        [&](int source)
        {
            if (std::size_t(source) < owned_) costs[std::size_t(source)] += ofImage;
        });
    return costs;
}

template<int dim> std::size_t Particles<dim>::total() const { return ofAllRanks(owned_, std::size_t(0), Add{}); }

template<int dim> void Particles<dim>::hold(const RunningModel<dim>& by, std::vector<int> held)
{
    const auto known = std::ranges::find(heldBy_, &by, [](const auto& each) { return each.first; });
    if (known == heldBy_.end()) heldBy_.emplace_back(&by, std::move(held));
    else known->second = std::move(held);
    held_.clear();
    for (const auto& [model, each] : heldBy_) held_.insert(held_.end(), each.begin(), each.end());
}

template<int dim> bool Particles<dim>::holdsAny() const { return ofAllRanks(held_.size(), std::size_t(0), Add{}) > 0; }

template<int dim> void Particles<dim>::makeLists(bool inPassing)
{
    images_.buildPlaces(store_, owned_, !inPassing);
    lists_.build(std::as_const(store_).pointers(Position{}), owned_, images_.nullParticle(), settings_.searchReach() + skin_,
                 NeighbourLists<dim>::Stored::yes, plan_.idle());
    images_.keepSeen(store_, lists_);
    images_.listLayers(lists_);
    bind();
}

template<int dim> void Particles<dim>::bind()
{
    images_.rules().bind();
    plan_.bind(store_, coefficients_);
}

template<int dim> void Particles<dim>::driftWalls(double deltaT)
{
    if (!movingWalls_.any()) return;
    movingWalls_.advance(geometry_, deltaT);
    moved(2 * movingWalls_.fastest() * deltaT); // images go twice as far
}

template<int dim> void Particles<dim>::evaluate()
{
    if (travelled_ > 0.5 * skin_) rebuild();
    else
    {
        run(JoinPoint::moved);
        images_.move(store_);
    }
    evaluateFirst();
}

template<int dim> void Particles<dim>::evaluateFirst()
{
    plan_.evaluate(store_, images_, lists_, kernel_);
    run(JoinPoint::afterEvaluation);
}

template<int dim> void Particles<dim>::evaluate(const std::string& group, double deltaT, std::span<const std::uint8_t> leftOut)
{
    plan_.evaluate(store_, images_, lists_, kernel_, plan_.group(group), deltaT, leftOut);
}

template<int dim> void Particles<dim>::evaluateAt(std::span<const int> particles, const std::string& group)
{
    plan_.evaluateAt(particles, store_, images_, lists_, kernel_, plan_.group(group));
}

template<int dim> std::size_t Particles<dim>::bytes() const
{
    std::size_t n = store_.bytes() + images_.bytes() + plan_.bytes();
    if (halo_) n += halo_->bytes();
    for (const auto& model : runningModels_) n += model->bytes();
    return n;
}

template class Particles<2>;
template class Particles<3>;

}
