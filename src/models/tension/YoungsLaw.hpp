/// The wall's tension with each phase, from its contact angles by Young's law,
///
///   gamma_sb - gamma_sa = gamma_ab cos(theta_ab)
///
/// gamma_sk [N/m] tension of the wall with phase k, gamma_ab [N/m] of the phases, theta_ab the angle through a. Erratum of Barker et al. (2012), eq. (14):
/// the law is printed with the other sign, by which 30 degrees would be 150. Each angle ties two tensions together: with n phases n - 1 of them that connect all phases tell the rest, of which more
/// must be consistent. Verified by test/unit/tension.
#pragma once
#include "geometry/Geometry.hpp"
#include "plan/Coefficients.hpp"
#include <functional>

namespace sph
{

/// Contact angle of two phases, given by their numbers.
struct PhaseAngle
{
    std::size_t a, b;
    double angle; ///< [degrees], through a
};
double cosineThroughFirst(const PhaseAngle&);

using Complain = std::function<void(const std::string&)>;

/// The angles that a wall gives; names of phases that there are not, and one angle for more than two phases, are errors.
std::vector<PhaseAngle> phaseAngles(const WallProperties&, const Coefficients&, const Complain&);

/// gamma_sk of each phase k; 0 without angles. Young leaves a common offset open: sum_k gamma_sk/rho_k = 0, by which the wall accelerates light phases
/// no more than need be. Half and half between two phases of equal densities; at 1000:1 half of it on the gas would accelerate it a thousand times as
/// much and limit the step tenfold.
///
/// Errors: angles that contradict those before them by more than half a degree, angles that leave phases unconnected, and angles by which a
/// pair of phases would have |cos(theta)| > 1: the wall then has a film of a third phase between the two, and no line of contact.
std::vector<double> wallTensions(const std::vector<PhaseAngle>&, const Coefficients&, const Complain&);

}
