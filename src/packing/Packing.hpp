/// Packing of a scene: particles with phase, mass and velocity from the dictionaries of a case. It is what packParticles does.
#pragma once
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "packing/FluidSpace.hpp"
#include "packing/InitialPressure.hpp"
#include "packing/InitialVelocity.hpp"
#include "packing/Lattice.hpp"
#include "packing/Regions.hpp"
#include "packing/Relaxation.hpp"
#include "packing/Saturation.hpp"
#include <optional>

namespace sph
{

struct PhaseToPack
{
    std::string name;
    double rho; ///< rest density [kg/m^3]
    Location where;
};

/// `{ region ..; phase ..; U (..); p ..; }`: the last rule that contains a particle decides on its phase, the last that has U or p on those.
struct FillRule
{
    static constexpr int noPhase = -1; ///< `phase none`: no particle there (free surface)
    Region region;
    int phase;
    std::optional<Vector<3>> U;
    std::optional<double> p;
};

/// Plan of a packing: all that the dictionaries say, checked.
struct PackingPlan
{
    Geometry geometry;
    LatticeSpec lattice;
    std::string kernel;
    double support = 0; ///< H [m]
    std::optional<RelaxationSettings> relaxation;
    std::vector<PhaseToPack> phases;
    std::vector<FillRule> fill;
    std::optional<Saturation> saturation;
    std::optional<VelocityField> velocity;
    std::optional<PressureField> pressure;
    bool allowEmpty = false;
    Location spacingAt, latticeAt, relaxAt;

    /// Numbers for the report alone: period of a sphere bed [m], gravity [m/s^2] and the first surface tension [N/m], where given.
    double bedPeriod = 0, g = 0;
    double bondPerArea = 0; ///< rho g/gamma, the Bond number over the square of a length [1/m^2]; 0 where it is none
};

/// Reads constant/geometry, constant/phaseProperties, constant/g, system/sphSchemes (`resolution`) and system/packParticlesDict
/// (every entry has a default, and the file may be missing). Throws CaseError with all mistakes.
PackingPlan readPackingPlan(const Case&);
/// Entries of system/packParticlesDict.
EntryList packingEntries();

struct PackedPhase
{
    std::size_t particles = 0;
    double mass = 0; ///< [kg]; [kg/m] in 2-D
    PackedPhase& operator+=(const PackedPhase& other)
    {
        particles += other.particles;
        mass += other.mass;
        return *this;
    }
};

struct Packing
{
    Points points;
    std::vector<double> phase; ///< index into PackingPlan::phases
    std::vector<double> mass;  ///< [kg]
    std::vector<double> rho;
    Points velocity;
    std::vector<double> p; ///< [Pa] above the background; empty where no pressure at the start is given

    FluidVolume volume;         ///< of the space between the walls
    double particleVolume = 0;  ///< the same for all: volume over places
    std::size_t inCrevices = 0; ///< places in crevices, which hold no particle (geometry/crevice.hpp)
    double shareOfCrevices = 0; ///< of all places, and so of the fluid's volume; the other places share it
    double porosity = 1;        ///< share of the fluid's box that walls leave to the fluid
    std::vector<Ball> balls;
    std::array<long, 3> layers{};
    Vector<3> fittedSpacing;
    RelaxationResult relaxation;
    /// Crowded particles (Relaxation.hpp), those of empty places left out: how many, and the most crowded.
    struct Crowd
    {
        std::size_t particles = 0;
        double residual = 0;
        Vector<3> at;
    } crowd;
    std::vector<PackedPhase> phases;
    std::size_t leftEmpty = 0; ///< places without a particle, by `phase none` or because no region covers them
    double saturation = 0;     ///< reached
};

/// Fills the whole space between the walls, relaxes it, and then gives the places to phases or leaves them empty, so that a free
/// surface does not spread. Throws CaseError where there are no particles, a phase has none, or two particles coincide.
Packing pack(const PackingPlan&);

/// Warns where the lattice crowds particles between walls that it does not fit; not of a jitter, which is asked for.
void warnOfCrowd(const PackingPlan&, const Packing&, Diagnostics&);

/// Report of a packing to the user.
std::string report(const PackingPlan&, const Packing&);

/// Writes `<time>/lagrangian/sph/{positions U m p phase rho}`, constant/polyMesh and `<case>.foam`. With V in place of rho where the
/// pressure at the start is given: the solver finds it, or with a number density the masses that make it, by the state equation.
void writePacking(const Case&, const std::string& time, const PackingPlan&, const Packing&, const WriteOptions&);

}
