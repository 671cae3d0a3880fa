/// Energy balance of a run: its energy against all that its scene can have supplied. A scheme whose pressure and tension are gradients of an energy
/// gains none; others may, and do where nothing takes it up (tutorials/stiff/dropOnFilm).
///
///   held       K(t) + sum_models E(t)
///   supplied   K(0) + sum_models (E(0) + S) + max_t W
///
/// K [J] kinetic energy, E [J] what a model stores (RunningModel::energy), S [J] the most that it may give from the start on (RunningModel::supply): an upper bound; W the
/// work of gravity, of the body force and of models since then. Energy of compression counts at the start alone. Dissipation is left out: a healthy run
/// holds less than it was given. In 2-D all are per metre of depth. The impulse of gravity and body force is kept beside their work, for whoever balances
/// momentum (function object conservation). A restarted run goes on with the account of the time folder, where the forces are those that it was written
/// with; else it begins a new one.
#pragma once
#include "scene/Particles.hpp"
#include "solver/Simulation.hpp"
#include <map>
#include <string>

namespace sph
{

/// The operation that feeds the motion, in words: the one with the most work, if any has done some upon the fluid. "what feeds it is a: work of a 2 J, b
/// -1 J"
std::string sourceInWords(const std::map<std::string, double>& workOfEach);

template<int dim> class EnergyBalance
{
    double given_, work_ = 0, mostWork_ = 0, measuredWork_ = 0;
    Vector<3> impulse_;

    /// Numbers of a restart, by name.
    static auto numbersOf(auto& self);

public:
    /// The balance at the start of a run.
    EnergyBalance(const Particles<dim>&, const Summary&);
    /// `work`: the most that was done [J], against which the energy is held; `measured` [J] what was done, for whoever balances energy.
    void addWork(double work, double measured);
    void addImpulse(const Vector<3>& impulse) { impulse_ += impulse; }
    /// The account, for a restart.
    void save(Numbers&) const;
    void restore(const Numbers&);
    Energy at(const Particles<dim>&, const Summary&) const;
};

}
