/// Time of a run as controlDict states it: where it starts and stops, when it writes, and how a time folder comes to be.
#pragma once
#include "base/Clock.hpp"
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "case/TimeControls.hpp"
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace sph
{

/// Numbers that a restart needs besides the fields, kept in `<time>/uniform/time` (value, name, index, deltaT) and
/// `<time>/uniform/sphState` (whatever the solver adds, in shortest round-trip form).
using StateNumbers = std::map<std::string, double>;

/// Histories of function objects, which later rows need, kept in `<time>/uniform/functionObjects` where there are any.
using Histories = std::map<std::string, std::vector<double>>;

class RunTime
{
public:
    /// Folder of this process for its time folders: below `folder` of the case, those of `times` alone (sorted) where some are named.
    struct Place
    {
        std::string folder; ///< "processor3"; empty: the case itself
        std::vector<std::string> times = {};
    };
    /// Reads system/controlDict, `functions` left to others. Mistakes go to the case's Diagnostics.
    explicit RunTime(const Case& c) : RunTime(c, {}) {}
    RunTime(const Case&, Place);
    /// Entries of system/controlDict, function objects apart.
    static EntryList entries();

    double value() const { return value_; }
    /// The name of the present time, by timeFormat and timePrecision and with as many digits more as it needs: that of a time folder reads
    /// back as the time within 1e-10 of the step, or its round-off; the others, which a log has, differ from the step before.
    std::string name() const;
    /// Name of the folder that the run starts from; "0.orig" is copied to "0" first where there is no "0".
    const std::string& startName() const { return startName_; }
    /// Path of the start folder in the case.
    std::string startFolder() const { return inPlace(startName_); }
    double startTime() const { return startTime_; }
    /// Infinite where stopAt is not endTime.
    double endTime() const { return controls_.end(); }
    long index() const { return index_; }
    /// The last step taken; before the first, the one that led to the start folder, or deltaT of controlDict.
    double deltaT() const { return deltaT_; }
    bool adjustTimeStep() const { return controls_.adjustTimeStep; }
    double maxDeltaT() const { return controls_.maxDeltaT; }

    /// False once stopAt is satisfied.
    bool running() const;
    /// The step to take: `limit` from stability, shortened (or stretched by at most a tenth) so that write times and the end are hit
    /// exactly where writeControl is adjustable/adjustableRunTime. deltaT of controlDict where adjustTimeStep is off; where it is on, deltaT limits the very first step.
    ///
    /// A restarted run takes the same steps as one that was not stopped, to the last bit, provided that `limit` is the same: the
    /// answer depends on the exact time, `limit` and controlDict alone (see TimeControls).
    double nextDeltaT(double limit) const;
    void advance(double deltaT);
    /// The step just taken is the last and is to be written, as by stopAt writeNow: for signals.
    void stopNow();
    /// True at the times that writeControl asks for, and at the end.
    bool writeTime() const;

    /// Writes into `<name>.partial/` beside the final name and renames when `fill` has returned, then purges. `fill` gets the folder
    /// to write into. A failure (full disk) leaves no folder of that name and the last good one whole, and throws CaseError.
    /// Ranks write it together; numbers and histories are those of the first.
    void write(const std::function<void(const std::filesystem::path& folder)>& fill, const StateNumbers&, const Histories& = {});
    WriteOptions writeOptions() const { return controls_.writeOptions; }

    /// The numbers stored with the folder that the run started from; empty at a fresh start.
    const StateNumbers& restored() const { return restored_; }
    const Histories& restoredHistories() const { return histories_; }

    /// Looks at controlDict again (runTimeModifiable; by size and modification time) and says in words what changed, or "".
    /// A file with mistakes changes nothing, and the words say so.
    std::string rereadIfModified();
    /// The look alone, for ranks that must agree on when to read.
    bool controlDictModified() const;

    /// The dictionary, for further entries of controlDict, and for `reportUnused` when all that are known have been read.
    const Dictionary& controlDict() const { return control_; }

    /// Wall and processor time since the start [s], which clockTime, cpuTime and maxClockTime refer to. Ranks of a parallel run
    /// give those of the master, so that all stop and write together.
    struct Clocks
    {
        std::function<double()> wall, processor;
    };
    void useClocks(Clocks);

    /// Sets a barrier for several processes that write a time folder each: it waits for the others, once this one's is whole and once more when it has its name.
    /// Then either all or none of them are there when a run is killed, but for the moment of renaming.
    void useBarrier(std::function<void()> barrier) { barrier_ = std::move(barrier); }

    /// `postProcessing/<function>/<startTime>/<file>`: the stream's path; an existing file of an earlier run from the same start is
    /// kept and `<stem>_<startTime><ext>` is taken instead, as OpenFOAM does.
    std::filesystem::path outputFile(const std::string& function, const std::string& file) const;

private:
    /// Size and modification time to the nanosecond, compared exactly: an edit within a second of the last one is seen.
    struct FileStamp
    {
        long long size = -1, seconds = 0, nanoseconds = 0;
        friend bool operator==(const FileStamp&, const FileStamp&) = default;
    };
    FileStamp stamp() const;
    void findStart(const Case&);
    void restore(const Case&);
    void startAt(const std::string& name, double value);
    std::string nameWithDigitsUntil(const std::function<bool(const std::string& candidate, int precision)>& enough) const;
    std::string folderName() const;
    std::string stepName() const;
    double clock() const;
    bool writesByClock();
    void purge();

    std::string inPlace(const std::string& file) const { return place_.folder.empty() ? file : place_.folder + "/" + file; }
    std::filesystem::path timesFolder() const { return caseFolder_ / place_.folder; }

    std::filesystem::path caseFolder_;
    Place place_;
    Dictionary control_;
    FileStamp stamp_;
    TimeControls controls_;
    Clocks clocks_;
    std::function<void()> barrier_ = [] {};
    std::string startName_ = "0";
    double startTime_ = 0, value_ = 0, deltaT_ = 0;
    long index_ = 0, startIndex_ = 0;
    bool scheduled_ = false, stopped_ = false;
    double clockIndex_ = 0;
    /// Exact times by the names of their folders: that of the start and those written since.
    std::map<std::string, double> named_;
    /// Time folders that purgeWrite counts, oldest first.
    std::vector<std::string> written_;
    StateNumbers restored_;
    Histories histories_;
};

}
