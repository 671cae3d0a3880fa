/// An opening that has its place in a scene: the lines of its section, and the present state of its boundary.
///
///     const OpenScene scene{geometry, coefficients, state, depth};
///     for (const PlacedOpening& placed : placeOpenings(readOpenings(theCase, geometry, coefficients, state), scene)) ..
#pragma once
#include "fields/fieldTags.hpp"
#include "models/openings/Section.hpp"

namespace sph
{

/// Margin of a buffer's depth, and of the support on either side of a plane, for the way of particles before lists are rebuilt [spacings].
inline constexpr double spareDepth = 1;

/// The scene as all parts of open boundaries see it. What it refers to must outlive them.
struct OpenScene
{
    const Geometry& geometry;
    const Coefficients& coefficients;
    const State& state;
    double bufferDepth;       ///< depth of the buffer beyond a plane [m]
    bool fillsInPart = false; ///< whether the fluid may fill a plane in part: one phase with a free surface

    std::size_t phases() const { return coefficients.restDensity.size(); }
    /// Name of a number of one phase: "drainMass", of several phases "drainMass_water".
    std::string named(const std::string& name, std::size_t phase) const
    {
        return phases() == 1 ? name : name + "_" + coefficients.phases[phase];
    }
    /// Phase of each particle, from an array that is looked up once.
    struct Phases
    {
        const double* phase;
        std::size_t operator()(std::size_t i) const { return phase ? std::size_t(phase[i]) : 0; }
    };
    Phases phasesOf(const auto& store) const { return {phases() > 1 ? store.component(Phase::info.name, 0) : nullptr}; }
};

struct PlacedOpening
{
    Opening opening;
    OpenPlane plane; ///< the whole plane that it is a part of; itself where it stands alone
    Section section;
    std::optional<double> asked;         ///< prescribed rate of an inlet [m^3/s]; none where a pressure alone drives it
    double most, speed;                  ///< U of an inlet [m/s]: its limit, and its present value
    std::vector<double> pressure, slope; ///< a [Pa] and b [Pa/m] of each phase
    double density = 0;                  ///< rest density of the incoming fluid [kg/m^3]
    double inflow = 0;                   ///< volume flow rate of what is near the plane (BoundaryFit.hpp) [m^3/s]
    std::vector<double> inflows;         ///< inflow of each phase [m^3/s]
    std::vector<double> velocity = {};   ///< velocity of each line [m/s]; infinite where its particles keep what they have
};

/// Places openings in a scene. Throws CaseError where one does not fit: inside a wall, narrower than the kernel's support, with a duct that is not
/// straight, out of the domain as far as the buffer particles reach, where another one has its buffer, or with its normal out of the scene.
std::vector<PlacedOpening> placeOpenings(const std::vector<Opening>&, const OpenScene&);

}
