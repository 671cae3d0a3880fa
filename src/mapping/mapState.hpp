/// State of a scene for other particles of the same scene: finer, coarser, or elsewhere.
#pragma once
#include "base/FieldClass.hpp"
#include "case/Cloud.hpp"
#include "sampling/ParticleView.hpp"
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace sph
{

/// Sums over the particles of a phase that are of the scene.
struct PhaseState
{
    std::size_t particles = 0;
    double mass = 0;          ///< [kg]; per metre of depth in 2-D, as all else
    Vector<3> momentum;       ///< sum m U [kg m/s]
    double kineticEnergy = 0; ///< sum m U^2/2 [J]
    PhaseState& operator+=(const PhaseState&);
};

struct MapSettings
{
    std::vector<std::string> fields = {}; ///< of the source, beside U
    bool gasIsInPart = false;             ///< the lightest phase is there around the others alone, as with `gas band;`
    std::string sourceName = "the source", targetName = "the target"; ///< for messages
};

struct MappedState
{
    std::vector<int> phase;                   ///< of each particle of the target, in its own order of phases; leftEmpty where it goes
    std::vector<double> mass;                 ///< [kg]
    std::map<std::string, CloudField> fields; ///< U, and those of the settings

    std::vector<PhaseState> source, interpolated, corrected; ///< by phase of the target
    std::vector<double> leastShare;                          ///< of each phase (choosePhases); 1 where it did not choose
    std::size_t emptied = 0;                                 ///< places that the source leaves empty
    std::size_t uncovered = 0;                               ///< places of gas at rest, which the source does not cover
    std::size_t byNearest = 0; ///< places beyond the support of any source particle, between walls that nearly touch: what the nearest has
};

/// Lines that tell of the progress of long work.
using Say = std::function<void(const std::string&)>;

/// Gives the particles of `target`, which fill the fluid's space of the same scene, the state of those of `source`.
///
///   s_k(x) = sum_(j in k) V_j W(x - x_j)/sum_j V_j W(x - x_j)        share of phase k
///   m_i = rho_k V_i,  sum_(i in k) m_i = M_k within m_i/2            the places of the largest shares, heaviest phase first (choosePhases)
///   f_i = sum_(j in k) w_j f_j,  sum_j w_j = 1,  sum_j w_j (x_j - x_i) = 0
///   U_i -> U_i + (P_k - sum_(i in k) m_i U_i)/sum_(i in k) m_i
///
/// V volume [m^3], W the source's kernel [1/m^3], for shares of 1.5 spacings alone, M_k [kg] and P_k [kg m/s] mass and momentum of a phase of the source, rho_k its density at rest [kg/m^3].
/// Weights w_j are those of moving least squares, of the particles of the same phase that are in sight (Surroundings): linear fields are exact, smooth ones of
/// second order in the spacing. All but U are means: where a weight is negative (at walls and surfaces) it becomes 0, and the others sum to 1. So fractions remain
/// fractions, and stresses within the convex bounds of their law.
/// Conserves the momentum of each phase to round-off (between openings its mean velocity) and its mass to half a particle; the lightest phase has the places that are left.
///
/// Where the source has less than 99 % of the target's volume it has a free surface: shares are of what the space holds,
///
///   s_k(x) = sum_(j in k) V_j W(x - x_j)/sum_i V_i W(x - x_i),  i of the target, W of the whole support,
///
/// every phase keeps its mass, and the places that are left stay empty. `gasIsInPart` gives them to the lightest phase, at rest where no
/// particle of the source is within six spacings.
///
/// Views carry `phases`, `restDensity`, volumes and masses; the target's velocities and fields are not looked at. Throws CaseError where the source has more volume
/// than the target, where a phase finds no place, or where its particles do not cover those of the target.
/// Verified by test/unit/mapping (MapState).
MappedState mapState(const ParticleView& source, const ParticleView& target, const MapSettings&, const Say&);

}
