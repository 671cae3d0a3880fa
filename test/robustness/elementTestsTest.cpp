/// elementTest on damaged cases: an error with file and line and exit code 1, or a table without anything that is not finite.
#include "TestCase.hpp"
#include <gtest/gtest.h>

namespace sph::test::elementTestsTest
{
namespace
{

const Files good{
    {"constant/soilProperties",
     "rho 1850;\nlaw wuBauer;\nwuBauerCoeffs\n{\n    c1 -69.4;\n    c2 -673.1;\n    c3 -655.9;\n    c4 699.6;\n}\n"},
    {"system/elementTestDict",
     "tests\n{\n    oedometer { type oedometer; pressure 1e5; strain (0.01); points 4; }\n    triaxial { type triaxialCompression; pressure 1e5; "
     "strain (0.05 0.04); points 4; }\n}\nplots no;\ncalibration\n{\n    pressure 1e5;\n    initialStiffness 2.1e7;\n    initialVolumeSlope 0.983;\n"
     "    peak 1.929e5;\n    peakVolumeSlope -0.0047;\n}\n"}};

void isRefused(const TestCase& c, const std::string& words, const std::string& arguments = "")
{
    const auto outcome = c.run("elementTest", arguments);
    EXPECT_EQ(outcome.code, 1) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("--> FATAL ERROR"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << "no \"" << words << "\" in:\n" << outcome.err;
}

TEST(ElementTests, runWell)
{
    const TestCase c(good);
    const auto log = c.runWell("elementTest");
    EXPECT_NE(log.find("K_0 by eq. (21): 0.510134"), std::string::npos) << log;
    EXPECT_NE(log.find("\nEnd\n"), std::string::npos);
    for (const auto& [name, text] : c.files("postProcessing/elementTest")) EXPECT_EQ(text.find("nan"), std::string::npos) << name << text;
    EXPECT_TRUE(c.has("postProcessing/elementTest/triaxial.csv"));
    EXPECT_FALSE(c.has("postProcessing/elementTest/elementTests.gp"));
    const auto found = c.runWell("elementTest", "-calibrate");
    EXPECT_NE(found.find("c1 -69"), std::string::npos) << found;
    EXPECT_TRUE(c.has("postProcessing/elementTest/calibration"));
    EXPECT_EQ(c.run("elementTest", "-help").code, 0);
}

TEST(ElementTests, plots)
{
    const TestCase c(good);
    c.replace("system/elementTestDict", "plots no", "plots yes");
    c.runWell("elementTest");
    EXPECT_GT(c.read("postProcessing/elementTest/oedometer.png").size(), 2000u);
    EXPECT_FALSE(c.has("postProcessing/elementTest/log.gnuplot"));
}

TEST(ElementTests, numbersThatAreNone)
{
    for (const char* number : {"nan", "inf", "1e", "(1)", "word", "", "[0 0 1 0 0 0 0] 1"})
        for (const char* entry : {"rho 1850", "c1 -69.4", "c4 699.6"})
        {
            SCOPED_TRACE(std::string(entry) + " " + number);
            const TestCase c(good);
            const std::string key(entry, std::string(entry).find(' '));
            c.replace("constant/soilProperties", std::string(entry) + ";", key + " " + number + ";");
            isRefused(c, "constant/soilProperties:");
        }
}

// An error, or a result without anything that is not finite, in a few seconds.
TEST(ElementTests, hugeAndTinyNumbers)
{
    for (const char* number : {"1e300", "-1e300", "1e-300", "0", "1e9", "-1e9"})
        for (const auto& [file, entry] : {std::pair<std::string, std::string>{"constant/soilProperties", "c1 -69.4"},
                                          {"constant/soilProperties", "c2 -673.1"},
                                          {"constant/soilProperties", "c3 -655.9"},
                                          {"constant/soilProperties", "c4 699.6"},
                                          {"system/elementTestDict", "initialStiffness 2.1e7"},
                                          {"system/elementTestDict", "peak 1.929e5"},
                                          {"system/elementTestDict", "peakVolumeSlope -0.0047"}})
        {
            SCOPED_TRACE(entry + " " + number);
            const TestCase c(good);
            c.replace(file, entry + ";", entry.substr(0, entry.find(' ')) + " " + number + ";");
            const auto outcome = c.run("elementTest", file[0] == 's' ? "-calibrate" : "");
            EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << outcome.err;
            EXPECT_EQ(outcome.code == 1, outcome.err.find("--> FATAL ERROR") != std::string::npos) << outcome.err;
            EXPECT_EQ(outcome.err.find("stopped unexpectedly"), std::string::npos) << outcome.err;
            EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
            if (outcome.code == 0 && c.has("postProcessing"))
            {
                for (const auto& [name, text] : c.files("postProcessing"))
                    EXPECT_TRUE(text.find("nan") == std::string::npos && text.find("inf") == std::string::npos) << name << text;
            }
        }
}

TEST(ElementTests, missingFiles)
{
    for (const char* file : {"constant/soilProperties", "system/elementTestDict"})
    {
        const TestCase c(good);
        std::filesystem::remove(c.folder() / file);
        isRefused(c, file);
    }
    const TestCase c(good);
    isRefused(c, "Invalid option -calibrat", "-calibrat");
    c.replace("system/elementTestDict", "calibration", "calibratoin");
    isRefused(c, "\"calibratoin\" is not used");
    isRefused(c, "\"calibration\" is missing", "-calibrate");
}

// Far beyond the floor: said, and without an end of substeps.
TEST(ElementTests, extensionWithoutEnd)
{
    const TestCase c(good);
    c.replace("system/elementTestDict", "type oedometer; pressure 1e5; strain (0.01)", "type oedometer; pressure 1e5; strain (-5)");
    EXPECT_NE(c.runWell("elementTest").find("free of stress in 4 rows"), std::string::npos);
}

}
}
