#include "base/words.hpp"
#include "case/forcesOnWalls.hpp"
#include "sampling/BedHydrodynamics.hpp"
#include "sampling/Conservation.hpp"
#include "sampling/Contour.hpp"
#include "sampling/Errors.hpp"
#include "sampling/Filling.hpp"
#include "sampling/Forces.hpp"
#include "sampling/FunctionLibraries.hpp"
#include "sampling/FunctionType.hpp"
#include "sampling/Probes.hpp"
#include "sampling/Profile.hpp"
#include "sampling/Reduction.hpp"
#include "sampling/SurfaceIntegral.hpp"
#include "sampling/VolFieldValue.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

std::vector<FunctionType>& knownTypes()
{
    static std::vector<FunctionType> types{
        functionType<Probes>("probes", "fields and expressions at points"),
        functionType<Profile>("profile", "fields and expressions along a line"),
        functionType<Conservation>("conservation", "mass, momentum and energy"),
        functionType<BedHydrodynamics>("bedHydrodynamics", "saturation and flow in a packed bed"),
        functionType<Errors>("errors", "errors against exact solutions and tables"),
        functionType<Filling>("filling", "how far a cavity is filled"),
        functionType<Reduction>("reduction", "sums, means, extremes and percentiles of expressions"),
        functionType<Contour>("contour", "shape and way of a level set, or of the surface of a phase"),
        functionType<SurfaceIntegral>("surfaceIntegral", "integral of an expression over a wall: flux, force, torque"),
        functionType<VolFieldValue>("volFieldValue", "mean, least or largest value in a box"),
        functionType<Forces>(forcesType, "forces on walls"),
    };
    return types;
}

Cases types()
{
    Cases all;
    for (const auto& t : knownTypes()) all.push_back({t.name, t.entries()});
    return all;
}
}

namespace entry
{
const Choice control{"executeControl",
                     {{"writeTime", "at each executeInterval-th write time"},
                      {"timeStep", "at each executeInterval-th step"},
                      {"runTime", "at multiples of executeInterval"},
                      {"onEnd", "when the run ends"}}, // in the order of FunctionObjects::Entry::Control
                     "writeTime",
                     "when it is due"};
const Scalar time{"executeInterval", units::s, required, positive, "time between two samples"};
const Count times{"executeInterval", 1, atLeast(1), "write times or steps between two samples"};
const FreeName function{"<function>", "dictionary", "a function object; its name is that of the folder below postProcessing"};

static Choice functionType() { return {"type", wordsOf(types()), required, "what it measures"}; }
}

const std::vector<FunctionType>& functionTypes() { return knownTypes(); }
AddedFunction::AddedFunction(const FunctionType& type) { knownTypes().push_back(type); }

std::vector<TableInfo> functionTables()
{
    std::vector<TableInfo> tables;
    for (const auto& t : knownTypes()) tables.push_back(t.table());
    return tables;
}

EntryList functionEntries()
{
    return {{entry::function,
             {{entry::control,
               {{"writeTime", {entry::times}}, {"timeStep", {entry::times}}, {"runTime", {entry::time}}, {"onEnd", {entry::times}}}},
              entry::libs,
              {entry::functionType(), types()}}}};
}

namespace
{

/// The next multiple of the interval after t, so that a restarted run samples at the same times. The fraction forgives the
/// round-off of a sum of time steps.
double nextMultiple(double interval, double t) { return interval * (std::floor(t / interval + 1e-6) + 1); }

constexpr double roundOff = 1e-6; ///< of an interval

}

FunctionObjects::FunctionObjects(const Dictionary& functions, const Geometry& geometry, const std::vector<std::string>& phases,
                                 const RunTime& time)
{
    for (const auto& name : functions.keys()) read(functions, geometry, phases, outputOf(time), name, time.value());
    restore(time.restoredHistories());
}

namespace
{
constexpr const char* writeTimes = "writeTimes";
}

Histories FunctionObjects::histories() const
{
    Histories all;
    for (const auto& entry : entries_)
    {
        for (auto& [list, values] : entry.object->histories()) all[entry.name + "." + list] = std::move(values);
        if (entry.control == Entry::Control::writeTime && entry.interval > 1) all[entry.name + "." + writeTimes] = {entry.next};
    }
    return all;
}

void FunctionObjects::restore(const Histories& all)
{
    for (auto& entry : entries_)
    {
        Histories own;
        const auto prefix = entry.name + ".";
        for (const auto& [name, values] : all)
            if (name.starts_with(prefix)) own[name.substr(prefix.size())] = values;
        // The time folder's own sample is taken again when the run starts.
        if (const auto counted = own.find(writeTimes); counted != own.end() && !counted->second.empty())
            entry.next = counted->second[0] - 1;
        if (!own.empty()) entry.object->restore(own);
    }
}

FunctionObjects::FunctionObjects(const Dictionary& functions, const Geometry& geometry, const std::vector<std::string>& phases,
                                 const OutputPlace& output, const std::vector<std::string>& only)
{
    const auto names = functions.keys();
    for (const auto& name : only)
        if (std::ranges::find(names, name) == names.end())
            functions.error("", fmt::format("there is no function \"{}\". {}", name, suggestion(name, "functions", names)));
    for (const auto& name : only.empty() ? names : only)
        if (std::ranges::find(names, name) != names.end()) read(functions, geometry, phases, output, name, 0);
}

void FunctionObjects::read(const Dictionary& functions, const Geometry& geometry, const std::vector<std::string>& phases,
                           const OutputPlace& output, const std::string& name, double now)
{
    using Control = Entry::Control;
    if (!functions.isDictionary(name)) return functions.error(name, fmt::format("{} must be a dictionary: {} {{ type ...; }}", name, name));
    if (name.starts_with('.') || name.find_first_of("/\\\t\n") != name.npos)
        return functions.error(name, "names the folder of its output, below postProcessing: no path, no '.' at its beginning, no tab");
    const auto d = functions.subDict(name);
    loadLibraries(d);
    const auto type = entry::functionType().known(d);
    if (!type) return;
    Entry entry;
    entry.name = name;
    entry.control = Control(entry::control.index(d));
    const bool byTime = entry.control == Control::runTime;
    entry.interval = byTime ? entry::time(d) : entry::times(d);
    entry.next = byTime ? nextMultiple(entry.interval, now) : 0;
    for (const auto& t : knownTypes())
        if (t.name.word == *type)
        {
            entry.object = t.make(d, {name, geometry, phases, output});
            d.reportUnused();
        }
    if (entry.object) entries_.push_back(std::move(entry));
}

bool FunctionObjects::due(const Entry& entry, const RunTime& time, bool writeTime, bool end)
{
    using Control = Entry::Control;
    switch (entry.control)
    {
    case Control::writeTime:
        return writeTime && std::fmod(entry.next, entry.interval) == 0;
    case Control::timeStep:
        return time.index() % long(entry.interval) == 0;
    case Control::runTime:
        return time.value() >= entry.next - roundOff * entry.interval;
    case Control::onEnd:
        return end;
    }
    return false;
}

bool FunctionObjects::due(const RunTime& time, bool writeTime, bool end) const
{
    for (const auto& entry : entries_)
        if (due(entry, time, writeTime, end)) return true;
    return false;
}

std::vector<std::string> FunctionObjects::execute(const ParticleView& view, const RunTime& time, bool writeTime, bool end)
{
    using Control = Entry::Control;
    std::vector<FunctionObject*> now;
    for (auto& entry : entries_)
    {
        const bool isDue = due(entry, time, writeTime, end);
        if (entry.control == Control::writeTime && writeTime) ++entry.next; // counts write times
        if (entry.control == Control::runTime && isDue) entry.next = nextMultiple(entry.interval, time.value());
        if (isDue) now.push_back(entry.object.get());
    }
    // All of them have been counted by now: where one fails, the state that is written then has the counts of all.
    return execute(now, view);
}

std::vector<std::string> FunctionObjects::executeAll(const ParticleView& view)
{
    std::vector<FunctionObject*> all;
    for (auto& entry : entries_) all.push_back(entry.object.get());
    return execute(all, view);
}

std::vector<std::string> FunctionObjects::execute(const std::vector<FunctionObject*>& objects, const ParticleView& view)
{
    std::vector<std::string> reports;
    for (auto* object : objects)
    {
        object->execute(view);
        if (auto report = object->report(); !report.empty()) reports.push_back(std::move(report));
    }
    return reports;
}

}
