#include "meshes/meshFiles.hpp"
#include "base/OutputFile.hpp"
#include <bit>
#include <cstdint>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// VTK XML PolyData of points, lines and triangles, with cell arrays; numbers in binary behind the text.
class VtpText
{
    std::string text_, data_ = "_";

    template<class T> void array(const std::string& name, int components, const std::vector<T>& values)
    {
        static_assert(std::endian::native == std::endian::little);
        fmt::format_to(std::back_inserter(text_),
                       "<DataArray type=\"{}{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
                       std::is_integral_v<T> ? "Int" : "Float", 8 * sizeof(T), name, components, data_.size() - 1);
        const std::uint64_t bytes = values.size() * sizeof(T);
        data_.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
        data_.append(reinterpret_cast<const char*>(values.data()), bytes);
    }

    template<std::size_t n> void cells(const std::string& name, const std::vector<std::array<int, n>>& corners)
    {
        std::vector<std::int32_t> all, ends;
        for (const auto& c : corners)
        {
            all.insert(all.end(), c.begin(), c.end());
            ends.push_back(std::int32_t(all.size()));
        }
        text_ += "<" + name + ">\n";
        array("connectivity", 1, all);
        array("offsets", 1, ends);
        text_ += "</" + name + ">\n";
    }

public:
    VtpText(const std::vector<Vector<3>>& points, const std::vector<std::array<int, 2>>& lines,
            const std::vector<std::array<int, 3>>& triangles)
    {
        text_ = fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                            "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
                            "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n<Points>\n",
                            points.size(), lines.size(), triangles.size());
        std::vector<double> x;
        for (const auto& p : points) x.insert(x.end(), {p.x, p.y, p.z});
        array("Points", 3, x);
        text_ += "</Points>\n";
        cells("Lines", lines);
        cells("Polys", triangles);
        text_ += "<CellData>\n";
    }
    /// Values of cells: those of lines, then those of triangles.
    template<class T> void cellArray(const std::string& name, const std::vector<T>& values) { array(name, 1, values); }
    std::string end()
    {
        return text_ + "</CellData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n" + data_ + "\n</AppendedData>\n</VTKFile>\n";
    }
};

std::filesystem::path inTriSurface(const std::string& wall, const char* what)
{
    return std::filesystem::path("constant") / "triSurface" / (wall + what);
}

std::string write(const std::filesystem::path& caseFolder, const std::filesystem::path& file, const std::string& text)
{
    createFolders((caseFolder / file).parent_path());
    writeFile(caseFolder / file, text);
    return file.string();
}

constexpr auto defects = ".defects.vtp";

}

std::string writeEdges(const std::filesystem::path& caseFolder, const std::string& wall, const FacetSurface& s,
                       const std::vector<DihedralEdge>& edges, double featureAngle)
{
    std::vector<std::array<int, 2>> lines;
    std::vector<float> angle;
    std::vector<std::int32_t> kind, region(edges.size(), -1);
    for (const auto& e : edges)
    {
        lines.push_back({e.a, e.b});
        angle.push_back(float(e.angle));
        kind.push_back(e.angle > 180 + featureAngle ? 1 : e.angle < 180 - featureAngle ? -1 : 0);
    }
    angle.resize(edges.size() + s.triangles.size(), 180);
    kind.resize(angle.size(), 0);
    region.insert(region.end(), s.region.begin(), s.region.end());
    VtpText vtp(s.points, lines, s.triangles);
    vtp.cellArray("angle", angle);
    vtp.cellArray("kind", kind);
    vtp.cellArray("region", region);
    return write(caseFolder, inTriSurface(wall, ".edges.vtp"), vtp.end());
}

std::string writeDefects(const std::filesystem::path& caseFolder, const std::string& wall, const UnusableMesh& bad)
{
    auto points = bad.facets.points;
    std::vector<std::array<int, 2>> lines;
    for (const auto& [a, b] : bad.edges)
    {
        lines.push_back({int(points.size()), int(points.size()) + 1});
        points.insert(points.end(), {a, b});
    }
    return write(caseFolder, inTriSurface(wall, defects), VtpText(points, lines, bad.facets.triangles).end());
}

void removeDefects(const std::filesystem::path& caseFolder, const std::string& wall)
{
    std::error_code none;
    std::filesystem::remove(caseFolder / inTriSurface(wall, defects), none);
}

}
