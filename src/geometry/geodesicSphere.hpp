/// The unit sphere as an icosahedron whose edges are cut into n: 20 n^2 facets, normals outwards.
#pragma once
#include "geometry/TriangleSurface.hpp"

namespace sph
{

TriangleSurface geodesicSphere(int n);

}
