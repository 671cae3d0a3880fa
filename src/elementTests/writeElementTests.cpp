#include "elementTests/writeElementTests.hpp"
#include "base/OutputFile.hpp"
#include <algorithm>
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
             {"rejected", "", "substeps of these that were made again, shorter"},
             {"voidRatio", "-", "with a law that has it"},
             {"intergranularStrain.<xx>", "-", "component of it, with a law that has it"},
             {"porePressure", "Pa", "of the water since the last drained piece, of undrained tests: the total lateral stress is held"},
             {"stage", "", "its name, of tests with stages"}}};
}

namespace
{

/// Names of the components of the law's state variables, as columns have them.
std::vector<std::string> variableColumns(const SoilLaw& any)
{
    std::vector<std::string> names;
    std::visit(
        [&]<class Law>(const Law&)
        {
            using Variables = typename StateOf<Law>::Variables;
            std::size_t k = 0;
            const auto add = [&]<class Part>(const Part&)
            {
                const std::string name = Variables::names[k++].name;
                if constexpr (std::is_same_v<Part, SymmTensor<3>>)
                    for (const auto component : SymmTensor<3>::names) names.push_back(name + "." + std::string(component));
                else names.push_back(name);
            };
            const Variables variables{};
            Variables::parts(variables, [&](const auto&... part) { (add(part), ...); });
        },
        any);
    return names;
}

bool isUndrained(const ElementTest& test)
{
    return std::ranges::any_of(test.legs, [](const ElementLeg& leg) { return !leg.drains; });
}

}

void writeElementTable(const std::filesystem::path& file, const ElementTest& test, const SoilLaw& law, const std::vector<ElementRow>& rows)
{
    std::string text;
    const auto variables = variableColumns(law);
    const bool undrained = isUndrained(test), staged = !rows.back().stage.empty();
    const auto name = [&](const std::string& column, const std::string& unit)
    { text += (text.empty() ? "" : ",") + column + (unit.empty() ? "" : fmt::format(" [{}]", unit)); };
    for (const auto& column : elementTestTable().columns)
    {
        if (column.name == "voidRatio")
        {
            for (const auto& variable : variables) name(variable, column.unit);
            if (undrained) name("porePressure", "Pa");
            if (staged) name("stage", "");
            break;
        }
        if (column.name.find('<') == std::string::npos) name(column.name, column.unit);
        else
            for (const auto component : SymmTensor<3>::names)
            {
                const auto of = column.of(std::string(component));
                name(of.name, of.unit);
            }
    }
    text += "\n";
    for (const auto& row : rows)
    {
        text += shortestText(row.path) + ",";
        for (const auto& tensor : {row.strain, row.stress})
            for (const auto component : symmComponents) text += shortestText(tensor.*component) + ",";
        const double K = row.stress.zz != 0 ? row.stress.xx / row.stress.zz : 0;
        text += fmt::format("{},{},{},{},{},{},{}", shortestText(trace(row.strain)), shortestText(-trace(row.stress) / 3),
                            shortestText(deviatorStress(row.stress)), shortestText(K), wordOf(row.state), row.subSteps.accepted,
                            row.subSteps.rejected);
        for (const double value : row.variables) text += "," + shortestText(value);
        if (undrained) text += "," + shortestText(row.porePressure);
        if (staged) text += "," + row.stage;
        text += "\n";
    }
    writeFile(file, text);
}

std::string elementPlots(const std::vector<ElementTest>& tests, const SoilLaw& law)
{
    const auto variables = variableColumns(law);
    const bool hasVoidRatio = std::ranges::find(variables, VoidRatio::names[0].name) != variables.end();
    std::string script = fmt::format(
        "# Written by elementTest; draws itself again with `gnuplot elementTests.gp`. Principal stresses here are compression positive.\n"
        "set datafile separator ','\nset terminal pngcairo size {},400 font ',10'\nset grid\nset key noenhanced\n",
        hasVoidRatio ? 1600 : 1200);
    for (const auto& test : tests)
    {
        script += fmt::format("\nset output '{0}.png'\nset multiplot layout 1,{2} title '{0}' noenhanced\n"
                              "set xlabel '{1}'\nset ylabel 'compressive stress [kPa]'\n"
                              "plot '{0}.csv' using 'path':(-1e-3*column('stress.xx [Pa]')) with lines title 'xx', "
                              "'' using 'path':(-1e-3*column('stress.yy [Pa]')) with lines dt 2 title 'yy', "
                              "'' using 'path':(-1e-3*column('stress.zz [Pa]')) with lines title 'zz', "
                              "'' using 'path':(1e-3*column('stress.xz [Pa]')) with lines title 'shear, xz'\n"
                              "set ylabel 'volume strain, extension positive [-]'\n"
                              "plot '{0}.csv' using 'path':'volumeStrain [-]' with lines notitle\n"
                              "set xlabel 'p [kPa]'\nset ylabel 'q [kPa]'\n"
                              "plot '{0}.csv' using (1e-3*column('p [Pa]')):(1e-3*column('q [Pa]')) with lines notitle\n",
                              test.name, test.pathAxis, hasVoidRatio ? 4 : 3);
        if (hasVoidRatio)
            script += fmt::format("set ylabel 'void ratio [-]'\nset logscale x\n"
                                  "plot '{}.csv' using (1e-3*column('p [Pa]')):'voidRatio [-]' with lines notitle\nunset logscale x\n",
                                  test.name);
        script += "unset multiplot\n";
    }
    return script;
}

}
