#include "mapping/mapCase.hpp"
#include "base/words.hpp"
#include "case/RunTime.hpp"
#include "case/TimeName.hpp"
#include "case/cloudViews.hpp"
#include "case/replaceCloud.hpp"
#include "mapping/checkAlike.hpp"
#include "mapping/choosePhases.hpp"
#include "sampling/SampledField.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace sph
{

namespace
{
constexpr const char* cloudName = StoredCase::cloudName;

/// The source, whose messages say that they are of it: its files have the names of the target's.
class Source
{
    std::string name_;
    Case case_;
    std::optional<StoredCase> stored_;

    template<class F> auto ofSource(const F& f) const
    {
        try
        {
            return f();
        }
        catch (const CaseError& e)
        {
            throw CaseError(fmt::format("source case {}: {}", name_, e.what()));
        }
    }

public:
    explicit Source(const std::filesystem::path& folder) : name_(folder.string()), case_(folder)
    {
        ofSource(
            [&]
            {
                stored_.emplace(case_);
                case_.diagnostics().throwIfAny();
            });
    }
    const std::string& name() const { return name_; }
    const StoredCase& stored() const { return *stored_; }

    std::string time(const std::string& wanted) const
    {
        const auto times = ofSource([&] { return stored_->times(); });
        if (wanted == "latestTime") return times.back();
        const auto value = timeValue(wanted);
        if (!value) throw CaseError(fmt::format("-sourceTime: \"{}\" is neither a time nor latestTime", wanted));
        const auto found = std::ranges::find_if(times, [&](const auto& time)
                                                { return std::fabs(*timeValue(time) - *value) <= 1e-12 * std::fabs(*value); });
        if (found == times.end())
            throw CaseError(fmt::format("-sourceTime: {} has no particles at time {}. There are: {}", name_, wanted, list(times)));
        return *found;
    }
    ParticleView load(const std::string& time)
    {
        return ofSource([&] { return stored_->load(time); });
    }
};

/// Fields of the target's scene that are mapped, by their names on disk; and those of them that the source does not have.
struct FieldsToMap
{
    std::vector<std::string> mapped, missing;
};

FieldsToMap fieldsToMap(const Settings& of, const Cloud& source, bool startsByPressure)
{
    FieldsToMap fields;
    const auto add = [&](const std::string& name) { (source.fields.contains(name) ? fields.mapped : fields.missing).push_back(name); };
    if (startsByPressure) add("p");
    for (const auto& evolving : of.state)
        if (evolving.ofMaterial && evolving.written && !(startsByPressure && evolving.fileName() == "rho")) add(evolving.fileName());
    return fields;
}

/// The particles that stay, with all fields that the folder has.
Cloud mappedCloud(Cloud cloud, const MappedState& state, const std::vector<double>& restDensity, bool startsByPressure)
{
    for (const auto& [name, field] : state.fields) cloud.fields[name] = field;
    cloud.fields["m"] = {FieldClass::scalar, {state.mass}};
    cloud.fields["phase"] = {FieldClass::label, {std::vector<double>(state.phase.begin(), state.phase.end())}};
    if (!startsByPressure && !state.fields.contains("rho"))
    {
        auto& rho = cloud.fields["rho"] = {FieldClass::scalar, {std::vector<double>(cloud.size())}};
        for (std::size_t i = 0; i < cloud.size(); ++i)
            if (state.phase[i] != leftEmpty) rho.component[0][i] = restDensity[std::size_t(state.phase[i])];
    }
    if (state.emptied == 0) return cloud;
    const auto keep = [&](std::vector<double>& values)
    {
        std::size_t to = 0;
        for (std::size_t i = 0; i < state.phase.size(); ++i)
            if (state.phase[i] != leftEmpty) values[to++] = values[i];
        values.resize(to);
    };
    for (auto* x : {&cloud.x, &cloud.y, &cloud.z}) keep(*x);
    for (auto& [name, field] : cloud.fields)
        for (auto& values : field.component) keep(values);
    return cloud;
}

void write(const Case& target, const std::string& folder, const Cloud& cloud, const WriteOptions& options)
{
    replaceCloud(target.folder(), folder, cloudName, cloud.size(), positionsOf(cloud), fieldsOf(cloud), options);
}

std::string row(const std::string& name, const PhaseState& s)
{
    return fmt::format("    {:<24} {:>10} {:>16.9g} ({:>13.6g} {:>13.6g} {:>13.6g}) {:>14.6g}\n", name, s.particles, s.mass, s.momentum.x,
                       s.momentum.y, s.momentum.z, s.kineticEnergy);
}

std::string report(const MappedState& state, const ParticleView& target, const FieldsToMap& fields)
{
    const bool isFlat = target.dimension == 2;
    std::string s = fmt::format("{:<28} {:>10} {:>16} {:^45} {:>14}\n", "", "particles", isFlat ? "mass [kg/m]" : "mass [kg]",
                                isFlat ? "momentum [kg m/s per m]" : "momentum [kg m/s]", isFlat ? "energy [J/m]" : "energy [J]");
    for (std::size_t k = 0; k < target.phases.size(); ++k)
    {
        s += fmt::format("{}\n", target.phases[k]);
        s += row("source", state.source[k]) + row("interpolated", state.interpolated[k]) + row("momentum corrected", state.corrected[k]);
        if (state.leastShare[k] < 1) s += fmt::format("    where its share is {:.3f} or more\n", state.leastShare[k]);
    }
    if (!fields.mapped.empty()) s += fmt::format("Interpolated beside U: {}\n", fmt::join(fields.mapped, " "));
    if (!fields.missing.empty())
        s += fmt::format("Left to the dictionaries, for the source has none: {}\n", fmt::join(fields.missing, " "));
    if (state.emptied > 0) s += fmt::format("{} places left empty\n", state.emptied);
    if (state.byNearest > 0)
        s += fmt::format("{} particles farther than 1.5 spacings from any of the source, between walls: they have what the nearest has\n",
                         state.byNearest);
    if (state.uncovered > 0)
        s += fmt::format("{} particles that the source does not cover: the lightest phase, at rest\n", state.uncovered);
    return s;
}
}

MapReport mapCase(const Case& target, const std::filesystem::path& sourceFolder, const std::string& sourceTime, const Say& say)
{
    std::error_code ignored;
    if (std::filesystem::equivalent(sourceFolder, target.folder(), ignored))
        throw CaseError(fmt::format("{} is the case itself: the source is another case", sourceFolder.string()));
    Source source(sourceFolder);
    StoredCase of(target);
    target.diagnostics().throwIfAny();
    checkAlike(target, of, source.stored(), source.name());
    const RunTime runTime(target);
    target.diagnostics().throwIfAny();
    const auto folder = runTime.startName();
    if (!runTime.restored().empty())
        throw CaseError(
            {folder + "/uniform", 0},
            "is of a run: what is mapped goes into the particles of packParticles. Take the time folders of the run away, or set startFrom");
    if (!hasCloud(target.folder(), folder, cloudName))
        throw CaseError({fmt::format("{}/lagrangian/{}", folder, cloudName), 0},
                        "has no particles: the time folder that a run starts from is packed first, by packParticles");

    const auto time = source.time(sourceTime);
    const auto from = source.load(time);
    const auto to = of.load(folder);
    say(fmt::format("Source {}, time {}: {} particles, spacing {:g} m\nTarget {}: {} particles, spacing {:g} m", source.name(), time,
                    from.n, from.spacing, folder, to.n, to.spacing));
    checkOutOfSolid(from, of.geometry(), source.name());

    const bool startsByPressure = of.cloud().fields.contains("V") && !of.cloud().fields.contains("rho");
    const auto fields = fieldsToMap(of.settings(), source.stored().cloud(), startsByPressure);
    const bool gasIsInPart = source.stored().settings().facts.get<PhaseInPart>().phase >= 0;
    const auto state = mapState(from, to, {fields.mapped, gasIsInPart, fmt::format("{} at {}", source.name(), time), "the case"}, say);
    write(target, folder, mappedCloud(of.cloud(), state, to.restDensity, startsByPressure), runTime.writeOptions());
    return {time, folder, report(state, to, fields)};
}

}
