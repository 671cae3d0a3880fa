/// The moves that keep particles evenly spaced.
#pragma once
#include "scene/Particles.hpp"

namespace sph
{

/// Particle shifting, dx_i = C |v| dt Delta_x shift_i, at most a tenth of a spacing; |v| of the particle, or the largest of all (ParticleShifting.hpp).
///
/// Implicit steps are long, |v| dt up to 0.2 h, and the factor of shift_i has a limit of its own there, H^2/50. On square, hexagonal and cubic lattices the
/// most uneven mode is carried past its mean by each step beyond H^2/21 (wendlandC2, 3 spacings; H^2/16 to H^2/61 over all kernels and supports), and the
/// pressure that follows is never relaxed by sound: without the limit steps of five splashes with C = 2 were 0.6 times as long, by the force limit, and spray
/// grew by half (tutorials/stiff/dropOnFilm). Lind et al. (2012) have h^2/4. With it C matters little.
template<int dim> class Shifter final : public RunningModel<dim>
{
    double C_;
    bool byLargestSpeed_, byImplicitSteps_;

    void shift(Particles<dim>&, double deltaT) const;

public:
    Shifter(Particles<dim>& particles, const Numbers&, double C, bool byLargestSpeed)
        : C_(C), byLargestSpeed_(byLargestSpeed), byImplicitSteps_(particles.settings().integration.solvesPressure)
    {}
    std::vector<Stage<dim>> stages(JoinPoint) override;
};

/// The transport velocity of a step, w = dt/2 a by the last evaluation: at most a tenth of a spacing in the step (TransportVelocity.hpp).
template<int dim> class Transporter final : public RunningModel<dim>
{
public:
    Transporter(Particles<dim>&, const Numbers&) {}
    std::vector<Stage<dim>> stages(JoinPoint) override;
};

}
