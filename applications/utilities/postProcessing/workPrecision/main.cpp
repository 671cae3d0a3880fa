/// Runs a case over resolutions and variants and draws its error against its cost.
#include "CaseSweep.hpp"
#include "base/CommandLine.hpp"
#include <CLI/CLI.hpp>

int main(int argc, char** argv)
{
    bool dryRun = false;
    return sph::runApplication(
        "workPrecision", argc, argv,
        "Runs variants of a case over a ladder of resolutions, as told by system/workPrecisionDict, and writes errors, costs, "
        "observed\n"
        "orders and plots into postProcessing/workPrecision. Goes on where it was interrupted.",
        [&](CLI::App& app) { app.add_flag("--dry-run", dryRun, "Check everything, print what would run, and stop"); },
        [&](const std::filesystem::path& caseFolder)
        {
            sph::CaseSweep sweep(caseFolder);
            sweep.printPlan();
            return dryRun ? 0 : sweep.run();
        });
}
