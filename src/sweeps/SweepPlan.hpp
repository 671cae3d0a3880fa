/// Plan of a sweep, as system/workPrecisionDict states it.
///
///     baseCase        ".";                        // default: the case itself
///     resolutions     (8 16 32);                  // $n below is one of these at a time
///     setResolution                               // what a resolution means: entries of the case's files, as changeDictionary has them
///     {
///         "system/sphSchemes" { resolution { spacing #eval "1e-3/$n"; } }
///     }
///     variants                                    // entries that differ; on top of setResolution. Default: one, called base
///     {
///         suite { }
///         paper { "system/sphSchemes" { scheme paper; } }
///     }
///     steps           (packParticles meshToGhost sphFoamLike);   // "reconstructSurface -latestTime" has an argument
///     repeats         1;                          // the least cost of several counts
///     timeLimit       600;                        // [s] for the steps of one run together; default: none
///     core            1;                          // default: the last one that this process may use
///     errors                                      // rows of postProcessing/<function>/<startTime>/errors.dat
///     (
///         { function errors; field U.x; norm L2; time 0.1; }     // default: function errors, norm L2, time: the end
///         { field laplaceJump; norm mean; averageFrom 1.2; }      // |mean value/mean reference - 1| from 1.2 s to the time: what rings
///         { field frontPosition; norm rms; averageFrom 0; }       // sqrt(mean (value - reference)^2/mean reference^2): what moves
///     );
///     peers           ("reference/interFoam.csv"); // other codes' rows, drawn beside; default: none
///     plots           yes;
///
/// `$n`, and every macro and #eval, is resolved when the dictionary is read, once for each resolution.
#pragma once
#include "dictionary/EntryList.hpp"
#include "sweeps/Override.hpp"
#include <optional>

namespace sph
{

/// Choice of the error of a run.
struct ErrorChoice
{
    std::string function, field, norm;
    std::optional<double> time;        ///< [s]; the end where there is none
    std::optional<double> averageFrom; ///< [s], of norms mean and rms
    Location whereFunction, whereField, whereTime;
};

/// A variant at a resolution.
struct PlannedRun
{
    std::string variant;
    double resolution = 0;
    Location where; ///< of the variant
    std::vector<Override> overrides;

    /// "paper/16", also the folder below run/workPrecision
    std::string name() const;
};

struct SweepPlan
{
    std::filesystem::path baseCase;
    std::vector<double> resolutions;
    std::vector<std::string> variants;
    /// Runs, all variants of the coarsest resolution first: the cost of a finer one is then known before it starts.
    std::vector<PlannedRun> runs;
    std::vector<std::string> steps;
    Location whereSteps;
    int repeats = 1;
    std::optional<double> timeLimit; ///< [s]
    std::optional<int> core;
    Location whereCore;
    std::vector<ErrorChoice> errors;
    std::vector<std::string> peers;
    bool plots = true;
};

inline const std::string sweepDictionary = "system/workPrecisionDict";

/// Every mistake goes to the case's Diagnostics.
SweepPlan readSweepPlan(const Case&);

/// A part of a sweep, as the command line chooses it.
struct SweepSelection
{
    std::vector<std::string> variants; ///< by name; empty: all
    int coarsest = 0;                  ///< as many resolutions, the coarsest ones; 0: all
};

/// Leaves the runs of the selection in the plan. Throws CaseError where the plan has no variant of that name.
void select(SweepPlan&, const SweepSelection&);
EntryList sweepEntries();

}
