/// A run from the dictionaries of a case to its last time folder, and its log.
#pragma once
#include "base/Clock.hpp"
#include "case/Case.hpp"
#include "case/RunTime.hpp"
#include "geometry/Geometry.hpp"
#include "sampling/FunctionObject.hpp"
#include "solver/Simulation.hpp"
#include "solver/WholeCloud.hpp"
#include "solver/readSettings.hpp"
#include <filesystem>
#include <iosfwd>
#include <map>
#include <memory>
#include <vector>

namespace sph
{

class Run
{
public:
    /// Reads everything; throws CaseError with all mistakes of the case at once. A parallel run of a decomposed case is one of its processor folders.
    Run(const std::filesystem::path& caseFolder, std::ostream& log, bool parallel);

    /// Prints the plan and, by the steps of some seconds in memory, how long the run would take. Writes nothing.
    void dryRun();
    /// Until controlDict's stopAt, or a signal (TERM, INT, HUP), which writes the present time and ends. Returns the exit code: 0, or 128 and the number of the signal.
    int solve();

private:
    Case case_;
    RunTime::Place place_;
    std::ostream& log_;
    Clock clock_;
    RunTime time_;
    Geometry geometry_;
    Settings settings_;
    std::unique_ptr<FunctionObjects> functions_;
    std::unique_ptr<AnySimulation> simulation_;
    std::vector<bool> warned_; ///< of each phase's compression
    Energy energy_;            ///< when last looked at
    bool warnedOfEnergy_ = false, warnedOfStep_ = false;
    std::map<std::string, double> work_; ///< of each operation since `tracedFrom_` [J]
    std::string tracedFrom_;
    int tracedSteps_ = 0;
    double deepestLeak_ = 0; ///< [m]
    std::string deepestLeakAt_;

    static Geometry loadGeometry(const Case&);
    /// Of particles that ranks share, an even part: they go to their owners when the lists are first made.
    Cloud readCloud() const;
    void warnOfFewParticles() const;
    void reportPlan() const;
    /// A step, looked at; returns its length [s].
    double advance(const StepLimit&);
    /// A line with the particle that the next step waits for, where one sets the limit. All ranks have to ask.
    std::string binding() const;
    void reportStep(const StepLimit&, double deltaT) const;
    /// Throws DivergedError where the state is none of a weakly compressible fluid.
    void check(const StepLimit&) const;
    /// The same of each particle and of all that is written, naming it: at every time folder, and where the whole is suspect.
    void checkParticles(const StepLimit&) const;
    [[noreturn]] void notFinite(const std::string& what, const StepLimit&) const;
    [[noreturn]] void notWeaklyCompressible(std::size_t phase, double density, const std::string& where) const;
    /// Throws DivergedError where the step has collapsed; warns once where a fixed one is beyond the limit.
    double nextDeltaT(const StepLimit&);
    /// Warns of a speed or a density beyond weak compressibility, once for each phase.
    void warnOfCompression();
    /// Warns once of more energy than the scene can have supplied; throws DivergedError where it is far more.
    void checkEnergy();
    /// Adds up, for some steps after that warning, the work of each operation, and then says which feeds the run.
    void traceEnergy(double deltaT);
    /// Which operation has done the most work since then, and what the others have.
    std::string sourceOfEnergy() const;
    void noteLeaks();
    std::string leaked() const;
    void reportLeaks() const;
    bool isDecomposed() const { return !place_.folder.empty(); }
    /// All ranks into the case together or, of a decomposed one, each into its folder.
    void write();
    void sample(bool writeTime, bool end);
    /// View of the particles of all ranks, on the first.
    ParticleView view(WholeCloud&) const;
};

}
