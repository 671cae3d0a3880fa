#include "checkCase.hpp"
#include "base/OutputFile.hpp"
#include "base/readText.hpp"
#include "case/RunTime.hpp"
#include "geometry/readShapes.hpp"
#include "packing/Packing.hpp"
#include "sampling/FunctionLibraries.hpp"
#include "sampling/FunctionObject.hpp"
#include "sampling/Measurement.hpp"
#include "solver/readSettings.hpp"
#include "sweeps/ChildProcess.hpp"
#include <algorithm>
#include <sstream>

namespace sph
{

namespace
{

bool contains(const std::vector<std::string>& words, const std::string& word) { return std::ranges::find(words, word) != words.end(); }

/// Meshes are walls once meshToGhost has prepared them: in the copy here, as in each run.
void prepareMeshes(const Case& c)
{
    if (meshWalls(c.dictionary("constant/geometry")).empty()) return;
    ProcessTask task;
    task.command = {findProgram("meshToGhost").value().string()};
    task.folder = c.folder();
    task.log = c.folder() / "log.meshToGhost";
    if (runProcess(task).well()) return;
    std::string reason;
    const auto log = readText(task.log, reason).value_or(reason), failure = failureIn(log);
    throw CaseError(failure.empty() ? "meshToGhost: " + log : failure);
}

/// Reads the case as sphFoamLike begins, with meshToGhost's walls made on the spot.
void readAsSolver(const Case& c, CaseCheck& check)
{
    RunTime time(c);
    check.endTime = time.endTime();
    const auto& control = time.controlDict();
    loadLibraries(control);
    control.get<std::string>("application", "sphFoamLike");
    const auto resolution = readResolution(c.dictionary("system/sphSchemes"));
    check.spacing = resolution.spacing;
    const auto dict = c.dictionary("constant/geometry");
    const auto geometry = readGeometry(dict, resolution, supportsOfSolver, c.folder());
    dict.reportUnused();
    const auto settings = readSettings(c, geometry);
    const FunctionObjects functions(control.subDictOrEmpty("functions"), geometry, settings.coefficients.phases, time);
    control.reportUnused();
}

}

std::vector<std::string> filesReadWhole(const std::vector<std::string>& programs)
{
    std::vector<std::string> files;
    if (contains(programs, "sphFoamLike"))
        files = {"system/controlDict", "system/sphSchemes", "constant/geometry", "constant/phaseProperties", "constant/g"};
    if (contains(programs, "packParticles")) files.push_back("system/packParticlesDict");
    return files;
}

CaseCheck checkCase(const std::filesystem::path& folder, const std::vector<std::string>& programs)
{
    const Case c(folder);
    CaseCheck check;
    createFolders(folder / "0"); // which packParticles would have made
    try
    {
        if (contains(programs, "meshToGhost")) prepareMeshes(c);
        if (contains(programs, "sphFoamLike")) readAsSolver(c, check);
        if (contains(programs, "packParticles")) readPackingPlan(c);
        if (check.spacing == 0) check.spacing = readResolution(c.dictionary("system/sphSchemes")).spacing;
        if (check.endTime == 0) check.endTime = TimeControls::read(c.dictionary("system/controlDict")).end();
        c.diagnostics().throwIfAny();
    }
    catch (const CaseError& e)
    {
        std::istringstream lines(e.what());
        for (std::string line; std::getline(lines, line);)
            if (!line.ends_with(" errors")) check.mistakes.push_back(line); // the last line is their count
    }
    return check;
}

std::vector<std::string> errorFields(const Dictionary& function)
{
    const auto measures = measureNames();
    std::vector<std::string> fields;
    const auto add = [&](const Dictionary& comparison)
    {
        const auto reference = comparison.subDictOrEmpty("reference");
        const auto name = reference.get("name", "");
        if (reference.get("type", "") == "formula" && contains(measures, name)) return fields.push_back(name);
        const auto field = comparison.get("field", ""), component = comparison.get("component", "");
        if (!field.empty()) fields.push_back(component.empty() ? field : field + "." + component);
    };
    const auto numbers = function.subDictOrEmpty("numbers");
    for (const auto& name : numbers.keys())
        if (numbers.subDict(name).found("reference")) fields.push_back(name);
    if (!function.found("fields")) add(function);
    else
        for (const auto& comparison : function.dictionaries("fields")) add(comparison);
    return fields;
}

}
