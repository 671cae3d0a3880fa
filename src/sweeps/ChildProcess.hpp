/// Child process: runs a program on one core and measures its time and memory.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

struct ProcessTask
{
    /// Program, by its path, and arguments, passed as they are: no shell reads them.
    std::vector<std::string> command;
    std::filesystem::path folder;    ///< to run in
    std::filesystem::path log;       ///< takes what it writes
    std::optional<int> core;         ///< to stay on
    std::optional<double> wallLimit; ///< [s]
    /// Asked some times a second; false ends the program.
    std::function<bool()> goOn = [] { return true; };
};

struct ProcessOutcome
{
    int exitCode = 0;
    int signal = 0;            ///< that ended it, 0 where none did
    bool reachedLimit = false; ///< stopped at the limit
    bool stopped = false;      ///< because goOn said so
    double wallSeconds = 0;
    double cpuSeconds = 0; ///< of all its threads, in user and system mode
    double peakMemory = 0; ///< [byte] largest resident size

    bool well() const { return exitCode == 0 && signal == 0 && !reachedLimit && !stopped; }
    /// "exit code 1", "killed by signal 11 (Segmentation fault)"
    std::string inWords() const;
};

/// Starts it and waits for its end. A program that is stopped, or passes its limit, is asked to end (TERM) and five seconds later made
/// to (KILL), with all that it has started. It ends with this process, however this one ends. Throws CaseError where it cannot start.
ProcessOutcome runProcess(const ProcessTask&);

/// The path of a program: a sibling of this executable, or on PATH; nothing where there is none.
std::optional<std::filesystem::path> findProgram(const std::string& name);

/// Message with which an application of the suite ended, from the text of its log, line by line; "" where there is none.
std::string failureIn(const std::string& log);

/// Cores that this process may run on.
std::vector<int> usableCores();

}
