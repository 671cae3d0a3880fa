/// The mesh as CGAL's algorithms take it. For the sources of this module alone.
#pragma once
#include "meshes/readers/NumberedMesh.hpp"
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace sph
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using WorkingMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FaceOf = WorkingMesh::Face_index;
using NumberOfFace = WorkingMesh::Property_map<FaceOf, int>;

inline Kernel::Point_3 toPoint(const Vector<3>& x) { return {x.x, x.y, x.z}; }
inline Vector<3> toVector(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

inline NumberOfFace regionOf(WorkingMesh& w) { return w.add_property_map<FaceOf, int>("f:region", 0).first; }
inline NumberOfFace numberOf(WorkingMesh& w) { return w.add_property_map<FaceOf, int>("f:number", -1).first; }

/// Working mesh of facets that are manifold and oriented; face i is triangle i.
WorkingMesh toWorkingMesh(const NumberedMesh&);
/// Puts a working mesh into `m`, whose names of regions stay. Faces that carry none, as a repair makes them, have number -1.
void fromWorkingMesh(WorkingMesh&, NumberedMesh& m);

}
