/// Scripts for gnuplot.
#include "sweeps/plots.hpp"
#include "TestCase.hpp"
#include "sweeps/ChildProcess.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

ResultRow made(const std::string& variant, double n, double error, const std::string& status = "ok")
{
    return {.variant = variant,
            .resolution = n,
            .spacing = 1 / n,
            .cpuSeconds = n * n,
            .field = "U",
            .norm = "L2",
            .error = error,
            .status = status};
}

// Quotes in names stay names; rows that logarithmic axes cannot show are left out; a curve of one point is drawn, too. gnuplot, where
// it is installed, draws all four files and nothing else runs.
TEST(Plots, DrawWhatCanBeDrawn)
{
    const Diagram diagram{"errors",
                          "it's a `touch made` title",
                          {made("suite", 8, 0.1), made("suite", 16, 0.025), made("suite", 32, 0.5, "failed"), made("zero", 8, 0),
                           made("one", 8, 0.3)},
                          {made("peer's system('touch made')", 8, 0.2), made("peer's system('touch made')", 16, 0.1)}};
    const auto script = gnuplotScript(diagram);
    EXPECT_NE(script.find("suite, order 2.00"), std::string::npos) << script;
    EXPECT_NE(script.find("peer''s system(''touch made''), order 1.00"), std::string::npos);
    EXPECT_EQ(script.find("zero"), std::string::npos);
    EXPECT_NE(script.find("title 'one'"), std::string::npos);
    EXPECT_EQ(gnuplotScript({"errors", "none", {made("suite", 8, 0.1, "diverged")}, {}}), "");

    const auto gnuplot = findProgram("gnuplot");
    if (!gnuplot) GTEST_SKIP() << "gnuplot is not installed";
    const TestCase place(Files{{"errors.gp", script}});
    ProcessTask task;
    task.command = {gnuplot->string(), "errors.gp"};
    task.folder = place.folder();
    task.log = place.folder() / "log";
    EXPECT_TRUE(runProcess(task).well()) << place.read("log");
    EXPECT_EQ(place.read("log"), "");
    for (const char* kind : {"cpuTime", "spacing"})
    {
        EXPECT_NE(place.read(std::string("errors.") + kind + ".svg").find("</svg>"), std::string::npos);
        EXPECT_EQ(place.read(std::string("errors.") + kind + ".png").substr(1, 3), "PNG");
    }
    EXPECT_FALSE(place.has("made"));
}

}
}
