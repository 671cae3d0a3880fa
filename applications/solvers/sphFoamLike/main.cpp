#include "CaseLock.hpp"
#include "CommandLine.hpp"
#include "Run.hpp"
#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>

int main(int argc, char** argv)
{
    bool dryRun = false;
    return sph::runApplication(
        "sphFoamLike", argc, argv, "Smoothed particle hydrodynamics of any number of fluid phases between walls.",
        [&](CLI::App& app) { app.add_flag("--dry-run", dryRun, "Print the plan (passes, fields, memory, what was left out) and stop"); },
        [&](const std::filesystem::path& caseFolder)
        {
            // A plan can be looked at while a run goes on.
            std::optional<sph::CaseLock> lock;
            if (!dryRun) lock.emplace(caseFolder, "sphFoamLike");
            sph::Run run(caseFolder, std::cout);
            if (dryRun) run.printPlan();
            else run.solve();
            return 0;
        });
}
