#include "models/labels/labels.hpp"
#include "models/labels/RunningLabels.hpp"
#include "parallel/reduce.hpp"

namespace sph
{

namespace
{
template<class F> Evolving label(F field)
{
    Evolving evolving{stateField(field)};
    evolving.inlet = [](const Dictionary&, std::size_t) { return RunningLabels<3>::notYet; };
    return evolving;
}

/// Number of a particle by its place in the time folder, of which every rank has read a part.
Evolving number()
{
    auto evolving = label(NumberOfOrigin{});
    evolving.missing = [](const Loading& loading)
    {
        const auto before = sumOfRanksBefore(loading.size());
        for (std::size_t i = 0; i < loading.size(); ++i) loading.values[0][i] = double(before + i);
    };
    return evolving;
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    for (const auto& name : entry::shown(reading.schemes)) settings.state.push_back(name == origId ? number() : label(RankOfOrigin{}));
}

void read(const Reading& reading)
{
    const auto isLabel = [](const Evolving& e) { return e.value.name == origId || e.value.name == origProcId; };
    // The part is made after all models have prepared: what openings bring must be there first.
    if (std::ranges::any_of(reading.settings.state, isLabel)) reading.settings.runningModels.push_back(running<RunningLabels>());
}
}

const Model& labelsModel()
{
    static const Model model{"labels", "what particles are called for life",   read, {}, {}, prepare, {},
                             {},       {{"system/sphSchemes", {entry::shown}}}};
    return model;
}

}
