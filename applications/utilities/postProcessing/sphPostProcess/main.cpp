/// Runs the function objects of a case on its stored times.
#include "base/CommandLine.hpp"
#include "case/timeSelection.hpp"
#include "sampling/FunctionLibraries.hpp"
#include "sampling/FunctionObject.hpp"
#include "storedCase/StoredCase.hpp"
#include <fmt/format.h>

namespace
{

struct Options
{
    std::string times;
    bool latestTime = false;
    std::vector<std::string> functions;
};

int run(const std::filesystem::path& path, const Options& options)
{
    const sph::Case theCase(path);
    sph::StoredCase stored(theCase);
    const auto control = theCase.dictionary("system/controlDict");
    theCase.diagnostics().throwIfAny();
    const auto all = stored.times();
    const auto times = options.latestTime ? std::vector{all.back()} : sph::selectTimes(all, options.times);

    std::string current = times.front();
    sph::loadLibraries(control);
    sph::FunctionObjects functions(control.subDictOrEmpty("functions"), stored.geometry(), stored.phases(),
                                   sph::outputOf(theCase.folder(), times.front(), current), options.functions);
    theCase.diagnostics().throwIfAny();
    for (const auto& warning : theCase.diagnostics().warnings()) fmt::print(stderr, "--> Warning: {}\n", warning);
    if (functions.empty()) throw sph::CaseError({"system/controlDict", 0}, "has no functions to run");
    for (const auto& time : times)
    {
        current = time;
        fmt::print("Time = {}\n", time);
        for (const auto& report : functions.executeAll(stored.load(time))) fmt::print("{}\n", report);
        fmt::print("\n");
        std::fflush(stdout);
    }
    fmt::print("End\n");
    return 0;
}

}

int main(int argc, char** argv)
{
    Options options;
    return sph::runApplication(
        "sphPostProcess", argc, argv, "Runs the function objects of system/controlDict on the stored times of a case, into postProcessing.",
        [&](sph::CommandLine& line)
        {
            const auto time = line.option("time", options.times, "ranges", "Times and ranges: '0.1,0.3', '0.1:0.5', ':0.5' (default: all)");
            line.flag("latestTime", options.latestTime, "The last time only").excludes(time);
            line.option("func", options.functions, "name", "These function objects only");
        },
        [&](const std::filesystem::path& folder) { return run(folder, options); });
}
