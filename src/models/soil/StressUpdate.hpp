/// The stress of soil, a staggered leapfrog: v lives at the ends of steps, x as seen by forces, and sigma, in their middles.
///
///   x^(n+1/2) = x^n + dt/2 v^n,    v^(n+1) = v^n + dt a(x^(n+1/2), sigma^(n+1/2))
///   sigma^(n+3/2) = integral of the law over L dt,    L = velocity gradient of v^(n+1) at x^(n+1/2)        (integrateStress.hpp)
///
/// The stress of a step's middle is so the one that acts there, and sound is stable up to the limit below though the first order terms of a viscosity lag.
///
/// With two levels (`scheme verlet`, TwoLevels.hpp) all lives at the ends of steps, and the law is integrated from the level before over the velocity gradient between the two:
///
///   sigma^(n+1) = integral of the law from sigma^(n-1) over (dt_0 + dt) L^n, or from sigma^n over dt L^n by a re-coupling step;    L^n = velocity gradient of v^n at x^n
///
/// The limit by artificial viscosity is then `stableDecay` times as long.
///
///   dt <= f h/max_i(c_i + |v|),    dt <= 0.5 h/(alpha max_i c_i)        c_i = sqrt(M_i/rho_i), M the law's stiffness, h = H/2, f = soundFactor
///
/// State variables of the law (soilLaws/SoilState.hpp) are integrated with the stress, and live where it does; the density goes with the share of the solids in the
/// volume, rho (1 + e) constant for a void ratio e, and no continuity equation runs.
///
/// With `stressSmoothing` delta the stress relaxes meanwhile towards that of its surroundings (StressNoise.hpp), where the law admits the result:
///
///   sigma += (1 - exp(-delta min(c/h, k |D|) dt)) noise,    k = 500;    delta c/h in place of the least of both with `smoothingActs always`
///
/// Stress-free, inadmissible and unresolved particles of the last step are counted, and the first of the latter two is named by its place.
#pragma once
#include "scene/Particles.hpp"
#include "scene/TwoLevels.hpp"
#include <optional>

namespace sph
{

template<int dim> class StressUpdate final : public RunningModel<dim>
{
public:
    StressUpdate(Particles<dim>&, const Numbers&);

    std::vector<Stage<dim>> stages(JoinPoint) override;
    /// The speeds of sound of the stress that was read, before the first evaluation.
    std::vector<StepLimit> limits() const override;
    Numbers columns(const Particles<dim>&) const override;
    std::string introduction() const override;
    std::string report(const Particles<dim>&) const override;
    std::string note() const override;
    void save(Numbers&) const override;
    /// Minus that of the stress, for what deforms soil is taken from its motion, and that of walls which move across themselves.
    double power() const override { return summary_.power; }

private:
    struct Counts
    {
        std::size_t stressFree = 0, inadmissible = 0, unresolved = 0;
        double fastest = 0; ///< largest c [m/s]
        double ofLaw = 0;   ///< the same by the law alone, without compactionSpeed [m/s]
        double power = 0;   ///< -sum V S:D [W]
        Vector<3> place{};  ///< of the first that is inadmissible or unresolved [m]
        Counts& operator+=(const Counts&);
    };
    static constexpr double strainsOfNoise = 500; ///< k: by how much strain noise vanishes, 1/(k delta)
    const Particles<dim>& particles_;
    Counts summary_;
    std::optional<TwoLevels> levels_; ///< none where steps start from one
    bool measured_ = false, fresh_;   ///< fresh_: the run begins here, and does not go on from another

    void advance(Particles<dim>&, double deltaT);
    void measure(Particles<dim>&); ///< the speeds of sound
    /// Throws CaseError where the state variables at the start are outside of the law's range.
    void checkVariables(const Particles<dim>&) const;
    /// -sum V/dx (S n).v_w of the row at the walls [W]
    double powerOfWalls(const Particles<dim>&) const;
};

}
