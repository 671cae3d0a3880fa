/// Powder that cannot be: refused with file and line before anything runs, and never a run that pretends to have gone well.
#include "refusal.hpp"
#include <fmt/format.h>

namespace sph::test
{
namespace
{

const TestCase& goodSuspension()
{
    static const auto made = firstWriteOf(suspensionCase(), "ascii");
    return *made;
}

struct Entry
{
    std::string text, key;
    int line;
};
const std::vector<Entry> entries{{"phi 0.4", "phi", 3},   {"phiMax 0.68", "phiMax", 4}, {"exponent 1.82", "exponent", 5},
                                 {"Dc 0.4", "Dc", 6}, {"Deta 0.62", "Deta", 7},     {"radius 0.05", "radius", 8}};

TEST(Suspensions, NumbersThatAreNoneOrOfTheWrongSign)
{
    for (const auto& entry : entries)
        for (const char* number : {"nan", "inf", "-1", "1e", "[0 0 1 0 0 0 0] 0.5"})
        {
            SCOPED_TRACE(entry.key + " " + number);
            Damaged c(goodSuspension());
            c.replace("constant/transportProperties", entry.text + ";", entry.key + " " + number + ";");
            c.isRefused("sphFoamLike", {fmt::format("constant/transportProperties:{}", entry.line)});
        }
}

// An error, or a result without anything that is not finite.
TEST(Suspensions, HugeNumbers)
{
    for (const auto& entry : entries)
        for (const char* number : {"1e300", "1e-300", "0"})
        {
            SCOPED_TRACE(entry.key + " " + number);
            Damaged c(goodSuspension());
            c.replace("constant/transportProperties", entry.text + ";", entry.key + " " + number + ";");
            const auto outcome = c.run("sphFoamLike");
            EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << outcome.err;
            EXPECT_EQ(outcome.code == 1, outcome.err.find("--> FATAL ERROR") != std::string::npos) << outcome.err;
            EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
        }
}

TEST(Suspensions, MisspeltAndMissingEntries)
{
    Damaged misspelt(goodSuspension());
    misspelt.replace("constant/transportProperties", "exponent", "exponnent");
    misspelt.isRefused("sphFoamLike", {"constant/transportProperties:5: entry \"exponnent\" is not used", "Did you mean \"exponent\"?"});
    Damaged empty(goodSuspension());
    empty.write("constant/transportProperties", "");
    empty.isRefused("sphFoamLike", {"constant/transportProperties", "suspension"});
}

// Particles that stay where they are cannot build up a pressure: uneven ones drive a flow, of 19 m/s in a channel at rest, and a force against a wall one
// through it.
TEST(Suspensions, CreepingFlowThroughWalls)
{
    const auto with = [](const std::string& packing, const std::string& force)
    {
        Damaged c(goodSuspension());
        std::filesystem::remove_all(c.folder()/"0.02");
        c.replace("system/sphSchemes", "semiImplicit", "quasiSteady");
        c.replace("system/sphSchemes", "shifting 2", "shifting 0");
        c.replace("system/packParticlesDict", "jitter 0.1; velocity { type taylorGreen; U 1; L 1; }", packing);
        c.replace("constant/g", "(1 0 0)", force);
        c.runWell("packParticles");
        return c.run("sphFoamLike");
    };
    for (const auto& outcome : {with("jitter 0.1;", "(1 0 0)"), with("", "(0 1 0)")})
    {
        EXPECT_EQ(outcome.code, 1);
        EXPECT_NE(outcome.err.find("system/sphSchemes: scheme quasiSteady leaves particles where they are"), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(with("", "(1 0 0)").code, 0);
    EXPECT_EQ(with("", "(0 0 0)").code, 0);
}

TEST(Suspensions, WithoutPowder)
{
    Damaged lost(goodSuspension());
    std::filesystem::remove(lost.folder()/"0.02/lagrangian/sph/phi");
    lost.isRefused("sphFoamLike", {"0.02/lagrangian/sph/phi: is missing, and was written with the others"});
    std::filesystem::remove(lost.folder()/"0.02/uniform/lagrangian/sph/cloudProperties");
    lost.isRefused("sphFoamLike", {"has no field phi: where the powder is, is lost"});
    Damaged never(goodSuspension());
    std::filesystem::remove_all(never.folder()/"0.02");
    never.replace("constant/transportProperties", "phi 0.4;", "");
    never.isRefused("sphFoamLike", {"constant/transportProperties: has no `phi`"});
}

// What a restart reads: powder of a negative amount is no result of any run; more than packed may be, by the capped branch.
TEST(Suspensions, PowderOfARestart)
{
    const auto with = [](const std::string& phi)
    {
        auto c = std::make_unique<Damaged>(goodSuspension());
        const std::string file = "0.02/lagrangian/sph/phi";
        auto text = c->read(file);
        const auto at = text.find("\n(\n") + 3;
        c->write(file, text.replace(at, text.find('\n', at) - at, phi));
        return c;
    };
    with("-0.1")->isRefused("sphFoamLike", {"particle 0", "phi = -0.1"});
    with("nan")->isRefused("sphFoamLike", {"phi"});
    EXPECT_EQ(with("0.681")->run("sphFoamLike").code, 0);
}

}
}
