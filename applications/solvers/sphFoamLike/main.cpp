#include "base/CommandLine.hpp"
#include "case/CaseLock.hpp"
#include "parallel/Ranks.hpp"
#include "run/Run.hpp"
#include <chrono>
#include <fstream>
#include <iostream>
#include <optional>
#include <thread>

int main(int argc, char** argv)
{
    bool dryRun = false, parallel = false;
    const int code = sph::runApplication(
        "sphFoamLike", argc, argv, "Smoothed particle hydrodynamics of any number of fluid phases between walls.",
        [&](sph::CommandLine& line)
        {
            line.flag("dry-run", dryRun,
                      "Print the plan (passes, fields, memory, what was left out) and how long the run would take, and stop");
            line.flag("parallel", parallel, "Share the particles between the processes that mpirun has started");
        },
        [&](const std::filesystem::path& caseFolder)
        {
            if (parallel) sph::startRanks();
            const bool first = sph::isFirstRank();
            std::ofstream nowhere;
            try
            {
                // A plan can be looked at while a run goes on.
                std::optional<sph::CaseLock> lock;
                if (first && !dryRun) lock.emplace(caseFolder, "sphFoamLike");
                sph::Run run(caseFolder, first ? std::cout : nowhere, parallel);
                if (!dryRun) return run.solve();
                run.dryRun();
            }
            catch (...)
            {
                // An error that all ranks find is reported by the first, which ends them.
                if (!first) std::this_thread::sleep_for(std::chrono::seconds(2));
                throw;
            }
            return 0;
        },
        sph::Banner::none);
    // What a signal has stopped, codes from 128 on, has ended well on all ranks.
    if (const auto* const all = sph::ranks(); all && code != 0 && code < 128) all->abort();
    return code;
}
