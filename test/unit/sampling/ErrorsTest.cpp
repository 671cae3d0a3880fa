#include "sampling/Errors.hpp"
#include "Particles.hpp"
#include "sampling/CsvReference.hpp"
#include "verification/verification.hpp"
#include <gtest/gtest.h>

using namespace sph;

namespace
{

/// An `errors` object called `errors` in a case of its own.
struct ErrorsCase
{
    TemporaryCase folder;
    Case theCase{folder.folder()};
    RunTime time{theCase};
    std::string mistakes;

    ErrorsCase() { addVerification(); }
    std::unique_ptr<Errors> make(const Particles& particles, const std::string& text)
    {
        const auto d = Dictionary::parse(text, "system/controlDict", theCase.sharedDiagnostics());
        auto object = std::make_unique<Errors>(d, FunctionContext{"errors", particles.geometry, particles.phases, outputOf(time)});
        d.reportUnused();
        mistakes = errorsOf(theCase.diagnostics());
        return object;
    }
    std::vector<std::vector<std::string>> rowsOf(const Particles& particles, const std::string& text)
    {
        const auto errors = make(particles, text);
        EXPECT_EQ(mistakes, "");
        errors->execute(particles.view());
        return folder.rows("postProcessing/errors/0/errors.dat");
    }
};

/// Two particles, y = 0.5 and 1.5, of volumes 1 and 3, with u = 1 and 3.
Particles two()
{
    Particles particles(2, {0, 0, 0}, {1, 2, 0}, 1);
    particles.volume = {1, 3};
    particles.ux = {1, 3};
    particles.p = {1, 2};
    return particles;
}

constexpr const char* zeroToFour = "reference { type csv; file \"table.csv\"; columns { coordinate y; value v; } }";

}

TEST(Norms, areThoseByHand)
{
    // Reference u = 2 y = 1 and 3 minus 0.5 of the table below: errors 0.5, 0.5... with v = 1.5 and 1: |e| = 0.5 and 2, V = 1
    // and 3: L1 = (0.5 + 6)/4, L2 = sqrt((0.25 + 12)/4), Linf = 2.
    ErrorsCase c;
    c.folder.write("table.csv", "y,v\n0.5,1.5\n1.5,1\n");
    const auto rows = c.rowsOf(two(), "field U; component x; norm absolute;\n" + std::string(zeroToFour));
    ASSERT_EQ(rows.size(), 1u);
    const auto& row = rows[0];
    ASSERT_EQ(row.size(), 9u);
    EXPECT_EQ(row[1], "U.x");
    EXPECT_NEAR(std::stod(row[2]), 6.5 / 4, 1e-15);
    EXPECT_NEAR(std::stod(row[3]), std::sqrt(12.25 / 4), 1e-15);
    EXPECT_NEAR(std::stod(row[4]), 2, 1e-15);
    EXPECT_EQ(row[5], "2");
    EXPECT_EQ(row[6], "1.5");
    EXPECT_NEAR(std::stod(row[7]), std::sqrt(28.0 / 4), 1e-15);
    EXPECT_NEAR(std::stod(row[8]), std::sqrt((2.25 + 3) / 4), 1e-15);
}

TEST(Norms, relativeOnesAreDividedByTheSameNormOfTheReference)
{
    ErrorsCase c;
    c.folder.write("table.csv", "y,v\n0.5,1.5\n1.5,1\n");
    const auto row = c.rowsOf(two(), "field U; component x;\n" + std::string(zeroToFour)).at(0);
    EXPECT_NEAR(std::stod(row[2]), 6.5 / 4.5, 1e-15);
    EXPECT_NEAR(std::stod(row[3]), std::sqrt(12.25 / 5.25), 1e-15);
    EXPECT_NEAR(std::stod(row[4]), 2 / 1.5, 1e-15);
}

TEST(Norms, canBeScaledByAGivenValue)
{
    ErrorsCase c;
    c.folder.write("table.csv", "y,v\n0.5,1.5\n1.5,1\n");
    const auto row = c.rowsOf(two(), "field U; component x; scale 10;\n" + std::string(zeroToFour)).at(0);
    EXPECT_NEAR(std::stod(row[4]), 0.2, 1e-15);
    EXPECT_EQ(row[8], "10");
}

TEST(Norms, ofNothingWhereNothingShouldBeAreZero)
{
    // At t = 0 both fluid and reference are at rest.
    ErrorsCase c;
    auto particles = two();
    particles.ux = {0, 0};
    const auto row = c.rowsOf(particles, "field U; reference { type formula; name planePoiseuille; nu 1; acceleration 1; width 2; }").at(0);
    EXPECT_EQ(row[1], "U");
    EXPECT_EQ(row[2], "0");
    EXPECT_EQ(row[4], "0");
}

TEST(Norms, nanIsNeverHidden)
{
    NormSum all(1, std::nan(""));
    all += NormSum(1, 2);
    EXPECT_TRUE(std::isnan(all.norms().L1));
    EXPECT_TRUE(std::isnan(all.norms().Linf));
    EXPECT_TRUE(std::isnan(NormSum().norms().L2));
}

TEST(Errors, vectorsAreComparedByTheMagnitudeOfTheirDifference)
{
    // Couette in steady state, u = y/2; the particles have v = 0.4 on top, so that |difference| = (1, 3) - (0.25, 0.75) and 0.4.
    ErrorsCase c;
    auto particles = two();
    particles.uy = {0.4, 0};
    const auto row = c.rowsOf(particles, "field U; norm absolute; reference { type formula; name couette; steady yes; nu 1; width 2;"
                                         " velocity (1 0 0); }")
                         .at(0);
    EXPECT_NEAR(std::stod(row[4]), 2.25, 1e-15);
    EXPECT_NEAR(std::stod(row[2]), (std::hypot(0.75, 0.4) + 3 * 2.25) / 4, 1e-15);
}

TEST(Errors, meansCanBeRemovedFromAPressure)
{
    // p = 1, 2 against hydrostatic 1.5, 0.5 (g = 1, rho = 1): means 1.75 and 0.75 go, differences 0.75 + 0.75 and 0.25 + 0.25.
    ErrorsCase c;
    const auto row = c.rowsOf(two(), "field p; norm absolute; removeMean yes;"
                                     "reference { type formula; name hydrostatic; heights (2); densities (1); g (0 -1 0); }")
                         .at(0);
    EXPECT_NEAR(std::stod(row[4]), 1.5, 1e-15);
    EXPECT_NEAR(std::stod(row[2]), (1.5 + 3 * 0.5) / 4, 1e-15);
}

TEST(Errors, canBeRestrictedToAPhaseOrARegion)
{
    ErrorsCase c;
    auto particles = two();
    particles.phases = {"water", "air"};
    particles.phase = {0, 1};
    const std::string reference = "reference { type formula; name couette; steady yes; nu 1; width 2; velocity (1 0 0); } }";
    const auto rows = c.rowsOf(particles, "fields ( { field U; phase air; " + reference +
                                              " { field U; region { min (0 0 0); max (1 1 0); } " + reference + " );");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0][5], "1");
    EXPECT_NEAR(std::stod(rows[0][7]), 3, 1e-15);
    EXPECT_NEAR(std::stod(rows[1][7]), 1, 1e-15);
}

// The mean of y (2 - y)/2 over a cell of 0.1 is 0.1^2/24 less than its middle; 200 parts give that to 1/200^2 of it.
TEST(Errors, canBeTakenAgainstMeansOverCells)
{
    ErrorsCase c;
    Particles particles(2, {0, 0, 0}, {0.2, 2, 0}, 0.1);
    particles.setU([](Vector<3> x) { return Vector<3>{0.5 * x.y * (2 - x.y) - 0.01 / 24, 0, 0}; });
    const std::string reference =
        "norm absolute; reference { type formula; name planePoiseuille; steady yes; nu 1; acceleration 1; width 2; }";
    EXPECT_NEAR(std::stod(c.rowsOf(particles, "field U; cellMeans y; " + reference).at(0)[4]), 0, 2e-8);
    ErrorsCase middles;
    EXPECT_NEAR(std::stod(middles.rowsOf(particles, "field U; " + reference).at(0)[4]), 0.01 / 24, 1e-12);
}

TEST(Errors, canBeTakenAtTheRowsOfATable)
{
    // u = 2 x + y on a lattice, interpolated exactly at x = 0.5, y = 0.2, 0.5 and 0.8 (rows off the particles): 1.2, 1.5, 1.8 against 1, 2, 1.8
    // weigh the same, whatever the volumes.
    ErrorsCase c;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.1);
    particles.setU([](Vector<3> x) { return Vector<3>{2 * x.x + x.y, 0, 0}; });
    c.folder.write("table.csv", "# two notes\n# above the names\ny,v\n0.2,1\n0.5,2\n0.8,1.8\n");
    const std::string text =
        "field U; component x; norm absolute; points rows;\nreference { type csv; file \"table.csv\"; columns { coordinate y; "
        "value v; } origin (0.5 0 0); }";
    const auto row = c.rowsOf(particles, text).at(0);
    EXPECT_NEAR(std::stod(row[2]), 0.7 / 3, 1e-12);
    EXPECT_NEAR(std::stod(row[3]), std::sqrt((0.04 + 0.25) / 3), 1e-12);
    EXPECT_NEAR(std::stod(row[4]), 0.5, 1e-12);
    EXPECT_EQ(row[5], "100");

    // Where there is no particle there is no number: a hole is not passed over.
    Particles far(2, {0, 0, 0}, {1, 0.4, 0}, 0.1);
    ErrorsCase other;
    other.folder.write("table.csv", "y,v\n0.2,1\n0.5,2\n0.8,1.8\n");
    EXPECT_TRUE(std::isnan(std::stod(other.rowsOf(far, text).at(0)[3])));
}

// A field that swings by 0.3 about 2 x + y: nothing before `meanFrom`, then the error of the mean over all times since, also after a restart.
TEST(Errors, canBeThatOfTheMeanOverTime)
{
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.1);
    const std::string text = "field U; component x; norm absolute; points rows; meanFrom 1;\nreference { type csv; file \"table.csv\"; "
                             "columns { coordinate y; value v; } origin (0.5 0 0); }";
    struct Run : ErrorsCase
    {
        std::unique_ptr<Errors> errors;
        Run(const Particles& particles, const std::string& text)
        {
            folder.write("table.csv", "y,v\n0.2,1\n0.5,2\n0.8,1.8\n");
            errors = make(particles, text);
        }
        void at(double seconds, double swing, Particles& particles)
        {
            particles.setU([=](Vector<3> x) { return Vector<3>{2 * x.x + x.y + swing, 0, 0}; });
            auto view = particles.view();
            view.time = seconds;
            errors->execute(view);
        }
        std::vector<double> L1()
        {
            std::vector<double> all;
            for (const auto& row : folder.rows("postProcessing/errors/0/errors.dat")) all.push_back(std::stod(row[2]));
            return all;
        }
    };
    Run first(particles, text), second(particles, text);
    ASSERT_EQ(first.mistakes, "");
    first.at(0.9, 7, particles);
    first.at(1, 0.3, particles);
    first.at(1.1, -0.3, particles);
    ASSERT_EQ(first.L1().size(), 2u);
    EXPECT_NEAR(first.L1()[0], (0.5 + 0.2 + 0.3) / 3, 1e-12);
    EXPECT_NEAR(first.L1()[1], 0.7 / 3, 1e-12);

    second.errors->restore(first.errors->histories());
    second.at(1.2, 0.6, particles);
    second.at(1.3, -0.6, particles);
    ASSERT_EQ(second.L1().size(), 2u);
    EXPECT_NEAR(second.L1()[0], (0.4 + 0.3 + 0.2) / 3, 1e-12);
    EXPECT_NEAR(second.L1()[1], 0.7 / 3, 1e-12);

    ErrorsCase refused;
    refused.folder.write("table.csv", "y,v\n0,1\n1,2\n");
    refused.make(two(), "field U; component x; meanFrom 1;\n" + std::string(zeroToFour));
    EXPECT_EQ(refused.mistakes, "system/controlDict:1: goes with `points rows;` alone: particles do not stay at a place");
}

TEST(Errors, onlyTablesHaveRows)
{
    ErrorsCase c;
    auto particles = two();
    particles.phases = {"water", "air"};
    c.make(particles, "field U;\npoints rows;\nreference { type formula; name couette; nu 1; width 2; velocity (1 0 0); }\n");
    EXPECT_EQ(c.mistakes, "system/controlDict:2: only a reference of type csv has rows");
    ErrorsCase other;
    other.folder.write("table.csv", "y,v\n0,1\n1,2\n");
    other.make(particles, "field U; points rows;\nphase air;\n" + std::string(zeroToFour));
    EXPECT_EQ(other.mistakes, "system/controlDict:2: phase goes with `points particles;` alone: a row belongs to no phase");
}

TEST(Errors, headerNamesTheColumns)
{
    ErrorsCase c;
    c.rowsOf(two(), "field U; reference { type formula; name couette; nu 1; width 2; velocity (1 0 0); }");
    const auto text = c.folder.read("postProcessing/errors/0/errors.dat");
    EXPECT_NE(text.find("\n# Time\tfield\tL1\tL2\tLinf\tnParticles\texecutionTime\tvalue\treference\n0\tU\t"), std::string::npos) << text;
}

TEST(Errors, ofMeasuresAreThoseOfTheirValue)
{
    // Pressure 3 in a drop whose Laplace pressure is 1/R = 4: -25 %.
    ErrorsCase c;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.surfaceTension = 1;
    particles.setP([](Vector<3>) { return 3.0; });
    const auto row = c.rowsOf(particles, "reference { type formula; name laplaceJump; radius 0.25; }").at(0);
    EXPECT_EQ(row[1], "laplaceJump");
    for (const int k : {2, 3, 4}) EXPECT_NEAR(std::stod(row[std::size_t(k)]), 0.25, 1e-14);
    EXPECT_NEAR(std::stod(row[7]), 3, 1e-14);
    EXPECT_EQ(row[8], "4");
}

TEST(Errors, unknownWordsAreExplained)
{
    ErrorsCase c;
    c.make(two(), "field U;\nreference\n{\n    type formula;\n    name planePoisseuille;\n}\n");
    EXPECT_EQ(
        c.mistakes,
        "system/controlDict:5: name \"planePoisseuille\" is unknown. Did you mean \"planePoiseuille\"? Known name: "
        "planePoiseuille, twoLayerPoiseuille, couette, taylorGreen, hydrostatic, ritter, suspensionChannel, rotatingSquarePatch, laplaceJump, contactAngle, "
        "capAngle, drainingFilm, dragFactor, dropPeriod, dropDecay, interfaceGrowth, columnGrowth, capillaryRise, "
        "bridgeNeck, bridgePressure, bridgeForce, lensAngle, lensRadius, earthPressure, overburden, wallDropTime.");
}

TEST(Errors, unknownFieldsAreExplainedWhenTheyAreFirstSeen)
{
    ErrorsCase c;
    const auto errors =
        c.make(two(), "\nfield UU;\n" + std::string("reference { type csv; file \"table.csv\"; columns { coordinate y; value v; } }"));
    try
    {
        errors->execute(two().view());
        FAIL();
    }
    catch (const CaseError& error)
    {
        EXPECT_STREQ(error.what(), "system/controlDict:2: field \"UU\" is unknown. Known fields: U, p.");
    }
}

namespace
{

/// A table read in a case; mistakes are kept as text.
struct Table
{
    TemporaryCase folder;
    std::string mistakes;

    CsvReference read(const std::string& csv, const std::string& text)
    {
        folder.write("table.csv", csv);
        auto diagnostics = std::make_shared<Diagnostics>();
        const auto d = Dictionary::parse("file \"table.csv\";\n" + text, "system/controlDict", diagnostics);
        const CsvReference reference(d, folder.folder());
        d.reportUnused();
        mistakes = errorsOf(*diagnostics);
        return reference;
    }
};

}

TEST(CsvReference, interpolatesLinearlyInSpaceAndTime)
{
    Table table;
    const auto v = table.read("t,y,v\n0,0,0\n0,1,10\n2,0,4\n2,1,6\n", "columns { coordinate y; time t; value v; }");
    EXPECT_EQ(table.mistakes, "");
    EXPECT_NEAR(*v({7, 0.25, 7}, 0), 2.5, 1e-15);
    EXPECT_NEAR(*v({0, 0.25, 0}, 2), 4.5, 1e-15);
    EXPECT_NEAR(*v({0, 0.25, 0}, 0.5), 3, 1e-14);
    EXPECT_FALSE(v({0, 0.25, 0}, 2.1));
    EXPECT_FALSE(v({0, 0.25, 0}, -0.1));
}

TEST(CsvReference, cubicInterpolationIsExactForCubics)
{
    Table table;
    std::string rows = "y,v\n";
    for (const double y : {0.0, 0.5, 0.8, 1.5, 2.0, 3.0}) rows += std::to_string(y) + "," + std::to_string(y * y * y - 2 * y) + "\n";
    const auto v = table.read(rows, "columns { coordinate y; value v; } interpolation cubic;");
    for (const double y : {0.1, 0.7, 1.1, 2.9}) EXPECT_NEAR(*v.at(y, 123), y * y * y - 2 * y, 1e-12);
}

TEST(CsvReference, reachesOneIntervalBeyondTheEnds)
{
    Table table;
    const auto v = table.read("y,v\n0.25,1\n0.75,3\n", "columns { coordinate y; value v; }");
    EXPECT_NEAR(*v.at(0, 0), 0, 1e-15);
    EXPECT_NEAR(*v.at(1, 0), 4, 1e-15);
    EXPECT_FALSE(v.at(1.26, 0));
}

TEST(CsvReference, selectsRowsAndConvertsUnits)
{
    Table table;
    const auto v = table.read("set,nu,s,\"v, scaled\"\na,1e-6,0,0\na,1e-6,1,2\nb,1e-6,0,7\na,2e-6,0,8\n",
                              "columns { coordinate s; value \"v, scaled\"; }\nselect { set a; nu \"1.0e-06\"; }\n"
                              "units { coordinate 1e-3; value 100; }\naxis (0 0 1); origin (0 0 5); mirror yes;");
    EXPECT_EQ(table.mistakes, "");
    EXPECT_NEAR(*v({0, 0, 5 - 0.25e-3}, 0), 50, 1e-9);
}

TEST(CsvReference, mistakesNameFileAndLine)
{
    Table table;
    table.read("y,v\n0,1\n1,one\n1\n", "columns { coordinate y; value v; }");
    EXPECT_EQ(table.mistakes, "table.csv:3: \"one\" in column v is not a number\n"
                              "table.csv:4: 1 cells under 2 columns\n"
                              "2 errors");
    table.read("y,v\n0,1\n1,2\n", "columns\n{\n    coordinate y;\n    value w;\n}\n");
    EXPECT_EQ(table.mistakes, "system/controlDict:5: table.csv has no column \"w\". Known columns: y, v.");
    table.read("y,v\n0,1\n1,2\n0,3\n", "columns { coordinate y; value v; }");
    EXPECT_EQ(table.mistakes, "table.csv:4: a second value at y = 0: say by `select` which rows are meant");
    table.read("s,v\n0,1\n1,2\n", "columns { coordinate s; value v; }");
    EXPECT_EQ(table.mistakes, "system/controlDict: axis is needed: coordinate column \"s\" does not say x, y or z");
}

// u = 1 and 3 at y = 0.5 and 1.5 against 2 y + t = 1 and 3; and a mistake where it stands.
TEST(Errors, takeAnExpressionOfPositionAndTime)
{
    ErrorsCase c;
    const auto rows = c.rowsOf(two(), "field U; component x; norm absolute; reference { type expression; value \"2*$y + $t\"; }\n");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0][3], "0");
    ErrorsCase wrong;
    wrong.make(two(), "field U; component x;\nreference { type expression; value \"2*$u\"; }\n");
    EXPECT_NE(wrong.mistakes.find("system/controlDict:2"), std::string::npos) << wrong.mistakes;
    EXPECT_NE(wrong.mistakes.find("$u is unknown here. Known: $x, $y, $z, $t"), std::string::npos) << wrong.mistakes;
}
