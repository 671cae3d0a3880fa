/// The moves that keep particles evenly spaced.
#pragma once
#include "Particles.hpp"

namespace sph
{

/// Particle shifting, dx_i = C |v| dt Delta_x shift_i, at most a tenth of a spacing; |v| of the particle, or the largest of all (ParticleShifting.hpp).
template<int dim> class Shifter final : public Part<dim>
{
    double C_;
    bool byLargestSpeed_;

    void shift(Particles<dim>&, double deltaT) const;

public:
    Shifter(Particles<dim>&, const Numbers&, double C, bool byLargestSpeed) : C_(C), byLargestSpeed_(byLargestSpeed) {}
    std::vector<Stage<dim>> stages(Place) override;
};

/// The transport velocity of a step, w = dt/2 a by the last evaluation: at most a tenth of a spacing in the step (TransportVelocity.hpp).
template<int dim> class Transporter final : public Part<dim>
{
public:
    Transporter(Particles<dim>&, const Numbers&) {}
    std::vector<Stage<dim>> stages(Place) override;
};

}
