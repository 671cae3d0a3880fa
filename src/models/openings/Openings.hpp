/// Inlets and outlets at work: particles that come and go, and those beyond the planes, which are held.
///
/// Beyond each plane stand particles of the scene as deep as the kernel sees from the plane, and as deep again for their own sums. They take
/// part in every sum, but do not obey it:
///
///   inlet    v = U u n                  U mean velocity [m/s], u profile of the section (Section.hpp), n normal
///   outlet   v = (v_l.n) n, v_l the mean of the free particles within H of the plane that come along the same line l, never inwards
///   both     p = a + b s                s [m] distance from the plane, < 0; a, b fitted to the fluid within H of the plane, at an outlet
///                                       with a the given pressure; where density is integrated, the density that goes with it
///
/// Of several phases each has a fit p of its own, or that of all where it has none, and v_l is a mean by mass. An outlet with `backflow` lets that phase
/// in again, by lines: a line along which nothing else comes may move inwards, is filled up from behind, and what else is held on it becomes that phase. It
/// starts from rest outside, a = p - rho u^2/2, and beside it other phases have its pressure and the jump across their surface, which is measured.
///
/// Beyond a plane they stand as deep as sums reach: twice the support H for forces, one more with the interface stress (gradC), two more with tension by
/// curvature (colour, gradC, curvature, its mean). At a plane interface across an opening, at rest, the tension pulls at the free particles with 1e-5
/// gamma/(rho dx^2) where 2 H are held, 4e-11 with 3 and nothing with 4.
///
/// An inlet that has a pressure p_in moves by the balance of forces on the plug of length l that it holds, and not faster than its velocity,
/// if it has one: dU/dt = (p_in - a)/(rho l), U >= 0. A particle is free from the evaluation on that finds it past an inlet's plane, and held from that
/// on which finds it past an outlet's. Lines are filled up from behind, and what comes to the end of an outlet is taken away, when neighbour lists are
/// rebuilt: both out of the scene's sight, so that when this happens decides nothing. What is packed further beyond a plane than is held there is taken away
/// at the start.
///
/// Counts what passes, by phases, and what is taken away at the start: what is free has grown by the one less the other, to round-off. Powder that migrates
/// between held and free particles counts too.
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

/// Of marked fluid that has left: how long after it came in.
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

/// What an opening is, what it has let pass, into the scene > 0, and its present state.
struct Flow
{
    std::string name;
    bool inlet = true;
    double area = 0;                    ///< [m^2], a length [m] in 2-D
    std::size_t held = 0;               ///< particles beyond the plane
    std::vector<double> mass;           ///< of each phase since the first start [kg]; per metre of depth in 2-D
    std::vector<double> amounts;        ///< of what is counted beside it (Evolving::amount) [m^3]
    std::vector<double> taken;          ///< away at the start, from further beyond the plane than is held there [kg]
    double flowRate = 0;                ///< [m^3/s], into the scene > 0
    std::optional<double> asked = {};   ///< of an inlet that has a rate or a velocity [m^3/s]
    std::vector<double> flowRates;      ///< of each phase
    double pressure = 0;                ///< of the fluid at the plane [Pa], without the background pressure
    std::optional<Transit> marked = {}; ///< of what has passed; none where nothing is marked
};

/// By which the mass of each phase and the amounts of what is free miss what has passed and was taken away, relative to the largest of what is there,
/// was there and has passed.
struct Imbalance
{
    std::vector<double> mass;
    std::vector<double> amounts;
};

template<int dim> class Openings
{
public:
    /// Throws CaseError where an opening does not fit the scene: inside a wall, narrower than the kernel's support, with a duct that is not
    /// straight, out of the domain as far as the held particles reach, where another one holds particles, or with its normal out of the scene.
    /// `restored` holds the numbers that `state` gave; `supports`: depth of what is held.
    Openings(const std::vector<Opening>&, const Geometry&, const Coefficients&, const State&, const std::map<std::string, double>& restored,
             int supports = 2);

    /// Before particles are sorted: takes away and adds what has come and gone, and returns how many there are now. `predicted`: between prediction
    /// and correction, where what passes is what a particle had at the start of the step.
    std::size_t exchange(FieldStore<dim>&, std::size_t owned, bool predicted = false);
    /// After they are sorted: finds those that are held, and those that are near.
    void locate(FieldStore<dim>&, std::size_t owned);
    /// Between two sortings, at new positions: what has passed a plane since is held, or free.
    void follow(FieldStore<dim>&, bool predicted);
    /// Indices of the particles that are held.
    std::span<const int> held() const { return held_; }
    /// After an evaluation: takes from held particles what would move or change them, and keeps what goes into them by a kick.
    void hold(FieldStore<dim>&);
    /// Once a step, after the kick: pressures and velocities of the held particles. `time` [s] at the end of the step.
    void drive(FieldStore<dim>&, double deltaT, double time = 0);
    /// A rate is about to act for `deltaT` [s]: held particles keep what they have, and what would go into them is counted.
    void holdRate(FieldStore<dim>&, const std::string& field, double deltaT);
    /// Names of the amounts that are counted.
    const std::vector<std::string>& amounts() const { return amountNames_; }

    std::vector<Flow> flows() const;
    Imbalance imbalance(const FieldStore<dim>&) const;
    /// Volume at rest density that has come in, less what has left [m^3].
    double volume() const;
    bool marks() const { return marks_; }
    /// Of what comes in upon the fluid [W]; never negative.
    double power() const;
    /// What a restart needs.
    std::map<std::string, double> state() const;

private:
    struct Gate
    {
        Opening opening;
        Opening plane; ///< which it is a part of; itself where it stands alone
        Section section;
        std::optional<double> asked;         ///< the rate of an inlet [m^3/s]; none where a pressure alone drives it
        double most, speed;                  ///< U of an inlet: its limit, and now
        std::vector<double> pressure, slope; ///< a and b, of each phase
        std::vector<double> taken;           ///< away at the start, of each phase
        std::vector<double> takenAmounts;
        double density = 0;                ///< at rest, of what comes in
        double inflow = 0;                 ///< of what is near, through all of the section [m^3/s]
        std::vector<double> inflows;       ///< of each phase
        std::vector<double> velocity = {}; ///< of each line [m/s]
        std::vector<int> near = {};        ///< free particles within H
    };
    /// Of a gate.
    struct Passed
    {
        std::vector<double> mass, amounts; ///< of each phase; of each fraction that is counted
        Transit marked = {};
        double held = 0; ///< particles that are there now
    };
    struct Account
    {
        std::vector<Passed> gates = {};
        std::vector<double> heldAmounts = {}; ///< what rates have brought into what is held [m^3]
    };
    /// Over what is free and near a plane, by `weight`.
    struct Sums
    {
        double n = 0, v0 = 0, s1 = 0, p0 = 0, s2 = 0, count = 0, p1 = 0; ///< of w, w v, w s, w p, w s^2, 1 and w s p
        Sums& operator+=(const Sums&);
    };
    /// The same of what is near along one line of an outlet, and over what is held on it.
    struct LineSums
    {
        double n = 0;      ///< of w; of several phases of w m
        double others = 0; ///< particles of phases that do not come back
        double held = 0, heldV = 0;
        double v0 = 0; ///< of w v, or w m v
        LineSums& operator+=(const LineSums&);
    };
    struct Fit
    {
        Sums of;
        double pressure, slope; ///< a and b
        bool enough;
    };
    std::vector<Gate> gates_;
    Account account_; ///< of this rank
    const Geometry& geometry_;
    const Coefficients& coefficients_;
    const State& state_;
    bool integrates_ = false;              ///< density evolves
    std::vector<const Evolving*> counted_; ///< fractions whose amounts are counted
    std::vector<std::string> amountNames_;
    std::size_t phases_;
    bool marks_ = false;                          ///< some of what comes in
    double depth_;                                ///< of the held particles beyond a plane [m]
    double time_ = 0;                             ///< [s]
    std::vector<int> close_, held_;               ///< close_: all that may come near or be held before the next sorting
    std::vector<double> startMass_;               ///< of what is free and what is taken away, at the first start [kg]
    std::vector<double> startAmounts_, intoHeld_; ///< [m^3], and by the rates at hand [m^3/s]
    bool restored_ = false, counts_ = false;      ///< counts_: who is held is known from before

    void check(const Opening&, const Section&) const;
    double densityOf(const Opening&, const Section&) const;
    void checkNormal(const Gate&) const;
    /// Of a free particle at a distance s from a plane: what comes into reach and leaves it does so gradually.
    double weight(double s) const { return std::max(0.0, s * (coefficients_.support - s)); }
    bool inDomain(const Vector<3>& x, double beyond) const;
    bool belongs(const Gate&, const Vector<3>& x) const;
    bool meet(const Gate& a, const Gate& b) const;
    int holderOf(const Vector<3>& x) const;
    int farBeyond(const Vector<3>& x) const;
    /// Who holds a particle at x_i from now on; counts what passes. Returns 1 + the opening, or 0.
    int assign(FieldStore<dim>&, double& holder, std::size_t i, const Vector<3>& x_i, bool predicted);
    /// Of `close_`: those that are held, and those that are near.
    void list(FieldStore<dim>&);
    void mark(FieldStore<dim>&, std::size_t i, const Opening&, Transit& marked, double sign);
    /// Of all ranks.
    Account account() const;
    static void eachShare(auto& account, const auto& visit);
    /// Each number of a restart: visit(name, value, whether 0 goes without saying).
    static void eachNumber(auto& self, auto& account, const auto& visit);
    std::string named(const std::string& name, std::size_t phase) const;
    /// Of particles, looked up once.
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
    /// Those without any of `others` too near, on any rank.
    std::vector<Place> clearOf(const std::vector<Vector<3>>& others, const std::vector<Place>&) const;
    void replace(FieldStore<dim>&, std::size_t i, const Gate&, const Vector<3>& x_i) const;
    void impose(FieldStore<dim>&, std::size_t i, const Vector<3>& x_i) const;
    Sums sumsOf(FieldStore<dim>&, const Gate&, const auto& counts) const;
    /// Of all gates and all ranks: `sumsOfGate()` of each, of all that is near and, of several phases, of each of them.
    std::vector<Sums> sumsNear(FieldStore<dim>&) const;
    std::size_t sumsOfGate() const { return phases_ > 1 ? 1 + phases_ : 1; }
    /// Of the lines of all outlets and of all ranks.
    std::vector<LineSums> sumsOfLines(FieldStore<dim>&) const;
    Fit fit(const Gate&, double a, const Sums&) const;
    void measure(Gate&, std::span<const Sums>) const;
    std::vector<double> velocities(const Gate&, std::span<const LineSums>) const;
    /// Of what is free.
    std::vector<double> freeMass(const FieldStore<dim>&) const;
    double freeAmount(const FieldStore<dim>&, const Evolving&) const;
    /// amount(i) of a particle, m fraction/rho_0 [m^3]; `predicted`: of the value at the start of the step, where that is kept.
    auto amounts(const FieldStore<dim>& store, const Evolving& fraction, bool predicted = false) const
    {
        const auto& name = predicted && store.has(fraction.startName()) ? fraction.startName() : fraction.value.name;
        return [q = store.component(name, 0), m = store.component(Mass::info.name, 0), phase = phasesOf(store),
                rho = coefficients_.restDensity.data()](std::size_t i) { return q[i] * m[i] / rho[phase(i)]; };
    }
};

}
