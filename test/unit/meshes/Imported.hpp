/// What the reader alone makes of a file.
#pragma once
#include "meshTexts.hpp"
#include "meshes/readers/importMesh.hpp"
#include "temporaryCase.hpp"

namespace sph::test
{

/// By the divergence theorem, about one of the points: what is far from the origin loses no digits.
inline double volumeOf(const TriangleSurface& m)
{
    double six = 0;
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
        six += dot(m.points[std::size_t(m.triangles[f][0])] - m.points[0], areaVector(m, int(f)));
    return six / 6;
}

/// The file, with others beside it; or why it is refused.
struct Imported
{
    TemporaryCase folder;
    std::vector<std::string> notes;
    NumberedMesh mesh;
    std::string refusal;

    Imported(const std::string& file, const std::string& text, const std::vector<std::pair<std::string, std::string>>& others = {})
    {
        folder.write(file, text);
        for (const auto& [name, bytes] : others) folder.write(name, bytes);
        try
        {
            mesh = importMesh(folder.folder() / file, notes);
        }
        catch (const UnusableMesh& e)
        {
            refusal = e.what();
        }
    }
    double volume() const { return volumeOf(mesh); }
    /// "lid 2, shell 10"
    std::string regions() const
    {
        std::string text;
        for (std::size_t r = 0; r < mesh.regions.size(); ++r)
            text += fmt::format("{}{} {}", r > 0 ? ", " : "", mesh.regions[r], std::count(mesh.region.begin(), mesh.region.end(), int(r)));
        return text;
    }
    std::string allNotes() const { return fmt::format("{}", fmt::join(notes, "\n")); }
};

inline std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    return text.replace(text.find(what), what.size(), with);
}

inline std::string replacedAll(std::string text, const std::string& what, const std::string& with)
{
    for (auto at = text.find(what); at != text.npos; at = text.find(what, at + with.size())) text.replace(at, what.size(), with);
    return text;
}

}
