#include "models/labels/RunningLabels.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>

namespace sph
{

template<int dim> RunningLabels<dim>::RunningLabels(Particles<dim>&, const Numbers& restored)
{
    if (const auto found = restored.find(nextName); found != restored.end()) next_ = found->second;
}

template<int dim> std::vector<Stage<dim>> RunningLabels<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::loaded)
        return {{"first label", "of the particles to come", [this](Particles<dim>& p, const Substep&) { begin(p); }}};
    if (place == JoinPoint::exchange)
        return {{"label", "of particles that have come in", [this](Particles<dim>& p, const Substep&) { label(p); }}};
    return {};
}

template<int dim> void RunningLabels<dim>::begin(const Particles<dim>& particles)
{
    const auto& store = particles.store();
    if (next_ || !store.has(NumberOfOrigin{})) return;
    const double* const id = store.component(origId, 0);
    next_ = std::max(0.0, 1 + most(particles.size(), [&](std::size_t i) { return id[i]; }));
}

template<int dim> void RunningLabels<dim>::label(Particles<dim>& particles)
{
    const std::size_t owned = particles.size();
    auto& store = particles.store();
    if (store.has(RankOfOrigin{}))
    {
        double* const rank = store.component(origProcId, 0);
        std::replace(rank, rank + owned, notYet, double(ranks() ? ranks()->rank() : 0));
    }
    if (!store.has(NumberOfOrigin{})) return;
    double* const id = store.component(origId, 0);
    const auto isNew = [&](std::size_t i) { return id[i] == notYet; };
    std::size_t own = 0;
    for (std::size_t i = 0; i < owned; ++i) own += isNew(i);
    double number = *next_ + double(sumOfRanksBefore(own));
    for (std::size_t i = 0; i < owned; ++i)
        if (isNew(i)) id[i] = number++;
    *next_ += double(ofAllRanks(own, std::size_t(0), Add{}));
}

template<int dim> void RunningLabels<dim>::save(Numbers& numbers) const
{
    if (next_) numbers[nextName] = *next_;
}

template class RunningLabels<2>;
template class RunningLabels<3>;

}
