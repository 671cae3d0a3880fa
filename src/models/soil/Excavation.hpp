/// Soil that is dug out: particles go where an expression of place and time is not 0.
///
///     excavation { where "$t > 2 && $x < 0 && $y > -0.5*($t - 2)"; }      // constant/soilProperties
///
/// `$x`, `$y`, `$z` [m] of a particle, `$t` [s]. It is looked at once a step; what goes does before the next sorting of particles, with its mass, stress and motion. What carried it, or was held by it, is free
/// from then on: soil dug out at once lets a wave of unloading go, in slices it does not. The log says how much has gone. Verified by test/unit/soil/excavationTest (stress and heave of a layer that is dug off).
#pragma once
#include "dictionary/ExpressionProgram.hpp"
#include "scene/Particles.hpp"

namespace sph
{

struct Digging
{
    ExpressionProgram where;
    Location at;
};

/// What a name of the text is; throws ExpressionError where it is none of place and time.
ExpressionProgram::Kind kindInDigging(const std::string& name);

template<int dim> class Excavation final : public RunningModel<dim>
{
    const Digging digging_;
    double time_ = 0;                 ///< that the next sorting digs at [s]
    double gone_ = 0, particles_ = 0; ///< since the first start: mass [kg], per metre of depth in 2-D, and number

    /// Marks of the particles that go at a time.
    std::vector<std::uint8_t> within(const Particles<dim>&, double time) const;
    void look(Particles<dim>&, double time);
    void dig(Particles<dim>&);

public:
    Excavation(Particles<dim>&, const Numbers& restored, const Digging&);
    std::vector<Stage<dim>> stages(JoinPoint) override;
    double letIn(std::size_t /*phase*/) const override { return -gone_; }
    std::string report(const Particles<dim>&) const override;
    void save(Numbers&) const override;
};

}
