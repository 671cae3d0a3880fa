/// Sums over a closed surface of triangles, and its files.
#pragma once
#include "base/SymmTensor.hpp"
#include "geometry/TriangleSurface.hpp"
#include <filesystem>
#include <string>

namespace sph
{

/// Moments of the enclosed volume, by the divergence theorem; the volume is positive where the normals point outwards.
struct VolumeMoments
{
    double volume = 0;    ///< [m^3]
    Vector<3> centroid;   ///< [m]
    SymmTensor<3> second; ///< int (x - centroid)(x - centroid) dV [m^5]
};
VolumeMoments volumeMoments(const TriangleSurface&);

/// Edges that two triangles do not share, each in its own direction: none where the surface is closed and oriented.
std::size_t looseEdges(const TriangleSurface&);

/// The surface with each point once: an STL file repeats them.
TriangleSurface welded(const TriangleSurface&);

struct NamedSurface
{
    std::string name;
    TriangleSurface surface;
};
/// OBJ with a group for each name; surfaces of one name must follow one another. Numbers read back to the same.
std::string objText(const std::vector<NamedSurface>&);
/// Binary STL: single precision, no names.
std::string stlBytes(const TriangleSurface&);

/// Any mesh that `importMesh` reads. Throws CaseError, which names the file.
TriangleSurface readSurface(const std::filesystem::path& caseFolder, const std::string& file);

}
