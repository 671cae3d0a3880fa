/// A mesh in its place in the scene.
#pragma once
#include "NumberedMesh.hpp"
#include "triSurface.hpp"

namespace sph
{

/// By scale, rotation and translation of the dictionary.
void place(NumberedMesh&, const TriSurface&);
/// Points nearer than this are one where the dictionary does not say [m].
double weldOf(const Box&);

}
