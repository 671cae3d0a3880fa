#include "Simulation.hpp"
#include "CaseError.hpp"
#include "EnergyBalance.hpp"
#include "ParticleSystem.hpp"
#include "TimeStepLimits.hpp"
#include "moves.hpp"
#include "summarise.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Of the speed along walls; packings of pipes have 0.12 at 9 across and 0.04 at 19 (tutorials/powderMoulding/circularPipe), a lattice jittered by
/// a tenth of a spacing 0.8.
constexpr double mostThroughWalls = 0.5;

/// Largest speed through the walls over the largest along them, of particles within a spacing of one. In a steady flow no fluid goes through walls;
/// where particles stay where they are, no pressure builds up that would see to it.
template<int dim> double shareThroughWalls(ParticleSystem<dim>& particles, const Geometry& geometry, const Settings& settings)
{
    const auto x = particles.store().pointers(Position{}), v = particles.store().pointers(Velocity{});
    double through = 0, along = 1e-9*settings.coefficients.soundSpeed[0]; // round-off of a fluid at rest
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
        Vector<dim> x_i, v_i;
        fetch(x_i, [&](int c) { return x[c][i]; });
        fetch(v_i, [&](int c) { return v[c][i]; });
        particles.images().forEachWallNear(x_i, [&](const Foot& foot, const Patch& patch)
        {
            if (foot.distance > settings.coefficients.spacing) return;
            const auto relative = in3D(v_i) - geometry.wallVelocity(patch.wall, in3D(x_i) - foot.distance*foot.normal);
            const double normal = dot(relative, foot.normal);
            through = std::max(through, std::fabs(normal));
            along = std::max(along, mag(relative - normal*foot.normal));
        });
    }
    return through/along;
}

template<int dim> class Simulation final : public AnySimulation
{
    const Settings& settings_;
    const Geometry& geometry_;
    ParticleSystem<dim> particles_;
    Summary summary_;
    double initialPowderVolume_ = 0;
    EnergyBalance<dim> energy_;

    void solveSteadyFlow()
    {
        particles_.solveSteadyFlow();
        if (const double share = shareThroughWalls(particles_, geometry_, settings_); share > mostThroughWalls)
            throw CaseError({"system/sphSchemes", 0},
                            fmt::format("scheme quasiSteady leaves particles where they are, and the flow beside the walls goes into them, "
                                        "with {:.2g} of its speed along them: it is driven by particles that lie unevenly, or by a force that "
                                        "only pressure could balance. Start from an even lattice, with a force along the walls, or take "
                                        "semiImplicit", share));
        particles_.evaluateMigration();
        summary_ = summarise(particles_, settings_);
    }
    Summary firstSummary()
    {
        if (settings_.suspension()) particles_.evaluateMigration();
        return summarise(particles_, settings_);
    }

public:
    Simulation(const Settings& settings, const Geometry& geometry, const Cloud& cloud, const StateNumbers& restored)
        : settings_(settings), geometry_(geometry), particles_(settings, geometry, cloud, restored), summary_(firstSummary()),
          energy_(particles_, settings_, geometry, summary_)
    {
        const auto volume = restored.find("powderVolume");
        initialPowderVolume_ = volume != restored.end() ? volume->second : summary_.powderVolume;
        if (settings_.integrator == Integrator::quasiSteady && restored.empty()) solveSteadyFlow();
    }

    /// The algorithm. Half a drift, the rates there, the whole kick, the other half of the drift:
    ///
    ///   predictorCorrector   rates at t predict v(t + dt/2): second order, two evaluations
    ///   leapfrog             the last rates predict v(t + dt/2): second order, one evaluation
    ///   symplecticEuler      v(t) stands for v(t + dt/2): first order in what depends on velocity, one evaluation, no memory
    ///   semiImplicit         the same, but viscosity acts with v(t + dt), solved for: no viscous limit of the step
    ///
    /// Of a step in several parts each is such a step, but surface tension acts once, by the whole step and at the middle of the middle
    /// part: the impulse method of Tuckerman, Berne & Martyna (1992), reversible in time where forces depend on positions.
    ///
    /// Powder migrates with the velocities at the end of the step and the positions of its middle. quasiSteady is for flows that change
    /// only as the powder migrates: particles stay where they are.
    void step(double time, double deltaT) override
    {
        if (settings_.integrator == Integrator::quasiSteady)
        {
            particles_.migrate(deltaT);
            particles_.evaluate();
            solveSteadyFlow();
            return;
        }
        const int parts = settings_.maxSubSteps > 1 ? partsOf(deltaT, settings_, stepLimits()) : 1;
        for (int part = 0; part < parts; ++part) stepOfPart(time + part*deltaT/parts, deltaT/parts, 2*part + 1 == parts ? deltaT : 0);
    }

    void stepOfPart(double time, double deltaT, double slowDeltaT)
    {
        const bool predicts = settings_.predicts(), slow = particles_.slowPlan() && slowDeltaT > 0;
        if (settings_.integrator == Integrator::predictorCorrector) particles_.evaluate();
        if (settings_.coefficients.transportVelocity > 0) transport(particles_, settings_, deltaT);
        drift(particles_, 0.5*deltaT);
        particles_.moved(0.5*deltaT*summary_.maxSpeed);
        if (predicts) predict(particles_, 0.5*deltaT);
        particles_.evaluate();
        if (slow) particles_.evaluateSlow();
        if (settings_.integrator == Integrator::semiImplicit) particles_.solveViscosity(deltaT);
        if (predicts) correct(particles_, deltaT);
        else kick(particles_, deltaT);
        if (slow) kickSlowly(particles_, slowDeltaT);
        particles_.drive(deltaT);
        if (settings_.suspension()) particles_.migrate(deltaT);
        if (time < settings_.dampedUntil) damp(particles_, std::exp(-settings_.dampingRate*deltaT));
        drift(particles_, 0.5*deltaT);
        if (settings_.shifting > 0) shift(particles_, settings_, summary_.maxSpeed, deltaT);
        particles_.images().ghostVelocity().filter();
        const double power = summary_.power;
        summary_ = summarise(particles_, settings_);
        energy_.addWork(0.5*(power + summary_.power)*deltaT);
        if (const auto* openings = particles_.openings()) energy_.addWork(openings->power()*deltaT);
        particles_.moved(0.5*deltaT*summary_.maxSpeed);
    }

    std::optional<SuspensionLimits> suspensionLimits() const
    {
        if (!settings_.suspension()) return {};
        return SuspensionLimits{summary_.minViscosity, summary_.maxViscosity, particles_.migration()->limit()};
    }
    StepLimit stepLimit() const override
    {
        return sph::stepLimit(settings_, summary_.maxSpeed, summary_.maxAcceleration, summary_.maxSlowAcceleration, suspensionLimits());
    }
    std::vector<StepLimit> stepLimits() const override
    {
        return sph::stepLimits(settings_, summary_.maxSpeed, summary_.maxAcceleration, summary_.maxSlowAcceleration, suspensionLimits());
    }
    Summary summary() const override { return summary_; }
    Energy energy() const override { return energy_.at(particles_, summary_); }

    void settle() override
    {
        particles_.rebuild();
        particles_.evaluate();
        particles_.evaluateSlow();
        if (settings_.suspension()) particles_.evaluateMigration();
        summary_ = summarise(particles_, settings_);
    }

    std::size_t size() const override { return particles_.size(); }
    FieldView positions() const override { return field(Position::info.name); }

    FieldView field(const std::string& name) const override
    {
        FieldView view{name, name == "phase" ? FieldClass::label : FieldClass::scalar, {}};
        const auto& fields = particles_.store().fields();
        const auto found = fields.find(name);
        if (found == fields.end()) return {name, view.type, {nullptr}};
        for (const auto& a : found->second.component) view.component.push_back(a.data());
        if (view.component.size() == dim)
        {
            view.type = FieldClass::vector;
            view.component.resize(3, nullptr);
        }
        if (dim == 2 && view.component.size() == 3 && view.type != FieldClass::vector)
            view = {name, FieldClass::symmTensor, {view.component[0], view.component[1], nullptr, view.component[2], nullptr, nullptr}};
        if (view.component.size() == 6) view.type = FieldClass::symmTensor;
        return view;
    }

    std::vector<FieldView> fields() const override
    {
        std::vector<std::string> names{"U", "rho", "p", "phase", "m"};
        if (particles_.store().has(WallAcceleration{})) names.push_back(WallAcceleration::info.name);
        if (particles_.store().has(TransportVelocity{})) names.push_back(TransportVelocity::info.name);
        std::vector<FieldView> views;
        for (const auto& name : names) views.push_back(field(name));
        if (settings_.suspension())
        {
            for (const char* name : {PowderFraction::info.name, ShearRate::info.name}) views.push_back(field(name));
            views.push_back(field(DynamicViscosity::info.name));
            views.back().name = "eta"; // as suspensions are written of
        }
        return views;
    }

    StateNumbers state() const override
    {
        StateNumbers numbers;
        if (settings_.normaliseDensity) numbers["densityScale"] = particles_.densityScale();
        if (settings_.suspension()) numbers["powderVolume"] = initialPowderVolume_;
        if (const auto* openings = particles_.openings()) numbers.merge(openings->state());
        return numbers;
    }

    void printPlan(std::ostream& out) const override
    {
        particles_.plan().print(out, particles_.store(), particles_.slowPlan(), "once in a step of several parts");
        if (!particles_.migration()) return;
        out << "Plan of the powder's migration:\n";
        particles_.migration()->printPasses(out);
    }
    std::vector<Flow> flows() const override { return particles_.openings() ? particles_.openings()->flows() : std::vector<Flow>{}; }
    Imbalance imbalance() const override { return particles_.openings() ? particles_.openings()->imbalance(particles_.store()) : Imbalance{}; }
    int migrationSteps() const override { return particles_.migration() ? particles_.migration()->steps() : 0; }
    double powderDrift() const override { return initialPowderVolume_ > 0 ? summary_.powderVolume/initialPowderVolume_ - 1 : 0; }
    int solverIterations() const override { return particles_.implicitViscosity() ? particles_.implicitViscosity()->iterations() : 0; }
    int pairPasses() const override { return particles_.plan().pairPasses(); }
    double meanNeighbours() const override { return double(particles_.lists().pairs())/double(std::max<std::size_t>(1, size())) - 1; }
    std::size_t images() const override { return particles_.images().count(); }
    long rebuilds() const override { return particles_.rebuilds(); }
    Leaks leaks() const override { return particles_.leaks(); }
    double bytesPerParticle() const override
    {
        return double(particles_.store().bytes() + particles_.images().bytes() + particles_.plan().bytes() +
                      (particles_.slowPlan() ? particles_.slowPlan()->bytes() : 0) +
                      (particles_.implicitViscosity() ? particles_.implicitViscosity()->bytes() : 0) +
                      (particles_.migration() ? particles_.migration()->bytes() : 0))/double(std::max<std::size_t>(1, size()));
    }
};

}

std::unique_ptr<AnySimulation> makeSimulation(const Settings& settings, const Geometry& geometry, const Cloud& cloud, const StateNumbers& restored)
{
    if (cloud.size() == 0 && settings.openings.empty()) throw CaseError("there are no particles: has packParticles been run?");
    if (geometry.dimension == 2) return std::make_unique<Simulation<2>>(settings, geometry, cloud, restored);
    return std::make_unique<Simulation<3>>(settings, geometry, cloud, restored);
}

}
