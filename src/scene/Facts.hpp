/// Facts: what the models of a scene tell one another before any particle is read. A fact is a value of a type below. One model gives it, any may ask:
///
///     settings.facts.give(OpenBoundary{true}, "constant/openings");                     // in models/openings
///     if (settings.facts.get<OpenBoundary>().exists) ...                                // in whoever needs to know
///
/// A fact that no model gives has the value that its type begins with, which is that of a scene of one enclosed phase with a state equation. A fact that two
/// models give is an error which names both. All types stand on this page: models tell one another things both ways, and their folders may not.
///
/// Models give facts in `declare` (what files say without any other model), in `prepare` (what hangs on the choice of schemes) or in `read` (what only a
/// run or a conflict asks for). A fact that is asked for before it is given is an error of the program, not of the case, and the first such scene finds it.
#pragma once
#include "scene/LeakGuard.hpp"
#include <any>
#include <map>
#include <string>
#include <typeindex>

namespace sph
{

/// Some phase has the stress of a constitutive law in place of its state equation.
struct ConstitutiveStress
{
    static constexpr auto says = "what the stress of a phase is";
    bool exists = false;
};

/// Set of schemes that a scene takes where system/sphSchemes names none.
struct SchemeSet
{
    static constexpr auto says = "which set of schemes the scene takes";
    std::string word;
};

/// The one of several phases that there are particles of, where none of another can come in.
struct LonePhase
{
    static constexpr auto says = "which phase is alone";
    int phase = -1; ///< none is
};

/// Energy of the interfaces between phases.
struct InterfaceEnergy
{
    static constexpr auto says = "the energy of interfaces";
    double largest = 0; ///< of all pairs of phases [J/m^2]
};

/// Whether interfaces exert forces by which they reduce their area.
struct InterfaceForces
{
    static constexpr auto says = "whether interfaces exert forces";
    bool act = false;
};

/// Distance over which the forces on a particle depend on others: that of the sums over neighbours that they are made of, one behind the other.
struct ForceReach
{
    static constexpr auto says = "how far forces reach";
    int supports = 2; ///< [kernel's support]
};

/// Interfaces between phases go straight on behind walls, and are not mirrored.
struct InterfacesBehindWalls
{
    static constexpr auto says = "how interfaces go on behind walls";
    bool straight = false;
};

/// Form of the acceleration by pressure.
struct PressureForce
{
    static constexpr auto says = "the form of the acceleration by pressure";
    enum class Form
    {
        none,
        huAdams, ///< gradient of an energy; pairs weigh by their volumes
        densityWeighted,
        other
    } form = Form::none;
    bool hasEnergy() const { return form == Form::huAdams; }
};

/// Density is integrated in time, rather than summed over neighbours.
struct IntegratedDensity
{
    static constexpr auto says = "where the density comes from";
    bool exists = false;
};

/// Volumes of particles are those of the number density, rather than m/rho.
struct VolumeOfPlaces
{
    static constexpr auto says = "where the volumes of particles come from";
    bool exists = true;
};

/// Viscosity differs from particle to particle within a phase.
struct VaryingViscosity
{
    static constexpr auto says = "that viscosity varies within a phase";
    bool exists = false;
};

/// Some term accelerates by viscosity.
struct ViscousForce
{
    static constexpr auto says = "whether viscosity accelerates";
    bool acts = false;
};

/// A fluid that parts under tension: its particles may lack neighbours.
struct FreeSurface
{
    static constexpr auto says = "that a fluid parts under tension";
    bool exists = false;
};

/// Particles come in and go out through parts of the boundary, at whose buffers particles lack neighbours.
struct OpenBoundary
{
    static constexpr auto says = "what particles come in by";
    bool exists = false;
    bool isDriven = false; ///< by a pressure: a plug of fluid is pushed in, whose steps sound limits
};

/// A phase that is there only in part, and ends at a constant pressure.
struct PhaseInPart
{
    static constexpr auto says = "which phase is there in part";
    int phase = -1; ///< none
};

/// A phase whose force lacks the background pressure far from all others.
struct CalmPhase
{
    static constexpr auto says = "which phase lacks the background pressure far from the others";
    int phase = -1; ///< none
};

/// How near particles come to walls, which hold them off (models/walls/WallContact.hpp).
struct WallClearance
{
    static constexpr auto says = "how near particles come to walls";
    double spacings = 0; ///< the least that walls keep anyway
};

/// The distance over which walls act upon particles by laws of their own, beside images.
struct WallReach
{
    static constexpr auto says = "how far walls act";
    double supports = 1; ///< [kernel's support], 3/2 at most (Geometry.hpp)
};

/// The liquid is alone: the gas that it ends at is left out, and has a constant pressure, 0.
struct GasLeftOut
{
    static constexpr auto says = "whether the gas is left out";
    bool isLeftOut = false;
};

/// Velocity by which particles drift besides their own, a field.
struct DriftVelocity
{
    static constexpr auto says = "what particles drift by";
    std::string field;
};

/// What walls do to what lies behind them.
struct WallConditions
{
    static constexpr auto says = "what walls do to the fields behind them";
    bool slip = false;                 ///< fluid slides along all walls
    bool interpolated = false;         ///< particles in layers have one value each, fitted to the fluid
    std::string pressure = "mirrored"; ///< word of `wallPressure`
};

/// What becomes of a particle that is found in a solid.
struct LeakedParticles
{
    static constexpr auto says = "what becomes of leaked particles";
    LeakAction action = LeakAction::putBack;
};

/// All that walls and openings do upon the fluid is in the energy balance.
struct BoundaryPower
{
    static constexpr auto says = "whether the power of walls and openings is measured";
    bool isMeasured = false;
};

/// Advice where a run gains energy.
struct EnergyAdvice
{
    static constexpr auto says = "what to do about energy that a run gains";
    std::string text = "a smaller factor in `integration`";
};

class Facts
{
public:
    /// Throws CaseError where another model has given the fact, and std::logic_error where somebody has asked for it before.
    template<class Fact> void give(Fact fact, const std::string& by)
    {
        note(typeid(Fact), Fact::says, by);
        given_[typeid(Fact)].value = std::move(fact);
    }
    template<class Fact> Fact get() const
    {
        const auto& found = given_[typeid(Fact)];
        return found.value.has_value() ? std::any_cast<const Fact&>(found.value) : Fact{};
    }
    /// Model or file that has given a fact; "" where none has.
    template<class Fact> std::string by() const { return given_[typeid(Fact)].by; }

private:
    struct Given
    {
        std::any value;
        std::string by;
    };
    /// Facts that were given, and those that were asked for in vain.
    mutable std::map<std::type_index, Given> given_;

    void note(const std::type_info& fact, const char* says, const std::string& by);
};

}
