/// Phases of places by their shares, with the volume of each phase kept.
#pragma once
#include <cstddef>
#include <vector>

namespace sph
{

/// Phase of a place that stays without a particle.
inline constexpr int leftEmpty = -1;

struct PhaseChoice
{
    std::vector<int> phase; ///< of each place
    /// Share of the last place that a phase has taken: 0.5 where its surface lies at the same place as before.
    std::vector<double> leastShare;
    /// Volume that a phase wanted and found no place for where it has any share [m^3].
    std::vector<double> unplaced;
};

/// Phases in the order in which they choose, each the places of its largest shares s_k among those that are left, until their volume is that
/// wanted to within half of the last:
///
///   | sum_i V_i - V_k | <= V_last/2
///
/// `rest` takes what is left over: a phase, which does not choose, or `leftEmpty`. Equal shares go by number. Where two liquids and a gas meet, the surface
/// of each against the gas and that between them lie where shares are equal, as far as volumes let them.
///
/// `shares` [phase][place], 0 where a phase cannot be; `volume` V_i [m^3] of places; `wanted` V_k [m^3]. Verified by test/unit/mapping (Phases).
PhaseChoice choosePhases(const std::vector<std::vector<double>>& shares, const std::vector<double>& volume,
                         const std::vector<double>& wanted, const std::vector<int>& order, int rest);

}
