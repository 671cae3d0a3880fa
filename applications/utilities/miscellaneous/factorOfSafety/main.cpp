/// The factor of safety of soil by strength reduction.
#include "base/CommandLine.hpp"
#include "base/OutputFile.hpp"
#include "case/Case.hpp"
#include "dictionary/DictionaryText.hpp"
#include "figures/FigurePlan.hpp"
#include "figures/FigureTable.hpp"
#include "sweeps/CaseCopy.hpp"
#include "sweeps/ChildProcess.hpp"
#include <fmt/format.h>
#include <fstream>

namespace
{

namespace fs = std::filesystem;

struct Options
{
    double low = 0, high = 0;
    double tolerance = 0.02, speed = 1e-3; ///< of the factor, [m/s]
};

/// Runs of a case with its strength divided by one factor after another, a folder and a line of factors.csv each.
class StrengthReduction
{
    fs::path case_, runs_;
    double speed_;
    std::string solver_, phase_;

    /// The application in the folder of a run; throws CaseError with the log to read.
    static void runIn(const fs::path& folder, const std::string& application)
    {
        const auto program = sph::findProgram(application);
        if (!program) throw sph::CaseError(fmt::format("there is no application \"{}\"", application));
        sph::ProcessTask task;
        task.command = {program->string()};
        task.folder = folder;
        task.log = folder / ("log." + application);
        const auto outcome = sph::runProcess(task);
        if (!outcome.well()) throw sph::CaseError(fmt::format("{} failed: {}; read {}", application, outcome.inWords(), task.log.string()));
    }

    /// Root mean square speed at the end of a run [m/s].
    double lastSpeed(const fs::path& folder) const
    {
        const auto mistakes = std::make_shared<sph::Diagnostics>();
        const auto text =
            fmt::format("name speed; table conservation; operation last; value \"sqrt(2*$kineticEnergy/$mass_{})\"; format %.17g;", phase_);
        const auto figure = sph::readOneFigure(sph::Dictionary::parse(text, "factorOfSafety", mistakes));
        mistakes->throwIfAny();
        return std::stod(sph::makeFigure(folder, figure));
    }

public:
    StrengthReduction(const fs::path& caseFolder, const Options& o)
        : case_(caseFolder), runs_(caseFolder / "run" / "factorOfSafety"), speed_(o.speed)
    {
        const sph::Case c(caseFolder);
        const auto control = c.dictionary("system/controlDict"), phases = c.dictionary("constant/phaseProperties");
        solver_ = control.get("application", "sphFoamLike");
        const auto names = phases.get<std::vector<std::string>>("phases");
        const double end = control.get<double>("endTime");
        const auto damping = c.dictionary("system/sphSchemes").subDictOrEmpty("integration").subDictOrEmpty("damping");
        const double until = damping.get<double>("until", 0);
        if (until < end)
            damping.error(
                damping.found("until") ? "until" : "",
                "the damping of integration is to last beyond endTime: without it soil that stands rings on, and is taken for soil that fails");
        c.diagnostics().throwIfAny();
        phase_ = names.front();
        sph::createFolders(runs_);
        std::ofstream(runs_ / "factors.csv") << "factor,root mean square speed [m/s],fails\n";
    }

    /// Soil fails where it finds no equilibrium: at endTime it is faster than the bound.
    bool fails(double factor) const
    {
        const auto name = sph::shortestText(factor);
        const auto folder = runs_ / name;
        sph::copyInputs(case_, folder, false);
        sph::setEntry(folder, "constant/soilProperties", "reduceStrength", name);
        for (const auto& application : {std::string("packParticles"), std::string("meshToGhost"), solver_}) runIn(folder, application);
        const double speed = lastSpeed(folder);
        const bool fails = speed > speed_;
        std::ofstream(runs_ / "factors.csv", std::ios::app) << fmt::format("{},{:.6g},{:d}\n", name, speed, fails);
        fmt::print(stderr, "factor {}: {:.6g} m/s at the end, {}\n", name, speed, fails ? "fails" : "stands");
        return fails;
    }
};

double findFactor(const fs::path& caseFolder, const Options& o)
{
    if (!(o.low > 0 && o.high > o.low)) throw sph::CaseError(fmt::format("factors {} and {} are to be positive and grow", o.low, o.high));
    const StrengthReduction reduction(caseFolder, o);
    double low = o.low, high = o.high;
    if (reduction.fails(low)) throw sph::CaseError(fmt::format("the soil fails by the factor {} already: give a smaller one", low));
    if (!reduction.fails(high)) throw sph::CaseError(fmt::format("the soil stands by the factor {} still: give a larger one", high));
    while (high - low > o.tolerance * 1.000001)
    {
        const double factor = 0.5 * (low + high);
        (reduction.fails(factor) ? high : low) = factor;
    }
    return 0.5 * (low + high);
}

}

int main(int argc, char** argv)
{
    Options o;
    return sph::runApplication(
        "factorOfSafety", argc, argv,
        "Finds the factor by which the strength of soil may be divided until it fails: runs the case with `reduceStrength` of\n"
        "constant/soilProperties at the middle of an interval of factors, and halves it. Soil fails that is not at rest at endTime; the\n"
        "load is to be on from the start, under damping of a rate. Runs and factors.csv are in run/factorOfSafety; prints the factor.",
        [&](sph::CommandLine& line)
        {
            line.argument("low", o.low, "A factor by which the soil stands").required();
            line.argument("high", o.high, "One by which it fails").required();
            line.option("tolerance", o.tolerance, "width", "Width of the last interval (default 0.02)").positive();
            line.option("speed", o.speed, "speed", "Root mean square speed above which it fails [m/s] (default 1e-3)").positive();
        },
        [&](const fs::path& caseFolder)
        {
            fmt::print("{:.6g}\n", findFactor(caseFolder, o));
            return 0;
        },
        sph::Banner::none);
}
