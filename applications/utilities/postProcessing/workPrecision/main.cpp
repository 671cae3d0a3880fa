/// Runs a case over resolutions and variants and draws its error against its cost.
#include "CaseSweep.hpp"
#include "base/CommandLine.hpp"
#include "base/version.hpp"
#include <fmt/format.h>

int main(int argc, char** argv)
{
    bool dryRun = false, csv = false;
    sph::SweepSelection selection;
    return sph::runApplication(
        "workPrecision", argc, argv,
        "Runs variants of a case over a ladder of resolutions, as told by system/workPrecisionDict, and writes errors, costs, "
        "observed\n"
        "orders and plots into postProcessing/workPrecision. Goes on where it was interrupted.",
        [&](sph::CommandLine& line)
        {
            const auto print = line.flag("csv", csv, "Print the table of what has been run, and of the peers, and stop");
            line.flag("dry-run", dryRun, "Check everything, print what would run, and stop").excludes(print);
            line.option("variants", selection.variants, "names", "These variants alone: suite,paper (default: all)")
                .commaSeparated()
                .excludes(print);
            line.option("coarsest", selection.coarsest, "number", "As many resolutions alone, the coarsest ones (default: all)")
                .positive()
                .excludes(print);
        },
        [&](const std::filesystem::path& caseFolder)
        {
            if (csv)
            {
                fmt::print("{}", sph::sweepTable(caseFolder));
                return 0;
            }
            fmt::print("{}", sph::banner("workPrecision", caseFolder));
            sph::CaseSweep sweep(caseFolder, selection);
            sweep.printPlan();
            return dryRun ? 0 : sweep.run();
        },
        sph::Banner::none);
}
