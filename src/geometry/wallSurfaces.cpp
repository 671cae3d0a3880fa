#include "geometry/wallSurfaces.hpp"
#include "geometry/TriangleMesh.hpp"
#include <fmt/format.h>
#include <iterator>

namespace sph
{

std::vector<TriangleSurface> wallSurfaces(const Geometry& g, double margin, double size)
{
    const Vector<3> m{margin, margin, margin};
    Box within{g.low - m, g.high + m};
    if (g.dimension == 2)
    {
        within.low.z = -0.5 * size;
        within.high.z = 0.5 * size;
    }
    std::vector<TriangleSurface> surfaces(g.walls.size());
    for (const auto& patch : g.patches)
        if (patch.mesh)
            for (std::size_t region = 0; region < std::max<std::size_t>(1, patch.walls.size()); ++region)
                append(surfaces[std::size_t(patch.wallAt(int(region)))], cropped(patch.mesh->region(int(region)), within));
        else append(surfaces[patch.wall], triangulate(*patch.shape, within, size));
    return surfaces;
}

std::string stlText(const Geometry& g, const std::vector<TriangleSurface>& surfaces)
{
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    for (std::size_t w = 0; w < surfaces.size(); ++w)
    {
        fmt::format_to(to, "solid {}\n", g.walls[w].name);
        for (const auto& [a, b, c] : surfaces[w].triangles)
        {
            const auto &p = surfaces[w].points[a], &q = surfaces[w].points[b], &r = surfaces[w].points[c];
            const auto n = unitVector(cross(q - p, r - p));
            fmt::format_to(to, "facet normal {:.6g} {:.6g} {:.6g}\n outer loop\n", n.x, n.y, n.z);
            for (const auto& v : {p, q, r}) fmt::format_to(to, "  vertex {:.9g} {:.9g} {:.9g}\n", v.x, v.y, v.z);
            fmt::format_to(to, " endloop\nendfacet\n");
        }
        fmt::format_to(to, "endsolid {}\n", g.walls[w].name);
    }
    return fmt::to_string(out);
}

std::string vtpText(const Geometry& g, const std::vector<TriangleSurface>& surfaces)
{
    TriangleSurface all;
    std::vector<std::size_t> wallOf;
    for (std::size_t w = 0; w < surfaces.size(); ++w)
    {
        append(all, surfaces[w]);
        wallOf.resize(all.triangles.size(), w);
    }
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    const auto array = [&](const std::string& type, const std::string& attributes, std::size_t count, auto&& value)
    {
        fmt::format_to(to, "<DataArray type=\"{}\" {} format=\"ascii\">\n", type, attributes);
        for (std::size_t i = 0; i < count; ++i) fmt::format_to(to, "{}\n", value(i));
        fmt::format_to(to, "</DataArray>\n");
    };
    fmt::format_to(to,
                   "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
                   "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                   all.points.size(), all.triangles.size());
    fmt::format_to(to, "<CellData Scalars=\"wall\">\n");
    array("Int32", "Name=\"wall\"", wallOf.size(), [&](std::size_t i) { return wallOf[i]; });
    array("Float64", "Name=\"contactAngle\"", wallOf.size(),
          [&](std::size_t i)
          {
              const auto& wall = g.walls[wallOf[i]];
              return wall.contactAngles.empty() ? wall.contactAngle : wall.contactAngles.front().angle;
          });
    fmt::format_to(to, "</CellData>\n<Points>\n");
    array("Float64", "NumberOfComponents=\"3\"", all.points.size(),
          [&](std::size_t i) { return fmt::format("{:.9g} {:.9g} {:.9g}", all.points[i].x, all.points[i].y, all.points[i].z); });
    fmt::format_to(to, "</Points>\n<Polys>\n");
    array("Int64", "Name=\"connectivity\"", all.triangles.size(),
          [&](std::size_t i) { return fmt::format("{} {} {}", all.triangles[i][0], all.triangles[i][1], all.triangles[i][2]); });
    array("Int64", "Name=\"offsets\"", all.triangles.size(), [](std::size_t i) { return 3 * (i + 1); });
    fmt::format_to(to, "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n");
    return fmt::to_string(out);
}

}
