/// Gives the packed particles of a case the state of another case of the same scene, of whatever spacing: see src/mapping.
#include "base/CommandLine.hpp"
#include "case/CaseLock.hpp"
#include "mapping/mapCase.hpp"
#include <fmt/format.h>

int main(int argc, char** argv)
{
    std::string source, time = "latestTime";
    return sph::runApplication(
        "mapParticles", argc, argv,
        "Gives the particles that packParticles has packed the state of another case of the same scene, of coarser or finer spacing.",
        [&](sph::CommandLine& line)
        {
            line.argument("sourceCase", source, "Case whose particles have the state").required();
            line.option("sourceTime", time, "time", "Time of the source, or latestTime (default)");
        },
        [&](const std::filesystem::path& caseFolder)
        {
            const sph::CaseLock lock(caseFolder, "mapParticles");
            const sph::Case theCase(caseFolder);
            const auto report = sph::mapCase(theCase, source, time,
                                             [](const std::string& line)
                                             {
                                                 fmt::print("{}\n", line);
                                                 std::fflush(stdout);
                                             });
            for (const auto& line : theCase.diagnostics().warnings()) fmt::print("Warning: {}\n", line);
            fmt::print("{}\nWritten to {}/lagrangian/sph\n\nEnd\n", report.text, report.folder);
            return 0;
        });
}
