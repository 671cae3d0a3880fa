/// Function objects of controlDict's `functions` sub-dictionary: they look at the run and write below postProcessing/.
#pragma once
#include "Dictionary.hpp"
#include "ParticleView.hpp"
#include "RunTime.hpp"
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
};

/// All function objects of a case; reads `functions`, records every mistake in its Diagnostics.
class FunctionObjects
{
    struct Entry
    {
        std::string name;
        std::unique_ptr<FunctionObject> object;
        double interval;            ///< in time [s] or steps, by `control`
        enum class Control { writeTime, timeStep, runTime, onEnd } control;
        double next;
    };
    std::vector<Entry> entries_;

public:
    FunctionObjects(const Dictionary& functions, const Geometry&, const std::vector<std::string>& phases, const RunTime&);
    bool empty() const { return entries_.empty(); }
    /// True if some object is due, so that the view need be made only then.
    bool due(const RunTime&, bool writeTime, bool end) const;
    /// Runs those that are due; returns their reports.
    std::vector<std::string> execute(const ParticleView&, const RunTime&, bool writeTime, bool end);
};

}
