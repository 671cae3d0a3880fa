/// The particles of a case and the step that moves them.
#pragma once
#include "case/Cloud.hpp"
#include "case/RunTime.hpp"
#include "scene/LeakGuard.hpp"
#include "scene/Settings.hpp"
#include "solver/readSettings.hpp"
#include <algorithm>
#include <iosfwd>
#include <map>
#include <memory>

namespace sph
{

/// Summary of a state, which the log prints and which tells whether the state is still physical. Sums are over owned particles in a fixed order.
struct Summary
{
    double maxSpeed = 0, maxAcceleration = 0,
           maxSlowAcceleration = 0; ///< of all particles, those that openings hold among them: they limit the step
    double kineticEnergy = 0;
    double power = 0;                                             ///< of gravity and body force [W]
    Vector<3> momentum, force;                                    ///< [kg m/s]; of gravity and body force [N]
    std::vector<double> mass, minDensity, maxDensity, maxSpeedOf; ///< of each phase
    std::vector<std::size_t> count;
    /// Buffer particles, which openings hold beyond their planes; all else is of the scene alone.
    struct Held
    {
        std::vector<double> mass, minDensity, maxDensity; ///< of each phase
        std::vector<std::size_t> count;
    } held;
    Numbers columns; ///< of the models, by name
    bool finite = true;

    /// Number of particles of a phase, buffer particles among them.
    std::size_t allOf(std::size_t phase) const { return count[phase] + held.count[phase]; }
    double maxSpeedOfScene() const { return maxSpeedOf.empty() ? 0 : *std::ranges::max_element(maxSpeedOf); }
};

/// The energy that the fluid holds and that it was given (EnergyBalance.hpp); per metre of depth in 2-D.
struct Energy
{
    double kinetic = 0;               ///< [J]
    std::vector<StoredEnergy> stored; ///< of models
    double supplied = 0;              ///< the most that the scene can have given since the start [J]
    double measuredWork = 0;          ///< since the start, of gravity, of the body force and of models [J]
    Vector<3> impulse;                ///< since the start, of gravity and body force [kg m/s]

    double held() const
    {
        double sum = kinetic;
        for (const auto& of : stored)
            if (of.isHeld) sum += of.value;
        return sum;
    }
    double allStored() const
    {
        double sum = 0;
        for (const auto& of : stored) sum += of.value;
        return sum;
    }
};

/// A simulation as an application sees it, whatever its dimension.
class AnySimulation
{
public:
    virtual ~AnySimulation() = default;

    /// Takes a step of `deltaT` [s] from `time` [s] with the scheme of the settings. Throws CaseError where a particle has left the scene.
    virtual void step(double time, double deltaT) = 0;
    virtual StepLimit stepLimit() const = 0;
    /// All limits that apply to the step, of which the least binds.
    virtual std::vector<StepLimit> stepLimits() const = 0;
    virtual Summary summary() const = 0;
    /// Gravity that acts at present [m/s^2]: `shaking` of constant/g included.
    virtual Vector<3> gravity() const = 0;
    /// Energy of the present state, by a look at all pairs across interfaces.
    virtual Energy energy() const = 0;

    /// Power of each operation that accelerates, by name [W]; leaves no trace in the run.
    virtual std::map<std::string, double> powers() = 0;

    /// Evaluates all fields at the present state, for whoever looks at them; leaves no trace in the run.
    virtual void observe() = 0;
    /// Observes after the particles have been sorted and lists rebuilt: before writing.
    virtual void settle() = 0;
    virtual std::size_t total() const = 0; ///< particles of all ranks
    /// Number of particles of this rank; positions and fields are this rank's too, and WholeCloud.hpp has those of all.
    virtual std::size_t size() const = 0;
    virtual FieldView positions() const = 0;
    /// Fields of the time folder: U rho p phase, m where it is not one value, and what the models show or need for a restart.
    virtual std::vector<FieldView> fields() const = 0;
    virtual FieldView field(const std::string& name) const = 0;
    virtual StateNumbers state() const = 0;

    /// Stages of a step with the passes and operations that they run, numbered through; fields; what was left out.
    virtual void printPlan(std::ostream&) const = 0;
    /// Counts how often each stage, and each operation as "group/term", has run since the counting began.
    virtual void count() = 0;
    virtual std::map<std::string, long> counts() const = 0;
    /// Counts since the start how often each stage of a model has run that joins an evaluation, a sorting or an observation.
    virtual const std::map<std::string, long>& countsWithin() const = 0;
    /// Texts of the models: at the start; at a report; on the line of the step.
    virtual std::string introduction() const = 0;
    virtual std::string report() const = 0;
    virtual std::string note() const = 0;
    /// Warnings of the models about the present, settled state: each once.
    virtual std::vector<std::string> warnings() = 0;
    /// Number of pair passes since the start: of all evaluations, of what acts once a step, and of solvers.
    virtual long pairPassesRun() const = 0;
    virtual double meanNeighbours() const = 0;
    virtual std::size_t images() const = 0;
    /// Load of each rank, a line each, and how evenly it is shared; "" with one process alone.
    virtual std::string reportRanks() const = 0;
    virtual long rebuilds() const = 0;
    /// Particles put back out of the solid, or removed, since the start of the run, by all ranks.
    virtual Leaks leaks() const = 0;
    /// Bytes of all arrays but the neighbour lists, per owned particle.
    virtual double bytesPerParticle() const = 0;
};

/// Geometry and settings must outlive the simulation. Throws CaseError where the particles do not fit the scene: none at all, beyond a
/// wall, outside the domain, on top of one another, of an unknown phase.
std::unique_ptr<AnySimulation> makeSimulation(const Settings&, const Geometry&, Cloud, const StateNumbers& restored);

}
