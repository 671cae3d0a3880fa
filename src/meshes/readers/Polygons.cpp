#include "meshes/readers/Polygons.hpp"
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Unevenness from which the notes tell of a polygon: two triangulations of such a square of side 1 differ in volume by 1e-3.
constexpr double uneven = 1e-3;

}

void Polygons::add(std::span<const int> corners, int region, std::size_t place)
{
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    ends_.push_back(corners_.size());
    region_.push_back(region);
    place_.push_back(place);
}

std::span<const int> Polygons::operator[](std::size_t face) const
{
    const auto begin = face == 0 ? 0 : ends_[face - 1];
    return std::span(corners_).subspan(begin, ends_[face] - begin);
}

NumberedMesh Polygons::triangulated(std::vector<Vector<3>> points, const std::vector<std::string>& regions, const char* placeName,
                                    std::vector<std::string>& notes) const
{
    NumberedMesh mesh;
    mesh.points = std::move(points);
    mesh.regions = regions;
    mesh.triangles.reserve(size());
    std::size_t unevenFaces = 0, worstPlace = 0;
    double worst = 0;
    std::vector<Vector<3>> at;
    for (std::size_t face = 0; face < size(); ++face)
    {
        const auto corners = (*this)[face];
        const auto add = [&](int a, int b, int c)
        {
            mesh.triangles.push_back({corners[std::size_t(a)], corners[std::size_t(b)], corners[std::size_t(c)]});
            mesh.region.push_back(region_[face]);
            mesh.number.push_back(int(face));
        };
        if (corners.size() == 3)
        {
            add(0, 1, 2);
            continue;
        }
        at.clear();
        for (const int p : corners) at.push_back(mesh.points[std::size_t(p)]);
        try
        {
            for (const auto& [a, b, c] : triangulate(at)) add(a, b, c);
        }
        catch (const std::domain_error& e)
        {
            throw UnusableMesh(fmt::format("{} {}: facet {}, a polygon of {} corners from {} on, {}: write it as triangles", placeName,
                                           place_[face], face, corners.size(), inWords(at[0]), e.what()));
        }
        const double off = unevenness(at);
        unevenFaces += off > uneven;
        if (off > worst)
        {
            worst = off;
            worstPlace = place_[face];
        }
    }
    if (unevenFaces > 0)
        notes.push_back(
            fmt::format("{} not plane, by up to {:.2g} of the size ({} {}): its triangles bound another volume than other cuts of it",
                        unevenFaces == 1 ? "1 polygon is" : fmt::format("{} polygons are", unevenFaces), worst, placeName, worstPlace));
    return mesh;
}

}
