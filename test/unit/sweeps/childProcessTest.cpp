/// Programs that are run, measured and stopped.
#include "sweeps/ChildProcess.hpp"
#include "TestCase.hpp"
#include "base/CaseError.hpp"
#include <fstream>
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

ProcessTask task(const TestCase& place, std::vector<std::string> command)
{
    ProcessTask t;
    t.command = std::move(command);
    t.folder = place.folder();
    t.log = place.folder() / "log";
    return t;
}

// Arguments reach the program as they are, however a shell would read them; its output reaches the log, its exit code the caller.
TEST(ChildProcess, IsGivenItsArgumentsUnread)
{
    const TestCase place(Files{});
    const auto outcome =
        runProcess(task(place, {"/bin/sh", "-c", "pwd; echo \"$1\"; echo wrong >&2; exit 3", "sh", "$(touch made); a  'b"}));
    EXPECT_EQ(outcome.exitCode, 3);
    EXPECT_FALSE(outcome.well());
    EXPECT_EQ(outcome.inWords(), "exit code 3");
    EXPECT_EQ(place.read("log"), std::filesystem::canonical(place.folder()).string() + "\n$(touch made); a  'b\nwrong\n");
    EXPECT_FALSE(place.has("made"));
}

// A loop that does nothing but count takes as much processor time as wall time, at most; and memory that it touches is counted.
TEST(ChildProcess, IsMeasured)
{
    const TestCase place(Files{});
    auto t = task(place, {"/bin/sh", "-c", "i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done"});
    t.core = usableCores().back();
    const auto outcome = runProcess(t);
    EXPECT_TRUE(outcome.well());
    EXPECT_GT(outcome.cpuSeconds, 0.01);
    EXPECT_LT(outcome.cpuSeconds, outcome.wallSeconds + 0.02); // the resolution of both clocks
    EXPECT_GT(outcome.peakMemory, 1e5);
}

// A child that does not care for TERM is killed, and what it started as well.
TEST(ChildProcess, EndsAtItsLimit)
{
    const TestCase place(Files{});
    auto t = task(place, {"/bin/sh", "-c", "sleep 60 & sleep 60"});
    t.wallLimit = 0.2;
    const auto outcome = runProcess(t);
    EXPECT_TRUE(outcome.reachedLimit);
    EXPECT_FALSE(outcome.stopped);
    EXPECT_LT(outcome.wallSeconds, 5);

    t.command = {"/bin/sh", "-c", "trap '' TERM; while :; do sleep 0.1; done"};
    const auto stubborn = runProcess(t);
    EXPECT_TRUE(stubborn.reachedLimit);
    EXPECT_EQ(stubborn.signal, 9);

    t.wallLimit.reset();
    t.command = {"/bin/sh", "-c", "sleep 60"};
    t.goOn = [] { return false; };
    EXPECT_TRUE(runProcess(t).stopped);
}

TEST(ChildProcess, SaysWhyItCannotStart)
{
    const TestCase place(Files{{"noProgram", "text"}});
    EXPECT_THROW(runProcess(task(place, {(place.folder() / "noProgram").string()})), CaseError);
    auto t = task(place, {"/bin/true"});
    t.folder /= "nowhere";
    t.log = place.folder() / "log";
    EXPECT_THROW(runProcess(t), CaseError);
    EXPECT_TRUE(findProgram("sh"));
    EXPECT_FALSE(findProgram("no such program; true"));
    EXPECT_FALSE(findProgram((place.folder() / "noProgram").string()));
}

}
}
