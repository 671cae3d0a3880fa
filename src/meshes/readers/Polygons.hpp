/// Faces with any number of corners on their way to triangles. For the sources of this module alone.
#pragma once
#include "meshes/readers/NumberedMesh.hpp"
#include <span>

namespace sph
{

class Polygons
{
    std::vector<int> corners_;
    std::vector<std::size_t> ends_; ///< of the corners of each face
    std::vector<int> region_;
    std::vector<std::size_t> place_;

public:
    /// `place`: the line or byte of the file, for errors.
    void add(std::span<const int> corners, int region, std::size_t place);
    std::size_t size() const { return ends_.size(); }
    std::span<const int> operator[](std::size_t face) const;
    std::size_t place(std::size_t face) const { return place_[face]; }

    /// Triangles between the points, in the order of the faces and with their numbers. `placeName` is "line" or "byte". Throws
    /// UnusableMesh where a face crosses itself.
    NumberedMesh triangulated(std::vector<Vector<3>> points, const std::vector<std::string>& regions, const char* placeName,
                              std::vector<std::string>& notes) const;
};

/// Triangles of a polygon, by the numbers of its corners, with its orientation and no other points: the constrained Delaunay
/// triangulation in the coordinate plane that it is seen largest in, which moves no corner. Corners may lie on a straight line, may not
/// lie in one plane, and may be passed twice as by the cut that joins a hole to the rim. What has no area becomes a fan. Throws
/// std::domain_error with the reason where the polygon crosses or touches itself.
std::vector<std::array<int, 3>> triangulate(std::span<const Vector<3>> corners);

/// Warp of a polygon: how far its corners lie off a plane through the middle of the polygon, over the largest distance of a corner from the middle.
double unevenness(std::span<const Vector<3>> corners);

}
