/// Energy balance of a run: its energy against all that its scene can have supplied. A scheme whose pressure and tension are gradients of an energy
/// gains none; others may, and do where nothing takes it up (tutorials/stiff/dropOnFilm).
///
///   held       K(t) + S(t)
///   supplied   K(0) + S(0) + sum_i m_i e(rho_i) + 0.02 p_0 sum_i V_i + max_t W + sum_walls dgamma_s A + M u_w^2/2 + sum_i m_i (c/100)^2/2
///
/// K [J] kinetic energy, S = sum gamma_kl A_kl of the interfaces between phases; at the start the compression by the state equation,
/// e = int (p - p_b)/rho^2 drho [J/kg], and what a lattice may yield under the background pressure, p_0 = min(|p_b|, max rho c^2/20); W the
/// work of gravity and body force since then; what walls may give: the largest difference dgamma_s of their tensions with the phases on the
/// area A of the particles at them, and the speed u_w of the fastest wall to the whole mass M; and sound of Mach 0.01, which any start
/// makes. Each is an upper bound, dissipation is left out: a healthy run holds less than it was given. In 2-D all are per metre of depth.
/// The area of an interface is counted by the pairs across it nearer than the support H,
///
///   A_kl = sum_(i of k, j of l) V_i V_j/(2 H^3/3) in 2-D, /(pi H^4/4) in 3-D
///
/// exact for plane interfaces, and rising with every particle that strays into the other phase. The impulse of gravity and body force is
/// kept beside their work, for whoever balances momentum (function object conservation). A restarted run goes on with the account of
/// the time folder, where the forces are those that it was written with; else it begins a new one.
#pragma once
#include "Particles.hpp"
#include "Simulation.hpp"
#include <map>
#include <string>

namespace sph
{

/// The operation that feeds the motion, in words: the one with the most work, if any has done some upon the fluid. "what feeds it is a: work of a 2 J, b
/// -1 J"
std::string sourceInWords(const std::map<std::string, double>& workOfEach);

template<int dim> class EnergyBalance
{
    const Settings& settings_;
    double given_, work_ = 0, mostWork_ = 0;
    Vector<3> impulse_;

    double interfaces(const Particles<dim>&) const;
    double compression(const Particles<dim>&) const;
    /// Energy that a lattice may yield under the background pressure, and that of the sound that any start makes.
    double allowance(const Particles<dim>&, const Summary&) const;
    double walls(const Particles<dim>&, const Geometry&, const Summary&) const;

public:
    /// The balance at the start of a run. The settings must outlive it.
    EnergyBalance(const Particles<dim>&, const Settings&, const Geometry&, const Summary&);
    void addWork(double work);
    void addImpulse(const Vector<3>& impulse) { impulse_ += impulse; }
    /// The account, for a restart.
    void save(Numbers&) const;
    void restore(const Numbers&);
    Energy at(const Particles<dim>& particles, const Summary& summary) const
    {
        return {summary.kineticEnergy, interfaces(particles), compression(particles), given_ + mostWork_, work_, impulse_};
    }
};

}
