/// The numbers of one run, from its tables, logs and dictionaries.
#pragma once
#include "figures/FigurePlan.hpp"
#include "figures/RunTable.hpp"
#include <functional>

namespace sph
{

class RunNumbers
{
    std::filesystem::path case_, folder_;
    std::vector<std::string> words_;
    std::map<std::string, double> known_; ///< constants of the run and numbers that have been found
    std::map<std::string, double> told_;  ///< by the run's own log
    std::map<std::string, RunTable> tables_;
    std::map<std::string, DerivedTablePlan> derived_;                            ///< those that have not been made yet
    std::map<std::string, std::optional<std::vector<std::string>>> linesOfLogs_; ///< of each that has been asked for, by its path

    const RunTable& table(const std::string& name);
    std::string log(const std::string& name) const;
    std::vector<std::string> logs(const std::string& name) const;
    /// Of a file relative to the case, read once; nothing where it is not there.
    const std::optional<std::vector<std::string>>& linesOfLog(const std::string& file);
    RunTable logged(const NumberPlan&);
    RunTable toldByLogs(const NumberPlan&);
    RunTable derive(const DerivedTablePlan&);
    RunTable crossings(const DerivedTablePlan&, const RunTable&);
    RunTable entryOf(const NumberPlan&) const;
    std::optional<double> ofTheLog(const std::string& name);

    using Rows = std::vector<std::size_t>;
    using Columns = std::map<std::string, std::vector<double>>;
    /// A name that is no column: a number, a constant, what the log tells.
    std::optional<double> number(const std::string& name);
    /// The value of an expression for each of the rows. `usesColumns`: whether it has any.
    std::vector<double> evaluate(const std::string& text, const Dictionary&, const std::string& key, const RunTable*, const Rows&,
                                 const Columns&, bool* usesColumns = nullptr);
    std::vector<std::optional<double>> lookUp(const LookUpPlan&, const RunTable&, const Rows&, const Columns&);
    void keepWhere(const std::string& text, const Dictionary&, const RunTable&, Rows&, Columns&);
    double reduced(const NumberPlan&, const RunTable*, std::optional<Rows> only = {});

public:
    /// `folder` relative to the folder of the case.
    RunNumbers(std::filesystem::path caseFolder, const PlannedRunFolder&);

    /// NaN where there is no row. Throws CaseError, at the entry of the dictionary where that is to be changed.
    double operator()(const NumberPlan&);
    /// The same of one row alone.
    double operator()(const NumberPlan&, std::size_t row);
    /// Makes a number known to the expressions that follow.
    void add(const NumberPlan&);
    /// Makes a table known by its name; it is made when it is asked for.
    void add(const DerivedTablePlan&);
    /// The rows of which each is a line, with the value of its name.
    std::vector<std::pair<std::size_t, double>> lines(const LinesPlan&);
    /// True where the run has been made: it has a log.
    bool isThere() const;
    /// Date of the newest log, 2026-01-31.
    std::string day() const;
};

/// What the numbers of a run may ask of its log, by name, and what it is.
const std::vector<std::pair<std::string, std::string>>& factsOfTheLog();

}
