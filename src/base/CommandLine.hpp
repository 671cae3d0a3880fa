/// Command lines of all applications: OpenFOAM's single-dash options, `-help`, `-version`, `-case`, the head of the log, exit codes.
///
/// A main is then one call:
///
///     int main(int argc, char** argv)
///     {
///         bool dryRun = false;
///         std::string dict = "system/packDict";
///         return sph::runApplication("packParticles", argc, argv, "Fills regions with particles.",
///             [&](CLI::App& app)
///             {
///                 app.add_flag("--dry-run", dryRun, "Print the plan and stop");
///                 app.add_option("--dict", dict, "Dictionary to read")->type_name("<file>");
///             },
///             [&](const std::filesystem::path& caseFolder) { return pack(caseFolder, dict, dryRun); });
///     }
///
/// Options are declared to CLI11 with two dashes and typed, and shown, with one (two are accepted as well).
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace sph
{

/// The arguments after the program's name, in the order typed, with `-name` turned into the `--name` that CLI11 understands.
/// Left alone: `-n` (one letter), negative numbers (`-.5` becomes `-0.5`, which CLI11 takes for a number), and all that follows
/// a `--`. CLI::App::parse(vector) wants the reverse order; runApplication sees to that.
std::vector<std::string> openFoamArguments(int argc, const char* const* argv);

/// Head of an application's output (version.hpp). Those whose output is read by other programs have none; the solver writes its own, once for all ranks.
enum class Banner
{
    shown,
    none
};

/// Runs an application: `options` declares its options beside `-help`, `-version` and `-case <dir>` (default: the current folder), `body`
/// does the work and returns the exit code. Output to stdout is written line by line, so that a log which gets stderr as well has both
/// in order. Writes usage to stdout. Mistakes on the command line, CaseError and any other
/// exception are written to stderr, as "--> FATAL ERROR" and the message, and give exit code 1. This is the one place that
/// catches them.
int runApplication(const std::string& name, int argc, const char* const* argv, const std::string& description,
                   const std::function<void(CLI::App&)>& options, const std::function<int(const std::filesystem::path& caseFolder)>& body,
                   Banner = Banner::shown);

}
