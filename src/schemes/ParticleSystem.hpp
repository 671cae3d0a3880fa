/// The particles with their images, lists and plan: everything that an integrator moves, and nothing of time.
#pragma once
#include "Images.hpp"
#include "ImplicitViscosity.hpp"
#include "LeakGuard.hpp"
#include "Migration.hpp"
#include "Openings.hpp"
#include "Plan.hpp"
#include "Settings.hpp"
#include "Simulation.hpp"
#include "WallAdhesion.hpp"
#include "WallPotential.hpp"
#include "WallTension.hpp"
#include <optional>

namespace sph
{

template<int dim> class ParticleSystem
{
public:
    ParticleSystem(const Settings&, const Geometry&, const Cloud&, const StateNumbers& restored);

    /// Rates and derived fields at the present positions and velocities. A pure function of the state.
    void evaluate();
    /// After an evaluation, at the same state: the accelerations of what acts once in a step of several parts.
    void evaluateSlow();
    /// After an evaluation: makes of dU/dt one that has viscosity act at the end of a step of `deltaT` [s] (integrator semiImplicit).
    void solveViscosity(double deltaT) { implicit_->solve(store_, images_, lists_, kernel_, deltaT, held()); }
    /// The same, with U that of creeping flow (integrator quasiSteady).
    void solveSteadyFlow() { implicit_->solveSteady(store_, images_, lists_, kernel_); }
    /// Of a suspension, after an evaluation: viscosity, shear rate and the rate of phi; phi after `deltaT` [s].
    void evaluateMigration() { migration_->evaluate(store_, images_, lists_, kernel_); }
    void migrate(double deltaT);
    /// After the kick of a step: pressures and velocities of what openings hold.
    void drive(double deltaT)
    {
        if (openings_) openings_->drive(store_, deltaT);
    }
    /// Wraps, sorts, makes images and lists anew.
    void rebuild();
    /// Tells how far any particle may have moved since; lists are rebuilt when that may matter.
    void moved(double distance) { travelled_ += distance*images_.closingSpeed(); }

    std::size_t size() const { return owned_; }
    FieldStore<dim>& store() { return store_; }
    const FieldStore<dim>& store() const { return store_; }
    Images<dim>& images() { return images_; }
    const Images<dim>& images() const { return images_; }
    const Plan<dim>& plan() const { return plan_; }
    const Plan<dim>* slowPlan() const { return slow_ ? &*slow_ : nullptr; }
    const ImplicitViscosity<dim>* implicitViscosity() const { return implicit_ ? &*implicit_ : nullptr; }
    const Migration<dim>* migration() const { return migration_ ? &*migration_ : nullptr; }
    const Openings<dim>* openings() const { return openings_ ? &*openings_ : nullptr; }
    const NeighbourLists<dim>& lists() const { return lists_; }
    double densityScale() const { return coefficients_.densityScale; }
    long rebuilds() const { return rebuilds_; }
    const Leaks& leaks() const { return leakGuard_.leaks(); }

private:
    const Settings& settings_;
    const Geometry& geometry_;
    Coefficients coefficients_;
    Catalogue<dim> catalogue_;
    Plan<dim> plan_;
    FieldStore<dim> store_;
    Images<dim> images_;
    LeakGuard<dim> leakGuard_;
    NeighbourLists<dim> lists_;
    CellList<dim> cells_;
    Kernel<dim> kernel_;
    std::optional<Plan<dim>> slow_;
    std::optional<ImplicitViscosity<dim>> implicit_;
    std::optional<Migration<dim>> migration_;
    std::optional<Openings<dim>> openings_;
    std::optional<WallTension<dim>> wallTension_;
    std::optional<WallPotential<dim>> wallPotential_;
    std::optional<WallAdhesion<dim>> wallAdhesion_;
    std::size_t owned_ = 0;
    double skin_, travelled_ = 0;
    long rebuilds_ = 0;

    void load(const Cloud&, bool restarted);
    std::span<const int> held() const { return openings_ ? openings_->held() : std::span<const int>{}; }
    /// What the terms of surface tension read of the walls.
    void evaluateWalls();
    void checkApart() const;
    Vector<dim> position(std::size_t i) const;
    void normaliseDensity();
    void bindPlans();
    bool plans(const std::string& term) const { return plan_.has(term) || (slow_ && slow_->has(term)); }
    /// Does `f` while the slow accelerations, where there are any, stand in the place of all.
    template<class F> void inPlaceOfAll(const F& f)
    {
        if (slow_) store_.exchange(Acceleration{}, SlowAcceleration{});
        f();
        if (slow_) store_.exchange(Acceleration{}, SlowAcceleration{});
    }
};

}
