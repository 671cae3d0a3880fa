/// The entries of system/controlDict that may change while a run goes on, and what they make of a time and a step.
///
/// Every function is pure: what it answers depends on controlDict and on its arguments alone, and these are the numbers that
/// `<time>/uniform/time` keeps exactly (value, index, deltaT). That is why a restarted run takes the steps and writes the times of
/// one that was never stopped, to the last bit: nothing is accumulated that a restart could lose. Write times are k writeInterval
/// with k counted from time 0, not from the start of a run.
#pragma once
#include "case/Cloud.hpp"
#include "case/TimeName.hpp"
#include "dictionary/EntryList.hpp"
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace sph
{

enum class StopAt
{
    endTime,
    writeNow,
    noWriteNow,
    nextWrite
};
enum class WriteControl
{
    none,
    timeStep,
    runTime,
    adjustable,
    clockTime,
    cpuTime
};

struct TimeControls
{
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    StopAt stopAt = StopAt::endTime;
    double endTime = infinity;
    double deltaT = 0;
    bool adjustTimeStep = true;
    double maxDeltaT = infinity;
    WriteControl writeControl = WriteControl::none;
    double writeInterval = infinity;
    int purgeWrite = 0;
    WriteOptions writeOptions;
    TimeFormat timeFormat = TimeFormat::general;
    int timePrecision = 6;
    bool runTimeModifiable = true;
    double maxClockTime = infinity;

    /// Mistakes go to the dictionary's Diagnostics.
    static TimeControls read(const Dictionary& controlDict);
    static EntryList entries();

    /// Keyword and value of each, as words: two of these compared tell what has changed.
    std::vector<std::pair<std::string, std::string>> inWords() const;

    /// Steps are fitted to the write times.
    bool fitsSteps() const { return adjustTimeStep && writeControl == WriteControl::adjustable; }

    /// k of the last write time k writeInterval that is not later than t, give or take round-off.
    double writeIndex(double t) const;
    /// The end of the run; where steps are fitted, the write time that differs from it by round-off alone (3*0.1 for 0.3), so that
    /// a run that ends there holds the time that one going further passes through.
    double end() const;
    /// Time that a fitted step may not pass: the next write time after t or the end. Infinite where steps are not fitted.
    double nextTarget(double t) const;
    /// The step from t under the stability limit; see RunTime::nextDeltaT.
    double step(double t, double limit) const;
    /// t + dt, without the round-off that would accumulate: exactly the target that a fitted step reaches, exactly n deltaT for
    /// steps of fixed length.
    double advanced(double t, double dt) const;
    /// False once t has reached the end. A fixed step ends the run within half a step, as in OpenFOAM.
    bool before(double t) const;
};

}
