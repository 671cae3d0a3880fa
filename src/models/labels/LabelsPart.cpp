#include "LabelsPart.hpp"
#include "reduce.hpp"
#include <algorithm>

namespace sph
{

template<int dim> LabelsPart<dim>::LabelsPart(Particles<dim>&, const Numbers& restored)
{
    if (const auto found = restored.find(nextName); found != restored.end()) next_ = found->second;
}

template<int dim> void LabelsPart<dim>::loaded(Particles<dim>& particles)
{
    const auto& store = particles.store();
    if (next_ || !store.has(ParticleNumber{})) return;
    const double* const id = store.component(origId, 0);
    next_ = std::max(0.0, 1 + most(particles.size(), [&](std::size_t i) { return id[i]; }));
}

template<int dim> std::size_t LabelsPart<dim>::exchange(Particles<dim>& particles, std::size_t owned)
{
    auto& store = particles.store();
    if (store.has(RankOfOrigin{}))
    {
        double* const rank = store.component(origProcId, 0);
        std::replace(rank, rank + owned, notYet, double(ranks() ? ranks()->rank() : 0));
    }
    if (!store.has(ParticleNumber{})) return owned;
    double* const id = store.component(origId, 0);
    const auto isNew = [&](std::size_t i) { return id[i] == notYet; };
    std::size_t own = 0;
    for (std::size_t i = 0; i < owned; ++i) own += isNew(i);
    double number = *next_ + double(sumOfRanksBefore(own));
    for (std::size_t i = 0; i < owned; ++i)
        if (isNew(i)) id[i] = number++;
    *next_ += double(ofAllRanks(own, std::size_t(0), Add{}));
    return owned;
}

template<int dim> void LabelsPart<dim>::save(Numbers& numbers) const
{
    if (next_) numbers[nextName] = *next_;
}

template class LabelsPart<2>;
template class LabelsPart<3>;

}
