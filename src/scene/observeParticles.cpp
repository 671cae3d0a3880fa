/// Observation of particles, which leaves no trace: all fields at the present state, and the power of each operation that accelerates.
#include "parallel/reduce.hpp"
#include "scene/Particles.hpp"
#include "scene/planOfScene.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

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

    // Lists that are too old for the present positions are made anew in passing; as they are still too old, the next evaluation sorts as ever.
    if (travelled_ > 0.5 * skin_) makeLists(true);
    else images_.move(store_);
    at();

    for (const auto& [rate, where] : kept) std::copy_n(values(where), owned_, values(rate));
    for (const auto& [rate, copy] : copied) std::copy_n(copy.begin(), owned_, values(rate));
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
    images_.forget(); // a restart knows none
    rebuild();
    observe();
}

template class Particles<2>;
template class Particles<3>;

}
