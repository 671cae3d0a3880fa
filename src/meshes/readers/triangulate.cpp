#include "meshes/readers/Polygons.hpp"
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace sph
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>; // the first corner there
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>; // winding number
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                                 CGAL::No_constraint_intersection_requiring_constructions_tag>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;

/// Twice the area of a polygon times its normal (Newell).
Vector<3> areaVector(std::span<const Vector<3>> corners)
{
    Vector<3> a;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) a += cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    return a;
}

/// Normal of a polygon, or of one that cancels itself, as a bow, the normal of the largest triangle that its first corner makes with an edge.
Vector<3> normalOf(std::span<const Vector<3>> corners)
{
    constexpr double rounding = 1e-12;
    Vector<3> largest;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        if (const auto n = cross(corners[k] - corners[0], corners[k + 1] - corners[0]); mag(n) > mag(largest)) largest = n;
    const auto whole = areaVector(corners);
    return mag(whole) > rounding * mag(largest) ? whole : largest;
}

std::vector<std::array<int, 3>> fan(std::size_t corners)
{
    std::vector<std::array<int, 3>> triangles;
    for (int k = 1; k + 1 < int(corners); ++k) triangles.push_back({0, k, k + 1});
    return triangles;
}

/// Whether the corners lie on a straight line but for rounding.
bool isLine(std::span<const Vector<3>> corners)
{
    constexpr double rounding = 1e-12;
    Vector<3> longest;
    for (const auto& x : corners)
        if (mag(x - corners[0]) > mag(longest)) longest = x - corners[0];
    return std::ranges::all_of(corners,
                               [&](const auto& x) { return mag(cross(x - corners[0], longest)) <= rounding * dot(longest, longest); });
}

/// A polygon on the coordinate plane that its normal is nearest to.
class Flat
{
    Triangulation triangulation_;
    std::vector<VertexHandle> at_; ///< of the corners
    /// Passes of each edge from its first to its second vertex, less those back: 0 of the cut between a rim and a hole.
    std::map<std::pair<VertexHandle, VertexHandle>, int> passes_;

    int passes(VertexHandle a, VertexHandle b) const
    {
        const auto edge = passes_.find(std::minmax(a, b));
        return edge == passes_.end() ? 0 : a < b ? edge->second : -edge->second;
    }

    /// Winding numbers: the polygon goes so often around each face, one more on the left of an edge than on its right.
    void countWindings()
    {
        constexpr int unknown = std::numeric_limits<int>::max();
        for (const auto face : triangulation_.all_face_handles()) face->info() = unknown;
        std::vector<FaceHandle> front{triangulation_.infinite_face()};
        front[0]->info() = 0;
        while (!front.empty())
        {
            const auto face = front.back();
            front.pop_back();
            for (int k = 0; k < 3; ++k)
            {
                const auto next = face->neighbor(k);
                if (next->info() != unknown) continue;
                next->info() = face->info() - passes(face->vertex(face->ccw(k)), face->vertex(face->cw(k)));
                front.push_back(next);
            }
        }
    }

public:
    Flat(std::span<const Vector<3>> corners, const Vector<3>& normal)
    {
        // The two coordinates in the order that keeps the polygon counter-clockwise.
        const auto n = std::array{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
        const auto dropped = std::size_t(std::max_element(n.begin(), n.end()) - n.begin());
        constexpr std::array coordinate{&Vector<3>::x, &Vector<3>::y, &Vector<3>::z};
        auto u = coordinate[(dropped + 1) % 3], v = coordinate[(dropped + 2) % 3];
        if (normal.*coordinate[dropped] < 0) std::swap(u, v);

        FaceHandle near;
        for (std::size_t k = 0; k < corners.size(); ++k)
        {
            const auto before = triangulation_.number_of_vertices();
            const auto vertex = triangulation_.insert({corners[k].*u, corners[k].*v}, near);
            near = vertex->face();
            if (triangulation_.number_of_vertices() > before) vertex->info() = int(k);
            else if (corners[std::size_t(vertex->info())] != corners[k]) throw std::domain_error("has two corners behind one another");
            at_.push_back(vertex);
        }
        if (triangulation_.dimension() < 2) throw std::domain_error("crosses itself");
    }

    std::vector<std::array<int, 3>> triangles()
    {
        for (std::size_t k = 0; k < at_.size(); ++k)
        {
            const auto a = at_[k], b = at_[k + 1 < at_.size() ? k + 1 : 0];
            const auto [edge, isNew] = passes_.try_emplace(std::minmax(a, b), 0);
            edge->second += a < b ? 1 : -1;
            if (isNew) triangulation_.insert_constraint(a, b);
        }
        for (const auto& [edge, n] : passes_)
            if (!triangulation_.is_edge(edge.first, edge.second)) throw std::domain_error("touches itself");
        countWindings();
        std::vector<std::array<int, 3>> triangles;
        for (const auto face : triangulation_.finite_face_handles())
        {
            if (face->info() != 0 && face->info() != 1) throw std::domain_error("crosses itself");
            if (face->info() == 1) triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
        }
        if (triangles.empty()) throw std::domain_error("runs back along itself and bounds nothing");
        return triangles;
    }
};

}

double unevenness(std::span<const Vector<3>> corners)
{
    const auto a = areaVector(corners);
    Vector<3> middle;
    for (const auto& x : corners) middle += x / double(corners.size());
    double off = 0, size = 0;
    for (const auto& x : corners)
    {
        off = std::max(off, std::abs(dot(x - middle, a)) / mag(a));
        size = std::max(size, mag(x - middle));
    }
    return mag(a) > 0 ? off / size : 0;
}

std::vector<std::array<int, 3>> triangulate(std::span<const Vector<3>> corners)
{
    if (isLine(corners)) return fan(corners.size());
    // Corners that follow one another in one place are one.
    std::vector<Vector<3>> places;
    std::vector<int> number;
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (corners[k] != corners[k == 0 ? corners.size() - 1 : k - 1])
        {
            places.push_back(corners[k]);
            number.push_back(int(k));
        }
    try
    {
        auto triangles = Flat(places, normalOf(places)).triangles();
        for (auto& t : triangles)
            for (int& k : t) k = number[std::size_t(k)];
        return triangles;
    }
    catch (const Triangulation::Intersection_of_constraints_exception&)
    {
        throw std::domain_error("crosses itself");
    }
}

}
