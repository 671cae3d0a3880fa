#include "meshes/workingMesh.hpp"

namespace sph
{

WorkingMesh toWorkingMesh(const NumberedMesh& m)
{
    WorkingMesh w;
    w.reserve(WorkingMesh::size_type(m.points.size()), WorkingMesh::size_type(3 * m.triangles.size() / 2),
              WorkingMesh::size_type(m.triangles.size()));
    auto region = regionOf(w), number = numberOf(w);
    for (const auto& p : m.points) w.add_vertex(toPoint(p));
    using Vertex = WorkingMesh::Vertex_index;
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
    {
        const auto& [a, b, c] = m.triangles[f];
        const auto face =
            w.add_face(Vertex(WorkingMesh::size_type(a)), Vertex(WorkingMesh::size_type(b)), Vertex(WorkingMesh::size_type(c)));
        if (face == WorkingMesh::null_face())
            throw UnusableMesh("the surface is not manifold: facets cannot be put in order around a point", m, std::vector<int>{int(f)});
        region[face] = m.region[f];
        number[face] = m.number[f];
    }
    return w;
}

void fromWorkingMesh(WorkingMesh& w, NumberedMesh& m)
{
    w.collect_garbage();
    const auto region = regionOf(w), number = numberOf(w);
    m.points.clear();
    m.triangles.clear();
    m.region.clear();
    m.number.clear();
    for (const auto v : w.vertices()) m.points.push_back(toVector(w.point(v)));
    for (const auto f : w.faces())
    {
        std::array<int, 3> corners{};
        std::size_t k = 0;
        for (const auto v : w.vertices_around_face(w.halfedge(f))) corners[k++] = int(v);
        m.triangles.push_back(corners);
        m.region.push_back(region[f]);
        m.number.push_back(number[f]);
    }
}

}
