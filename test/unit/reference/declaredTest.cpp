/// Nothing is read that is not declared, and nothing is declared that is not read.
#include "TestCase.hpp"
#include "case/RunTime.hpp"
#include "declaredEntries.hpp"
#include "decomposition/readDecomposition.hpp"
#include "figures/FigurePlan.hpp"
#include "packing/Packing.hpp"
#include "reference/reference.hpp"
#include "sampling/FunctionObject.hpp"
#include "soilLaws/soilLaws.hpp"
#include "solids/entries/SolidsPlan.hpp"
#include "solver/readPhases.hpp"
#include "solver/readSettings.hpp"
#include "sweeps/SweepPlan.hpp"
#include <fstream>
#include <gtest/gtest.h>

using namespace sph;
using namespace sph::test;

namespace
{

const Files small{{"constant/geometry", "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x y z); }"},
                  {"constant/phaseProperties",
                   "phases (someName other); someName { rho 1; mu 1; soundSpeed 1; } other { rho 1; mu 1; soundSpeed 1; }"},
                  {"system/sphSchemes", "resolution { spacing 0.1; }"},
                  {"0/mark", ""}};

/// The formulas look whether they give the field that is asked for.
std::vector<std::string> withEachField(const std::string& text)
{
    const std::string any = "field " + freeName;
    std::vector<std::string> texts{text};
    for (const auto* field : {"U", "p", "phi"})
    {
        texts.push_back(text);
        for (auto at = text.find(any); at != std::string::npos; at = text.find(any, at + 1))
            texts.back() = std::string(text).replace(at, any.size(), std::string("field ") + field);
    }
    return texts;
}

/// The differences that a reader of a case makes, with `file` written anew each time.
std::string differenceOf(const std::string& file, const std::function<void(const Case&)>& read, const std::set<std::string>& apart = {})
{
    const TestCase folder(small);
    return difference(
        file, reference().find(file)->entries,
        [&](const std::string& text)
        {
            for (const auto& each : withEachField(text))
            {
                folder.write(file, each);
                try
                {
                    read(Case(folder.folder()));
                }
                catch (const CaseError&)
                {}
            }
        },
        apart);
}

}

TEST(Declared, geometry)
{
    EXPECT_EQ(differenceOf("constant/geometry", [](const Case& c) { readGeometry(c.dictionary("constant/geometry"), 1); }), "");
}

TEST(Declared, phasesAndGravity)
{
    const auto read = [](const Case& c) { readSettings(c, readGeometry(c.dictionary("constant/geometry"), 1)); };
    EXPECT_EQ(differenceOf("constant/phaseProperties", read), "");
    EXPECT_EQ(differenceOf("constant/g", read, {"constant/g.dimensions"}), "");
}

/// What all models read of a case: of two phases, and of one that has powder in it.
void readAsBoth(const Case& two)
{
    readSettings(two, readGeometry(two.dictionary("constant/geometry"), 1));
    auto files = small;
    files["constant/phaseProperties"] = "phases (someName); someName { rho 1; mu 1; soundSpeed 1; }";
    files["constant/transportProperties"] = "suspension { phi 0.4; phiMax 0.68; exponent 1.82; a radius; radius 0.05; Dc 0.4; Deta 1; }";
    const TestCase folder(files);
    for (const auto* each : {"system/sphSchemes", "constant/transportProperties", "constant/openings", "constant/scalarTransport"})
        if (two.has(each))
            std::filesystem::copy(two.folder() / each, folder.folder() / each, std::filesystem::copy_options::overwrite_existing);
    const Case one(folder.folder());
    readSettings(one, readGeometry(one.dictionary("constant/geometry"), 1));
}

TEST(Declared, modelsFiles)
{
    for (const auto* file : {"constant/transportProperties", "constant/openings", "system/sphSchemes"})
        EXPECT_EQ(differenceOf(file, readAsBoth), "") << file;
}

TEST(Declared, soil)
{
    // A phase of soil under gravity, in place of the two fluids of `small`.
    const auto read = [](const Case& c)
    {
        std::ofstream(c.folder() / "constant/phaseProperties") << "phases (someName); someName { rho 1; stress constitutiveLaw; }";
        std::ofstream(c.folder() / "constant/g") << "value (0 0 -1);";
        const Case soil(c.folder());
        readSettings(soil, readGeometry(soil.dictionary("constant/geometry"), 1));
    };
    EXPECT_EQ(differenceOf(soilProperties, read), "");
}

TEST(Declared, decomposition)
{
    EXPECT_EQ(differenceOf(decompositionDictionary, [](const Case& c) { readDecomposition(c); }), "");
}

TEST(Declared, packing)
{
    const auto read = [](const Case& c)
    {
        try
        {
            readSolidsPlan(Case(c.folder()));
        }
        catch (const CaseError&)
        {}
        readPackingPlan(c);
    };
    EXPECT_EQ(differenceOf("system/packParticlesDict", read), "");
}

TEST(Declared, sweep)
{
    EXPECT_EQ(differenceOf("system/workPrecisionDict", [](const Case& c) { readSweepPlan(c); },
                           {"system/workPrecisionDict.setResolution.someName", "system/workPrecisionDict.variants.someName.someName"}),
              "");
}

TEST(Declared, figures)
{
    EXPECT_EQ(differenceOf(figuresDictionary, [](const Case& c) { readFigurePlan(c.dictionary(figuresDictionary)); }), "");
}

TEST(Declared, controlDict)
{
    const auto read = [](const Case& c)
    {
        const RunTime time(c);
        const std::vector<std::string> phases{"someName", "other"};
        const auto geometry = readGeometry(c.dictionary("constant/geometry"), 1);
        const FunctionObjects functions(c.dictionary("system/controlDict").subDict("functions"), geometry, phases, time);
    };
    const std::string file = "system/controlDict.";
    EXPECT_EQ(differenceOf("system/controlDict", read,
                           {file + "application", file + "libs", file + "graphFormat", file + "DebugSwitches", file + "InfoSwitches",
                            file + "OptimisationSwitches"}),
              "");
}
