/// A mesh in its place in the scene.
#pragma once
#include "geometry/triSurface.hpp"
#include "meshes/readers/NumberedMesh.hpp"

namespace sph
{

/// Scales, turns and moves a mesh as the dictionary says.
void place(NumberedMesh&, const TriSurface&);
/// Points nearer than this are one where the dictionary does not say [m].
double weldOf(const Box&);

}
