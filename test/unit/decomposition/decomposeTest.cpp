/// Particles divided into folders and put together again, and what is found out of folders that do not belong together.
#include "decomposition/decompose.hpp"
#include "case/RunTime.hpp"
#include "decomposition/processorFolders.hpp"
#include "temporaryCase.hpp"
#include <algorithm>
#include <gtest/gtest.h>

using namespace sph;

namespace
{
constexpr int particles = 20;

/// Twenty particles in a row, at the times 0 and 0.5.
struct Row : TemporaryCase
{
    explicit Row(const std::string& parts = "3")
    {
        write("constant/geometry", "dimension 2; domain { min (0 0 0); max (20 1 0); }");
        write("system/decomposeParDict", "numberOfSubdomains " + parts + ";\n");
        for (const auto* time : {"0", "0.5"}) writeTime(time, std::stod(time));
    }
    void writeTime(const std::string& time, double shift) const
    {
        std::vector<double> x, y(particles, 0.5), U, phase;
        for (int i = 0; i < particles; ++i)
        {
            x.push_back(i + shift);
            U.push_back(0.1 * i);
            phase.push_back(i % 2);
        }
        writeCloud(folder() / time, "sph", particles, {"positions", FieldClass::vector, {x.data(), y.data(), nullptr}},
                   {{"U", FieldClass::vector, {U.data(), y.data(), nullptr}}, {"phase", FieldClass::label, {phase.data()}}}, {});
        write(time + "/uniform/time", "value " + time + ";\nindex 7;\n");
        write(time + "/uniform/sphState", "densityScale 1.25;\n");
    }
    auto divide(const std::vector<std::string>& times = {"0"}) const
    {
        const Case c(folder());
        return decompose(c, times, readDecomposition(c), {});
    }
    auto together(const std::string& time) const { return reconstruct(Case(folder()), time, {}); }
    Cloud read(const std::string& time) const
    {
        Diagnostics mistakes;
        auto cloud = readCloud(folder(), time, "sph", mistakes);
        mistakes.throwIfAny();
        return cloud;
    }
    std::string wrong() const
    {
        return messageOf([&] { processorTimes(Case(folder())); });
    }
};

TEST(Decompose, GivesEachFolderItsPartAndTheMeshOfTheWhole)
{
    const Row row;
    EXPECT_EQ(row.divide({"0", "0.5"}), (std::vector<std::vector<std::size_t>>{{6, 7, 7}, {6, 7, 7}}));
    EXPECT_EQ(countProcessorFolders(row.folder()), 3);
    int first = 0;
    for (int part = 0; part < 3; ++part)
    {
        const auto at = processorFolder(part) + "/";
        for (const auto* file : {"points", "faces", "owner", "neighbour", "boundary"})
            EXPECT_TRUE(row.has(at + "constant/polyMesh/" + file));
        EXPECT_FALSE(row.has(at + "processor" + std::to_string(part) + ".foam"));
        EXPECT_EQ(row.TemporaryCase::read(at + "0/uniform/sphState"), "densityScale 1.25;\n");
        const auto cloud = row.read(at + "0.5");
        ASSERT_EQ(cloud.size(), part == 0 ? 6u : 7u);
        for (std::size_t i = 0; i < cloud.size(); ++i, ++first)
        {
            EXPECT_EQ(cloud.x[i], first + 0.5);
            EXPECT_EQ(cloud.fields.at("U").component[0][i], 0.1 * first);
            EXPECT_EQ(cloud.fields.at("phase").component[0][i], first % 2);
        }
        EXPECT_FALSE(cloud.fields.contains("origId"));
    }
    EXPECT_EQ(first, particles);
    EXPECT_EQ(processorTimes(Case(row.folder())), (std::vector<std::string>{"0", "0.5"}));
    EXPECT_EQ(dividedTimes(Case(row.folder())), (std::vector<std::string>{"0", "0.5"}));
}

// To the last bit, by particle: each is found by its place.
TEST(Reconstruct, BringsBackWhatWasDivided)
{
    for (const auto* method : {"rcb", "rib", "hilbert"})
    {
        const Row row;
        row.write("system/decomposeParDict", std::string("numberOfSubdomains 4; method ") + method + ";\n");
        row.divide({"0.5"});
        std::filesystem::remove_all(row.folder() / "0.5");
        EXPECT_TRUE(dividedTimes(Case(row.folder())).empty());
        EXPECT_EQ(row.together("0.5"), std::size_t(particles));
        const auto cloud = row.read("0.5");
        ASSERT_EQ(cloud.size(), std::size_t(particles));
        std::vector<int> seen(particles, 0);
        for (std::size_t i = 0; i < cloud.size(); ++i)
        {
            const int k = int(cloud.x[i]);
            ++seen.at(std::size_t(k));
            EXPECT_EQ(cloud.x[i], k + 0.5);
            EXPECT_EQ(cloud.fields.at("U").component[0][i], 0.1 * k);
        }
        EXPECT_EQ(seen, std::vector(particles, 1));
        EXPECT_EQ(row.TemporaryCase::read("0.5/uniform/time"), "value 0.5;\nindex 7;\n");
        EXPECT_EQ(row.TemporaryCase::read("0.5/uniform/sphState"), "densityScale 1.25;\n");
    }
}

TEST(Decompose, RunningLabelsiclesWhereLabelsAreAskedFor)
{
    const Row row;
    row.write("system/sphSchemes", "shown (origId origProcId);\n");
    row.divide();
    const auto cloud = row.read("processor2/0");
    EXPECT_EQ(cloud.fields.at("origId").component[0], (std::vector<double>{13, 14, 15, 16, 17, 18, 19}));
    EXPECT_EQ(cloud.fields.at("origProcId").component[0], std::vector<double>(7, 0.0));
}

TEST(Decompose, RefusesMorePartsThanParticles)
{
    const Row row("21");
    EXPECT_EQ(messageOf([&] { row.divide(); }), "system/decomposeParDict: 21 parts for the 20 particles of 0/lagrangian/sph: take fewer");
    EXPECT_EQ(countProcessorFolders(row.folder()), 0);
}

TEST(Decompose, RemovesNothingUntilAllHasBeenRead)
{
    const Row row;
    row.write("processor0/1/lagrangian/sph/positions", "");
    EXPECT_NE(messageOf([&] { row.divide({"0", "7"}); }).find("7/lagrangian/sph/positions"), std::string::npos);
    EXPECT_TRUE(row.has("processor0/1/lagrangian/sph/positions"));
    row.divide();
    EXPECT_FALSE(row.has("processor0/1"));
}

// The last part has a number that no label can hold.
TEST(Decompose, WritesAllFoldersOrNone)
{
    const Row row;
    std::string values;
    for (int i = 0; i < particles; ++i) values += i + 1 < particles ? "1\n" : "3000000000\n";
    row.write("0/lagrangian/sph/big", "FoamFile { version 2.0; format ascii; class labelField; object big; }\n20\n(\n" + values + ")\n");
    EXPECT_NE(messageOf([&] { row.divide(); }).find("is not a label"), std::string::npos);
    for (const auto& entry : std::filesystem::directory_iterator(row.folder()))
        EXPECT_FALSE(entry.path().filename().string().starts_with("processor")) << entry.path();
}

TEST(ProcessorFolders, ThatAreLostAreMissed)
{
    const Row row;
    EXPECT_NE(row.wrong().find("processor0: is missing: the case has not been decomposed"), std::string::npos) << row.wrong();
    row.divide();
    EXPECT_EQ(row.wrong(), "");
    std::filesystem::rename(row.folder() / "processor1", row.folder() / "away");
    EXPECT_NE(row.wrong().find("processor1: is missing, and processor2 is there"), std::string::npos) << row.wrong();
    std::filesystem::rename(row.folder() / "away", row.folder() / "processor1");
    std::filesystem::remove_all(row.folder() / "processor2");
    EXPECT_NE(row.wrong().find("system/decomposeParDict:1: numberOfSubdomains is 3, and the case has 2 processor folders"),
              std::string::npos)
        << row.wrong();
    std::filesystem::remove(row.folder() / "system/decomposeParDict");
    EXPECT_NE(row.wrong().find("processor0/constant/decomposition: is of one of 3 folders, and the case has 2"), std::string::npos)
        << row.wrong();
}

TEST(ProcessorFolders, ThatDoNotBelongTogetherAreFoundOut)
{
    const Row row, other;
    row.divide();
    other.writeTime("0", 0.25);
    other.divide();
    std::filesystem::remove_all(row.folder() / "processor1");
    std::filesystem::copy(other.folder() / "processor1", row.folder() / "processor1", std::filesystem::copy_options::recursive);
    EXPECT_NE(row.wrong().find("processor1/constant/decomposition: is of another decomposition than that of processor0"), std::string::npos)
        << row.wrong();
    row.divide();
    std::filesystem::rename(row.folder() / "processor1", row.folder() / "away");
    std::filesystem::rename(row.folder() / "processor2", row.folder() / "processor1");
    std::filesystem::rename(row.folder() / "away", row.folder() / "processor2");
    EXPECT_NE(row.wrong().find("processor1/constant/decomposition: is that of processor2"), std::string::npos) << row.wrong();
    row.divide();
    std::filesystem::remove(row.folder() / "processor2/constant/decomposition");
    EXPECT_NE(row.wrong().find("processor2/constant/decomposition: is missing: the folder is none of decomposeParticles"),
              std::string::npos)
        << row.wrong();
}

TEST(Reconstruct, RefusesTimesThatDoNotBelongTogether)
{
    const Row row;
    const auto wrong = [&](const std::string& time) { return messageOf([&] { row.together(time); }); };
    row.divide({"0", "0.5"});
    std::filesystem::remove_all(row.folder() / "processor1/0.5");
    EXPECT_NE(wrong("0.5").find("processor1/0.5: is missing, and others have that time"), std::string::npos) << wrong("0.5");
    row.divide({"0", "0.5"});
    row.write("processor2/0.5/uniform/time", "value 0.5;\nindex 8;\n");
    EXPECT_NE(wrong("0.5").find("processor2/0.5/uniform/time: differs from processor0/0.5/uniform/time"), std::string::npos)
        << wrong("0.5");
    std::filesystem::remove(row.folder() / "processor1/0/lagrangian/sph/U");
    EXPECT_NE(wrong("0").find("processor1/0/lagrangian/sph/U: is missing"), std::string::npos) << wrong("0");
    EXPECT_EQ(row.read("0.5").size(), std::size_t(particles)) << "what was there stays";
}

// In a folder of its own, and only once all are ready does it get its name.
TEST(PlaceOfARank, HasItsTimesInItsFolder)
{
    const Row row;
    row.write("system/controlDict",
              "startFrom latestTime; stopAt endTime; endTime 2; deltaT 0.5; adjustTimeStep no; writeControl timeStep; "
              "writeInterval 1;\n");
    row.divide({"0", "0.5"});
    const Case c(row.folder());
    RunTime time(c, {"processor1", {"0"}});
    EXPECT_EQ(time.startFolder(), "processor1/0") << "0.5 does not count";
    EXPECT_EQ(time.restored().at("densityScale"), 1.25);
    std::vector<std::string> seen;
    time.useBarrier(
        [&]
        {
            for (const auto* name : {"0.5.partial/uniform/time", "0.5/uniform/time"})
                seen.push_back(row.has(std::string("processor1/") + name) ? row.TemporaryCase::read(std::string("processor1/") + name)
                                                                          : "");
        });
    time.advance(0.5);
    time.write([](const auto&) {}, {});
    ASSERT_EQ(seen.size(), 4u);
    EXPECT_NE(seen[0].find("index           8;"), std::string::npos);
    EXPECT_EQ(seen[1], "value 0.5;\nindex 7;\n") << "that of before";
    EXPECT_EQ(seen[2], "");
    EXPECT_EQ(seen[3], seen[0]);
    EXPECT_EQ(row.TemporaryCase::read("0.5/uniform/time"), "value 0.5;\nindex 7;\n") << "that of the case";
}

}
