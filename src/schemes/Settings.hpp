/// What a case chooses, in words and numbers, before any particle is read.
#pragma once
#include "Case.hpp"
#include "Coefficients.hpp"
#include "Geometry.hpp"
#include "LeakGuard.hpp"
#include "Opening.hpp"
#include <string>
#include <vector>

namespace sph
{

/// Resolution as all programs of the suite read it: system/sphSchemes, `resolution { spacing 1e-4; support 2.6; kernel wendlandC2; }`.
struct Resolution
{
    double spacing = 1;      ///< [m]
    double support = 2.6;    ///< H in spacings
    std::string kernel = "wendlandC2";
    double H() const { return support*spacing; }
};
Resolution readResolution(const Dictionary& sphSchemes);

/// Fractions of the stability limits (TimeStepLimits.hpp; how far from where steps fail: test/stability/README.md).
struct StepFactors
{
    double sound = 0.4, dampedSound = 0.25, stiffness = 1.2, viscous = 0.125, capillary = 0.5, force = 0.25, migration = 0.25;
};

enum class Integrator { predictorCorrector, leapfrog, symplecticEuler, semiImplicit, quasiSteady };
enum class WallVelocity { reflected, secondOrder, freeSlip };

/// How semiImplicit and quasiSteady solve for velocities (ImplicitViscosity.hpp).
struct ImplicitSolve
{
    double theta = 1, tolerance = 1e-6;
    int maxIter = 1000;
    std::string response = "";   ///< the term that gives what viscosity makes of a change
};

struct Settings
{
    Resolution resolution;
    Coefficients coefficients;
    std::vector<std::string> terms;            ///< names in the catalogues
    std::vector<std::string> slowTerms;        ///< those that act once in a step of several parts, in its middle
    int maxSubSteps = 1;                       ///< parts of a step at most, an odd number
    std::vector<std::string> migrationTerms;   ///< of the powder, evaluated with the flow at rest; empty without a suspension
    bool correctedShear = false;               ///< the shear rate is that of a corrected gradient
    int migrationSteps = 4;                    ///< at most so many to a step of the flow
    Integrator integrator = Integrator::predictorCorrector;
    WallVelocity wallVelocity = WallVelocity::reflected;
    bool wallLayers = false;                   ///< walls are layers of particles (WallLayers.hpp); else they mirror
    bool hydrostaticGhosts = false;            ///< ghosts continue the pressure at rest; else they have their sources'
    bool detachingGhosts = false;              ///< ... but never by suction
    ImplicitSolve implicitSolve;
    StepFactors factors;
    bool integratedDensity = false;            ///< density by the continuity equation
    bool normaliseDensity = true;
    bool stiffnessLimit = false;               ///< Hu-Adams pressure between phases: c_eff = sqrt(max rho c^2/min rho) limits the step
    bool surfaceTension = false;               ///< acts between phases
    bool wallPotential = false;                ///< contact angles by WallPotential; else by terms of the plan
    double shifting = 0;                       ///< C of particle shifting; 0: none
    bool shiftsByLargestSpeed = false;         ///< else by the particle's own
    std::vector<Opening> openings;             ///< inlets and outlets
    double dampingRate = 0, dampedUntil = 0;   ///< dv/dt = -rate v [1/s] until a time [s]: a start from far off equilibrium
    std::vector<std::string> reasons;          ///< what was chosen for the user, and why: one line each for the log

    /// Whether velocities half a step on are foretold, for the rates there.
    bool predicts() const { return integrator == Integrator::predictorCorrector || integrator == Integrator::leapfrog; }
    bool multiphase() const { return coefficients.phases.size() > 1; }
    bool suspension() const { return coefficients.suspension.has_value(); }
    /// Whether some particles lack neighbours: beyond a free surface, or where those end that openings hold.
    bool endsInside() const { return coefficients.leastPressure > -1e299 || !openings.empty(); }
    /// Whether viscosity is a field.
    bool variableViscosity() const { return multiphase() || suspension(); }
    bool solvesForVelocity() const { return integrator == Integrator::semiImplicit || integrator == Integrator::quasiSteady; }
    Leaked leaked = Leaked::putBack;           ///< what becomes of particles in a solid
    bool weighted = false;                     ///< some wall is curved or has edges: images carry volume factors
};

/// Reads system/sphSchemes, constant/phaseProperties and constant/g; mistakes go to the case's Diagnostics.
Settings readSettings(const Case&, const Geometry&);

}
