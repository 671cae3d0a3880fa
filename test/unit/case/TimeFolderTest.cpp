#include "SmallDisk.hpp"
#include "base/OutputFile.hpp"
#include "case/RunTime.hpp"
#include "temporaryCase.hpp"
#include <gtest/gtest.h>

namespace sph
{

namespace
{

/// A run that stands at time 0.5, of a case in this folder.
RunTime runIn(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder / "system");
    std::filesystem::create_directories(folder / "0");
    writeFile(folder / "system" / "controlDict", "endTime 1;\n");
    RunTime time{Case(folder)};
    time.advance(0.5);
    return time;
}

std::vector<std::string> entriesOf(const std::filesystem::path& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

using Names = std::vector<std::string>;

}

// While it is filled the folder is no time, and its former contents stand; afterwards it has the new ones alone.
TEST(TimeFolder, comesToBeAtOnce)
{
    const TemporaryCase c;
    auto time = runIn(c.folder());
    c.write("0.5/former", "");
    time.write(
        [&](const std::filesystem::path& folder)
        {
            EXPECT_EQ(folder, c.folder() / "0.5.partial");
            EXPECT_EQ(Case(c.folder()).times(), (Names{"0", "0.5"}));
            EXPECT_TRUE(c.has("0.5/former"));
            writeFile(folder / "now", "");
        },
        {});
    EXPECT_EQ(entriesOf(c.folder() / "0.5"), (Names{"now", "uniform"}));
    EXPECT_EQ(entriesOf(c.folder()), (Names{"0", "0.5", "system"}));
}

TEST(TimeFolder, thatCannotBeFilledIsNotThere)
{
    const TemporaryCase c;
    auto time = runIn(c.folder());
    const auto fail = [](const std::filesystem::path& folder)
    {
        writeFile(folder / "U", "half of it");
        throw CaseError("no more");
    };
    EXPECT_EQ(messageOf([&] { time.write(fail, {}); }), "no more");
    EXPECT_EQ(entriesOf(c.folder()), (Names{"0", "system"}));
    // Nor is a former one of that name touched.
    c.write("0.5/former", "");
    EXPECT_EQ(messageOf([&] { time.write(fail, {}); }), "no more");
    EXPECT_EQ(entriesOf(c.folder()), (Names{"0", "0.5", "system"}));
    EXPECT_EQ(entriesOf(c.folder() / "0.5"), Names{"former"});
}

TEST(TimeFolder, leftPartialByAKilledRunIsRemovedAtTheFirstWrite)
{
    const TemporaryCase c;
    c.write("0.25.partial/lagrangian/sph/U", "half of it");
    auto time = runIn(c.folder());
    EXPECT_EQ(Case(c.folder()).times(), Names{"0"});
    time.write([](const auto&) {}, {});
    EXPECT_EQ(entriesOf(c.folder()), (Names{"0", "0.5", "system"}));
}

// A real full disk, 128 kB small: the last good time stays whole, the failed one is not there, and after making room the run goes on.
TEST(TimeFolder, onAFullDiskLeavesTheLastGoodTimeWhole)
{
    const test::SmallDisk disk("128k");
    if (!disk.mounted()) GTEST_SKIP() << test::SmallDisk::notPermitted;
    const auto& folder = disk.folder();
    auto time = runIn(folder);
    const std::vector<double> x(1000, 0.25), many(100000, 0.25);
    const auto filler = [](const std::vector<double>& values)
    {
        return [&values](const std::filesystem::path& where)
        {
            const auto* p = values.data();
            writeCloud(where, "sph", values.size(), {"positions", FieldClass::vector, {p, p, p}}, {}, {WriteFormat::binary, 0});
        };
    };
    time.write(filler(x), {});
    time.advance(0.25);
    EXPECT_EQ(messageOf([&] { time.write(filler(many), {}); }),
              (folder / "0.75.partial/lagrangian/sph/positions").string() + ": cannot be written: No space left on device");
    EXPECT_EQ(entriesOf(folder), (Names{"0", "0.5", "system"}));
    Diagnostics diagnostics;
    EXPECT_EQ(readCloud(folder, "0.5", "sph", diagnostics).x, x);
    EXPECT_EQ(messages(diagnostics), "");
    time.write(filler(x), {});
    EXPECT_EQ(readCloud(folder, "0.75", "sph", diagnostics).x, x);
}

// Entries that OpenFOAM's own tools look for in <time>/uniform/time.
TEST(TimeFolder, holdsOpenFoamsTimeDictionary)
{
    const TemporaryCase c;
    auto time = runIn(c.folder());
    time.write([](const auto&) {}, {{"mass", 0.1}});
    EXPECT_EQ(c.read("0.5/uniform/time"),
              "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n    location    "
              "\"0.5/uniform\";\n"
              "    object      time;\n}\n\nvalue           0.5;\nname            \"0.5\";\nindex           1;\n"
              "deltaT          0.5;\ndeltaT0         0.5;\n");
    const auto state = c.read("0.5/uniform/sphState");
    EXPECT_EQ(state.substr(state.find("}\n\n")), "}\n\nmass 0.1;\n");
}

}
