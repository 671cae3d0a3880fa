/// Tests of the laboratory on one element of soil: see src/elementTests.
#include "base/CommandLine.hpp"
#include "base/OutputFile.hpp"
#include "elementTests/calibrate.hpp"
#include "elementTests/readCalibration.hpp"
#include "elementTests/readElementTests.hpp"
#include "elementTests/writeElementTests.hpp"
#include "sweeps/ChildProcess.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace
{

const std::filesystem::path output = "postProcessing/elementTest";

void draw(const sph::Case& c, const std::vector<sph::ElementTest>& tests, const sph::SoilLaw& law)
{
    const auto gnuplot = sph::findProgram("gnuplot");
    if (!gnuplot)
        throw sph::CaseError(
            {sph::elementTestDictionary, 0},
            "the plots need gnuplot, which is not installed: install the package gnuplot-nox (etc/setup does), or say `plots no;`");
    const auto folder = c.folder() / output;
    sph::writeFile(folder / "elementTests.gp", sph::elementPlots(tests, law));
    sph::ProcessTask task;
    task.command = {gnuplot->string(), "elementTests.gp"};
    task.folder = folder;
    task.log = folder / "log.gnuplot";
    if (const auto outcome = sph::runProcess(task); !outcome.well())
        throw sph::CaseError(fmt::format("gnuplot could not draw {}: {}; read {}", (output / "elementTests.gp").string(), outcome.inWords(),
                                         (output / "log.gnuplot").string()));
    std::filesystem::remove(task.log);
}

void printTest(const sph::ElementTest& test, const std::vector<sph::ElementRow>& rows)
{
    int subSteps = 0, rejected = 0;
    for (const auto& row : rows)
    {
        subSteps += row.subSteps.accepted;
        rejected += row.subSteps.rejected;
    }
    const auto free = std::ranges::count(rows, sph::StressState::stressFree, &sph::ElementRow::state);
    const auto& end = rows.back();
    fmt::print("{:<24} {:<20} p {:>11.6g} Pa, q {:>11.6g} Pa, volume strain {:>+12.6g}; {} rows, {} substeps, {} rejected{}\n", test.name,
               test.type, -trace(end.stress) / 3, sph::deviatorStress(end.stress), trace(end.strain), rows.size(), subSteps, rejected,
               free ? fmt::format("; free of stress in {} rows", free) : "");
    std::fflush(stdout);
}

int runTests(const sph::Case& c)
{
    const auto properties = c.dictionary(sph::soilProperties);
    const auto soil = sph::readSoil(properties, "within");
    for (const auto* ofBodies : {sph::initialStressKeyword, sph::confiningPressureKeyword, sph::poreWaterKeyword})
        properties.ignore(ofBodies);
    properties.reportUnused();
    const auto plan = sph::readElementTests(c, soil.law);
    c.diagnostics().throwIfAny();
    for (const auto& warning : c.diagnostics().warnings()) fmt::print("Warning: {}\n", warning);
    if (const auto* law = std::get_if<sph::WuBauer>(&soil.law))
        fmt::print("Earth pressure at rest, K_0 by eq. (21): {:.6f}\n", law->K0().value());
    if (const auto strength = sph::strengthInWords(soil.law); !strength.empty()) fmt::print("Strength: {}\n", strength);
    sph::createFolders(c.folder() / output);
    for (const auto& test : plan.tests)
    {
        const auto rows = sph::runElementTest(soil, test);
        sph::writeElementTable(c.folder() / output / (test.name + ".csv"), test, soil.law, rows);
        printTest(test, rows);
    }
    if (plan.plots) draw(c, plan.tests, soil.law);
    fmt::print("\nEnd\n");
    return 0;
}

/// Constants of any law from several tests at once.
int runFit(const sph::Case& c)
{
    const auto law = sph::readSoil(c.dictionary(sph::soilProperties), "within").law;
    const auto plan = sph::readFit(c, law);
    const auto start = sph::startOf(c, plan.constants);
    c.diagnostics().throwIfAny();
    const auto trial = [&](const std::vector<double>& values)
    {
        const sph::Case other(c.folder());
        const auto soil = sph::readSoilWith(other, plan.constants, values);
        const auto tests = sph::readFit(other, soil.law).tests;
        other.diagnostics().throwIfAny();
        return std::pair(soil, tests);
    };
    const auto fit = sph::fitConstants(plan, start, trial);
    const auto name = std::visit([]<class Law>(const Law&) { return std::string(Law::name); }, law);
    std::string coeffs;
    fmt::print("{} constants of law {} from {} points of {} tests\n\n{:<28} {:>13} {:>13} {:>13} {:>13} {:>13}\n", fit.constants.size(),
               name, fit.points, plan.tests.size(), "constant", "value", "std. error", "+- 95 %", "least", "largest");
    for (std::size_t k = 0; k < fit.constants.size(); ++k)
    {
        const auto& [entry, least, largest, where] = plan.constants[k];
        const auto& found = fit.constants[k];
        fmt::print("{:<28} {:>13.6g} {:>13.3g} {:>13.3g} {:>13.6g} {:>13.6g}{}\n", entry, found.value, found.standardError, found.halfWidth,
                   least, largest, found.onBound ? "   on its bound: not found within" : "");
        coeffs += sph::entryAs(name + "Coeffs." + entry, sph::shortestText(found.value)) + "\n";
    }
    fmt::print("\nroot mean square of what the points are off, over the largest of their curve:\n");
    for (std::size_t t = 0; t < plan.tests.size(); ++t)
        for (std::size_t k = 0; k < plan.tests[t].curves.size(); ++k)
            fmt::print("    {:<24} {:<18} {:.3g} %\n", plan.tests[t].test.name, plan.tests[t].curves[k].name, 100 * fit.misfits[t][k]);
    sph::createFolders(c.folder() / output);
    sph::writeFile(c.folder() / output / "calibration", coeffs);
    fmt::print("{}, to be included at the end of constant/soilProperties\n\nEnd\n", (output / "calibration").string());
    return 0;
}

int runCalibration(const sph::Case& c)
{
    if (sph::hasMeasuredTests(c)) return runFit(c);
    const auto measured = sph::readMeasurement(c);
    c.diagnostics().throwIfAny();
    const auto found = sph::calibrate(measured);
    const auto& law = found.law;
    const auto coeffs =
        fmt::format("law wuBauer;\nwuBauerCoeffs\n{{\n    c1 {};\n    c2 {};\n    c3 {};\n    c4 {};\n}}\n", sph::shortestText(law.c1),
                    sph::shortestText(law.c2), sph::shortestText(law.c3), sph::shortestText(law.c4));
    sph::createFolders(c.folder() / output);
    sph::writeFile(c.folder() / output / "calibration", coeffs);
    fmt::print("c1 {:.6g}, c2 {:.6g}, c3 {:.6g}, c4 {:.6g}; K_0 {:.6f}\n", law.c1, law.c2, law.c3, law.c4, law.K0().value());
    if (found.misfitStress)
        fmt::print("root mean square of what the points are off: q {:.3g} % of the peak, volume strain {:.3g} % of its largest\n",
                   100 * *found.misfitStress, 100 * *found.misfitVolume);
    if (!(law.c4 > 9 * std::abs(law.c1))) fmt::print("Warning: c4 is not above 9 |c1|: some strain paths lead to tension\n");
    fmt::print("{}, for constant/soilProperties\n\nEnd\n", (output / "calibration").string());
    return 0;
}

}

int main(int argc, char** argv)
{
    bool calibrates = false;
    return sph::runApplication(
        "elementTest", argc, argv,
        "Tests soil of constant/soilProperties in one element, without SPH, as told by system/elementTestDict, and writes tables and plots into\n"
        "postProcessing/elementTest. Calibrates law wuBauer to one triaxial test, and any law to several tests at once.",
        [&](sph::CommandLine& line)
        { line.flag("calibrate", calibrates, "Find the constants that the section calibration asks for, and stop"); },
        [&](const std::filesystem::path& caseFolder)
        {
            const sph::Case c(caseFolder);
            return calibrates ? runCalibration(c) : runTests(c);
        });
}
