/// Function objects of controlDict's `functions` sub-dictionary: they look at the run and write below postProcessing/.
#pragma once
#include "base/Column.hpp"
#include "case/RunTime.hpp"
#include "dictionary/EntryList.hpp"
#include "sampling/OutputPlace.hpp"
#include "sampling/ParticleView.hpp"
#include <memory>
#include <string>
#include <vector>

namespace sph
{

class FunctionObject
{
public:
    virtual ~FunctionObject() = default;
    /// Called at the times that the object's executeControl/executeInterval (default: every write time) ask for.
    virtual void execute(const ParticleView&) = 0;
    /// One or more lines for the solver's log, "" where there is nothing to say.
    virtual std::string report() const { return ""; }
    /// History that later rows depend on beside the particles: a restarted run begins with it.
    virtual Histories histories() const { return {}; }
    virtual void restore(const Histories&) {}
};

/// Entries of each function object: the sub-dictionaries of controlDict's `functions`.
EntryList functionEntries();
/// What each type writes below postProcessing, and its columns behind `Time`.
std::vector<TableInfo> functionTables();

/// All function objects of a case; reads `functions`, records every mistake in its Diagnostics. Geometry and run time must
/// outlive it.
///
///     functions
///     {
///         energies { type conservation;  executeControl timeStep;  executeInterval 10; }
///     }
///
/// executeControl: writeTime (the default; each executeInterval-th one), timeStep (each executeInterval-th step), runTime
/// (multiples of executeInterval [s]), onEnd.
class FunctionObjects
{
    struct Entry
    {
        std::string name;
        std::unique_ptr<FunctionObject> object;
        double interval; ///< in time [s] or steps, by `control`
        enum class Control
        {
            writeTime,
            timeStep,
            runTime,
            onEnd
        } control;
        double next; ///< runTime: the next time [s]; writeTime: the number of write times so far
    };
    std::vector<Entry> entries_;
    void read(const Dictionary&, const Geometry&, const std::vector<std::string>& phases, const OutputPlace&, const std::string& name,
              double now);
    void restore(const Histories&);
    static bool due(const Entry&, const RunTime&, bool writeTime, bool end);
    static std::vector<std::string> execute(const std::vector<FunctionObject*>&, const ParticleView&);

public:
    FunctionObjects(const Dictionary& functions, const Geometry&, const std::vector<std::string>& phases, const RunTime&);
    bool empty() const { return entries_.empty(); }
    /// True if some object is due, so that the view need be made only then.
    bool due(const RunTime&, bool writeTime, bool end) const;
    /// Runs those that are due; returns their reports.
    std::vector<std::string> execute(const ParticleView&, const RunTime&, bool writeTime, bool end);
    /// Histories of all objects, "<name>.<list>", to be stored with a time folder; those of the start have been restored.
    Histories histories() const;

    /// Function objects for stored times: those of `only` (all where it is empty), due or not. An unknown name is an error.
    FunctionObjects(const Dictionary& functions, const Geometry&, const std::vector<std::string>& phases, const OutputPlace&,
                    const std::vector<std::string>& only);
    std::vector<std::string> executeAll(const ParticleView&);
};

}
