/// Facets by place. For the sources of this module alone.
#pragma once
#include "meshes/readers/NumberedMesh.hpp"
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

namespace sph
{

/// Tree of a surface, which must outlive it. Distances and rays are plain doubles: no decision rests on them.
class TriangleTree
{
public:
    using Kernel = CGAL::Simple_cartesian<double>;
    using Triangles = std::vector<Kernel::Triangle_3>;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

private:
    Triangles triangles_;
    Tree tree_;

    static Triangles trianglesOf(const TriangleSurface& s)
    {
        Triangles all;
        all.reserve(s.triangles.size());
        const auto corner = [&](int p) { return point(s.points[std::size_t(p)]); };
        for (const auto& [a, b, c] : s.triangles) all.emplace_back(corner(a), corner(b), corner(c));
        return all;
    }

public:
    explicit TriangleTree(const TriangleSurface& s) : triangles_(trianglesOf(s)), tree_(triangles_.begin(), triangles_.end()) {}
    TriangleTree(const TriangleTree&) = delete;

    static Kernel::Point_3 point(const Vector<3>& x) { return {x.x, x.y, x.z}; }
    const Tree& tree() const { return tree_; }
    int facet(Tree::Primitive_id id) const { return int(id - triangles_.cbegin()); }
};

}
