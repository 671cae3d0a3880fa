/// The file constant/walls: the geometry as the solver loads it, written by meshToGhost.
///
/// A dictionary with every number in the shortest form that reads back to the same double:
///
///     stamp      "a1b2c3d4e5f60718";          of the source, see geometryStamp
///     dimension  3;
///     domain     { min (0 0 0); max (1e-3 1e-3 1e-3); periodic (x y z); }
///     reach      2.6e-4;                      kernel support for which the walls were checked [m]
///     walls      { floor { contactAngle 30; anglesAt "constant/geometry:14"; velocity (0 0 0); } }
///     patches    ( { wall floor; type plane; point (0 0 0); normal (0 1 0); } ... )
///
/// Patches are single shapes in the words of constant/geometry, before periodic repetition; boxes with fluid inside and beds of
/// spheres are taken apart. A mesh is one entry, `{ wall rocks; type triSurface; regions (rocks rocks.top); }`: its facets are in constant/wallMeshes/rocks,
/// and `regions` are the walls of its regions.
#pragma once
#include "case/Case.hpp"
#include "geometry/Geometry.hpp"
#include <filesystem>

namespace sph
{

/// Identifies what constant/walls was made from: the text of constant/geometry and of the files that it includes, and the
/// resolution, `spacing` [m] and kernel support in spacings. A different stamp in the file: run meshToGhost again.
std::string geometryStamp(const std::filesystem::path& caseFolder, double spacing, double support);

/// Text of constant/walls for geometry.originals, with geometry.reach.
std::string wallsText(const Geometry&, const std::string& stamp);

/// Reads constant/walls, and the meshes in `folder`, that of the case. Patches are repeated as far as the solver needs them, or as far as the file says where that is more. Throws CaseError
/// where particles of this resolution do not fit the domain.
Geometry readWalls(const Dictionary&, const Resolution&, const std::filesystem::path& folder = {});

/// Reads constant/walls of a case. It is an error that a present constant/geometry, or this resolution, is not what it was made from.
Geometry readWalls(const Case&, const Resolution&);

/// "rock", and of a mesh the facet nearest to x: `"rock", facet 12 of constant/wallMeshes/rock`, counted from 0. Reads that file: for messages alone.
std::string wallInWords(const Geometry&, int patch, const Vector<3>& x);

}
