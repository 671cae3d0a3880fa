#include "case/RunTime.hpp"
#include "base/OutputFile.hpp"
#include "temporaryCase.hpp"
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace sph
{

namespace
{

const std::string timeHeader = "FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }\n";

void control(const TemporaryCase& c, const std::string& text) { c.write("system/controlDict", timeHeader + text); }

void makeTime(const TemporaryCase& c, const std::string& name) { std::filesystem::create_directories(c.folder() / name); }

void write(RunTime& time, const StateNumbers& state = {})
{
    time.write([](const auto&) {}, state);
}

/// All that is said of this controlDict, with time folders 0, 0.5 and 1.
std::string saidOf(const std::string& text)
{
    const TemporaryCase c;
    control(c, text);
    for (const auto* name : {"0", "0.5", "1", "0.orig", "2.partial", "constant"}) makeTime(c, name);
    const Case theCase(c.folder());
    const RunTime time(theCase);
    return messages(theCase.diagnostics());
}

/// A run from 0 under this controlDict and a constant limit: the names of the times written.
std::vector<std::string> timesWritten(const std::string& text, double limit)
{
    const TemporaryCase c;
    control(c, text);
    makeTime(c, "0");
    const Case theCase(c.folder());
    RunTime time(theCase);
    theCase.diagnostics().throwIfAny();
    std::vector<std::string> names;
    while (time.running())
    {
        time.advance(time.nextDeltaT(limit));
        if (!time.writeTime()) continue;
        names.push_back(time.name());
        write(time);
    }
    return names;
}

using Names = std::vector<std::string>;

}

TEST(Case, namesAFolderThatIsNotThere)
{
    const TemporaryCase c;
    c.write("file", "");
    const auto folder = c.folder().string();
    EXPECT_EQ(messageOf([&] { Case(c.folder() / "no"); }), "case folder \"" + folder + "/no\" does not exist");
    EXPECT_EQ(messageOf([&] { Case(c.folder() / "file"); }), "case \"" + folder + "/file\" is not a folder");
}

// By value, as they stand on disk: what is no number, or a file, is no time.
TEST(Case, listsItsTimes)
{
    const TemporaryCase c;
    for (const auto* name : {"10", "9", "0.orig", "1e-05", "0", "0.5.partial", "nan", "inf", "0x1", "constant", "-1"}) makeTime(c, name);
    c.write("7", "");
    EXPECT_EQ(Case(c.folder()).times(), (Names{"-1", "0", "1e-05", "9", "10"}));
}

TEST(RunTime, startsWhereControlDictSays)
{
    const auto startOf = [](const std::string& text)
    {
        const TemporaryCase c;
        control(c, text + " endTime 2;");
        for (const auto* name : {"0.1", "0.5", "1"}) makeTime(c, name);
        const Case theCase(c.folder());
        const RunTime time(theCase);
        EXPECT_EQ(messages(theCase.diagnostics()), "");
        return time.startName();
    };
    EXPECT_EQ(startOf("startFrom firstTime;"), "0.1");
    EXPECT_EQ(startOf("startFrom startTime; startTime 0.5;"), "0.5");
    EXPECT_EQ(startOf("startFrom latestTime;"), "1");
    EXPECT_EQ(startOf(""), "1");
}

TEST(RunTime, namesWhatIsWrong)
{
    EXPECT_EQ(saidOf("startFrom startTime; startTime 0.33;\nendTime 1;"),
              "system/controlDict:2: there is no time folder 0.33. Times: 0, 0.5, 1.");
    EXPECT_EQ(saidOf("endTime 1; writeControl timeStep;\nwriteInterval 1.5;"),
              "system/controlDict:3: writeInterval must be a number of steps, found 1.5");
    // The run may start there too: how many folders it would make is not known.
    EXPECT_EQ(
        saidOf("endTime 1e9; writeControl runTime;\nwriteInterval 0.25;"),
        "system/controlDict:3: writeInterval 0.25 s is less than 1e-09 of endTime 1000000000 s: moments so close to one another are lost in "
        "the rounding of time; give a longer interval, or count time from nearer to 0");
    EXPECT_EQ(saidOf("endTime 1;\npurgeWrite -1;"), "system/controlDict:3: purgeWrite must not be negative, found -1");
    EXPECT_EQ(saidOf("endTime 1;\nwritePrecision 30;"), "system/controlDict:3: writePrecision must be 1 to 17 digits, found 30");
    EXPECT_EQ(
        saidOf("endTime 1;\nwriteInterval 0.1;"),
        "system/controlDict:3: writeInterval does nothing without writeControl, which says what it counts: give `writeControl adjustable` for "
        "seconds that steps are fitted to, or leave it out");
    EXPECT_EQ(saidOf("endTime 1;\ndeltaT 0.1;").substr(0, 58), "system/controlDict:3: without adjustTimeStep the limits of");
    EXPECT_EQ(saidOf("endTime 1; adjustTimeStep no; deltaT 0.1;\nmaxDeltaT 1;"),
              "system/controlDict:3: maxDeltaT does nothing with `adjustTimeStep no`: steps are deltaT; leave it out");
    EXPECT_EQ(
        saidOf("endTime 1;\npurgeWrite 2;"),
        "system/controlDict:3: purgeWrite does nothing without writeControl: the end of the run is all that is written; leave it out");
    EXPECT_EQ(saidOf("endTime 1; writeFormat binary;\nwritePrecision 12;"),
              "system/controlDict:3: writePrecision does nothing with `writeFormat binary`, which keeps all digits; leave it out");
    EXPECT_EQ(saidOf("endTime 1;\ntimePrecision 0;"), "system/controlDict:3: timePrecision must be 1 to 17 digits, found 0");
    for (const auto* wrong :
         {"stopAt endTme;", "stopAt endTime;", "endTime 1; writeControl runTimee;", "endTime 1; adjustTimeStep no;",
          "endTime 1; writeControl runTime;", "endTime 1; writeControl runTime; writeInterval 0;",
          "endTime 1; adjustTimeStep yes; deltaT -1;", "endTime 1; writeFormat text;", "endTime 1; writeCompression on;",
          "endTime 1; timeFormat short;", "endTime nan;", "startFrom startTime; endTime 1;"})
        EXPECT_NE(saidOf(wrong).find("system/controlDict"), std::string::npos) << wrong;
}

// An OpenFOAM user's controlDict, word for word: nothing is said.
TEST(RunTime, acceptsWhatOpenFoamAccepts)
{
    const TemporaryCase c;
    control(c, "application sphFoamLike; startFrom latestTime; startTime 0; stopAt endTime; endTime 1; deltaT 0.005;\n"
               "writeControl adjustableRunTime; writeInterval 0.1; purgeWrite 0; writeFormat ascii; writePrecision 17;\n"
               "writeCompression off; timeFormat general; timePrecision 6; runTimeModifiable true; adjustTimeStep yes;\n"
               "maxDeltaT 1; libs (\"x.so\"); functions { probes { type probes; } }\n");
    makeTime(c, "0");
    const Case theCase(c.folder());
    const RunTime time(theCase);
    time.controlDict().reportUnused();
    EXPECT_EQ(messages(theCase.diagnostics()), "");
    EXPECT_TRUE(theCase.diagnostics().warnings().empty());
    EXPECT_EQ(time.writeOptions().precision, 17);
    EXPECT_EQ(time.endTime(), 1);
}

TEST(RunTime, warnsOfDigitsThatARestartWillMiss)
{
    const TemporaryCase c;
    control(c, "endTime 1;\nwriteFormat ascii;\nwritePrecision 6;\n");
    makeTime(c, "0");
    const Case theCase(c.folder());
    const RunTime time(theCase);
    ASSERT_EQ(theCase.diagnostics().warnings().size(), 1u);
    EXPECT_EQ(theCase.diagnostics().warnings()[0].substr(0, 38), "system/controlDict:4: 6 digits lose th");
}

TEST(RunTime, copiesTheOriginalFolderWhereThereIsNoTimeZero)
{
    const TemporaryCase c;
    control(c, "endTime 1;");
    c.write("0.orig/lagrangian/sph/positions", "text");
    {
        const Case theCase(c.folder());
        EXPECT_EQ(RunTime(theCase).startName(), "0");
        EXPECT_EQ(messages(theCase.diagnostics()), "");
        EXPECT_EQ(theCase.times(), Names{"0"});
    }
    EXPECT_EQ(c.read("0/lagrangian/sph/positions"), "text");
    // A "0" that is there, and a later time to go on from, are left as they are.
    c.write("0/lagrangian/sph/positions", "mine");
    EXPECT_EQ(RunTime(Case(c.folder())).startName(), "0");
    EXPECT_EQ(c.read("0/lagrangian/sph/positions"), "mine");
    std::filesystem::rename(c.folder() / "0", c.folder() / "0.5");
    EXPECT_EQ(RunTime(Case(c.folder())).startName(), "0.5");
    EXPECT_FALSE(c.has("0"));
}

TEST(RunTime, ofACaseWithoutAnyTimeIsAnError)
{
    const TemporaryCase c;
    control(c, "startFrom latestTime; endTime 1;");
    const Case theCase(c.folder());
    const RunTime time(theCase);
    EXPECT_EQ(messages(theCase.diagnostics()),
              "system/controlDict:2: the case has no time folder to start from, and no folder 0.orig to make one of");
}

// The names are exact, 0.3 and not 0.300001: adjusted steps hit k writeInterval and the end.
TEST(RunTime, writesWhenWriteControlSays)
{
    EXPECT_EQ(timesWritten("endTime 0.55; writeControl adjustable; writeInterval 0.1;", 0.03),
              (Names{"0.1", "0.2", "0.3", "0.4", "0.5", "0.55"}));
    EXPECT_EQ(timesWritten("endTime 1; writeControl timeStep; writeInterval 4; adjustTimeStep no; deltaT 0.1;", 1),
              (Names{"0.4", "0.8", "1"}));
    EXPECT_EQ(timesWritten("endTime 1; writeControl runTime; writeInterval 0.25; adjustTimeStep no; deltaT 0.1;", 1),
              (Names{"0.3", "0.5", "0.8", "1"}));
    EXPECT_EQ(timesWritten("endTime 1; writeControl none; adjustTimeStep no; deltaT 0.1;", 1), Names{"1"});
    EXPECT_EQ(timesWritten("endTime 1; writeControl runTime; writeInterval 0.5;", 0.3), (Names{"0.6", "1.2"}));
}

// A million steps of 1e-3: summed up, the time would be 1.7e-10 off; it is exact.
TEST(RunTime, doesNotAccumulateRoundOffOfFixedSteps)
{
    const TemporaryCase c;
    control(c, "endTime 1000; adjustTimeStep no; deltaT 1e-3; writeControl runTime; writeInterval 100;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    int writes = 0;
    while (time.running())
    {
        time.advance(time.nextDeltaT(1));
        writes += time.writeTime();
    }
    EXPECT_EQ(time.index(), 1000000);
    EXPECT_EQ(time.value(), 1000);
    EXPECT_EQ(writes, 10);
}

// No step above 1.1 times the limit nor above maxDeltaT, none below half of the smaller of the two, except where less is left.
TEST(RunTime, fitsStepsToWriteTimesWithinATenthOfTheLimit)
{
    const TemporaryCase c;
    control(c, "endTime 10; writeControl adjustable; writeInterval 0.1; maxDeltaT 0.05;");
    makeTime(c, "0");
    const RunTime time{Case(c.folder())};
    for (const double limit : {1e-3, 0.0333, 0.048, 0.049, 0.0501, 0.06, 0.09, 0.095, 1.0})
    {
        const double dt = time.nextDeltaT(limit);
        EXPECT_LE(dt, std::min(1.1 * limit, 0.05));
        EXPECT_GE(dt, 0.5 * std::min(limit, 0.05));
    }
}

// With adjustTimeStep deltaT limits the very first step alone, as OpenFOAM begins with it.
TEST(RunTime, takesDeltaTForTheFirstStep)
{
    const TemporaryCase c;
    control(c, "endTime 10; adjustTimeStep yes; deltaT 1e-3;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    EXPECT_EQ(time.nextDeltaT(0.01), 1e-3);
    EXPECT_EQ(time.nextDeltaT(1e-4), 1e-4);
    time.advance(1e-3);
    EXPECT_EQ(time.nextDeltaT(0.01), 0.01);
}

TEST(RunTime, refusesAStepThatIsNone)
{
    const TemporaryCase c;
    control(c, "endTime 1;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    EXPECT_EQ(messageOf([&] { time.nextDeltaT(std::nan("")); }), "at time 0 the limit of the time step is nan");
    EXPECT_EQ(messageOf([&] { time.nextDeltaT(0); }), "at time 0 the limit of the time step is 0");
    EXPECT_EQ(messageOf([&] { time.nextDeltaT(INFINITY); }), "system/controlDict: nothing limits the time step: give maxDeltaT");
    time.advance(0.5);
    EXPECT_EQ(messageOf([&] { time.advance(1e-20); }), "a time step of 1e-20 s is too small to advance time 0.5 s");
}

// Digits are added where timePrecision cannot tell two times apart, and only there.
TEST(RunTime, addsDigitsWhereTwoTimesWouldHaveOneName)
{
    const TemporaryCase c;
    control(c, "endTime 10; timePrecision 3;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    time.advance(1.5);
    EXPECT_EQ(time.name(), "1.5");
    write(time);
    time.advance(0.00001);
    EXPECT_EQ(time.name(), "1.50001");
    write(time);
    EXPECT_EQ(time.name(), "1.50001");
    time.advance(1);
    EXPECT_EQ(time.name(), "2.5");
    EXPECT_EQ(Case(c.folder()).times(), (Names{"0", "1.5", "1.50001"}));
}

// The name of a folder reads back as the time within 1e-10 of the step, however long ago the run began and in each format; a name that its
// round-off alone would make longer stays short.
TEST(RunTime, namesFoldersExactly)
{
    for (const std::string format : {"general", "fixed", "scientific"})
        for (const double start : {0.0, 1.0, 99999.5, 3.15576e7, 1e9})
            for (const double step : {0.25, 0.1, 1.0 / 3, 1.234567e-3})
            {
                const TemporaryCase c;
                makeTime(c, shortestText(start));
                control(c, "startFrom startTime; startTime " + shortestText(start) + "; endTime 1e10; timeFormat " + format + ";");
                RunTime time{Case(c.folder())};
                for (int k = 1; k <= 3; ++k)
                {
                    time.advance(step);
                    write(time);
                    const auto times = Case(c.folder()).times();
                    ASSERT_EQ(times.size(), std::size_t(k + 1)) << start << ' ' << step;
                    EXPECT_NEAR(*timeValue(times.back()), time.value(), std::max(1e-10 * step, 1e-15 * time.value())) << times.back();
                }
            }
    EXPECT_EQ(timesWritten("endTime 0.3; adjustTimeStep no; deltaT 0.1; writeControl timeStep; writeInterval 1;", 1),
              (Names{"0.1", "0.2", "0.3"}));
}

TEST(RunTime, namesTimesInTheFormatAskedFor)
{
    EXPECT_EQ(timesWritten("endTime 0.5; adjustTimeStep no; deltaT 0.5; timeFormat fixed; timePrecision 3;", 1), Names{"0.500"});
    EXPECT_EQ(timesWritten("endTime 0.5; adjustTimeStep no; deltaT 0.5; timeFormat scientific; timePrecision 2;", 1), Names{"5.00e-01"});
    EXPECT_EQ(timesWritten("endTime 1e-5; adjustTimeStep no; deltaT 1e-5;", 1), Names{"1e-05"});
}

// The oldest written by this run goes first; the start and "0" stay.
TEST(RunTime, purgesAllButTheLastWritesAndTheStart)
{
    const TemporaryCase c;
    control(c, "endTime 5; adjustTimeStep no; deltaT 1; writeControl timeStep; writeInterval 1; purgeWrite 2;");
    makeTime(c, "0");
    makeTime(c, "0.5");
    RunTime time{Case(c.folder())};
    while (time.running())
    {
        time.advance(time.nextDeltaT(1));
        if (time.writeTime()) write(time);
    }
    EXPECT_EQ(Case(c.folder()).times(), (Names{"0", "0.5", "3.5", "4.5"}));
}

TEST(RunTime, stopsAtTheNextWriteOrNow)
{
    EXPECT_EQ(timesWritten("stopAt nextWrite; endTime 5; writeControl adjustable; writeInterval 0.4;", 0.15), Names{"0.4"});
    EXPECT_EQ(timesWritten("stopAt writeNow; endTime 5; writeControl adjustable; writeInterval 0.4;", 0.15), Names{"0.15"});
    EXPECT_EQ(timesWritten("stopAt noWriteNow; endTime 5; writeControl adjustable; writeInterval 0.4;", 0.15), Names{});
}

TEST(RunTime, doesNothingWhereTheEndIsReached)
{
    EXPECT_EQ(timesWritten("endTime 0; writeControl adjustable; writeInterval 0.4;", 0.15), Names{});
}

TEST(RunTime, writesAndStopsByTheClock)
{
    const TemporaryCase c;
    control(c, "endTime 100; adjustTimeStep no; deltaT 1; writeControl clockTime; writeInterval 60; maxClockTime 200;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    double wall = 0;
    time.useClocks({[&] { return wall; }, [] { return 0.0; }});
    Names names;
    while (time.running())
    {
        wall += 25;
        time.advance(time.nextDeltaT(1));
        if (time.writeTime()) names.push_back(time.name());
    }
    // At 75, 125, 200 (the third minute has passed at 180) and past 200 s.
    EXPECT_EQ(names, (Names{"3", "5", "8", "9"}));
}

TEST(RunTime, noticesAnEditedControlDictAtOnce)
{
    const TemporaryCase c;
    control(c, "stopAt endTime; endTime 5; writeControl adjustable; writeInterval 0.4;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    EXPECT_EQ(time.rereadIfModified(), "");
    time.advance(time.nextDeltaT(0.1));
    // A mistake half-way through an edit must not end a run of days.
    control(c, "stopAt writNow; endTime 5; writeControl adjustable; writeInterval 0.4;");
    const auto said = time.rereadIfModified();
    EXPECT_EQ(said.substr(0, 101),
              "system/controlDict has changed, but not all of it can be understood. The run goes on as before.\nsyste");
    EXPECT_NE(said.find("writNow"), std::string::npos);
    time.advance(time.nextDeltaT(0.1));
    EXPECT_TRUE(time.running());
    // The edit comes within the second of the former one.
    control(c, "stopAt writeNow; endTime 5; writeControl adjustable; writeInterval 0.4;");
    EXPECT_EQ(time.rereadIfModified(), "system/controlDict has changed: stopAt endTime -> writeNow, endTime 5 -> inf");
    EXPECT_EQ(time.rereadIfModified(), "");
    EXPECT_TRUE(time.running());
    time.advance(time.nextDeltaT(0.1));
    EXPECT_FALSE(time.running());
    EXPECT_TRUE(time.writeTime());
}

// Whatever has become of controlDict, a run of days goes on: what would take the stack, the memory or all time ends in words.
TEST(RunTime, survivesAnyControlDict)
{
    const TemporaryCase c;
    control(c, "endTime 5;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    const auto repeated = [](const std::string& text)
    {
        std::string all;
        for (int k = 0; k < 10'000; ++k) all += text;
        return all;
    };
    const auto file = c.folder() / "system/controlDict";
    for (const auto& text : {repeated("a { "), repeated("a ("), "endTime #eval{ " + repeated("(") + " };", repeated("$a "),
                             repeated("\"(a|aa)+b\" 1; $" + std::string(90, 'a') + ";\n")})
    {
        control(c, text);
        EXPECT_EQ(time.rereadIfModified().find(
                      "system/controlDict has changed, but not all of it can be understood. The run goes on as before."),
                  0u)
            << text.substr(0, 40);
        EXPECT_EQ(time.endTime(), 5);
    }
    std::filesystem::remove(file);
    EXPECT_EQ(time.rereadIfModified(), "") << "an editor may be about to write it";
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    EXPECT_NE(time.rereadIfModified().find("system/controlDict: this is a device or a pipe: only regular files are read"),
              std::string::npos);
    std::filesystem::remove(file);
    control(c, "endTime 7;");
    EXPECT_EQ(time.rereadIfModified(), "system/controlDict has changed: endTime 5 -> 7");
}

TEST(RunTime, leavesControlDictAloneWhereItIsNotModifiable)
{
    const TemporaryCase c;
    control(c, "endTime 5; runTimeModifiable no;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    control(c, "endTime 500; runTimeModifiable yes;");
    EXPECT_EQ(time.rereadIfModified(), "");
    EXPECT_EQ(time.endTime(), 5);
}

TEST(RunTime, stopsByASignalAfterAStepThatIsWritten)
{
    const TemporaryCase c;
    control(c, "endTime 5;");
    makeTime(c, "0");
    RunTime time{Case(c.folder())};
    time.advance(0.1);
    EXPECT_FALSE(time.writeTime());
    time.stopNow();
    EXPECT_TRUE(time.writeTime());
    EXPECT_FALSE(time.running());
}

// As OpenFOAM: the file of an earlier run from the same start is kept.
TEST(RunTime, keepsTheOutputOfAnEarlierRun)
{
    const TemporaryCase c;
    control(c, "endTime 5;");
    makeTime(c, "0.5");
    const RunTime time{Case(c.folder())};
    const auto folder = c.folder() / "postProcessing/energy/0.5";
    EXPECT_EQ(time.outputFile("energy", "energy.dat"), folder / "energy.dat");
    c.write("postProcessing/energy/0.5/energy.dat", "former");
    EXPECT_EQ(time.outputFile("energy", "energy.dat"), folder / "energy_0.5.dat");
}

}
