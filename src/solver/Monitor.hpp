/// Watches a run: warns of what will spoil it, once each, and throws DivergedError where its state is none of a weakly compressible fluid, with the place and what to do.
#pragma once
#include "case/RunTime.hpp"
#include "solver/Simulation.hpp"
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace sph
{

class Monitor
{
public:
    /// All must outlive the monitor.
    Monitor(const Settings&, const Geometry&, AnySimulation&, const RunTime&, std::ostream& log);

    /// Throws where a step that may adjust itself has collapsed.
    void refuseCollapsed(const StepLimit&) const;
    /// Warns of a fixed step beyond the limit.
    void checkFixedStep(const StepLimit&, double deltaT);
    /// Looks at the sums and extremes of a state, and at single particles where these are suspect.
    void check(const StepLimit&);
    /// Looks at each particle and all that is written; throws with the particle's name.
    void checkParticles(const StepLimit&) const;
    /// Warns of more energy than the scene can have supplied; throws where it is far more. Creeping flow has no inertia, so no energy of motion to keep an account of.
    void checkEnergy();
    /// The same every so many steps, for it takes a loop over pairs.
    void checkEnergySometimes();
    /// Adds up, for some steps after that warning, the work of each operation, and then says which feeds the run.
    void traceEnergy(double deltaT);
    void noteLeaks();

    /// Energy held when last looked at, as a column of a step's report.
    std::string energyInWords() const;
    /// A line with the particle that the next step waits for, where one sets the limit. All ranks have to ask.
    std::string binding() const;
    /// A line on particles that were found in solids; empty where there are none and `always` is not asked for.
    std::string leaked(bool always) const;
    /// Where the deepest of them was.
    std::string deepestLeak() const;

private:
    const Settings& settings_;
    const Geometry& geometry_;
    AnySimulation& simulation_;
    const RunTime& time_;
    std::ostream& log_;
    std::vector<bool> warned_; ///< of each phase's compression
    Energy energy_;            ///< when last looked at
    bool warnedOfEnergy_ = false, warnedOfStep_ = false;
    std::map<std::string, double> work_; ///< of each operation since `tracedFrom_` [J]
    std::string tracedFrom_;
    int tracedSteps_ = 0;
    double deepestLeak_ = 0; ///< [m]
    std::string deepestLeakAt_;

    void warn(const std::string& what);
    [[noreturn]] void notFinite(const std::string& what, const StepLimit&) const;
    [[noreturn]] void notWeaklyCompressible(std::size_t phase, double density, const std::string& where) const;
    void warnOfCompression();
    /// Which operation has done the most work since then, and what the others have.
    std::string sourceOfEnergy() const;
};

}
