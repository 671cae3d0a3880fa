/// Formulas and measures by the library that a case names.
#include "TestCase.hpp"
#include "smallCases.hpp"
#include <gtest/gtest.h>

using namespace sph::test;

namespace
{

/// A channel whose flow is held against the formula, with what its controlDict says first.
Files channelAgainstItsFormula(const std::string& libs)
{
    auto files = channelCase();
    files["system/controlDict"] +=
        "functions\n{\n    errors\n    {\n        type errors; field U; component x;\n        reference\n        {\n"
        "            type formula;\n            name couette; nu 0.1; width 1; velocity (1 0 0);\n        }\n    }\n}\n";
    files["system/controlDict"] = libs + files["system/controlDict"];
    return files;
}

}

TEST(VerificationLibrary, bringsWhatItsCaseAsksFor)
{
    const TestCase c(channelAgainstItsFormula("libs (\"libsphVerification.so\");\n"));
    for (const char* program : {"packParticles", "meshToGhost"}) c.runWell(program);
    const auto log = c.runWell("sphFoamLike");
    EXPECT_NE(log.find("Library   : libsphVerification.so: planePoiseuille, "), std::string::npos) << log;
    EXPECT_NE(c.read("postProcessing/errors/0/errors.dat").find("\tU.x\t"), std::string::npos);
}

TEST(VerificationLibrary, isNamedWhereACaseHasForgottenIt)
{
    const TestCase c(channelAgainstItsFormula(""));
    for (const char* program : {"packParticles", "meshToGhost"}) c.runWell(program);
    const auto ended = c.run("sphFoamLike");
    EXPECT_NE(ended.code, 0);
    EXPECT_NE(ended.err.find(
                  "formula or measure \"couette\" comes from a library, and none has been loaded: `libs (\"libsphVerification.so\");` in "
                  "system/controlDict loads those of the suite"),
              std::string::npos)
        << ended.err;
    EXPECT_NE(ended.err.find("system/controlDict:"), std::string::npos) << ended.err;
}
