/// Openings as a part of a scene: where they act in a step, and what the log says of them.
#pragma once
#include "Openings.hpp"
#include "Particles.hpp"

namespace sph
{

template<int dim> class OpeningsPart final : public Part<dim>
{
    Openings<dim> openings_;

public:
    OpeningsPart(Particles<dim>&, const Numbers& restored, const std::vector<Opening>&);

    std::vector<Stage<dim>> stages(Place) override;
    std::size_t exchange(Particles<dim>&, std::size_t owned) override;
    void moved(Particles<dim>&) override;
    void sorted(Particles<dim>&) override;
    void holdRate(Particles<dim>&, const std::string& field, double deltaT) override;
    std::string introduction() const override;
    std::string report(const Particles<dim>&) const override;
    void save(Numbers&) const override;
    double power() const override { return openings_.power(); }
};

}
