/// A ladder of runs: what is to be done, doing it one by one, and what came of it.
#pragma once
#include "base/Clock.hpp"
#include "sweeps/ChildProcess.hpp"
#include "sweeps/ResultTable.hpp"
#include "sweeps/SweepPlan.hpp"
#include <set>

namespace sph
{

/// Times of a table and of a dictionary are the same where they differ by less than the digits that either is written with.
bool sameTime(double a, double b);

inline const std::string resultFile = "postProcessing/workPrecision/results.csv";

/// Rows of other codes, from the files that the plan names; mistakes in a file go to the case's Diagnostics.
std::vector<ResultRow> readPeers(const Case&, const SweepPlan&);

class CaseSweep
{
public:
    /// Reads and checks everything, each variant at each resolution included; throws CaseError with all mistakes at once.
    explicit CaseSweep(const std::filesystem::path& caseFolder, const SweepSelection& = {});

    void printPlan() const;

    /// Runs what is not done yet, writes table and plots after the last, the table after each. Returns the exit code: 1 where no run
    /// ended well. Throws CaseError when it is interrupted (INT, TERM).
    int run();

private:
    struct Step
    {
        std::string program;              ///< as the dictionary names it
        std::vector<std::string> command; ///< path and arguments
        bool timed = false;               ///< counts as cost
    };
    struct Run
    {
        PlannedRun plan;
        double spacing = 0, endTime = 0; ///< [m], [s]
        std::string inputs;              ///< stamp
        std::vector<ResultRow> rows;     ///< one for each error, once it is done
    };

    Case case_;
    SweepPlan plan_;
    std::filesystem::path runFolder_, outputFolder_;
    std::vector<Step> steps_;
    std::vector<Run> runs_;
    std::vector<ResultRow> peers_;
    std::optional<std::filesystem::path> gnuplot_;
    int core_ = 0;
    bool keepOld_ = false; ///< results.csv has rows that this ladder does not use
    std::set<std::string> baseMistakes_;

    void findPrograms();
    void checkRuns();
    void checkOverrides(const Run&);
    void checkErrors(const Run&, const std::filesystem::path& copy, bool endIsKnown);
    void reportMistakes(const Run&, const std::filesystem::path& copy, const std::vector<std::string>& mistakes);
    void takeOldRows();

    std::filesystem::path folderOf(const Run&) const;
    std::vector<std::string> programs() const;
    bool packs() const;
    double timeOf(const ErrorChoice&, const Run&) const;
    bool isFinal(const ResultRow&) const;
    std::string expectedFinish(std::size_t next) const;

    struct Cost
    {
        double cpuSeconds = 0, wallSeconds = 0, peakMemory = 0;
    };
    void execute(Run&);
    /// The status of the run, and in `note` what to say of it.
    std::string executeSteps(const Run&, Cost&, std::string& note);
    std::string readErrors(const Run&, std::vector<ResultRow>&, std::string& note) const;

    std::vector<ResultRow> rowsOf(std::size_t error) const;
    std::vector<ResultRow> peersOf(std::size_t error) const;
    std::string titleOf(std::size_t error) const;
    std::string stemOf(std::size_t error) const;
    void writeTable();
    void printTable(std::size_t error) const;
    void draw() const;
};

/// The rows of a sweep and, behind them, those of its peers, as comma-separated values. Throws CaseError where nothing has been run.
std::string sweepTable(const std::filesystem::path& caseFolder);

}
