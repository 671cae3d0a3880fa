/// Crevices: what two walls that face one another leave where grains touch, or at the bottom of a groove.
///
/// At a place with the distances d_1, d_2 [m] from two walls, whose normals n_1, n_2 enclose more than 120 degrees, the crevice has the width d_1 + d_2, which grows along
/// n_1 + n_2, by |n_1 + n_2| a length: 0 in a slit between parallel walls. A particle of spacing dx alone between the images of a gap of width h has the kernel sum
///
///   dx^3/h int W(|z|) dz = (0.33 dx)/h        wendlandC2, H = 2.6 dx
///
/// of its own, so that it is compressed where h < 0.33 dx whatever its neighbours do, and images fill crevices down to a width of 0.5 dx (src/images/README.md).
/// No particle is placed in one narrower than that, and none comes in (offWalls.hpp). The void of a contact of two spheres of radius R that is left out so is
/// pi R h^2/2, of the second order in h/R.
#pragma once
#include "geometry/forEachFoot.hpp"

namespace sph
{

/// Width of the narrowest crevices that particles enter [spacings].
inline constexpr double narrowestCrevice = 0.5;

struct Crevice
{
    double width = Box::infinity; ///< [m]; infinite where there is none
    Vector<3> wider;              ///< gradient of the width
};

/// The narrowest crevice at x among those narrower than `narrowest` [m], between the patches `near`.
Crevice creviceAt(const Geometry&, std::span<const int> near, const Vector<3>& x, double narrowest);

}
