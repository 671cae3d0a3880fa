/// Exact solution: the shape of a liquid bridge at rest.
#pragma once

namespace sph
{

/// Liquid held between two equal spheres (3-D) or parallel cylinders (2-D) by surface tension alone, at rest: the surface of revolution
/// r(z) of constant mean curvature, Orr, Scriven and Rivas (1975), J. Fluid Mech. 67:723
///
///   -dpsi/ds + cos(psi)/r = (p_l - p_g)/gamma,   dr/ds = sin(psi),   dz/ds = cos(psi)
///
/// z [m] along the line of centres from midway between them, r [m] from it, s [m] along the meridian, psi its slope against z: 0 at the
/// neck, psi = pi/2 - theta - beta on the sphere, where it meets it at the contact angle theta; beta is the half-filling angle, from the
/// line of centres to the line of contact. In 2-D there is no cos(psi)/r, and the surfaces are arcs of circles. Gravity is left out: Bond
/// number rho g R^2/gamma = 0. Bridges so full that they overhang their line of contact, psi < -pi/2 there, are not found.
class CapillaryBridge
{
    int dimension_;
    double radius_, gap_, theta_;
    double beta_, curvature_, neck_ = 0, volume_ = 0;

    double slopeAtContact(double beta) const;
    double contactRadius(double beta) const;
    double contactHeight(double beta) const;
    /// The curvature of the arc of a circle from contact to neck.
    double arc(double beta) const;
    /// Integrates the meridian from the line of contact to z = 0, with neck and volume on the way; returns its slope angle there [rad].
    double integrate(double beta, double curvature);
    bool solve(double volume);

public:
    /// radius R and gap [m] of the surfaces on the line of centres, `volume` [m^3] of the liquid (2-D: [m^2]), contact angle in degrees.
    /// Throws CaseError where there is no such bridge.
    CapillaryBridge(int dimension, double radius, double gap, double volume, double contactAngle);

    double neck() const { return neck_; }           ///< r at z = 0 [m]; in 2-D half the width
    double curvature() const { return curvature_; } ///< (p_l - p_g)/gamma [1/m]
    double halfFilling() const { return beta_; }    ///< beta [rad]
    /// Attraction of the spheres over gamma: the tension of the neck less the pressure on its section,
    /// 2 pi r - pi r^2 (p_l - p_g)/gamma [m]; in 2-D 2 - 2 r (p_l - p_g)/gamma [-].
    double force() const;
};

}
