/// Orientation of the closed surfaces of a mesh: which side of each is fluid.
#pragma once
#include "geometry/Shape.hpp"
#include "meshes/readers/NumberedMesh.hpp"

namespace sph
{

/// The closed surfaces (shells) of a mesh.
struct Shells
{
    std::vector<int> of; ///< shell of each triangle
    int count = 0;
    std::vector<double> volume, area; ///< [m^3] positive where normals point out of it; [m^2]
    std::vector<Box> box;
};
Shells findShells(const NumberedMesh&);
/// Each with the points that it has.
std::vector<NumberedMesh> apart(const NumberedMesh&, const Shells&);

/// Enclosed volume by the divergence theorem, 1/3 of the flux of x through the surface [m^3].
double enclosedVolume(const NumberedMesh&);

/// Turns shells so that all normals point into the fluid, which is on the given side of those that lie in no other; deeper down solid and
/// fluid alternate. Throws UnusableMesh where a shell encloses no volume.
void orientShells(NumberedMesh&, FluidSide, std::vector<std::string>& repairs);

}
