/// A table of figures as it is printed and recorded.
#pragma once
#include "figures/FigurePlan.hpp"

namespace sph
{

struct FigureLine
{
    std::string name;
    std::vector<std::string> cells; ///< "-" where there is no value
    std::string day;                ///< of the run, 2026-01-31
};

/// A figure that goes to run/results.csv.
struct RecordedFigure
{
    std::string run, figure, value, unit, against, day;
};

struct FigureTable
{
    std::string text; ///< as printed
    std::vector<RecordedFigure> recorded;
    std::vector<std::string> missing; ///< folders of runs that have not been made, relative to the case; sweeps
    std::size_t lines = 0;
};

/// Computes a table. Throws CaseError where a figure cannot be had.
FigureTable makeFigures(const std::filesystem::path& caseFolder, const TablePlan&);

/// One figure of the case itself, as its format has it.
std::string makeFigure(const std::filesystem::path& caseFolder, const NumberPlan&);

/// Lines `run,figure,value,unit,against,day,version,machine` to the end of run/results.csv; `version`, `machine` of the program that measured.
void recordFigures(const std::filesystem::path& caseFolder, const std::vector<RecordedFigure>&, const std::string& version,
                   const std::string& machine);

/// The processor's name, without commas.
std::string machineName();

}
