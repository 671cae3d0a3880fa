/// Part that labels particles which have no label yet: those that came in since the lists were built last.
#pragma once
#include "case/labelEntries.hpp"
#include "scene/Particles.hpp"

namespace sph
{

struct NumberOfOrigin
{
    static constexpr FieldInfo info{origId, "1"};
    template<int dim, class Real = double> struct At
    {
        Label id;
    };
};
struct RankOfOrigin
{
    static constexpr FieldInfo info{origProcId, "1"};
    template<int dim, class Real = double> struct At
    {
        Label rank;
    };
};

template<int dim> class RunningLabels final : public RunningModel<dim>
{
    static constexpr const char* nextName = "nextOrigId";
    std::optional<double> next_; ///< number of the next new particle; nothing before the first is known

    void begin(const Particles<dim>&);
    void label(Particles<dim>&);

public:
    static constexpr double notYet = -1;

    RunningLabels(Particles<dim>&, const Numbers& restored);
    std::vector<Stage<dim>> stages(JoinPoint) override;
    void save(Numbers&) const override;
};

}
