#include "meshes/readers/importMesh.hpp"
#include "case/MappedFile.hpp"
#include "meshes/readers/readers.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace sph
{

namespace
{

using Reader = NumberedMesh (*)(const std::filesystem::path&, std::string_view bytes, Notes&);

/// Reader of a format that is one file.
template<NumberedMesh (*read)(std::string_view, Notes&)>
NumberedMesh ofBytes(const std::filesystem::path&, std::string_view bytes, Notes& notes)
{
    return read(bytes, notes);
}

/// The format of a file, by the end of its name.
Reader readerOf(const std::filesystem::path& file)
{
    static const std::map<std::string, Reader> readers{{".stl", ofBytes<readStl>}, {".stlb", ofBytes<readStl>}, {".obj", ofBytes<readObj>},
                                                       {".ply", ofBytes<readPly>}, {".off", ofBytes<readOff>},  {".gltf", readGltf},
                                                       {".glb", readGltf}};
    auto end = file.extension().string();
    std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    const auto reader = readers.find(end);
    if (reader == readers.end())
        throw UnusableMesh(fmt::format("\"{}\" is no format that is known by its name. Known: .stl, .stlb, .obj, .ply, .off, .gltf, .glb; "
                                       "programs that write others write one of these, too",
                                       end));
    return reader->second;
}

/// Tells of single precision where it moves points by more than a thousandth of an edge.
void noteRounding(const NumberedMesh& m, Notes& notes)
{
    constexpr double share = 1e-3;
    double lengths = 0;
    for (const auto& [a, b, c] : m.triangles)
    {
        const auto &x = m.points[std::size_t(a)], &y = m.points[std::size_t(b)], &z = m.points[std::size_t(c)];
        lengths += mag(y - x) + mag(z - y) + mag(x - z);
    }
    const double edge = lengths / (3 * double(m.triangles.size()));
    if (m.rounding > share * edge)
        notes.push_back(
            fmt::format("its coordinates are in single precision, seven digits: rounded by up to {:.2g}, where an edge is {:.2g} long "
                        "in the mean. Write it in double precision (ascii STL, OBJ, OFF, PLY), or nearer to its origin",
                        m.rounding, edge));
}

}

NumberedMesh importMesh(const std::filesystem::path& file, std::vector<std::string>& notes)
{
    const auto read = readerOf(file);
    NumberedMesh mesh;
    try
    {
        const MappedFile bytes(file);
        if (bytes.text().empty()) throw UnusableMesh("it is empty");
        mesh = read(file, bytes.text(), notes);
    }
    catch (const UnusableMesh&)
    {
        throw;
    }
    catch (const std::exception& e)
    {
        throw UnusableMesh(fmt::format("it cannot be read: {}", e.what()));
    }
    if (mesh.triangles.empty()) throw UnusableMesh("it has no facets");
    noteRounding(mesh, notes);
    return mesh;
}

}
