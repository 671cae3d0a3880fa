/// Tables of results as comma-separated values.
#include "sweeps/ResultTable.hpp"
#include "TestCase.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

std::string mistakesIn(const std::string& text, Completeness wanted = Completeness::wholeRows)
{
    const TestCase folder(Files{{"peer.csv", text}});
    Diagnostics diagnostics;
    readResultTable(folder.folder(), "peer.csv", wanted, diagnostics);
    try
    {
        diagnostics.throwIfAny();
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

const std::string header = "variant,spacing,cpuSeconds,field,norm,error\n";

// Written and read again, every number is the same to the last bit and what is unknown stays unknown.
TEST(ResultTable, ReadsWhatItWrites)
{
    ResultRow row{.variant = "suite",
                  .resolution = 16,
                  .spacing = 0.1 / 3,
                  .nParticles = 256,
                  .cpuSeconds = 1e-3 / 7,
                  .field = "U.x",
                  .norm = "L2",
                  .error = 2.0 / 3,
                  .inputs = "0123456789abcdef"};
    auto diverged = row;
    diverged.error = std::nan("");
    diverged.status = "diverged";
    const TestCase folder(Files{{"results.csv", resultTableText({row, diverged})}});
    Diagnostics diagnostics;
    const auto rows = readResultTable(folder.folder(), "results.csv", Completeness::ownRows, diagnostics);
    EXPECT_TRUE(diagnostics.ok());
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].spacing, row.spacing);
    EXPECT_EQ(rows[0].cpuSeconds, row.cpuSeconds);
    EXPECT_EQ(rows[0].error, row.error);
    EXPECT_EQ(rows[0].inputs, row.inputs);
    EXPECT_EQ(rows[0].status, "ok");
    EXPECT_TRUE(std::isnan(rows[0].steps));
    EXPECT_TRUE(std::isnan(rows[1].error));
    EXPECT_EQ(rows[1].status, "diverged");
}

// Another code's table: columns in its own order, notes, Windows line ends, a comma within quotes.
TEST(ResultTable, ReadsAnotherCodes)
{
    const TestCase folder(Files{
        {"peer.csv", "# a note, with a comma\nerror, cpuSeconds ,variant,spacing,norm,field\r\n\n1e-3,2,\"box, 3-D\",0.1,Linf,p\r\n"}});
    Diagnostics diagnostics;
    const auto rows = readResultTable(folder.folder(), "peer.csv", Completeness::wholeRows, diagnostics);
    EXPECT_TRUE(diagnostics.ok());
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].variant, "box, 3-D");
    EXPECT_EQ(rows[0].error, 1e-3);
    EXPECT_EQ(rows[0].norm, "Linf");
    EXPECT_EQ(rows[0].status, "ok");
    EXPECT_TRUE(std::isnan(rows[0].time));
}

TEST(ResultTable, NamesWhatIsMalformed)
{
    EXPECT_NE(mistakesIn(header).find("peer.csv: has no rows"), std::string::npos);
    EXPECT_NE(mistakesIn("# nothing\n").find("peer.csv: has no line of column names"), std::string::npos);
    EXPECT_NE(mistakesIn("variant,spacing,cpuSecond,field,norm,error\n")
                  .find("peer.csv:1: column \"cpuSecond\" is unknown. Did you mean \"cpuSeconds\"?"),
              std::string::npos);
    EXPECT_NE(mistakesIn("variant,spacing,field,norm,error\na,1,U,L2,1\n").find("peer.csv:1: column \"cpuSeconds\" is missing"),
              std::string::npos);
    EXPECT_NE(mistakesIn("error,error,variant,spacing,cpuSeconds,field,norm\n").find("stands twice"), std::string::npos);

    const auto all = mistakesIn(header + "a,1,2,U,L2\na,0,-1,U,L3,1e\n,1,1,U,L2,\n");
    for (const char* what :
         {"peer.csv:2: 5 cells under 6 columns", "peer.csv:3: spacing is 0 but must be greater than 0",
          "peer.csv:3: cpuSeconds is -1 but must not be negative", "peer.csv:3: norm \"L3\" is unknown",
          "peer.csv:3: \"1e\" in column error is not a number", "peer.csv:4: \"variant\" is empty", "peer.csv:4: \"error\" is empty"})
        EXPECT_NE(all.find(what), std::string::npos) << what << " not in\n" << all;
}

}
}
