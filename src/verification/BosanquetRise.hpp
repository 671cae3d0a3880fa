/// Exact solution: capillary rise in a slit by Bosanquet's equation.
#pragma once

namespace sph
{

/// Rise of a liquid in a slit, the column as a body: Bosanquet (1923)
///
///   d(rho l v)/dt = 2 gamma cos(theta)/w - p_r - Delta rho g h - 12 mu l v/w^2,   dl/dt = v,   h = (l - l_0) (1 + w/W)
///
/// w [m] width of the slit, l [m] length of the column in it, l_0 at the start (the depth to which the slit's foot is immersed), h [m] height of its
/// level above that of a reservoir of width W [m], which sinks as the slit fills, p_r [Pa] pull of the reservoir's own walls, Delta rho
/// [kg/m^3] density less that of the gas. At rest h is Jurin's height. Neglected: the flow below the slit's foot and in the reservoir, the inertia
/// and viscosity of the gas, the time in which the meniscus forms, and the change of the contact angle with speed.
///
/// A `slipLength` lambda [m] takes in what of this is friction, and the inertia of the reservoir, whose column is
/// l_r = l_0 - (l - l_0) w/W long:
///
///   l v -> (l + l_r w/W) v                              on the left
///   l   -> l + l_r (w/W)^3 + 4 w/(3 pi) (1 + (w/W)^2)   in the last term: flow in the reservoir, creeping flow into two slits (Hasimoto 1958)
///   theta^3 -> theta^3 + 9 (mu v/gamma) ln(w/(2 lambda))   viscous bending of the interface at a moving line of contact (Cox 1986)
///
/// On a wall without slip no line of contact could move; particles have lambda of about half a spacing.
struct BosanquetRise
{
    double gamma, cosTheta, rho, deltaRho, mu, g;  ///< [N/m], -, [kg/m^3], [kg/m^3], [Pa s], [m/s^2]
    double width, immersion, reservoirWidth, pull; ///< [m], [m], [m] (0: endless), [Pa]
    double slipLength = 0; ///< [m]; 0: Bosanquet's equation as it stands. Else immersion and reservoirWidth are not 0

    /// h [m] at t [s] after a start from rest with both levels equal. NaN where that takes more than 10^7 steps.
    double height(double t) const;
    double heightAtRest() const { return (2 * gamma * cosTheta / width - pull) / (deltaRho * g); }
};

}
