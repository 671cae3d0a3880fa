/// Test whether a point lies in the solid that a file of triangles bounds, by rays of CGAL, not by the distances that the solver keeps particles off walls by.
#pragma once
#include "geometry/triSurface.hpp"
#include "meshes/MeshSpace.hpp"
#include <filesystem>
#include <memory>

namespace sph
{

class SolidOfFile
{
public:
    /// The file of the dictionary in its place: points welded, joined where periodic faces cut it, holes closed on request, closed surfaces turned as `fluid` says. Bodies that overlap are solid in both.
    /// Throws UnusableMesh where the file bounds no solid, as a scan that must be wrapped.
    SolidOfFile(const std::filesystem::path& caseFolder, const TriSurface&, const MeshSpace&);
    SolidOfFile(SolidOfFile&&) noexcept;
    ~SolidOfFile();

    /// Whether a point lies in the solid; its surface does not belong to it.
    bool contains(const Vector<3>&) const;

private:
    struct Shells;
    std::unique_ptr<Shells> shells_;
};

}
