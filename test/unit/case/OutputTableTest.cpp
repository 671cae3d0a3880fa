#include "case/OutputTable.hpp"
#include "temporaryCase.hpp"
#include <gtest/gtest.h>

namespace sph
{

// OpenFOAM's layout, a line for each column that has a meaning, and each row on disk before the next one is computed.
TEST(OutputTable, hasOpenFoamsLayoutAndIsFlushedRowByRow)
{
    const TemporaryCase c;
    OutputTable table(c.folder() / "energy.dat", {"Energies of the fluid"}, {{"kinetic", "J", "sum m U^2/2"}, {"momentum", "", ""}});
    const std::string head = "# Energies of the fluid\n# kinetic [J]: sum m U^2/2\n# Time\tkinetic\tmomentum\n";
    EXPECT_EQ(c.read("energy.dat"), head);
    table.row(0.1, std::vector<double>{0.1 + 0.2, -1e-300});
    EXPECT_EQ(c.read("energy.dat"), head + "0.1\t0.30000000000000004\t-1e-300\n");
    table.row(1, std::vector<std::string>{cell(5), cell(Vector<3>{1, -0.5, 0})});
    EXPECT_EQ(c.read("energy.dat"), head + "0.1\t0.30000000000000004\t-1e-300\n1\t5\t(1 -0.5 0)\n");
}

TEST(Column, isNamedByWhatItIsOf)
{
    const Column velocity{"superficial_<phase>", "m/s", ""}, area{"<phase>.area", "m^2", ""}, section{"section<n>_<phase>", "m/s", ""};
    EXPECT_EQ(velocity.of("water").name, "superficial_water");
    EXPECT_EQ(velocity.of("").name, "superficial");
    EXPECT_EQ(area.of("water").name, "water.area");
    EXPECT_EQ(area.of("").name, "area");
    EXPECT_EQ(section.of("2").of("air").name, "section2_air");
}

TEST(OutputTable, namesFileAndReasonOfAFailure)
{
    EXPECT_EQ(messageOf([] { OutputTable("/dev/full", {}, {{"a", "", ""}}); }), "/dev/full: cannot be written: No space left on device");
    EXPECT_EQ(messageOf(
                  [] {
                      OutputTable("/no/such/folder", {}, {{"a", "", ""}});
                  }),
              "/no/such/folder: cannot be written: No such file or directory");
}

// A buffer that is flushed in the middle of a number or a text loses nothing: more than its size of 1 MB, in pieces of all lengths.
TEST(OutputFile, keepsOrderAcrossItsBuffer)
{
    const TemporaryCase c;
    OutputFile file(c.folder() / "long");
    std::string expected;
    for (int k = 0; expected.size() < 5000000; ++k)
    {
        const std::string text(std::size_t(k) * 31 % 3000, char('a' + k % 26));
        file.write(text);
        file.write(std::int64_t(k));
        expected += text + std::to_string(k);
    }
    const std::string huge(3000000, 'z');
    file.write(huge);
    file.close();
    EXPECT_TRUE(c.read("long") == expected + huge);
}

}
