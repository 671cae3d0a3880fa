/// Settings of a case, in words and numbers, before any particle is read. Models fill them (Model.hpp).
#pragma once
#include "case/Case.hpp"
#include "geometry/Geometry.hpp"
#include "kernels/Resolution.hpp"
#include "plan/Coefficients.hpp"
#include "plan/Plan.hpp"
#include "scene/Facts.hpp"
#include "scene/RunningModel.hpp"
#include "scene/State.hpp"
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sph
{

/// Fractions of the stability limits (how far from where steps fail: test/stability/README.md).
struct StepFactors
{
    double sound = 0.4, flow = 0.2, dampedSound = 0.25, stiffness = 1.2, viscous = 0.125, diffusive = 0.125, capillary = 0.5, force = 0.25;
};

/// Settings of the time integration: the words of `integration`.
struct Integration
{
    std::string scheme = "predictorCorrector";
    bool predicts = true;               ///< values half a step on are predicted, for the rates there
    bool keepsRates = false;            ///< the rates of a step predict those of the next
    bool solves = false;                ///< a step solves for velocities, with viscosity as a linear force (ImplicitSolve.hpp)
    bool solvesPressure = false;        ///< a step solves for pressure too
    bool viscosityAtStart = false;      ///< of such a step: viscosity acts as it is at its start, and is not solved for
    bool moves = true;                  ///< particles move; else time is that of the fields that they carry
    int maxSubSteps = 1;                ///< most substeps of a step, an odd number
    double theta = 1, tolerance = 1e-6; ///< theta and relative tolerance of the solve
    int maxIter = 1000;
    StepFactors factors;
    std::vector<double StepFactors::*>
        factorsOfRunningModels;              ///< factors of the limits that models give at run time (RunningModel.hpp), beside their own
    std::vector<std::string> responses;      ///< terms: response of forces to a change in velocity; those of the diagonal go with them
    double dampingRate = 0, dampedUntil = 0; ///< dv/dt = -rate v [1/s] until a time [s], for a start far from equilibrium
};

/// Bounds of density over rest density; a solution outside them is neither read nor written. Weakly compressible flow keeps within a few per cent,
/// the start of a crude packing within two.
inline constexpr double leastCompression = 1e-3, mostCompression = 4;

/// Names of the groups in a plan: the evaluation, the forces that act once a step, the solver's response.
inline constexpr const char *ofEvaluation = "evaluate", *onceAStep = "evaluate what acts once a step", *ofSolver = "response";

struct Settings
{
    Resolution resolution;
    Coefficients coefficients;
    Facts facts; ///< what the models tell one another
    Integration integration;
    std::string shaking; ///< acceleration added to gravity, an expression of `$t` (Shaking.hpp); empty where there is none

    bool mixedPrecision = false; ///< terms of pairs that can are computed in single precision

    bool hasGravity() const { return mag(coefficients.g) > 0 || !shaking.empty(); }

    State state;                                              ///< all fields that evolve
    std::vector<std::string> terms;                           ///< terms of an evaluation, by their names in the catalogues
    std::vector<std::string> slowTerms;                       ///< terms that act once in a step of several substeps, in its middle
    std::vector<Group> groups;                                ///< further groups of the plan
    std::map<std::string, std::vector<StateField>> ruleReads; ///< by field: fields that the rule of its images reads of their source
    Catalogue<2> terms2;                                      ///< terms of models that come in any number, beside the catalogues
    Catalogue<3> terms3;
    std::vector<std::pair<std::string, std::string>> shown; ///< derived fields in time folders: name, and that on disk
    std::vector<RunningModelMaker> runningModels;           ///< models that do more at run time than terms can say
    std::vector<std::string> reasons;                       ///< choices made for the user, and why: one line each for the log

    std::map<std::string, std::string> chosen;      ///< by entry: the word that a model has chosen
    std::map<std::string, FieldClass> fieldClasses; ///< classes of all fields that the models know, in this scene or not
    Names separateSums; ///< separate sums: fields into which some forces are summed besides the acceleration (the force on a wall, say)
    /// Fields of models that the scene does not have, and the message where a dictionary gives one.
    std::map<std::string, std::string> absent;

    std::vector<std::optional<Location>> automaticSound; ///< by phase: entry that leaves the sound speed to the suite
    double maxImbalance = 1.02;                          ///< of ranks: recent processor time of the busiest over the mean

    bool multiphase() const { return coefficients.phases.size() > 1; }
    /// Distance within which particles are listed as neighbours, the skin aside [m]: the support of the kernel, or of a group's own that reaches farther.
    double searchReach() const
    {
        double reach = resolution.H();
        for (const auto& group : groups)
            if (group.kernel) reach = std::max(reach, group.kernel->support);
        return reach;
    }
    /// Whether viscosity is a field of the particles.
    bool hasViscosityField() const { return multiphase() || facts.get<VaryingViscosity>().exists; }
    /// Whether some particles lack neighbours: at a free surface, or at the end of an opening's buffer.
    bool endsInside() const { return facts.get<FreeSurface>().exists || facts.get<OpenBoundary>().exists; }
    /// Rates that the next step begins with: they are state, as the fields that they change.
    std::vector<StateField> keptRates() const
    {
        std::vector<StateField> rates;
        for (const auto& evolving : state)
            if (integration.keepsRates && evolving.rate && !evolving.advancedByModel) rates.push_back(*evolving.rate);
        return rates;
    }
    /// The fields of a time folder beside the positions: name, and that on disk.
    std::vector<std::pair<std::string, std::string>> written() const
    {
        std::vector<std::pair<std::string, std::string>> all;
        const auto add = [&](const std::string& name, const std::string& onDisk)
        {
            if (std::none_of(all.begin(), all.end(), [&](const auto& field) { return field.second == onDisk; }))
                all.emplace_back(name, onDisk);
        };
        for (const char* name : {"U", "rho", "p", "phase", "m"}) add(name, name);
        for (const auto& evolving : state)
            if (evolving.written && evolving.value.name != Position::info.name) add(evolving.value.name, evolving.fileName());
        for (const auto& rate : keptRates()) add(rate.name, rate.name);
        for (const auto& [name, onDisk] : shown) add(name, onDisk);
        return all;
    }
    /// Classes of the written fields, by the names on disk.
    std::map<std::string, FieldClass> writtenClasses() const
    {
        auto classes = fieldClasses;
        for (const auto& evolving : state)
            for (const auto* field : {&evolving.value, evolving.rate ? &*evolving.rate : nullptr})
                if (field) classes[field->name] = field->type(coefficients.dimension).fieldClass;
        std::map<std::string, FieldClass> onDisk;
        for (const auto& [name, file] : written()) onDisk[file] = classes.at(name);
        return onDisk;
    }
    /// Whether a model has chosen this word of its entry.
    bool has(const Choice& entry, const std::string& word) const
    {
        const auto found = chosen.find(entry.keyword());
        return found != chosen.end() && found->second == word;
    }
    template<int dim> const Catalogue<dim>& ownTerms() const
    {
        if constexpr (dim == 2) return terms2;
        else return terms3;
    }
    /// Name of the entry whose sum is separate.
    static std::string apart(const std::string& term) { return term + "Apart"; }
    /// The name by which to select a term of these catalogues: an entry of its own where its sum is separate (`separateSums`).
    std::string force(const std::string& term, const Catalogue<2>& in2, const Catalogue<3>& in3)
    {
        if (separateSums.empty()) return term;
        const std::string name = apart(term);
        terms2.push_back(redirected(in2, term, name, separateSums));
        terms3.push_back(redirected(in3, term, name, separateSums));
        return name;
    }
    /// Adds a term of its own numbers under its own name; `make(coefficients)` gives it.
    template<class T> void define(const std::string& name, const auto& make, const Names& names = {})
    {
        terms2.push_back(termEntry<2, T>(name, make, names));
        terms3.push_back(termEntry<3, T>(name, make, names));
    }
};

}
