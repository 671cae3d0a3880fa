#include "Particles.hpp"
#include "CaseError.hpp"
#include "reduce.hpp"
#include "skin.hpp"
#include <algorithm>
#include <cassert>
#include <cmath>
#include <fmt/format.h>
#include <utility>

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

std::vector<Group> groupsOf(const Settings& settings)
{
    std::vector<Group> groups{{ofEvaluation, settings.terms}};
    if (!settings.slowTerms.empty())
        groups.push_back({onceAStep, settings.slowTerms, {}, {{Acceleration::info.name, SlowAcceleration::info.name}}});
    groups.insert(groups.end(), settings.groups.begin(), settings.groups.end());
    return groups;
}

/// Fields that no term provides: the state, those of images themselves, and those that the caller of a group writes (the change that a solver tries).
std::set<std::string> givenOf(const Settings& settings)
{
    std::set<std::string> given{GhostWall::info.name};
    for (const auto& evolving : settings.state) given.insert(evolving.value.name);
    for (const auto& group : settings.groups) given.insert(group.inputs.begin(), group.inputs.end());
    return given;
}

template<int dim> std::map<std::string, std::vector<FieldUse<dim>>> rulesOf(const Settings& settings)
{
    std::map<std::string, std::vector<FieldUse<dim>>> rules;
    for (const auto& [field, fields] : settings.ruleReads)
        for (const auto& f : fields) rules[field].push_back({f.info, f.name, f.type(dim), nullptr});
    return rules;
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
              skinInSpacings * settings.resolution.spacing, halo_.get()),
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
    if (const auto time = restored.find(wallTime); time != restored.end()) movingWalls_.advance(geometry_, time->second);
    if (!geometry_.layers.empty()) images_.setLayers({geometry_, kernel_, settings.searchReach() + skin_, settings.resolution.spacing});
    if (settings.facts.get<InterfacesBehindWalls>().straight) images_.continueInterfaces();
    if (images_.layers() ? images_.layers()->weighted() : geometry_.bends()) store_.allocate(ImageWeight{});
    for (const auto& maker : settings.runningModels) runningModels_.push_back(maker.template make<dim>()(*this, restored));
    for (const auto place : withinStages) joined_[place] = stages(place);
    store_.keepImagesOf(halo_ ? plan_.readOfCopies() : plan_.readAtNeighbours());
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

template<int dim> bool Particles<dim>::holdsAny() const { return ofAllRanks(held_.size(), std::size_t(0), Add{}) > 0; }

template<int dim> void Particles<dim>::makeLists()
{
    images_.build(store_, owned_);
    lists_.build(std::as_const(store_).pointers(Position{}), owned_, images_.nullParticle(), settings_.searchReach() + skin_,
                 NeighbourLists<dim>::Stored::yes, plan_.idle());
    images_.keepSeen(lists_.seen());
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

template<int dim> void Particles<dim>::evaluate(const std::string& group, double deltaT)
{
    plan_.evaluate(store_, images_, lists_, kernel_, plan_.group(group), deltaT);
}

/// An evaluation overwrites every derived field. Only state survives it: rates kept for the next predictor count as state, and are put back here.
template<int dim> void Particles<dim>::look(const std::function<void()>& at)
{
    using Component = std::pair<std::string, int>;
    const auto values = [this](const Component& a) { return store_.component(a.first, a.second); };
    // Values at the start of a step are not needed between steps: they make room.
    std::vector<Component> idle;
    for (const auto& evolving : settings_.state)
        for (int c = 0; !predicted_ && store_.has(evolving.startName()) && c < evolving.value.in(dim); ++c)
            idle.emplace_back(evolving.startName(), c);
    std::vector<std::pair<Component, Component>> kept; // what, and where
    std::vector<std::pair<Component, std::vector<double>>> copied;
    for (const auto& [name, field] : store_.fields())
        for (int c = 0; field.state && plan_.provides(name) && c < field.type.components; ++c)
        {
            const Component rate{name, c};
            if (idle.empty()) copied.emplace_back(rate, std::vector<double>(values(rate), values(rate) + owned_));
            else
            {
                kept.emplace_back(rate, idle.back());
                std::copy_n(values(rate), owned_, values(idle.back()));
                idle.pop_back();
            }
        }
    std::vector<double> memories;
    for (const auto& model : runningModels_) memories.push_back(model->memory());

    // Lists that are too old for the present positions are made anew in passing; as they are still too old, the next evaluation sorts as ever.
    if (travelled_ > 0.5 * skin_) makeLists();
    else images_.move(store_);
    at();

    for (const auto& [rate, where] : kept) std::copy_n(values(where), owned_, values(rate));
    for (const auto& [rate, copy] : copied) std::copy_n(copy.begin(), owned_, values(rate));
    for (std::size_t k = 0; k < runningModels_.size(); ++k) runningModels_[k]->recall(memories[k]);
}

template<int dim> void Particles<dim>::observe()
{
    const auto largestOf = [&](const char* name)
    {
        std::vector<const double*> a;
        if (store_.has(name))
            for (int c = 0; c < dim; ++c) a.push_back(store_.component(name, c));
        return std::sqrt(reduce(
            owned_, 0.0,
            [&](std::size_t i)
            {
                double sum = 0;
                for (const double* component : a) sum += sqr(component[i]);
                return sum;
            },
            Larger{}));
    };
    look(
        [&]
        {
            evaluateFirst();
            if (plan_.hasGroup(onceAStep)) evaluate(onceAStep);
            run(JoinPoint::complete);
            observedAcceleration_ = largestOf(Acceleration::info.name) + largestOf(SlowAcceleration::info.name);
        });
}

template<int dim> void Particles<dim>::planAlone()
{
    const auto accelerates = [&](const std::string& term)
    {
        const auto entry = std::find_if(catalogue_.begin(), catalogue_.end(), [&](const auto& e) { return e.name == term; });
        return std::any_of(entry->results.begin(), entry->results.end(), [](const auto& f) { return f.name == Acceleration::info.name; });
    };
    auto all = settings_.terms;
    all.insert(all.end(), settings_.slowTerms.begin(), settings_.slowTerms.end());
    std::vector<std::string> others;
    std::copy_if(all.begin(), all.end(), std::back_inserter(others), [&](const auto& term) { return !accelerates(term); });
    for (const auto& term : all)
    {
        if (!accelerates(term)) continue;
        auto terms = others;
        terms.push_back(term);
        alone_[term] =
            std::make_unique<Plan<dim>>(catalogue_, std::vector<Group>{{ofEvaluation, terms}}, givenOf(settings_), rulesOf<dim>(settings_));
    }
}

template<int dim> std::map<std::string, double> Particles<dim>::powers()
{
    if (alone_.empty()) planAlone();
    std::map<std::string, double> power;
    look(
        [&]
        {
            const auto v = store_.pointers(Velocity{}), a = store_.pointers(Acceleration{});
            const double* const m = store_.component(Mass::info.name, 0);
            for (const auto& [term, plan] : alone_)
            {
                plan->bind(store_, coefficients_);
                plan->evaluate(store_, images_, lists_, kernel_);
                power[term] = sum(owned_,
                                  [&](std::size_t i)
                                  {
                                      double of = 0;
                                      for (int c = 0; c < dim; ++c) of += m[i] * v[c][i] * a[c][i];
                                      return of;
                                  });
            }
        });
    return power;
}

template<int dim> void Particles<dim>::settle()
{
    rebuild();
    observe();
}

template<int dim> std::size_t Particles<dim>::bytes() const
{
    std::size_t n = store_.bytes() + images_.bytes() + plan_.bytes();
    for (const auto& model : runningModels_) n += model->bytes();
    return n;
}

template class Particles<2>;
template class Particles<3>;

}
