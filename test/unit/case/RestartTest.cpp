#include "case/RunTime.hpp"
#include "temporaryCase.hpp"
#include <gtest/gtest.h>
#include <random>

namespace sph
{

namespace
{

struct Step
{
    double value, deltaT;
    long index;
    std::string written;
    friend bool operator==(const Step&, const Step&) = default;
};

/// A stability limit that is what a flow's would be: known from the state alone, here from the exact time, and anything from 1e-4 to 1e-2.
double limitAt(double time)
{
    std::mt19937_64 random(std::bit_cast<std::uint64_t>(time));
    return std::pow(10.0, std::uniform_real_distribution<double>(-4, -2)(random));
}

void control(const TemporaryCase& c, const std::string& endTime, const std::string& rest)
{
    c.write("system/controlDict", "startFrom latestTime; endTime " + endTime + ";\n" + rest);
}

/// Runs from the latest time to the end, or for a number of steps with a write at the last, as after a signal.
std::vector<Step> run(const TemporaryCase& c, int mostSteps = 1 << 30)
{
    const Case theCase(c.folder());
    RunTime time(theCase);
    theCase.diagnostics().throwIfAny();
    std::vector<Step> steps;
    while (time.running())
    {
        time.advance(time.nextDeltaT(limitAt(time.value())));
        if (--mostSteps == 0) time.stopNow();
        steps.push_back({time.value(), time.deltaT(), time.index(), time.writeTime() ? time.name() : ""});
        if (time.writeTime()) time.write([](const auto&) {}, {{"time", time.value()}});
    }
    return steps;
}

/// Whole, and in two parts: both lists of steps, which must be equal to the last bit. `stopStep` 0: the first part ends at `middle`.
void expectSameSteps(const std::string& middle, int stopStep, const std::string& end, const std::string& rest)
{
    const TemporaryCase whole, parts;
    for (const auto* c : {&whole, &parts}) std::filesystem::create_directories(c->folder() / "0");
    control(whole, end, rest);
    const auto uninterrupted = run(whole);
    control(parts, stopStep ? end : middle, rest);
    auto steps = stopStep ? run(parts, stopStep) : run(parts);
    ASSERT_LT(steps.size(), uninterrupted.size());
    const auto stopped = steps.size() - 1;
    control(parts, end, rest);
    const auto second = run(parts);
    steps.insert(steps.end(), second.begin(), second.end());
    // The extra write of the stop is no difference of the run.
    if (uninterrupted[stopped].written.empty()) steps[stopped].written.clear();
    ASSERT_EQ(steps.size(), uninterrupted.size());
    for (std::size_t k = 0; k < steps.size(); ++k) ASSERT_TRUE(steps[k] == uninterrupted[k]) << "step " << k << " time " << steps[k].value;
}

}

// Equal to the last bit, hence no tolerance. The folder's name has fewer digits than the time: going on from it would show at once. The
// limits are those of a flow (pseudo-random over two decades), about 1000 steps a run. A write interval of 0.1 has no exact double: 3*0.1
// is not 0.3, where the first part ends.
TEST(Restart, takesTheStepsOfARunThatWasNotStopped)
{
    const std::string adjustable = "writeControl adjustable; writeInterval 0.1;";
    expectSameSteps("0.3", 0, "2", adjustable);
    expectSameSteps("0.7", 0, "2", adjustable);
    for (const int stopStep : {1, 137, 500}) expectSameSteps("", stopStep, "2", adjustable);
    for (const int stopStep : {1, 137, 500}) expectSameSteps("", stopStep, "2", "writeControl runTime; writeInterval 0.1;");
    for (const int stopStep : {1, 137, 500}) expectSameSteps("", stopStep, "2", "writeControl timeStep; writeInterval 50;");
    for (const int stopStep : {1, 137, 500})
        expectSameSteps("", stopStep, "0.7", "writeControl runTime; writeInterval 0.1; adjustTimeStep no; deltaT 7e-4;");
    expectSameSteps("", 137, "2", adjustable + " maxDeltaT 3e-3; timePrecision 3;");
}

// From 10^5 s on 6 digits do not tell the times of two writes apart: each has a folder of its own, called by the time exactly, from which a
// run that names it, or takes the latest, goes on as the one that was not stopped, to the last bit.
TEST(Restart, findsLateTimesByTheirNames)
{
    const auto written = [](const TemporaryCase& c, const std::string& end, const std::string& from)
    {
        control(c, end, "writeControl adjustable; writeInterval 0.25; maxDeltaT 0.07; " + from);
        return run(c);
    };
    const TemporaryCase whole, parts;
    for (const auto* c : {&whole, &parts}) std::filesystem::create_directories(c->folder() / "99999.5");
    auto uninterrupted = written(whole, "100002", "startFrom startTime; startTime 99999.5;");
    EXPECT_EQ(Case(whole.folder()).times(), (std::vector<std::string>{"99999.5", "99999.75", "100000", "100000.25", "100000.5", "100000.75",
                                                                      "100001", "100001.25", "100001.5", "100001.75", "100002"}));
    auto steps = written(parts, "100000.75", "startFrom startTime; startTime 99999.5;");
    for (const auto& part : {written(parts, "100001.25", "startFrom startTime; startTime 100000.75;"), written(parts, "100002", "")})
        steps.insert(steps.end(), part.begin(), part.end());
    EXPECT_TRUE(steps == uninterrupted);
}

TEST(Restart, givesBackTheExactNumbers)
{
    const TemporaryCase c;
    std::filesystem::create_directories(c.folder() / "0");
    control(c, "1", "writeControl none;");
    const Histories histories{{"growth.0.0", {0.1 + 0.2, -1e-300, 3}}, {"fill.fillTime", {7}}};
    const StateNumbers state{{"inletVolume", 0.1 + 0.2}, {"shift", -1e-300}, {"steps", 12345678901234567.0}};
    {
        RunTime time{Case(c.folder())};
        EXPECT_TRUE(time.restored().empty());
        time.advance(1.0 / 3);
        EXPECT_EQ(time.name(), "0.333333");
        time.write([](const auto&) {}, state, histories);
    }
    const Case theCase(c.folder());
    const RunTime time(theCase);
    EXPECT_EQ(messages(theCase.diagnostics()), "");
    EXPECT_EQ(time.restoredHistories(), histories);
    EXPECT_EQ(time.startName(), "0.33333333333");
    EXPECT_EQ(time.value(), 1.0 / 3);
    EXPECT_EQ(time.startTime(), 1.0 / 3);
    EXPECT_EQ(time.index(), 1);
    EXPECT_EQ(time.deltaT(), 1.0 / 3);
    EXPECT_EQ(time.restored(), state);
}

// The packed bed of one run copied to the start of the next.
TEST(Restart, fromAFolderCopiedToAnotherTimeBeginsAfresh)
{
    const TemporaryCase c;
    control(c, "1", "");
    c.write("0/uniform/time", "value 0.5;\nname \"0.5\";\nindex 7;\ndeltaT 0.1;\n");
    c.write("0/uniform/sphState", "inletVolume 3;\n");
    const Case theCase(c.folder());
    const RunTime time(theCase);
    EXPECT_EQ(messages(theCase.diagnostics()), "");
    EXPECT_EQ(theCase.diagnostics().warnings(),
              std::vector<std::string>{"0/uniform/time:1: value 0.5 does not belong to a folder named 0: the run starts afresh at 0"});
    EXPECT_EQ(time.value(), 0);
    EXPECT_EQ(time.index(), 0);
    EXPECT_TRUE(time.restored().empty());
}

TEST(Restart, refusesToKeepNumbersThatAreNone)
{
    const TemporaryCase c;
    std::filesystem::create_directories(c.folder() / "0");
    control(c, "1", "");
    RunTime time{Case(c.folder())};
    time.advance(0.1);
    EXPECT_EQ(messageOf([&] { time.write([](const auto&) {}, {{"energy", 1.0 / 0.0}}); }), "energy is inf: a run cannot restart from that");
    EXPECT_FALSE(c.has("0.1"));
}

}
