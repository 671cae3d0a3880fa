/// Time folders of a case from those of its folders processor0, processor1, ..
#include "base/CommandLine.hpp"
#include "case/CaseLock.hpp"
#include "case/TimeControls.hpp"
#include "case/timeSelection.hpp"
#include "decomposition/decompose.hpp"
#include "geometry/Geometry.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace
{

struct Options
{
    std::string times;
    bool latestTime = false, newTimes = false;
};

std::vector<std::string> chosenTimes(const sph::Case& theCase, const Options& options)
{
    auto times = sph::processorTimes(theCase);
    if (times.empty()) throw sph::CaseError("The processor folders have no time folders");
    if (!options.times.empty()) return sph::selectTimes(times, options.times);
    if (options.latestTime) return {times.back()};
    const auto there = options.newTimes ? theCase.times() : sph::dividedTimes(theCase);
    std::erase_if(times, [&](const auto& time) { return std::ranges::find(there, time) != there.end(); });
    return times;
}

int run(const std::filesystem::path& folder, const Options& options)
{
    const sph::CaseLock lock(folder, "reconstructParticles");
    const sph::Case theCase(folder);
    const auto writeOptions = sph::TimeControls::read(theCase.dictionary("system/controlDict")).writeOptions;
    const auto [low, high] = sph::boundingBox(sph::readDomain(theCase));
    theCase.diagnostics().throwIfAny();
    const auto times = chosenTimes(theCase, options);
    if (times.empty()) fmt::print("No further times\n");
    for (const auto& time : times)
    {
        fmt::print("Time = {}\n", time);
        fmt::print("    {} particles\n", sph::reconstruct(theCase, time, writeOptions));
        std::fflush(stdout);
    }
    sph::writeBoundingMesh(folder, low, high);
    fmt::print("\nEnd\n");
    return 0;
}

}

int main(int argc, char** argv)
{
    Options options;
    return sph::runApplication(
        "reconstructParticles", argc, argv, "Puts the time folders of processor0, processor1, .. together into time folders of the case.",
        [&](sph::CommandLine& line)
        {
            const auto time = line.option("time", options.times, "ranges",
                                          "Times and ranges: '0.1,0.3', '0.1:0.5' (default: all but those that were decomposed)");
            const auto latest = line.flag("latestTime", options.latestTime, "The last time only").excludes(time);
            line.flag("newTimes", options.newTimes, "Those that the case does not have yet").excludes(time).excludes(latest);
        },
        [&](const std::filesystem::path& folder) { return run(folder, options); });
}
