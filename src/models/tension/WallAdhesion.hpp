/// Contact angle by the direction of the interface: which wall each particle is next to, for AdheringColourGradient
/// (CurvatureForce.hpp).
///
///   n_w = normal of the nearest wall where it is nearer than 5/6 H, else 0;    cos(theta) of that wall, 0 of one without a contact angle
///
/// The smoothed colour's gradient of a mirrored interface leans towards 90 degrees within about this distance. Measured at H = 3 spacings,
/// 16 spacings to a drop's radius: 60 and 120 degrees come out as 61 and 120 with 2.5 spacings, 63 and 122 with 3; with 2, at 8 to the
/// radius, 64 and 117 (tutorials/verification/contactAngle).
///
/// No force is needed but that of the curvature, and no layer of high pressure: the line of contact moves with little more resistance than
/// that of the viscous flow at it (tutorials/verification/capillaryRise), where WallPotential's layer holds it back. Bodies of a few
/// spacings between two walls, whose interface no direction fits, are calmer with WallPotential: in the bed of
/// tutorials/heapLeaching/bccBed, at 24 spacings a period, water and air have 2.5 times the kinetic energy of it after 2.5 ms.
#pragma once
#include "models/tension/NearestWall.hpp"
#include "models/tension/WettingAngles.hpp"

namespace sph
{

struct WallAdhesion : NextToWall
{
    static constexpr auto name = "wallAdhesion";
    using Provides = Fields<WallNormal, WallCosine>;
    const double* cosTheta; ///< of each wall

    explicit WallAdhesion(const Coefficients& c) : NextToWall(c), cosTheta(c.of<WettingAngles>().cosine.data()) {}
    template<int dim> auto finish(const SoFar<dim>& q) const { return Values<Provides, dim>{{q.n_w}, {q.found ? cosTheta[q.wall] : 0.0}}; }
};

}
