/// A particle seems to be nearer to a curved free surface than to a plane one: by how much, from the sum of its slopes |g|:
///
///   z - z' = beta H^2 k
///
/// z [m] depth, z' the depth below a plane surface of the same |g|, H [m] support, k [1/m] mean curvature of the surface, > 0 of a drop. A surface that bends around the particle has more of itself within reach.
/// beta is a number of the kernel and the dimension: the mean over depths of 0.1 to 0.5 H of a disc or ball with k = 1/(4 H), where it varies by a tenth. WendlandC2 in 3-D: 0.07.
/// Verified by test/unit/gas.
#pragma once
#include <string>

namespace sph
{

double depthBias(const std::string& kernel, int dimension);

}
