#include "elementTests/writeElementTests.hpp"
#include "base/OutputFile.hpp"
#include <fmt/format.h>

namespace sph
{

namespace
{

const char* wordOf(StressState state)
{
    switch (state)
    {
    case StressState::regular:
        return "regular";
    case StressState::stressFree:
        return "stressFree";
    case StressState::inadmissible:
        return "inadmissible";
    default:
        return "unresolved";
    }
}

}

TableInfo elementTestTable()
{
    return {"elementTest",
            "<test>.csv",
            "a row a state of the element; tension and extension are positive, but in p, q",
            {{"path", "", "strain [-] or angle [degrees] that the test is driven by"},
             {"strain.<xx>", "-", "component of the strain, the sum of D dt"},
             {"stress.<xx>", "Pa", "component of the effective stress"},
             {"volumeStrain", "-", "trace of the strain"},
             {"p", "Pa", "mean pressure, -tr(stress)/3"},
             {"q", "Pa", "deviator stress, (3 J2)^1/2"},
             {"K", "-", "stress.xx over stress.zz"},
             {"state", "", "regular, or what the law could not do: stressFree, inadmissible, unresolved"},
             {"subSteps", "", "substeps since the row before"},
             {"rejected", "", "substeps of these that were made again, shorter"}}};
}

void writeElementTable(const std::filesystem::path& file, const std::vector<ElementRow>& rows)
{
    std::string text;
    const auto add = [&](const Column& column)
    { text += (text.empty() ? "" : ",") + column.name + (column.unit.empty() ? "" : fmt::format(" [{}]", column.unit)); };
    for (const auto& column : elementTestTable().columns)
        if (column.name.find('<') == std::string::npos) add(column);
        else
            for (const auto component : SymmTensor<3>::names) add(column.of(std::string(component)));
    text += "\n";
    for (const auto& row : rows)
    {
        text += shortestText(row.path) + ",";
        for (const auto& tensor : {row.strain, row.stress})
            for (const auto component : symmComponents) text += shortestText(tensor.*component) + ",";
        const double K = row.stress.zz != 0 ? row.stress.xx / row.stress.zz : 0;
        text += fmt::format("{},{},{},{},{},{},{}\n", shortestText(trace(row.strain)), shortestText(-trace(row.stress) / 3),
                            shortestText(deviatorStress(row.stress)), shortestText(K), wordOf(row.state), row.subSteps.accepted,
                            row.subSteps.rejected);
    }
    writeFile(file, text);
}

std::string elementPlots(const std::vector<ElementTest>& tests)
{
    std::string script =
        "# Written by elementTest; draws itself again with `gnuplot elementTests.gp`. Principal stresses here are compression positive.\n"
        "set datafile separator ','\nset terminal pngcairo size 1200,400 font ',10'\nset grid\nset key noenhanced\n";
    for (const auto& test : tests)
        script += fmt::format("\nset output '{0}.png'\nset multiplot layout 1,3 title '{0}' noenhanced\n"
                              "set xlabel '{1}'\nset ylabel 'compressive stress [kPa]'\n"
                              "plot '{0}.csv' using 'path':(-1e-3*column('stress.xx [Pa]')) with lines title 'xx', "
                              "'' using 'path':(-1e-3*column('stress.yy [Pa]')) with lines dt 2 title 'yy', "
                              "'' using 'path':(-1e-3*column('stress.zz [Pa]')) with lines title 'zz', "
                              "'' using 'path':(1e-3*column('stress.xz [Pa]')) with lines title 'shear, xz'\n"
                              "set ylabel 'volume strain, extension positive [-]'\n"
                              "plot '{0}.csv' using 'path':'volumeStrain [-]' with lines notitle\n"
                              "set xlabel 'p [kPa]'\nset ylabel 'q [kPa]'\n"
                              "plot '{0}.csv' using (1e-3*column('p [Pa]')):(1e-3*column('q [Pa]')) with lines notitle\nunset multiplot\n",
                              test.name, test.pathAxis);
    return script;
}

}
