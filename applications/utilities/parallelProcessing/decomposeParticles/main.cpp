/// The particles of a case in folders processor0, processor1, .., for `sphFoamLike -parallel` and ParaView's decomposed reader.
#include "base/CommandLine.hpp"
#include "case/CaseLock.hpp"
#include "case/RunTime.hpp"
#include "case/timeSelection.hpp"
#include "decomposition/decompose.hpp"
#include "decomposition/processorFolders.hpp"
#include "estimateReport.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace
{

constexpr int mostRanks = 100000;

struct Options
{
    std::string times;
    bool latestTime = false, force = false;
    int estimate = 0;
    std::optional<double> scaleTo;
    sph::Costs costs;
};

/// Times that the user has asked for, or the one that a run would start from.
std::vector<std::string> chosenTimes(const sph::Case& theCase, const sph::RunTime& time, const Options& options)
{
    if (!options.latestTime && options.times.empty()) return {time.startName()};
    auto times = theCase.times();
    std::erase_if(times, [&](const auto& name) { return !sph::hasCloud(theCase.folder(), name, "sph"); });
    if (times.empty()) throw sph::CaseError("No time folder has a cloud lagrangian/sph");
    return options.latestTime ? std::vector{times.back()} : sph::selectTimes(times, options.times);
}

int estimate(const std::filesystem::path& folder, const Options& options)
{
    const sph::Case theCase(folder);
    const sph::RunTime time(theCase);
    theCase.diagnostics().throwIfAny();
    for (const auto& name : chosenTimes(theCase, time, options))
        fmt::print("{}", sph::estimateReport(theCase, name, options.estimate, options.costs, options.scaleTo));
    fmt::print("\nEnd\n");
    return 0;
}

int run(const std::filesystem::path& folder, const Options& options)
{
    const sph::CaseLock lock(folder, "decomposeParticles");
    const sph::Case theCase(folder);
    const auto decomposition = sph::readDecomposition(theCase);
    const sph::RunTime time(theCase);
    theCase.diagnostics().throwIfAny();
    const auto times = chosenTimes(theCase, time, options);
    if (const int parts = options.force ? 0 : sph::countProcessorFolders(folder); parts > 0)
        throw sph::CaseError(
            fmt::format("Case is already decomposed with {} domains, use the -force option: it removes their folders", parts));
    const auto sizes = sph::decompose(theCase, times, decomposition, time.writeOptions());
    for (const auto& warning : theCase.diagnostics().warnings()) fmt::print("--> Warning: {}\n", warning);
    for (std::size_t t = 0; t < times.size(); ++t)
    {
        fmt::print("Time = {}\n", times[t]);
        for (std::size_t part = 0; part < sizes[t].size(); ++part)
            fmt::print("    {}: {} particles\n", sph::processorFolder(int(part)), sizes[t][part]);
    }
    fmt::print("\nEnd\n");
    return 0;
}

}

int main(int argc, char** argv)
{
    Options options;
    return sph::runApplication(
        "decomposeParticles", argc, argv,
        "Divides the particles of a case between folders processor0, processor1, .. (system/decomposeParDict).",
        [&](sph::CommandLine& line)
        {
            const auto time =
                line.option("time", options.times, "ranges", "Times and ranges: '0.1,0.3', '0.1:0.5' (default: that of startFrom)");
            line.flag("latestTime", options.latestTime, "The last time").excludes(time);
            line.flag("force", options.force, "Remove the processor folders that there are");
            const auto ranks =
                line.option("estimate", options.estimate, "ranks", "Write nothing: report what so many ranks would have to do and to send")
                    .within(1, mostRanks);
            const auto ofEstimate = [&](const std::string& name, auto& value, const std::string& type, const std::string& meaning)
            { line.option(name, value, type, meaning).positive().needs(ranks); };
            auto& costs = options.costs;
            const auto with = [](const std::string& meaning, auto fallback) { return fmt::format("{} (default {})", meaning, fallback); };
            ofEstimate("scaleTo", options.scaleTo, "particles", "Also for so many particles, by the surfaces of boxes");
            ofEstimate("latency", costs.latency, "s", with("Of a message", costs.latency));
            ofEstimate("bandwidth", costs.bandwidth, "bytes/s", with("Of a rank", costs.bandwidth));
            ofEstimate("secondsPerParticle", costs.secondsPerParticle, "s", with("Of a step", costs.secondsPerParticle));
            ofEstimate("refreshes", costs.refreshes, "n", with("Of copies in a step", costs.refreshes));
            ofEstimate("values", costs.values, "n", with("Numbers of a copy that are sent in a step", costs.values));
        },
        [&](const std::filesystem::path& folder) { return options.estimate > 0 ? estimate(folder, options) : run(folder, options); });
}
