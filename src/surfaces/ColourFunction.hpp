/// The smoothed colour function of a phase on a regular grid, whose iso-surface 1/2 is the phase's boundary.
#pragma once
#include "surfaces/RegularGrid.hpp"
#include <string>
#include <vector>

namespace sph
{

/// Particles as the colour function needs them.
struct PhaseParticles
{
    std::vector<Vector<3>> position;
    std::vector<double> volume; ///< V_j = m_j/rho_j [m^dim]
    std::vector<char> inPhase;  ///< C_j^l, 1 in the phase and 0 in another
    std::size_t size() const { return position.size(); }
    /// sum_j V_j C_j^l
    double phaseVolume() const;
    /// True where particles of another phase are there, too.
    bool hasOtherPhase() const;
};

/// Divisor of the sum over the phase.
enum class Normalisation
{
    none,      ///< nothing: the sum as it stands; the surface bends away from walls, where half the kernel is empty
    walls,     ///< the part of the kernel that lies in the fluid's space: for a liquid whose gas is left out
    particles, ///< the sum over all particles (Shepard): where each phase is there
};

/// Barker et al. (2012), section "Spherical Packing", normalised:
///
///   C(x) = sum_j V_j C_j^l W(|x - x_j|) / D(x),   D = 1,  int_fluid W(|x - y|) dy  or  sum_j V_j W(|x - x_j|)
///
/// Erratum of Barker et al. (2012), surface function: the sum is of C_j^l and has the factor V_j. W [1/m^dim] the kernel named `kernel` with radius `support`. The function goes on smoothly into solids, two steps deep, so
/// that the iso-surface crosses the wall: cut there by the distance to the wall it ends on the wall. Particles are imaged across
/// periodic faces. Each node sums in the order of the particles, whatever the number of threads.
/// A surface of mean curvature 2H is displaced inwards by 2H s^2/2, s^2 the kernel's second moment in one direction: 0.4 % of the
/// volume of a sphere of 16 spacings' radius at support 2. Verified by test/unit/surfaces/sphere.cpp.
std::vector<double> colourFunction(const RegularGrid&, const std::vector<double>& wallDistance, const PhaseParticles&,
                                   const std::string& kernel, double support, Normalisation);

}
