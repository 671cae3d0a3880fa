#include "base/CommandLine.hpp"
#include "base/CaseError.hpp"
#include "base/readText.hpp"
#include "base/version.hpp"
#include <cstdio>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <sys/wait.h>
#include <unistd.h>

using namespace sph;

namespace
{

/// Result of an application "demo" with an option -entry, a flag -keywords, a number -value and an optional file, from its
/// arguments.
struct Demo
{
    int code = -1;
    std::string entry, file, caseFolder, out, err;
    double value = 0;
    bool keywords = false;

    explicit Demo(
        std::vector<const char*> arguments, const std::function<void()>& work = [] {}, Banner head = Banner::none)
    {
        arguments.insert(arguments.begin(), "demo");
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        code = runApplication(
            "demo", int(arguments.size()), arguments.data(), "Shows something.",
            [&](CommandLine& line)
            {
                line.option("entry", entry, "text", "Entry to show");
                line.option("value", value, "number", "A number");
                line.flag("keywords", keywords, "List keywords");
                line.argument("file", file, "File to read");
            },
            [&](const std::filesystem::path& folder)
            {
                caseFolder = folder.string();
                work();
                return 0;
            },
            head);
        out = testing::internal::GetCapturedStdout();
        err = testing::internal::GetCapturedStderr();
    }
};

}

// Single-dash long options become CLI11's, numbers and what follows "--" stay as typed.
TEST(CommandLine, mapsSingleDashOptionsAndLeavesNumbersAlone)
{
    const char* typed[] = {"demo", "-case", "x", "-n", "4", "-set", "-1.5", "-.5", "-3e-2", "--already", "--", "-raw"};
    EXPECT_EQ(openFoamArguments(12, typed),
              (std::vector<std::string>{"--case", "x", "-n", "4", "--set", "-1.5", "-0.5", "-3e-2", "--already", "--", "-raw"}));
}

// Options, flags, negative values and positional arguments reach the application in the order typed.
TEST(CommandLine, passesOptionsOn)
{
    const Demo demo({"-entry", "a.b", "-value", "-0.25", "system/controlDict", "-keywords", "-case", "/"});
    EXPECT_EQ(demo.code, 0) << demo.err;
    EXPECT_EQ(demo.entry, "a.b");
    EXPECT_EQ(demo.value, -0.25);
    EXPECT_EQ(demo.file, "system/controlDict");
    EXPECT_EQ(demo.caseFolder, "/");
    EXPECT_TRUE(demo.keywords);
    EXPECT_EQ(Demo({"-value", "-.5"}).value, -0.5);
    EXPECT_EQ(Demo({}).caseFolder, ".");
}

// The usage has OpenFOAM's layout, options with a single dash, and the exit code is 0.
TEST(CommandLine, printsUsageLikeOpenFOAM)
{
    const Demo demo({"-help"});
    EXPECT_EQ(demo.code, 0);
    EXPECT_EQ(demo.out, "\nUsage: demo [OPTIONS] [<file>]\nOptions:\n"
                        "  -help                     Print this usage\n"
                        "  -version                  Print the version\n"
                        "  -case <dir>               Case folder, instead of the current one\n"
                        "  -entry <text>             Entry to show\n"
                        "  -value <number>           A number\n"
                        "  -keywords                 List keywords\n"
                        "  <file>                    File to read\n"
                        "\nShows something.\n\n");
}

// A misspelt option names the one that was meant; so does a missing value and a missing case folder. Exit code 1.
TEST(CommandLine, explainsMistakes)
{
    const Demo misspelt({"-keyword"});
    EXPECT_EQ(misspelt.code, 1);
    EXPECT_EQ(misspelt.err, "--> FATAL ERROR\nInvalid option -keyword. Did you mean \"-keywords\"? "
                            "Known options: -help, -version, -case, -entry, -value, -keywords.\nSee 'demo -help' for usage\n");
    EXPECT_EQ(Demo({"-entry"}).err, "--> FATAL ERROR\n-entry: 1 required <text> missing\nSee 'demo -help' for usage\n");
    EXPECT_EQ(Demo({"a", "b"}).err, "--> FATAL ERROR\nUnexpected argument \"b\"\nSee 'demo -help' for usage\n");
    EXPECT_EQ(Demo({"-case", "nowhere"}).err, "--> FATAL ERROR\nThere is no case folder \"nowhere\"\nSee 'demo -help' for usage\n");
}

// Exceptions of the work itself end in exit code 1 and one message; a mistake of the user is told apart from one of the program.
TEST(CommandLine, catchesExceptionsOfTheWork)
{
    const Demo user({}, [] { throw CaseError({"system/controlDict", 12}, "\"deltaT\" must be positive"); });
    EXPECT_EQ(user.code, 1);
    EXPECT_EQ(user.err, "--> FATAL ERROR\nsystem/controlDict:12: \"deltaT\" must be positive\n");
    const Demo program({}, [] { throw std::logic_error("oops"); });
    EXPECT_EQ(program.code, 1);
    EXPECT_EQ(program.err, "--> FATAL ERROR\ndemo stopped unexpectedly: oops\n");
}

// In a log that gets both streams each line stands where it was written: what is printed, what a library says on standard error, the error
// that ends the application. A process of its own, whose standard output is a file from the start.
TEST(CommandLine, keepsTheOrderOfALogOfBothStreams)
{
    const auto log = std::filesystem::temp_directory_path() / fmt::format("sphCommandLine.{}.log", ::getpid());
    const auto process = ::fork();
    ASSERT_GE(process, 0);
    if (process == 0)
    {
        const bool redirected = std::freopen(log.c_str(), "w", stdout) && ::dup2(::fileno(stdout), STDERR_FILENO) >= 0;
        const char* arguments[] = {"demo"};
        const auto work = [](const std::filesystem::path&) -> int
        {
            fmt::print("printed 1\n");
            std::fputs("a library 2\n", stderr);
            std::cout << "streamed 3\n";
            std::cerr << "a library 4\n";
            fmt::print("printed 5\nwithout an end 6");
            throw CaseError("it ends 7");
        };
        ::_exit(redirected ? runApplication(
                                 "demo", 1, arguments, "", [](CommandLine&) {}, work, Banner::none)
                           : 2);
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 1);
    std::string reason;
    EXPECT_EQ(readText(log, reason).value_or(reason), "printed 1\na library 2\nstreamed 3\na library 4\nprinted 5\nwithout an end 6"
                                                      "--> FATAL ERROR\nit ends 7\n");
    std::filesystem::remove(log);
}

// -version is one line and needs no case; the head of a log names build, program and case, and stands before all else.
TEST(CommandLine, saysVersionAndBuild)
{
    setVersion({"1.2", "abcdef12"});
    const Demo asked({"-version", "-case", "nowhere"});
    EXPECT_EQ(asked.code, 0) << asked.err;
    EXPECT_EQ(asked.out, "demo 1.2 (abcdef12)\n");
    const Demo ran(
        {"-case", "/"}, [] { fmt::print("work\n"); }, Banner::shown);
    EXPECT_NE(ran.out.find("\nBuild  : 1.2 (abcdef12)\nExec   : demo\nDate   : "), std::string::npos) << ran.out;
    EXPECT_TRUE(ran.out.ends_with("\nCase   : /\n\nwork\n")) << ran.out;
    setVersion({"1.2", ""});
    EXPECT_EQ(Demo({"-version"}).out, "demo 1.2\n");
}
