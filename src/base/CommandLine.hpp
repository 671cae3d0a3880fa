/// Command lines of all applications: OpenFOAM's single-dash options, `-help`, `-version`, `-case`, the head of the log, exit codes.
///
/// A main is then one call:
///
///     int main(int argc, char** argv)
///     {
///         bool dryRun = false;
///         std::string dict = "system/packDict";
///         return sph::runApplication("packParticles", argc, argv, "Fills regions with particles.",
///             [&](sph::CommandLine& line)
///             {
///                 line.flag("dry-run", dryRun, "Print the plan and stop");
///                 line.option("dict", dict, "file", "Dictionary to read");
///             },
///             [&](const std::filesystem::path& caseFolder) { return pack(caseFolder, dict, dryRun); });
///     }
///
/// CLI11 reads the line. CommandLine.cpp alone includes its header, which takes three seconds to compile. Names are declared without dashes; a user types one
/// before them (two are accepted as well).
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}

namespace sph
{

/// Where an application declares its options. Their values are written once all are declared, when the line is read: they must live until then.
class CommandLine
{
    CLI::App& app_;

public:
    /// An option or argument as declared, and what it goes with.
    class Option
    {
        CLI::Option* option_ = nullptr;

    public:
        Option() = default;
        explicit Option(CLI::Option* option) : option_(option) {}

        Option required();
        Option positive();
        Option within(int least, int most);
        Option commaSeparated();
        Option valueOptional();        ///< the option may stand alone
        Option needs(Option other);    ///< both are given, or this one is not
        Option excludes(Option other); ///< one of them is given at most
        bool given() const;            ///< once the line has been read
    };

    explicit CommandLine(CLI::App& app) : app_(app) {}

    /// `-name`.
    Option flag(const std::string& name, bool& value, const std::string& meaning);
    /// `-name <type>`; Value: std::string, double, int, std::optional<double> or std::vector<std::string>. The value of an option that the line does not have stays.
    template<class Value> Option option(const std::string& name, Value& value, const std::string& type, const std::string& meaning);
    /// The next one of what stands without a dash; Value: std::string, double, or std::vector<std::string> for all that is left.
    template<class Value> Option argument(const std::string& name, Value& value, const std::string& meaning);
};

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
                   const std::function<void(CommandLine&)>& options,
                   const std::function<int(const std::filesystem::path& caseFolder)>& body, Banner = Banner::shown);

}
