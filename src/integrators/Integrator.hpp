/// An integrator: its word, what it asks of the state, and its list of stages. One file each.
#pragma once
#include "integrators/Schedule.hpp"
#include "scene/Model.hpp"

namespace sph
{

struct Integrator
{
    const char *word, *meaning;
    struct
    {
        bool predicts = false, keepsRates = false, solves = false, solvesPressure = false, moves = true; ///< as in Integration
        bool twoLevels = false;                                                                          ///< as TwoLevels
        double viscousFactor = 1; ///< of the limits by viscosity and diffusion
    } needs;
    void (*stages2)(Schedule<2>&);
    void (*stages3)(Schedule<3>&);

    void stages(Schedule<2>& schedule) const { stages2(schedule); }
    void stages(Schedule<3>& schedule) const { stages3(schedule); }
};

const std::vector<const Integrator*>& integrators();
/// The integrator of that word, one of `integrators`.
const Integrator& integratorOf(const std::string& word);

/// The words of `integration`.
const Model& integrationModel();
/// A factor that the user gives and that scales no limit of this scene is an error. Asked when all models have read.
void checkStepFactors(const Reading&);

}
