/// Openings as a part of a scene: where they act in a step, and what the log says of them.
#pragma once
#include "models/openings/Openings.hpp"
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class RunningOpenings final : public RunningModel<dim>
{
    Openings<dim> openings_;
    std::vector<std::string> phases_;
    const bool solvesPressure_;
    const bool isMeasured_; ///< whether the energy balance knows all that openings do

    /// One number of each phase: "1 kg of water, 2 kg of air".
    std::string ofPhases(const std::vector<double>&, const std::string& format) const;

public:
    RunningOpenings(Particles<dim>&, const Numbers& restored, const std::vector<Opening>&);

    std::vector<Stage<dim>> stages(JoinPoint) override;
    void withholdRate(Particles<dim>&, const std::string& field, double deltaT) override;
    Numbers columns(const Particles<dim>&) const override;
    std::string introduction() const override;
    std::string report(const Particles<dim>&) const override;
    void save(Numbers&) const override;
    double power() const override { return openings_.power(); }
    /// That of what passes the planes; what is held beyond them does the rest (solver/BoundaryWork).
    double measuredPower() const override { return isMeasured_ ? openings_.account().powerOfPassing() : power(); }
};

}
