#include "CaseError.hpp"
#include "FoamScanner.hpp"
#include "MappedFile.hpp"
#include "closedSurface.hpp"
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <sstream>

namespace sph
{

namespace
{

constexpr std::size_t stlHeader = 84, stlFacet = 50;

TriangleSurface fromBinaryStl(std::string_view bytes)
{
    TriangleSurface s;
    for (std::size_t at = stlHeader; at + stlFacet <= bytes.size(); at += stlFacet)
    {
        float corner[9];
        std::memcpy(corner, bytes.data() + at + 12, sizeof corner);
        const int first = int(s.points.size());
        for (int k = 0; k < 3; ++k) s.points.push_back({corner[3 * k], corner[3 * k + 1], corner[3 * k + 2]});
        s.triangles.push_back({first, first + 1, first + 2});
    }
    return s;
}

struct Lines
{
    std::istringstream text;
    std::string file;
    int line = 0;

    [[noreturn]] void fail(const std::string& what) const { throw CaseError({file, line}, what); }
    bool next(std::istringstream& words)
    {
        std::string all;
        if (!std::getline(text, all)) return false;
        ++line;
        words = std::istringstream(all);
        return true;
    }
    Vector<3> point(std::istringstream& words) const
    {
        Vector<3> p;
        if (!(words >> p.x >> p.y >> p.z)) fail("expected three coordinates");
        return p;
    }
};

TriangleSurface fromAsciiStl(Lines& lines)
{
    TriangleSurface s;
    std::istringstream words;
    std::string word;
    while (lines.next(words))
        if (words >> word && word == "vertex")
        {
            s.points.push_back(lines.point(words));
            if (const int n = int(s.points.size()); n % 3 == 0) s.triangles.push_back({n - 3, n - 2, n - 1});
        }
    if (s.points.size() % 3 != 0) lines.fail("the last facet is not whole");
    return s;
}

TriangleSurface fromObj(Lines& lines)
{
    TriangleSurface s;
    std::istringstream words;
    std::string word;
    while (lines.next(words))
    {
        if (!(words >> word)) continue;
        if (word == "v") s.points.push_back(lines.point(words));
        if (word != "f") continue;
        std::vector<int> corners;
        while (words >> word)
        {
            int n = 0;
            std::from_chars(word.data(), word.data() + word.size(), n);
            if (n < 0) n += int(s.points.size()) + 1;
            if (n < 1 || n > int(s.points.size())) lines.fail(fmt::format("\"{}\" is no point of the file", word));
            corners.push_back(n - 1);
        }
        if (corners.size() < 3) lines.fail("a facet has three points or more");
        for (std::size_t k = 2; k < corners.size(); ++k) s.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
    return s;
}

}

TriangleSurface readSurface(const std::filesystem::path& caseFolder, const std::string& file)
{
    const auto fail = [&](const std::string& what) { throw CaseError({file, 0}, what); };
    std::error_code none;
    if (!std::filesystem::is_regular_file(caseFolder / file, none)) fail("is missing");
    const MappedFile mapped(caseFolder / file);
    const auto bytes = mapped.text();
    TriangleSurface s;
    if (file.ends_with(".obj") || file.ends_with(".OBJ"))
    {
        Lines lines{std::istringstream(std::string(bytes)), file};
        s = fromObj(lines);
    }
    else if (file.ends_with(".stl") || file.ends_with(".STL"))
    {
        std::uint32_t facets = 0;
        if (bytes.size() >= stlHeader) std::memcpy(&facets, bytes.data() + 80, sizeof facets);
        if (bytes.size() == stlHeader + stlFacet * std::size_t(facets) && facets > 0) s = fromBinaryStl(bytes);
        else if (bytes.starts_with("solid"))
        {
            Lines lines{std::istringstream(std::string(bytes)), file};
            s = fromAsciiStl(lines);
        }
        else fail(fmt::format("is a binary STL file of {} facets by its header, and has another length", facets));
    }
    else fail("is neither .stl nor .obj");
    for (const auto& p : s.points)
        if (!std::isfinite(p.x + p.y + p.z)) fail("has a coordinate that is no number");
    if (s.triangles.empty()) fail("has no facets");
    return welded(s);
}

}
