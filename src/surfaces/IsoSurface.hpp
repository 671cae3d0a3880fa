/// Surfaces of the region `colour > iso` outside solids, as VTK meshes: triangles in 3-D, lines in 2-D.
#pragma once
#include "surfaces/RegularGrid.hpp"
#include <vector>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace sph
{

using Mesh = vtkSmartPointer<vtkPolyData>;

/// The iso-surface (flying edges, Schroeder et al. 2015) as far as it lies in the fluid: it ends at walls, cut by the signed
/// distance that `geometry` gives at its points, and at the faces of the domain. Triangles are oriented, and point normals point,
/// out of the region. `smoothingPasses` of Taubin's windowed-sinc filter, before it is cut; 0: none.
/// (20 or 40 change a ball's volume by at most 0.6 %.)
Mesh freeSurface(const RegularGrid&, const std::vector<double>& colour, double iso, const Geometry&, int smoothingPasses);

/// The whole boundary of the region, closed along walls and domain faces: the zero surface of the smaller one of
/// `length*(colour - iso)` and wall distance. Its edges along the contact line are rounded by part of a step. Without normals.
Mesh closedSurface(const RegularGrid&, const std::vector<double>& colour, double iso, const std::vector<double>& wallDistance,
                   double length);

/// The walls' own surface within the domain, with normals into the fluid; empty without walls.
Mesh wallSurface(const RegularGrid&, const std::vector<double>& wallDistance, const Geometry&);

/// Area of the triangles (3-D) or length of the lines (2-D).
double measure(vtkPolyData*);

/// Integral of x.n/dim over an oriented closed surface: the volume inside, by the divergence theorem.
double signedVolume(vtkPolyData*);

}
