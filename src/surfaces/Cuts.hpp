/// Cuts through bodies: where they meet the faces of the domain or a plane.
#pragma once
#include "surfaces/IsoSurface.hpp"
#include <functional>
#include <vtkDoubleArray.h>

namespace sph
{

struct CutPlane
{
    Vector<3> point, normal; ///< unit normal
    /// > 0 on the side that the normal points to.
    double height(const Vector<3>& x) const { return dot(x - point, normal); }
};

/// The part of a mesh where a value given at its points is positive, linear between them.
Mesh clipped(vtkPolyData*, vtkDoubleArray* values);

/// The part of a mesh on the side that the plane's normal points away from.
Mesh behind(const CutPlane&, vtkPolyData*);

/// The part of the domain's faces (3-D: all six; 2-D: the plane itself) that `inside` is positive on, and `alsoInside` where it
/// is not empty: where a cut through a body shows its inside. Without normals, to be shaded flat.
Mesh cutFaces(const RegularGrid&, const std::vector<double>& inside, const std::vector<double>& alsoInside);

/// The part of a plane within the grid's box where `inside` is positive, sampled at the grid's spacing. A point outside the box is asked for, too, up to two
/// steps away from it.
Mesh sectionOn(const CutPlane&, const RegularGrid&, const std::function<double(const Vector<3>&)>& inside);

/// The part of a plane within the domain that lies in solids, sampled at the grid's spacing; empty without walls.
Mesh solidsOn(const CutPlane&, const RegularGrid&, const Geometry&);

/// Both meshes in one.
Mesh joined(vtkPolyData*, vtkPolyData*);

}
