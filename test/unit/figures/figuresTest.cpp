/// Tables of figures of a case's runs.
#include "TestCase.hpp"
#include "figures/FigureTable.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

const std::string conservation =
    "# mass_water [kg]: mass of the phase\n# momentum [kg m/s]: sum m U; a vector\n# Time\tmass\tmomentum\tkineticEnergy\n"
    "0\t2\t(1 2 -3)\t8\n0.5\t2\t(1 2 -4)\t32\n1\t2\t(1 2 -5)\t18\n";
const std::string errors =
    "# Time\tfield\tL2\tvalue\treference\n0.5\tU.x\t0.25\t2\t1\n0.5\tp\t0.5\t3\t4\n1\tU.x\t0.125\t-6\t4\n1\tp\t0.75\tnan\t4\n";
const std::string log =
    "step 10  deltaT 0.1 (capillary)  max|U| 3.5  kinetic energy 1  energy/supply 0.4\nExecutionTime = 1.5 s\n"
    "step 20  deltaT 0.2 (capillary)  max|U| 2.5  kinetic energy 1  energy/supply 0.3\nExecutionTime = 2.5 s\nbalance: mass off by -3e-3\nLeaked: 4 particles put back\n";
const std::string logOfAgain = "step 10  deltaT 0.1\nExecutionTime = 1 s\nstep 20  deltaT 0.1\nExecutionTime = 1.4 s\n";

/// A case with two runs: run/a, and run/workPrecision/v/8.
Files files(const std::string& tables)
{
    Files all{{"system/figuresDict", "tables\n{\n" + tables + "\n}\n"},
              {"reference/path.csv", "# notes\nkind,strain,q [Pa]\nx,0,0\nx,1,10\nx,0.5,20\ny,0,5\n"}};
    for (const std::string run : {"run/a/", "run/workPrecision/v/8/"})
    {
        all[run + "log.sphFoamLike"] = log;
        all[run + "log.sphFoamLike.again"] = logOfAgain;
        all[run + "postProcessing/conservation/0/conservation.dat"] = conservation;
        all[run + "postProcessing/errors/0/errors.dat"] = errors;
        all[run + "postProcessing/late/0/late.dat"] = "# Time\tq\n3\t1\n3.1\t2\n3.2\t3\n4\t4\n4.1\t5\n";
        all[run + "postProcessing/errors/2/errors.dat"] = "# Time\tfield\tL2\tvalue\treference\n2\tp\t0.0625\t1\t1\n";
        all[run + "constant/phaseProperties"] = "gas { mu [1 -1 -1 0 0 0 0] 2e-3; }\n";
        all[run + "reference/path.csv"] = all["reference/path.csv"];
    }
    return all;
}

/// The cells of the first line of the only table, or the message of the error.
std::string firstLine(const std::string& body)
{
    const TestCase c(files(body));
    const auto diagnostics = std::make_shared<Diagnostics>();
    try
    {
        const auto plans = readFigurePlan(Dictionary::read(c.folder(), figuresDictionary, diagnostics));
        diagnostics->throwIfAny();
        std::string text;
        const auto table = makeFigures(c.folder(), plans.at(0));
        for (const auto& f : table.recorded) text += (text.empty() ? "" : "; ") + f.run + "," + f.figure + "," + f.value + "," + f.unit;
        for (const auto& run : table.missing) text += "; not run: " + run;
        return text;
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
}

/// A figure of run/a.
std::string figure(const std::string& entries)
{
    const auto text = firstLine("t { against x; runs (a); figures ( { name \"f [m]\"; " + entries + " } ); }");
    const std::string begin = "a,f,";
    return text.starts_with(begin) ? text.substr(begin.size(), text.rfind(',') - begin.size()) : text;
}

// Each operation on a column whose values are 8, 32, 18.
TEST(Figures, OperationsOverRows)
{
    const auto of = [](const std::string& operation)
    { return figure("table conservation; operation " + operation + "; value \"$kineticEnergy\";"); };
    EXPECT_EQ(of("last"), "18");
    EXPECT_EQ(of("first"), "8");
    EXPECT_EQ(of("min"), "8");
    EXPECT_EQ(of("max"), "32");
    EXPECT_EQ(of("sum"), "58");
    EXPECT_EQ(of("count"), "3");
    EXPECT_EQ(of("mean"), "19.33");
    EXPECT_EQ(of("rms"), "21.69");       // sqrt(1412/3)
    EXPECT_EQ(of("deviation"), "9.843"); // sqrt(1412/3 - (58/3)^2)
    EXPECT_EQ(figure("table conservation; operation farthest; value \"$momentum_z + 3.5\";"), "-1.5");
    EXPECT_EQ(figure("table conservation; value \"$kineticEnergy\"; where \"$Time < 0.7\";"), "32");
    EXPECT_EQ(figure("table conservation; value \"$mass_water*mag($momentum)\"; format \"%.2f\";"), "10.95"); // 2 sqrt(30)
}

// Rows are chosen by words; of several start times the last counts unless one is named; a value that is not there is no figure.
TEST(Figures, RowsByWordsAndTablesByTime)
{
    EXPECT_EQ(figure("table errors; value \"$L2\";"), "0.0625");
    EXPECT_EQ(figure("table \"errors/0\"; select { field U.x; } value \"100*abs($value/$reference - 1)\"; format \"%+.1f\";"), "+250.0");
    EXPECT_EQ(figure("table \"errors/0\"; select { field (p q); } operation sum; value \"$L2\";"), "1.25");
    EXPECT_EQ(figure("table \"errors/0\"; select { field p; } value \"$value\";"), "");
}

// The log's last and largest numbers, patterns of it, and entries of dictionaries.
TEST(Figures, OfLogsAndDictionaries)
{
    EXPECT_EQ(figure("value \"$steps\"; format \"%d\";"), "20");
    EXPECT_EQ(figure("value \"$speed + 10*$largestSpeed + 100*$energySupply + 1000*$putBack\"; format \"%.6g\";"), "4077.5");
    EXPECT_EQ(figure("value \"$processorTime\";"), "2.5");
    EXPECT_EQ(figure("pattern \"^balance: mass off by ([^ ]+)\"; value \"abs($value)\";"), "0.003");
    EXPECT_EQ(figure("pattern \"^step ([0-9]+)  deltaT ([^ ]+) \"; columns (n dT); operation mean; value \"$n*$dT\";"), "2.5");
    EXPECT_EQ(figure("dictionary \"constant/phaseProperties\"; entry \"gas.mu\"; value \"3*$value\";"), "0.006");
}

// What another log tells, and several logs, a row each: the last times of the two are 2.5 and 1.4, their 10 steps take 1 and 0.4 s.
TEST(Figures, OfSeveralLogs)
{
    EXPECT_EQ(figure("value \"$timeOfStep\";"), "0.1");
    EXPECT_EQ(figure("log \"../workPrecision/v/8/log.sphFoamLike.again\"; value \"$processorTime\";"), "1.4");
    EXPECT_EQ(figure("log \"sphFoamLike*\"; operation sum; value \"$processorTime\";"), "3.9");
    EXPECT_EQ(figure("log \"sphFoamLike*\"; operation min; value \"$timeOfStep\"; where \"$processorTime > 2\";"), "0.1");
    EXPECT_EQ(figure("log \"none*\"; operation count; value \"$steps\";"), "0");
    EXPECT_NE(figure("log none; value \"$steps\";").find("run/a/log.none is not there"), std::string::npos);
}

/// A figure of run/a from the table d that is made of others.
std::string derived(const std::string& table, const std::string& entries)
{
    const auto text = firstLine("t { against x; runs (a); table conservation; derivedTables { d { " + table +
                                " } } figures ( { name f; table d; " + entries + " } ); }");
    const std::string begin = "a,f,";
    return text.starts_with(begin) ? text.substr(begin.size(), text.rfind(',') - begin.size()) : text;
}

// Of -12, 12, -2 at 0, 0.5, 1: changes of sign at 0.25 and 0.5 + 0.5*12/14, and the largest between them.
TEST(Figures, CrossingsOfAValue)
{
    const auto of = [](const std::string& entries)
    { return derived("type crossings; along \"$Time\"; value \"$kineticEnergy - 20\";", entries + " format \"%.6g\";"); };
    EXPECT_EQ(of("operation count; value \"1\";"), "2");
    EXPECT_EQ(of("operation first; value \"$place\";"), "0.25");
    EXPECT_EQ(of("select { number 2; } value \"$place\";"), "0.928571");
    EXPECT_EQ(of("value \"$interval\";"), "0.678571");
    EXPECT_EQ(of("value \"$peak\";"), "12");
    EXPECT_EQ(of("operation first; value \"$interval + $peak\";"), ""); // none before the first
    // A zero between two signs is one change, and between two of one sign none.
    EXPECT_EQ(derived("type crossings; along \"$Time\"; value \"2*$Time - 1\";", "operation sum; value \"$place\";"), "0.5");
    EXPECT_EQ(derived("type crossings; along \"$Time\"; value \"sqr(2*$Time - 1)\";", "operation count; value \"1\";"), "0");
}

// The last row of errors/0 is: 1 p 0.75 nan 4.
TEST(Figures, ColumnsAsRows)
{
    const std::string table = "type columns; table \"errors/0\";";
    EXPECT_EQ(derived(table, "select { column (L2 reference); } operation sum; value \"$value\";"), "4.75");
    EXPECT_EQ(derived(table, "operation count; value \"1\";"), "4");
    EXPECT_NE(derived("type columns; table d;", "value \"$value\";").find("there is no table \"d\""), std::string::npos);
}

// A number hides a column of its name; a run has constants, others have none of them; words in curly brackets name a run.
TEST(Figures, NumbersAndRuns)
{
    EXPECT_EQ(firstLine("t { against x; runs (\"run/workPrecision/{v w}/{8}\"); named ( a { law 4; } ); table conservation;"
                        " numbers { K0 { operation first; value \"$kineticEnergy\"; } }"
                        " figures ( { name \"ratio [-]\"; value \"$kineticEnergy/$K0\"; } { name law; value \"$law\"; } ); }"),
              "v 8,ratio,2.25,-; a,ratio,2.25,-; a,law,4,-; not run: run/workPrecision/w/8");
    EXPECT_EQ(firstLine(
                  "t { against x; runs (\"run/workPrecision/{*}/{*}\"); name \"<2> of <1>\"; figures ( { name n; value \"2\"; } ); }"),
              "8 of v,n,2,-");
    EXPECT_EQ(
        firstLine(
            "t { against x; runs (a); lines { name \"t = %.1f\"; of \"$Time\"; every 1; table conservation; } figures ( { name K; value \"$kineticEnergy\"; } ); }"),
        "t = 0.0,K,8,-; t = 1.0,K,18,-");
    // Of a run that goes on from 3 s: no rows in place of those that it has not.
    EXPECT_EQ(
        firstLine(
            "t { against x; runs (a); lines { name \"%.1f\"; of \"$Time\"; every 1; } table late; figures ( { name q; value \"$q\"; } ); }"),
        "3.0,q,1,-; 4.0,q,4,-");
}

// What no comparison orders is neither the largest nor passed over.
TEST(Figures, NoExtremesOfWhatIsNoNumber)
{
    for (const std::string operation : {"min", "max", "farthest"})
        EXPECT_EQ(figure("table errors; select { field p; } operation " + operation + "; value \"$value\";"),
                  figure("table errors; select { field p; } operation mean; value \"$value\";"))
            << operation;
}

// Between the rows of another table, the first that have the place between them; exact in the order of the path, which turns back.
TEST(Figures, LookUpsInOtherTables)
{
    const auto at = [](const std::string& place, const std::string& more)
    {
        return figure(
            "table conservation; operation first; value \"$q\"; lookUps ( { name q; table \"reference/path.csv\"; select { kind x; } key \"$strain\"; at \"" +
            place + "\"; value \"$q\"; " + more + "} );");
    };
    EXPECT_EQ(at("0.25", ""), "2.5");
    EXPECT_EQ(at("0.5", ""), "5");
    EXPECT_EQ(at("0.5", "match exact; "), "20");
    EXPECT_EQ(at("7", ""), ""); // no row has it
    // A word of the run's in the name of the table.
    EXPECT_EQ(
        firstLine(
            "t { against x; runs (\"run/{a}\"); table conservation; figures ( { name n; operation first; value \"$q\"; lookUps ( { name "
            "q; table \"reference/p<1>th.csv\"; select { kind x; } key \"$strain\"; at \"0.25\"; value \"$q\"; } ); } ); }"),
        "a,n,2.5,-");
}

// What is wrong is said at the entry, with what there is in its place.
TEST(Figures, MistakesNameWhatThereIs)
{
    EXPECT_NE(
        figure("table conservation; value \"$kinetic\";")
            .find(
                "system/figuresDict:3: \"$kinetic\": run/a/postProcessing/conservation/0/conservation.dat has no column or number \"kinetic\". "),
        std::string::npos);
    EXPECT_NE(figure("table conservation; value \"$kineticEnerg\";").find("Did you mean \"kineticEnergy\"?"), std::string::npos);
    EXPECT_NE(figure("table conservatio; value \"$Time\";")
                  .find("system/figuresDict:3: run/a/postProcessing: there is no table \"conservatio\". Did you mean \"conservation\"?"),
              std::string::npos);
    EXPECT_NE(figure("table \"errors/0\"; select { fild p; } value \"$L2\";").find("has no column \"fild\". Did you mean \"field\"?"),
              std::string::npos);
    EXPECT_NE(figure("table errors; value \"$field\";").find("errors.dat:2: column \"field\" holds \"p\", which is no number"),
              std::string::npos);
    EXPECT_NE(figure("table conservation; value \"$momentum\";").find("take a component"), std::string::npos);
    EXPECT_NE(figure("value \"1 +\";").find("system/figuresDict:3: \"1 +\": a value is missing at the end"), std::string::npos);
    EXPECT_NE(figure("value \"1\"; format \"%s\";").find("system/figuresDict:3: \"%s\" is no format of one number"), std::string::npos);
    EXPECT_NE(figure("value \"1\"; operatio max;").find("Did you mean \"operation\"?"), std::string::npos);
    EXPECT_NE(firstLine("t { against \"a, b\"; figures (); }").find("a comma parts the columns"), std::string::npos);
    EXPECT_NE(
        firstLine("t { against x; runs (\"run/bond{*}\"); figures ( { name n; value \"2\"; } ); }").find("{*} stands for a whole folder"),
        std::string::npos);
}

// What workPrecision has written: errors in %, their order, steps and processor time once a run; several times are told apart.
TEST(Figures, OfASweep)
{
    auto all = files("t { type workPrecision; against exact; }");
    all["log.workPrecision"] = "Runs\nPareto front of L2(U):\n    suite\n";
    all["postProcessing/workPrecision/results.csv"] =
        "variant,resolution,spacing,nParticles,steps,cpuSeconds,wallSeconds,peakMemory,time,field,norm,error,order,status,inputs\n"
        "suite,8,0.125,64,310,0.0703,0.154,10125312,1,U,L2,0.0108,,ok,0287bf9f41127e2d\n"
        "suite,8,0.125,64,310,0.0703,0.154,10125312,2,U,L2,0.0208,1.5,ok,0287bf9f41127e2d\n";
    const TestCase c(all);
    const auto plans = readFigurePlan(Dictionary::read(c.folder(), figuresDictionary, std::make_shared<Diagnostics>()));
    const auto table = makeFigures(c.folder(), plans.at(0));
    std::string text;
    for (const auto& f : table.recorded) text += f.run + "," + f.figure + "," + f.value + "," + f.unit + "," + f.against + "\n";
    EXPECT_EQ(text, "suite 8,L2(U) at 1,1.08,%,exact\nsuite 8,steps,310,-,-\nsuite 8,processor time,0.07,s,-\n"
                    "suite 8,L2(U) at 2,2.08,%,exact\nsuite 8,order of L2(U) at 2,1.50,-,exact\n");
    EXPECT_EQ(table.text, "\nPareto front of L2(U):\n    suite\n");
    recordFigures(c.folder(), table.recorded, "v1", "machine");
    EXPECT_TRUE(contentsOf(c.folder() / "run/results.csv").starts_with("suite 8,L2(U) at 1,1.08,%,exact,20"));
    EXPECT_TRUE(contentsOf(c.folder() / "run/results.csv").ends_with(",v1,machine\n"));
}

}
}
