/// Time of a run as controlDict states it: where it starts and stops, when it writes, and how a time folder comes to be.
#pragma once
#include "Case.hpp"
#include "Cloud.hpp"
#include <functional>
#include <map>
#include <string>

namespace sph
{

/// Numbers that a restart needs besides the fields, kept in `<time>/uniform/time` (value, name, index, deltaT) and
/// `<time>/uniform/sphState` (whatever the solver adds, in shortest round-trip form).
using StateNumbers = std::map<std::string, double>;

class RunTime
{
public:
    /// Reads system/controlDict: application startFrom startTime stopAt endTime deltaT adjustTimeStep maxDeltaT writeControl
    /// writeInterval purgeWrite writeFormat writePrecision timeFormat timePrecision runTimeModifiable maxClockTime functions (ignored
    /// here). Mistakes go to the case's Diagnostics.
    explicit RunTime(const Case&);

    double value() const { return value_; }
    /// The name of the current time folder, by timeFormat and timePrecision; digits are added where two times would collide.
    std::string name() const;
    /// Name of the folder that the run starts from; "0.orig" is copied to "0" first where there is no "0".
    const std::string& startName() const { return startName_; }
    double startTime() const { return startTime_; }
    double endTime() const { return endTime_; }
    long index() const { return index_; }
    double deltaT() const { return deltaT_; }
    bool adjustTimeStep() const { return adjustTimeStep_; }
    double maxDeltaT() const { return maxDeltaT_; }

    /// False once stopAt is satisfied.
    bool running() const;
    /// The step to take: `limit` from stability, shortened (or stretched by at most a tenth) so that write times and the end are hit
    /// exactly where writeControl is adjustable/adjustableRunTime.
    double nextDeltaT(double limit) const;
    void advance(double deltaT);
    /// True at the times that writeControl asks for, and at the end.
    bool writeTime() const;

    /// Writes into `<name>.partial/` beside the final name and renames when `fill` has returned, then purges. `fill` gets the folder
    /// to write into. A failure (full disk) leaves no folder of that name and the last good one whole, and throws CaseError.
    void write(const std::function<void(const std::filesystem::path& folder)>& fill, const StateNumbers&);
    WriteOptions writeOptions() const { return options_; }

    /// The numbers stored with the folder that the run started from; empty at a fresh start.
    const StateNumbers& restored() const { return restored_; }

    /// Looks at controlDict again (runTimeModifiable; by size and modification time) and says in words what changed, or "".
    std::string rereadIfModified();

    /// `postProcessing/<function>/<startTime>/<file>`: the stream's path; an existing file of an earlier run from the same start is
    /// kept and `<stem>_<startTime><ext>` is taken instead, as OpenFOAM does.
    std::filesystem::path outputFile(const std::string& function, const std::string& file) const;

private:
    void read(const Dictionary&);

    std::filesystem::path caseFolder_;
    Dictionary control_;
    std::string startName_;
    double startTime_ = 0, endTime_ = 0, value_ = 0, deltaT_ = 0, maxDeltaT_ = 0;
    long index_ = 0, startIndex_ = 0;
    bool adjustTimeStep_ = true;
    WriteOptions options_;
    StateNumbers restored_;
    // further members as the implementation needs them
};

}
