/// Damaged field files and impossible particles.
#include "refusal.hpp"
#include <array>
#include <unistd.h>

namespace sph::test::fieldFilesTest
{
namespace
{

const std::string cloud = "0.02/lagrangian/sph/";

/// The time folder 0.02 rewritten as text, so that a test can edit numbers; `field` with its line of values.
Damaged inText()
{
    return Damaged(
        []() -> const TestCase&
        {
            static const auto made = firstWriteOf(channelCase(), "ascii");
            return *made;
        }());
}

/// Line `number`, counted from 1, replaced.
void setLine(const TestCase& c, const std::string& file, int number, const std::string& line)
{
    auto text = c.read(file);
    std::size_t begin = 0;
    for (int k = 1; k < number; ++k) begin = text.find('\n', begin) + 1;
    text.replace(begin, text.find('\n', begin) - begin, line);
    c.write(file, text);
}

/// The line of the first value: after the one that is "(" alone.
int firstValue(const TestCase& c, const std::string& file)
{
    const auto text = c.read(file);
    const auto at = text.find("\n(\n");
    return int(std::count(text.begin(), text.begin() + long(at), '\n')) + 3;
}

TEST(FieldFiles, Truncated)
{
    Damaged c;
    for (const char* field : {"U", "positions", "rho"})
    {
        Damaged d;
        const auto text = d.read(cloud + field);
        d.write(cloud + field, text.substr(0, text.size() * 2 / 3));
        d.isRefused("sphFoamLike", {cloud + field});
    }
}

TEST(FieldFiles, Unreadable)
{
    Damaged c;
    c.write(cloud + "U", std::string(1000, '\xff'));
    c.isRefused("sphFoamLike", {cloud + "U"});
    Damaged empty;
    empty.write(cloud + "positions", "");
    empty.isRefused("sphFoamLike", {cloud + "positions"});
    if (geteuid() != 0)
    {
        Damaged closed;
        std::filesystem::permissions(closed.folder() / (cloud + "U"), std::filesystem::perms::none);
        EXPECT_EQ(closed.run("sphFoamLike").code, 1);
    }
}

TEST(FieldFiles, UnequalLengths)
{
    auto c = inText();
    const auto line = firstValue(c, cloud + "U");
    setLine(c, cloud + "U", line - 2, "399");
    setLine(c, cloud + "U", line, "");
    c.isRefused("sphFoamLike", {cloud + "U", "399", "400"});
}

TEST(FieldFiles, NotANumberAndInfinite)
{
    for (const char* value : {"(nan 0 0)", "(0 inf 0)", "(0 -1e999 0)"})
    {
        auto c = inText();
        const int line = firstValue(c, cloud + "U") + 17;
        setLine(c, cloud + "U", line, value);
        c.isRefused("sphFoamLike", {cloud + "U:" + std::to_string(line), "particle 17"});
    }
    auto c = inText();
    setLine(c, cloud + "positions", firstValue(c, cloud + "positions") + 3, "(nan 0.5 0) 0");
    c.isRefused("sphFoamLike", {cloud + "positions:", "particle 3"});
}

// Each file is of one class, and the solver says of which, before it copies a component that is not there.
TEST(FieldFiles, OfAnotherClass)
{
    for (const auto& [field, isClass, other, value] : {std::array{"U", "vectorField", "scalarField", "1"},
                                                       {"U", "vectorField", "labelField", "1"},
                                                       {"U", "vectorField", "symmTensorField", "(1 2 3 4 5 6)"},
                                                       {"m", "scalarField", "vectorField", "(1 2 3)"},
                                                       {"phase", "labelField", "scalarField", "0.7"}})
    {
        SCOPED_TRACE(std::string(field) + " " + other);
        auto c = inText();
        c.write(cloud + field, std::string("FoamFile { version 2.0; format ascii; class ") + other + "; }\n400{" + value + "}\n");
        c.write("system/controlDict", c.read("system/controlDict") + "functions { sums { type conservation; } }\n");
        c.isRefused("sphFoamLike", {cloud + field + ":1", other, isClass});
        c.isRefused("sphPostProcess", {cloud + field + ":1", other, isClass}, "-latestTime");
    }
}

// Powder as a vector is no volume fraction, though it has a first component.
TEST(FieldFiles, PowderOfAnotherClass)
{
    static const auto made = firstWriteOf(suspensionCase(), "ascii");
    Damaged c(*made);
    c.write(cloud + "phi", "FoamFile { version 2.0; format ascii; class vectorField; }\n400{(0.4 0 0)}\n");
    c.isRefused("sphFoamLike", {cloud + "phi:1", "vectorField", "scalarField"});
}

TEST(Particles, MovingOutOfThePlane)
{
    auto c = inText();
    setLine(c, cloud + "U", firstValue(c, cloud + "U") + 5, "(0 0 0.1)");
    c.isRefused("sphFoamLike", {cloud + "U: particle 5 at (", "U_z = 0.1: in 2-D it must be 0"});
}

TEST(Particles, BeyondAWall)
{
    auto c = inText();
    setLine(c, cloud + "positions", firstValue(c, cloud + "positions") + 5, "(0.5 -0.06 0) 0");
    c.isRefused("sphFoamLike", {"particle ", "(0.5 -0.06 0)", "0.06 m beyond a wall"});
}

TEST(Particles, FarOutsideTheDomain)
{
    auto c = inText();
    setLine(c, cloud + "positions", firstValue(c, cloud + "positions") + 5, "(57 0.5 0) 0");
    c.isRefused("sphFoamLike", {"particle 5 ", "(57 0.5 0)", "domain"});
}

TEST(Particles, OfAnUnknownPhase)
{
    auto c = inText();
    const auto head = c.read(cloud + "phase");
    c.write(cloud + "phase", head.substr(0, head.find('}') + 1) + "\n400{3}\n");
    c.isRefused("sphFoamLike", {cloud + "phase: particle 0", "phase 3", "constant/phaseProperties"});
}

// A mass or an integrated density that no particle of the scene can have would be divided by, or weigh nothing: the file is to blame, not the step.
TEST(Particles, OfAnImpossibleMass)
{
    for (const char* mass : {"0", "-1", "1e-300", "1e300"})
    {
        SCOPED_TRACE(mass);
        auto c = inText();
        c.write(cloud + "m", std::string("FoamFile { version 2.0; format ascii; class scalarField; }\n400{") + mass + "}\n");
        c.isRefused("sphFoamLike", {cloud + "m: particle 0 at (", ") has m = ", "at rest it has 2.5 kg"});
    }
    auto c = inText();
    const auto head = c.read(cloud + "m");
    std::string masses = head.substr(0, head.find('}') + 1) + "\n400\n(\n";
    for (int i = 0; i < 400; ++i) masses += i == 7 ? "-2.5\n" : "2.5\n";
    c.write(cloud + "m", masses + ")\n");
    c.isRefused("sphFoamLike", {cloud + "m: particle 7 at (", ") has m = -2.5 kg"});
}

TEST(Particles, OfAnImpossibleDensity)
{
    static const auto made = []
    {
        auto files = channelCase();
        files["system/sphSchemes"] += "density continuity;\n";
        return firstWriteOf(files, "ascii");
    }();
    for (const char* density : {"0", "-1", "1e-300", "0.5", "5000", "1e300"})
    {
        SCOPED_TRACE(density);
        Damaged c(*made);
        c.write(cloud + "rho", std::string("FoamFile { version 2.0; format ascii; class scalarField; }\n400{") + density + "}\n");
        c.isRefused("sphFoamLike", {cloud + "rho: particle 0 at (", ") has rho = ", "at rest it has 1000 kg/m^3"});
    }
}

// Two particles at one place attract nobody's attention in the sums (x_ij = 0), but they never part again.
TEST(Particles, TwoAtOnePlace)
{
    auto c = inText();
    const int first = firstValue(c, cloud + "positions");
    setLine(c, cloud + "positions", first + 100, "(0.512 0.487 0) 0");
    setLine(c, cloud + "positions", first + 200, "(0.512 0.487 0) 0");
    c.isRefused("sphFoamLike", {"(0.512 0.487 0)", "same place"});
}

TEST(Particles, ThousandsInOneCell)
{
    auto c = inText();
    std::filesystem::remove_all(c.folder() / "0.02");
    std::string positions = "FoamFile { version 2.0; format ascii; class Cloud<passiveParticle>; location \"0/lagrangian/sph\"; "
                            "object positions; }\n2000\n(\n";
    for (int i = 0; i < 2000; ++i) positions += "(" + std::to_string(0.5 + 1e-5 * i) + " 0.5 0) 0\n";
    std::filesystem::remove_all(c.folder() / "0");
    c.write("0/lagrangian/sph/positions", positions + ")\n");
    c.isRefused("sphFoamLike", {"particle ", "has more than 1024 neighbours"});
}

TEST(Particles, None)
{
    Damaged c;
    std::filesystem::remove_all(c.folder() / "0.02");
    std::filesystem::remove_all(c.folder() / "0");
    c.isRefused("sphFoamLike", {"system/controlDict:1: the case has no time folder to start from"});
    Damaged empty;
    std::filesystem::remove_all(empty.folder() / "0.02");
    std::filesystem::remove_all(empty.folder() / "0");
    empty.write("0/lagrangian/sph/positions",
                "FoamFile { version 2.0; format ascii; class Cloud<passiveParticle>; location \"0/lagrangian/sph\"; object "
                "positions; }\n0\n(\n)\n");
    empty.isRefused("sphFoamLike", {"there are no particles: has packParticles been run?"});
}

// A phase that no particle belongs to is legal in the solver, which says so, and a mistake where it is packed.
TEST(Particles, NoneOfAPhase)
{
    Damaged c;
    c.replace("constant/phaseProperties", "phases (water);", "phases (water oil); oil { rho 800; mu 10; soundSpeed 15; }");
    c.replace("system/sphSchemes", "wallVelocity secondOrder;", "");
    const auto outcome = c.run("sphFoamLike");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("phase \"oil\" has no particles"), std::string::npos);
    Damaged packed;
    packed.replace("constant/phaseProperties", "phases (water);", "phases (water oil); oil { rho 800; mu 10; soundSpeed 15; }");
    packed.isRefused("packParticles", {"oil"});
}

}
}
