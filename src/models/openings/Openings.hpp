/// Open boundaries (inlets and outlets): fluid particles that enter and leave the scene, and buffer particles beyond the planes, whose state is prescribed.
///
/// Buffer particles beyond each plane fill twice the support H, more with surface tension: the depth that the kernel sees from the plane, and as much again for
/// their own sums. They take part in every sum, but do not obey it:
///
///   inlet    v = U u n                  U mean velocity [m/s], u profile of the section (Section.hpp), n normal
///   outlet   v = (v_l.n) n, v_l the mean of the free particles within H of the plane that come along the same line l, never inwards
///   both     p = a + b s                s [m] distance from the plane, < 0; a, b fitted to the fluid within H of the plane, at an outlet
///                                       with a the given pressure; where density is integrated, the density that goes with it
///
/// With several phases each has a fit p of its own, or that of all where it has none, and v_l is a mean by mass. An outlet with `backflow` lets that phase
/// in again, by lines: a line along which nothing else comes may move inwards, is filled up from behind, and what else is held on it becomes that phase. It
/// starts from rest outside, a = p - rho u^2/2, and beside it other phases have its pressure and the jump across their surface, which is measured.
///
/// Sums reach far beyond a plane: the buffer is twice the support H deep for forces, one more with the interface stress (gradC), two more with tension by
/// curvature (colour, gradC, curvature, its mean). At a plane interface across an opening, at rest, the tension pulls at the free particles with 1e-5
/// gamma/(rho dx^2) where the buffer is 2 H deep, 4e-11 with 3 and nothing with 4.
///
/// An inlet that has a pressure p_in moves by the balance of forces on the plug of length l that it holds, and not faster than its velocity,
/// if it has one: dU/dt = (p_in - a)/(rho l), U >= 0. A particle is free from the evaluation on that finds it past an inlet's plane, and held from that
/// on which finds it past an outlet's. Lines are filled up from behind, and what comes to the end of an outlet is taken away, when neighbour lists are
/// rebuilt: both out of the scene's sight, so that the time of it changes nothing. A packing farther beyond a plane than the buffer reaches is taken away
/// at the start.
///
/// The account of an opening counts what passes, by phases, and what is removed at the start: free fluid has grown by the one less the other, to round-off.
/// Powder that migrates between buffer and free particles counts too.
///
/// Where ranks share the particles, each counts what passes among its own, and sums over what is free before a plane or held beyond it are those of all: planes
/// move alike on all ranks. The first puts in what comes, and from there it goes to the rank in whose box it lies.
/// Verified by test/unit/openings and tutorials/verification/openChannel.
#pragma once
#include "FieldStore.hpp"
#include "Opening.hpp"
#include "Section.hpp"
#include "State.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
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

template<int dim> class Openings
{
public:
    /// Throws CaseError where an opening does not fit the scene: inside a wall, narrower than the kernel's support, with a duct that is not
    /// straight, out of the domain as far as the buffer particles reach, where another one has its buffer, or with its normal out of the scene.
    /// `restored` holds the numbers that `state` gave; `supports`: depth of the buffer in supports of the kernel.
    Openings(const std::vector<Opening>&, const Geometry&, const Coefficients&, const State&, const std::map<std::string, double>& restored,
             int supports = 2);

    /// Removes and inserts particles before the sorting, and returns how many there are now. `predicted`: the call lies between prediction
    /// and correction, where the amounts that pass are those of a particle at the start of the step.
    std::size_t exchange(FieldStore<dim>&, std::size_t owned, bool predicted = false);
    /// Finds the buffer particles, and the free ones near a plane, after the sorting.
    void locate(FieldStore<dim>&, std::size_t owned);
    /// Updates who is in the buffer at new positions between two sortings: a particle that has passed a plane is held, or free, from now on.
    void follow(FieldStore<dim>&, bool predicted);
    /// Indices of the buffer particles.
    std::span<const int> held() const { return held_; }
    /// Sets the rates of the buffer particles to 0 after an evaluation, and remembers the amounts that the rates would have brought into them.
    void hold(FieldStore<dim>&);
    /// Prescribes pressures and velocities of the buffer particles, once a step, after the kick. `time` [s] is that of the end of the step.
    void drive(FieldStore<dim>&, double deltaT, double time = 0);
    /// Sets a rate that is about to act for `deltaT` [s] to 0 at the buffer particles, and counts the amount that it would have brought into them.
    void withholdRate(FieldStore<dim>&, const std::string& field, double deltaT);
    /// Names of the amounts that are counted.
    const std::vector<std::string>& amounts() const { return amountNames_; }

    std::vector<Flow> flows() const;
    Imbalance imbalance(const FieldStore<dim>&) const;
    /// Volume at rest density that has come in, less that which has left [m^3].
    double volume() const;
    bool marks() const { return marks_; }
    /// Power of the inflow upon the fluid, Q (p + rho u^2/2) [W]; never negative.
    double power() const;
    /// Numbers of a restart, by name.
    std::map<std::string, double> state() const;

private:
    struct Gate
    {
        Opening opening;
        Opening plane; ///< the whole plane that it is a part of; itself where it stands alone
        Section section;
        std::optional<double> asked;         ///< prescribed rate of an inlet [m^3/s]; none where a pressure alone drives it
        double most, speed;                  ///< U of an inlet [m/s]: its limit, and its present value
        std::vector<double> pressure, slope; ///< a [Pa] and b [Pa/m] of each phase
        std::vector<double> taken;           ///< mass of each phase removed at the start [kg]
        std::vector<double> takenAmounts;
        double density = 0;                ///< rest density of the incoming fluid [kg/m^3]
        double inflow = 0;                 ///< mean velocity near the plane times the area [m^3/s]
        std::vector<double> inflows;       ///< the same of each phase
        std::vector<double> velocity = {}; ///< velocity of each line [m/s]
        std::vector<int> near = {};        ///< free particles within H
    };
    /// Amounts that have passed one opening.
    struct Passed
    {
        std::vector<double> mass, amounts; ///< of each phase [kg]; of each fraction that is counted [m^3]
        Transit marked = {};
        double held = 0; ///< number of buffer particles now
    };
    struct Account
    {
        std::vector<Passed> gates = {};
        std::vector<double> heldAmounts = {}; ///< amounts that rates have brought into buffer particles [m^3]
    };
    /// Weighted sums over the free particles near a plane, with w = `weight`.
    struct Sums
    {
        double n = 0, v0 = 0, s1 = 0, p0 = 0, s2 = 0, count = 0, p1 = 0; ///< sums of w, w v, w s, w p, w s^2, 1, w s p
        Sums& operator+=(const Sums&);
    };
    /// Weighted sums over the free particles near the plane along one line of an outlet, and sums over the buffer particles on it.
    struct LineSums
    {
        double n = 0;      ///< sum of w; with several phases, of w m
        double others = 0; ///< number of particles of phases that do not come back
        double held = 0, heldV = 0;
        double v0 = 0; ///< sum of w v, or of w m v
        LineSums& operator+=(const LineSums&);
    };
    struct Fit
    {
        Sums of;
        double pressure, slope; ///< a and b
        bool enough;
    };
    std::vector<Gate> gates_;
    Account account_; ///< amounts that this rank has counted
    const Geometry& geometry_;
    const Coefficients& coefficients_;
    const State& state_;
    bool integrates_ = false;              ///< density evolves
    std::vector<const Evolving*> counted_; ///< fractions whose amounts are counted
    std::vector<std::string> amountNames_;
    std::size_t phases_;
    bool marks_ = false;                          ///< some inlet marks its fluid
    double depth_;                                ///< depth of the buffer beyond a plane [m]
    double time_ = 0;                             ///< [s]
    std::vector<int> close_, held_;               ///< close_: all particles that may come near or be held before the next sorting
    std::vector<double> startMass_;               ///< mass of the free and the removed particles, at the first start [kg]
    std::vector<double> startAmounts_, intoHeld_; ///< the same amounts [m^3]; present rates into the buffer [m^3/s]
    bool restored_ = false, counts_ = false;      ///< counts_: the holder of each particle is known from before

    void check(const Opening&, const Section&) const;
    double densityOf(const Opening&, const Section&) const;
    void checkNormal(const Gate&) const;
    /// Weight w = s (H - s) [m^2] of a free particle at a distance s from a plane: 0 at the plane and at H, so that particles enter the sums gradually.
    double weight(double s) const { return std::max(0.0, s * (coefficients_.support - s)); }
    bool inDomain(const Vector<3>& x, double beyond) const;
    bool belongs(const Gate&, const Vector<3>& x) const;
    bool meet(const Gate& a, const Gate& b) const;
    int holderOf(const Vector<3>& x) const;
    int farBeyond(const Vector<3>& x) const;
    /// Sets the holder of a particle at x_i from now on, 1 + the opening or 0 for a free one, and returns it; counts the particle where it passes a plane.
    int assign(FieldStore<dim>&, double& holder, std::size_t i, const Vector<3>& x_i, bool predicted);
    /// Divides `close_` into the buffer particles and the free ones near a plane.
    void list(FieldStore<dim>&);
    void mark(FieldStore<dim>&, std::size_t i, const Opening&, Transit& marked, double sign);
    /// Sums of the accounts of all ranks.
    Account account() const;
    static void eachShare(auto& account, const auto& visit);
    /// Calls visit(name, value, whether a 0 is left out) for each number of a restart.
    static void eachNumber(auto& self, auto& account, const auto& visit);
    std::string named(const std::string& name, std::size_t phase) const;
    /// Phase of each particle, from an array that is looked up once.
    struct Phases
    {
        const double* phase;
        std::size_t operator()(std::size_t i) const { return phase ? std::size_t(phase[i]) : 0; }
    };
    Phases phasesOf(const FieldStore<dim>& store) const { return {phases_ > 1 ? store.component(Phase::info.name, 0) : nullptr}; }
    void bring(FieldStore<dim>&, std::size_t i, const Stream&) const;
    void fillFirst(FieldStore<dim>&, std::size_t& owned);
    double firstRow(const FieldStore<dim>&, std::size_t owned, const Gate&) const;
    std::vector<bool> linesToFill(FieldStore<dim>&, std::size_t owned, int gate) const;
    void countStart(const FieldStore<dim>&, std::size_t owned, const std::vector<int>& takenBy);
    /// A place for a particle that comes in.
    struct Place
    {
        Vector<3> x;
        std::size_t line;
    };
    void refill(FieldStore<dim>&, std::size_t& owned, int gate);
    void insert(FieldStore<dim>&, std::size_t& owned, int gate, const std::vector<Place>&);
    /// Places that have none of `others` nearer than 0.8 spacings, on any rank.
    std::vector<Place> clearOf(const std::vector<Vector<3>>& others, const std::vector<Place>&) const;
    void replace(FieldStore<dim>&, std::size_t i, const Gate&, const Vector<3>& x_i) const;
    void impose(FieldStore<dim>&, std::size_t i, const Vector<3>& x_i) const;
    Sums sumsOf(FieldStore<dim>&, const Gate&, const auto& counts) const;
    /// Sums near all openings, over all ranks: `sumsOfGate()` for each, one over all particles near it and, with several phases, one for each phase.
    std::vector<Sums> sumsNear(FieldStore<dim>&) const;
    std::size_t sumsOfGate() const { return phases_ > 1 ? 1 + phases_ : 1; }
    /// Sums along the lines of all outlets, over all ranks.
    std::vector<LineSums> sumsOfLines(FieldStore<dim>&) const;
    Fit fit(const Gate&, double a, const Sums&) const;
    void measure(Gate&, std::span<const Sums>) const;
    std::vector<double> velocities(const Gate&, std::span<const LineSums>) const;
    /// Mass of the free particles, of each phase [kg].
    std::vector<double> freeMass(const FieldStore<dim>&) const;
    double freeAmount(const FieldStore<dim>&, const Evolving&) const;
    /// Function amount(i) of a particle, m fraction/rho_0 [m^3]; `predicted`: with the value at the start of the step, where that is kept.
    auto amounts(const FieldStore<dim>& store, const Evolving& fraction, bool predicted = false) const
    {
        const auto& name = predicted && store.has(fraction.startName()) ? fraction.startName() : fraction.value.name;
        return [q = store.component(name, 0), m = store.component(Mass::info.name, 0), phase = phasesOf(store),
                rho = coefficients_.restDensity.data()](std::size_t i) { return q[i] * m[i] / rho[phase(i)]; };
    }
};

}
