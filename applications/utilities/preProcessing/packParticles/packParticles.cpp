/// Fills the space between the walls with particles: see src/packing. Before that, with -solids, packs the solids: see src/solids.
#include "base/CommandLine.hpp"
#include "case/CaseLock.hpp"
#include "packing/Packing.hpp"
#include "solids/BedReport.hpp"
#include <fmt/format.h>

namespace
{
/// writeFormat and writePrecision of controlDict; binary where there is none.
sph::WriteOptions writeOptions(const sph::Case& c)
{
    static const std::vector<std::string> formats{"ascii", "binary"};
    const auto control = c.dictionaryIfPresent("system/controlDict");
    sph::WriteOptions options;
    if (control.choose("writeFormat", formats, "binary") == "ascii") options.format = sph::WriteFormat::ascii;
    return options;
}

void packSolids(const sph::Case& theCase)
{
    const auto plan = sph::readSolidsPlan(theCase);
    const auto bed = sph::packSolids(theCase, plan,
                                     [](const std::string& line)
                                     {
                                         fmt::print("{}\n", line);
                                         std::fflush(stdout);
                                     });
    const auto measures = sph::measure(plan, bed);
    const auto files = sph::writeBed(theCase, plan, bed, measures);
    fmt::print("\n{}\nWritten to {}\n\nEnd\n", sph::report(plan, bed, measures), fmt::join(files, ", "));
}
}

int main(int argc, char** argv)
{
    std::string time = "0";
    bool solids = false;
    return sph::runApplication(
        "packParticles", argc, argv, "Fills the space between the walls of a case with particles (system/packParticlesDict).",
        [&](sph::CommandLine& line)
        {
            line.option("time", time, "name", "Time folder to write (default 0)");
            line.flag("solids", solids, "Pack the solids of section solids instead: the bed that constant/geometry takes in");
        },
        [&](const std::filesystem::path& caseFolder)
        {
            const sph::CaseLock lock(caseFolder, "packParticles");
            const sph::Case theCase(caseFolder);
            if (solids)
            {
                packSolids(theCase);
                return 0;
            }
            const auto options = writeOptions(theCase);
            const auto plan = sph::readPackingPlan(theCase);
            const auto packing = sph::pack(plan);
            sph::writePacking(theCase, time, plan, packing, options);
            sph::warnOfCrowd(plan, packing, theCase.diagnostics());
            for (const auto& line : theCase.diagnostics().warnings()) fmt::print("Warning: {}\n", line);
            fmt::print("{}\nWritten to {}/lagrangian/sph\n\nEnd\n", sph::report(plan, packing), time);
            return 0;
        });
}
