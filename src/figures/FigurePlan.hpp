/// Tables of figures of a case's runs, as system/figuresDict states them.
///
///     tables
///     {
///         rest
///         {
///             against "hydrostatic pressure";
///             runs    (calm "run/workPrecision/{oneLayer twoLayers}/{16 32}");
///             numbers                                                          // by which figures are computed
///             {
///                 first { operation first; table conservation; value "$kineticEnergy"; }
///             }
///             figures
///             (
///                 { name "L2(p) [%]"; format "%.2f"; table errors; select { field p; } value "100*$L2"; }
///                 { name "largest kinetic energy [J]"; table conservation; operation max; value "$kineticEnergy"; where "$Time > 0.1"; }
///                 { name "energy over that of the start [-]"; table conservation; value "$kineticEnergy/$first"; }
///                 { name "processor time [s]"; format "%.0f"; value "$processorTime"; }
///             );
///         }
///         sweep { type workPrecision; against "exact solution"; }              // what workPrecision has found
///     }
///
/// A table is a line for each run, or with `lines` one for each row of a table. Tables that a run has not written can be made of those that it has:
///
///     derivedTables
///     {
///         halfPeriods { type crossings; table conservation; along "$Time"; value "$momentum_x"; }      // $number $place $interval $peak
///         pressures   { type columns; table "pressure/p"; }                                            // $column $value
///     }
#pragma once
#include "dictionary/EntryList.hpp"
#include <filesystem>
#include <map>

namespace sph
{

/// The words or numbers that a column may hold, by its name.
using Selection = std::map<std::string, std::vector<std::string>>;

/// A column that is looked up in another table: the value there at the place where `key` comes to `at`.
struct LookUpPlan
{
    std::string name, table, key, at, value;
    Selection select;
    bool exact = false;
    Dictionary dict;
};

/// A number of a run.
struct NumberPlan
{
    explicit NumberPlan(Dictionary d) : dict(std::move(d)) {}
    std::string name, operation, value, where, table, log, pattern, file, entry;
    bool ofLogs = false; ///< of what the logs tell, a row each
    Selection select;
    std::vector<std::string> columns;
    std::vector<LookUpPlan> lookUps;
    Dictionary dict;
    bool isFigure = false;
    std::string unit, format; ///< of a figure
};

/// A table that is made of another one of the run.
struct DerivedTablePlan
{
    explicit DerivedTablePlan(Dictionary d) : dict(std::move(d)) {}
    std::string name, type, table, value, along;
    Dictionary dict;
};

struct PlannedRunFolder
{
    std::string name;                    ///< <1>, <2> .. in it stand for the words
    std::filesystem::path folder;        ///< relative to the case; * in it for any name
    std::vector<std::string> words = {}; ///< that were put into curly brackets
    std::map<std::string, double> constants;
};

/// Rows of which each is a line of its own.
struct LinesPlan
{
    explicit LinesPlan(Dictionary d) : dict(std::move(d)) {}
    std::string name, of, table, where;
    double every = 0;
    Selection select;
    Dictionary dict;
};

struct TablePlan
{
    explicit TablePlan(Dictionary d) : dict(std::move(d)) {}
    std::string name, against, unit;
    bool isSweep = false, recorded = true;
    std::vector<PlannedRunFolder> runs;
    std::vector<DerivedTablePlan> derivedTables;
    std::vector<NumberPlan> numbers, figures;
    std::optional<LinesPlan> lines;
    Dictionary dict;
};

inline const std::string figuresDictionary = "system/figuresDict";

/// Every mistake goes to the dictionary's Diagnostics.
std::vector<TablePlan> readFigurePlan(const Dictionary&);
/// `name` with the words in place of <1>, <2> ..
std::string filledName(std::string name, const std::vector<std::string>& words);

/// The folders that there are in place of one with *, numbers by their value, and their names.
std::vector<PlannedRunFolder> foldersOf(const PlannedRunFolder&, const std::filesystem::path& caseFolder);

/// One of the figures of a table.
NumberPlan readOneFigure(const Dictionary&);
EntryList figureEntries();

/// "run/{a b}/{8 16}" as (run/a/8, run/a/16, run/b/8, run/b/16), each with the words that were put into it. Throws std::invalid_argument of a bracket
/// that is not closed.
std::vector<std::pair<std::string, std::vector<std::string>>> expandBraces(const std::string& pattern);

}
