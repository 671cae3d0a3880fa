#include "BedHydrodynamics.hpp"
#include "Conservation.hpp"
#include "Errors.hpp"
#include "Filling.hpp"
#include "FunctionContext.hpp"
#include "Probes.hpp"
#include "Profile.hpp"
#include "VolFieldValue.hpp"
#include "knownWord.hpp"
#include "words.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

struct Type
{
    std::string name;
    std::unique_ptr<FunctionObject> (*make)(const Dictionary&, const FunctionContext&);
};

template<class Object> std::unique_ptr<FunctionObject> make(const Dictionary& d, const FunctionContext& context)
{
    return std::make_unique<Object>(d, context);
}

const std::vector<Type>& catalogue()
{
    static const std::vector<Type> types{
        {"probes", make<Probes>},
        {"profile", make<Profile>},
        {"conservation", make<Conservation>},
        {"bedHydrodynamics", make<BedHydrodynamics>},
        {"errors", make<Errors>},
        {"filling", make<Filling>},
        {"volFieldValue", make<VolFieldValue>},
    };
    return types;
}

/// The next multiple of the interval after t, so that a restarted run samples at the same times. The fraction forgives the
/// round-off of a sum of time steps.
double nextMultiple(double interval, double t) { return interval * (std::floor(t / interval + 1e-6) + 1); }

constexpr double roundOff = 1e-6; ///< of an interval

}

FunctionObjects::FunctionObjects(const Dictionary& functions, const Geometry& geometry, const std::vector<std::string>& phases,
                                 const RunTime& time)
{
    for (const auto& name : functions.keys()) read(functions, geometry, phases, outputOf(time), name, time.value());
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
    std::vector<std::string> types;
    for (const auto& t : catalogue()) types.push_back(t.name);
    const std::vector<std::string> controls{"writeTime", "timeStep", "runTime", "onEnd"}; // in the order of Control

    if (!functions.isDictionary(name))
        return functions.error(name, fmt::format("{} must be a dictionary: {} {{ type ...; }}", name, name));
    const auto d = functions.subDict(name);
    const auto type = knownWord(d, "type", types);
    if (!type) return;
    const auto control = d.choose("executeControl", controls, "writeTime");
    Entry entry;
    entry.name = name;
    entry.control = Control(std::ranges::find(controls, control) - controls.begin());
    if (entry.control == Control::runTime)
    {
        entry.interval = d.getPositive("executeInterval", units::s);
        entry.next = nextMultiple(entry.interval, now);
    }
    else
    {
        entry.interval = d.get("executeInterval", 1);
        entry.next = 0;
        if (entry.interval < 1)
            d.error("executeInterval", fmt::format("executeInterval of {} counts and must be at least 1", control));
    }
    for (const auto& t : catalogue())
        if (t.name == *type)
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
    std::vector<std::string> reports;
    for (auto& entry : entries_)
    {
        const bool now = due(entry, time, writeTime, end);
        if (entry.control == Control::writeTime && writeTime) ++entry.next; // counts write times
        if (!now) continue;
        if (entry.control == Control::runTime) entry.next = nextMultiple(entry.interval, time.value());
        entry.object->execute(view);
        if (auto report = entry.object->report(); !report.empty()) reports.push_back(std::move(report));
    }
    return reports;
}

std::vector<std::string> FunctionObjects::executeAll(const ParticleView& view)
{
    std::vector<std::string> reports;
    for (auto& entry : entries_)
    {
        entry.object->execute(view);
        if (auto report = entry.object->report(); !report.empty()) reports.push_back(std::move(report));
    }
    return reports;
}

}
