/// Account of open boundaries: what has passed each of them, by phases and counted amounts, and the mass-balance error.
///
/// An opening counts what passes its plane, and what is removed at the start: free fluid has grown by the one less the other, to round-off. Powder that
/// migrates between buffer and free particles counts too. Where ranks share the particles, each counts what passes among its own.
#pragma once
#include "fields/FieldStore.hpp"
#include "models/openings/PlacedOpening.hpp"
#include "parallel/reduce.hpp"
#include "scene/State.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace sph
{

/// Residence time of marked fluid that has passed an opening, counted from the time of its entry: 0 for what passes an inlet.
struct Transit
{
    double mass = 0, time = 0, square = 0; ///< sum m, sum m t, sum m t^2 [kg], [kg s], [kg s^2]
    void add(double m, double t)
    {
        mass += m;
        time += m * t;
        square += m * t * t;
    }
    double mean() const { return mass > 0 ? time / mass : 0; }
    double deviation() const { return mass > 0 ? std::sqrt(std::max(0.0, square / mass - mean() * mean())) : 0; }
};

/// One opening in numbers: its kind, what has passed its plane (into the scene > 0), and its present state.
struct Flow
{
    std::string name;
    bool inlet = true;
    double area = 0;                    ///< area of the section [m^2], a length [m] in 2-D
    std::size_t held = 0;               ///< number of buffer particles beyond the plane
    std::vector<double> mass;           ///< net inflow of each phase since the first start [kg]; per metre of depth in 2-D
    std::vector<double> amounts;        ///< net inflow of each fraction that is counted beside it (Evolving::amount) [m^3]
    std::vector<double> taken;          ///< mass removed at the start, from farther beyond the plane than the buffer reaches [kg]
    double flowRate = 0;                ///< volume flow rate [m^3/s], into the scene > 0
    std::optional<double> asked = {};   ///< prescribed flow rate of an inlet that has a rate or a velocity [m^3/s]
    std::vector<double> flowRates;      ///< flow rate of each phase [m^3/s]
    double pressure = 0;                ///< pressure of the fluid at the plane [Pa], without the background pressure
    std::optional<Transit> marked = {}; ///< marked fluid that has passed; none where nothing is marked
};

/// Mass-balance error of each phase and each counted amount: free fluid now, minus that at the start, minus net inflow, plus what was removed at the start;
/// relative to the largest of the amount now, the amount at the start, and what has passed one opening. What rates bring into the buffer counts as outflow.
struct Imbalance
{
    std::vector<double> mass;
    std::vector<double> amounts;
};

template<int dim> class OpeningAccount
{
public:
    /// The scene and the openings must outlive the account.
    OpeningAccount(const OpenScene&, const std::vector<PlacedOpening>&);

    /// Counts a particle that passes an opening, into the scene with a sign > 0. `predicted`: its amounts are those at the start of the step.
    void pass(FieldStore<dim>&, std::size_t i, std::size_t opening, double sign, bool predicted);
    /// Counts free and removed particles at the start. `takenBy`: 1 + the opening that removes each, 0 for those that stay.
    void countStart(const FieldStore<dim>&, std::size_t owned, const std::vector<int>& takenBy);
    /// Sets the number of buffer particles of each opening.
    void countHeld(const std::vector<std::size_t>& numbers);
    /// Remembers the amounts that present rates bring into buffer particles.
    void noteRates(const FieldStore<dim>&, std::span<const int> held);
    /// Ends a step of `deltaT` at `time` [s], in which the rates have acted and particles have passed.
    void advance(double deltaT, double time);
    /// Sets a rate that is about to act for `deltaT` [s] to 0 at the buffer particles, and counts the amount that it would have brought into them.
    void withholdRate(FieldStore<dim>&, const std::string& field, double deltaT, std::span<const int> held);

    /// Counts the energy of what passes from now on.
    void countEnergy() { countsEnergy_ = true; }
    /// Kinetic energy and energy of compression that particles brought in during the last step, over its length [W]. All ranks must ask.
    double powerOfPassing() const { return ofAllRanks(powerOfPassing_, 0.0, Add{}); }

    /// Whether some inlet marks its fluid.
    bool marks() const { return marks_; }
    /// Names of the amounts that are counted.
    const std::vector<std::string>& amounts() const { return amountNames_; }
    std::vector<Flow> flows() const;
    /// `letIn`: mass of each phase that others have let into the scene since the first start, less what they have taken out [kg]; none by default.
    Imbalance imbalance(const FieldStore<dim>&, const std::vector<double>& letIn = {}) const;
    /// Volume at rest density that has come in, less that which has left [m^3].
    double volume() const;
    /// Adds the numbers of a restart, those of all ranks together.
    void save(std::map<std::string, double>& numbers) const;
    /// Takes the numbers of a restart; false where there are none, at the first start.
    bool restore(const std::map<std::string, double>& numbers);

private:
    /// Amounts that have passed one opening.
    struct Passed
    {
        std::vector<double> mass, amounts; ///< of each phase [kg]; of each fraction that is counted [m^3]
        Transit marked = {};
        double held = 0; ///< number of buffer particles now
    };
    /// Amounts that ranks add up: what each has counted of its own particles.
    struct Sums
    {
        std::vector<Passed> of = {};
        std::vector<double> heldAmounts = {}; ///< amounts that rates have brought into buffer particles [m^3]
        double energy = 0;                    ///< energy that has passed since the last step ended [J]
    };
    /// Amounts removed at the start, from farther beyond a plane than the buffer reaches.
    struct Taken
    {
        std::vector<double> mass, amounts;
    };
    const OpenScene& scene_;
    const std::vector<PlacedOpening>& placed_;
    std::vector<const Evolving*> counted_; ///< fractions whose amounts are counted
    std::vector<std::string> amountNames_;
    bool marks_ = false, countsEnergy_ = false;
    double time_ = 0;           ///< [s]
    double powerOfPassing_ = 0; ///< of this rank, in the last step [W]
    Sums sums_;                 ///< amounts that this rank has counted
    std::vector<Taken> taken_;
    std::vector<double> startMass_;               ///< mass of the free and the removed particles, at the first start [kg]
    std::vector<double> startAmounts_, intoHeld_; ///< the same amounts [m^3]; present rates into the buffer [m^3/s]

    void mark(FieldStore<dim>&, std::size_t i, const Opening&, Transit& marked, double sign);
    double energyOf(const FieldStore<dim>&, std::size_t i) const;
    /// Rate of the amount of a counted fraction in the buffer [m^3/s].
    double rateInto(const FieldStore<dim>&, const Evolving& fraction, std::span<const int> held) const;
    Sums ofAll() const;
    static void eachShare(auto& sums, const auto& visit);
    /// Calls visit(name, value, whether a 0 is left out) for each number of a restart.
    static void eachNumber(auto& self, auto& sums, const auto& visit);
    /// Mass of the free particles, of each phase [kg].
    std::vector<double> freeMass(const FieldStore<dim>&) const;
    double freeAmount(const FieldStore<dim>&, const Evolving&) const;
    /// Function amount(i) of a particle, m fraction/rho_0 [m^3]; `predicted`: with the value at the start of the step, where that is kept.
    auto amountsOf(const FieldStore<dim>& store, const Evolving& fraction, bool predicted = false) const
    {
        const auto& name = predicted && store.has(fraction.startName()) ? fraction.startName() : fraction.value.name;
        return [q = store.component(name, 0), m = store.component(Mass::info.name, 0), phase = scene_.phasesOf(store),
                rho = scene_.coefficients.restDensity.data()](std::size_t i) { return q[i] * m[i] / rho[phase(i)]; };
    }
};

}
