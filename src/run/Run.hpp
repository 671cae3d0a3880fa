/// A run from the dictionaries of a case to its last time folder, and its log.
#pragma once
#include "base/Clock.hpp"
#include "case/Case.hpp"
#include "case/RunTime.hpp"
#include "geometry/Geometry.hpp"
#include "sampling/FunctionObject.hpp"
#include "solver/Monitor.hpp"
#include "solver/WholeCloud.hpp"
#include "solver/readSettings.hpp"
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>

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
    std::optional<Monitor> monitor_;

    static Geometry loadGeometry(const Case&);
    /// Of particles that ranks share, an even part: they go to their owners when the lists are first made.
    Cloud readCloud() const;
    void warnOfFewParticles() const;
    /// A step, looked at; returns its length [s].
    double advance(const StepLimit&);
    bool isDecomposed() const { return !place_.folder.empty(); }
    /// All ranks into the case together or, of a decomposed one, each into its folder.
    void write();
    void sample(bool writeTime, bool end);
    /// View of the particles of all ranks, on the first.
    ParticleView view(WholeCloud&) const;
};

}
