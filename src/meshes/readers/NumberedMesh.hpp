/// Triangles on their way from a file to a wall, and what ends the way.
#pragma once
#include "geometry/FacetSurface.hpp"
#include <span>
#include <stdexcept>

namespace sph
{

/// Nothing is promised of it: points may be several times there, edges open.
struct NumberedMesh : FacetSurface
{
    std::vector<int> number; ///< of the facet in the file that a triangle is, or is part of, from 0; -1: made by a repair
    double rounding = 0;     ///< by which single precision in the file may have moved a coordinate, in its lengths; 0: double precision
};

struct Box;

/// The error of a mesh that cannot be used, with the facets and edges that are to blame, to be looked at.
struct UnusableMesh : std::runtime_error
{
    TriangleSurface facets;
    std::vector<std::array<Vector<3>, 2>> edges;

    explicit UnusableMesh(const std::string& why) : runtime_error(why) {}
    /// Names the first of the facets, with their coordinates, behind `why`.
    UnusableMesh(const std::string& why, const NumberedMesh&, const std::vector<int>& facets, const std::string& remedy = "");
    /// An error with the places of edges, given by the numbers of their points.
    UnusableMesh(const std::string& why, const NumberedMesh&, const std::vector<std::array<int, 2>>& edges, const std::vector<int>& facets,
                 const std::string& remedy = "");
};

/// "(0.1 0 0.25)", six digits
std::string inWords(const Vector<3>&);
/// "facet 7", as the file counts it
std::string nameOfFacet(const NumberedMesh&, int facet);
/// "1 facet", "7 facets"
std::string counted(std::size_t number, const std::string& thing);

/// Edges by their two points, low < high, sorted, so that those of one edge follow one another.
struct HalfEdge
{
    int low, high;
    int facet;
    bool forward; ///< the facet goes from low to high
};
std::vector<HalfEdge> sortedHalfEdges(const TriangleSurface&);

/// visit(span of the half-edges of one edge)
void forEachEdge(const std::vector<HalfEdge>& sorted, auto&& visit)
{
    for (std::size_t i = 0, j = 0; i < sorted.size(); i = j)
    {
        while (j < sorted.size() && sorted[j].low == sorted[i].low && sorted[j].high == sorted[i].high) ++j;
        visit(std::span(sorted).subspan(i, j - i));
    }
}

/// Sets that are joined one by one.
class DisjointSets
{
    std::vector<int> parent_;

public:
    explicit DisjointSets(std::size_t n);
    int find(int i);
    void join(int i, int k) { parent_[std::size_t(find(i))] = find(k); }
    /// The number of the set of each, in the order of their first members; and how many there are.
    std::pair<std::vector<int>, int> numbered();
};

/// 2 a n of a triangle: its cross product.
inline Vector<3> areaVector(const TriangleSurface& s, int facet)
{
    const auto& [a, b, c] = s.triangles[std::size_t(facet)];
    return cross(s.points[std::size_t(b)] - s.points[std::size_t(a)], s.points[std::size_t(c)] - s.points[std::size_t(a)]);
}

inline Vector<3> centroid(const TriangleSurface& s, int facet)
{
    const auto& [a, b, c] = s.triangles[std::size_t(facet)];
    return (s.points[std::size_t(a)] + s.points[std::size_t(b)] + s.points[std::size_t(c)]) / 3;
}

/// Box of the points; empty (low > high) where there are none.
Box boundingBox(const TriangleSurface&);

}
