#include "meshes/readers/RegionNames.hpp"
#include "meshes/readers/readers.hpp"
#include "meshes/readers/singlePrecision.hpp"
#include "meshes/readers/textParts.hpp"
#include <bit>
#include <cstring>
#include <fmt/format.h>

namespace sph
{

namespace
{

constexpr std::size_t headerBytes = 84, facetBytes = 50; // the last four bytes of the header count the facets
static_assert(std::endian::native == std::endian::little, "numbers of a binary STL are");

std::uint32_t facetCount(std::string_view bytes)
{
    std::uint32_t facets = 0;
    std::memcpy(&facets, bytes.data() + headerBytes - sizeof facets, sizeof facets);
    return facets;
}

/// A header may begin with "solid", too; but no text has a zero, which the count of fewer than 2^24 facets ends with.
bool isBinary(std::string_view bytes)
{
    if (bytes.size() > headerBytes && bytes.size() == headerBytes + facetBytes * facetCount(bytes)) return true;
    const bool isWide = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); // text in UTF-16
    return !isWide && bytes.substr(0, headerBytes + facetBytes).find('\0') != bytes.npos;
}

void addFacet(NumberedMesh& m, const std::array<Vector<3>, 3>& corners, int region)
{
    const int first = int(m.points.size());
    m.points.insert(m.points.end(), corners.begin(), corners.end());
    m.number.push_back(int(m.triangles.size()));
    m.triangles.push_back({first, first + 1, first + 2});
    m.region.push_back(region);
}

NumberedMesh fromBinary(std::string_view bytes, Notes& notes)
{
    if (bytes.size() < headerBytes) throw UnusableMesh(fmt::format("byte {}: it ends within its header: it is truncated", bytes.size()));
    const std::size_t facets = facetCount(bytes), behind = bytes.size() - headerBytes, there = behind / facetBytes;
    if (facets == 0)
        throw UnusableMesh(
            behind == 0 ? "it has no facets"
                        : fmt::format("byte 80: its header tells of no facets, and {} bytes follow, as {} facets have", behind, there));
    if (there < facets)
        throw UnusableMesh(
            fmt::format("byte {}: its header tells of {} facets, {} are there: it is truncated", bytes.size(), facets, there));
    if (const auto more = behind - facets * facetBytes; more > 0)
        notes.push_back(fmt::format("{} behind the {} facets that the header tells of left out{}", counted(more, "byte"), facets,
                                    more >= facetBytes ? fmt::format(": {} have as many", counted(more / facetBytes, "facet")) : ""));
    NumberedMesh m;
    m.regions = {"patch0"};
    m.points.reserve(3 * facets);
    for (auto* all : {&m.region, &m.number}) all->reserve(facets);
    m.triangles.reserve(facets);
    double largest = 0;
    for (std::size_t f = 0; f < facets; ++f)
    {
        const auto at = headerBytes + f * facetBytes + 12; // behind the normal
        std::array<float, 9> x;
        std::memcpy(x.data(), bytes.data() + at, sizeof x);
        std::array<double, 9> y;
        for (std::size_t k = 0; k < 9; ++k)
        {
            if (!std::isfinite(x[k]))
                throw UnusableMesh(fmt::format("byte {}: facet {} has a coordinate that is no finite number", at + 4 * k, f));
            y[k] = asWritten(x[k]);
            largest = std::max(largest, std::abs(y[k]));
        }
        addFacet(m, {{{y[0], y[1], y[2]}, {y[3], y[4], y[5]}, {y[6], y[7], y[8]}}}, 0);
    }
    m.rounding = roundingOf(largest);
    return m;
}

class AsciiStl
{
    TextLines lines_;
    std::string_view line_;
    NumberedMesh mesh_;
    RegionNames regions_;

    /// Empty at the end of the text.
    std::string_view word()
    {
        for (auto w = nextWord(line_);; w = nextWord(line_))
            if (!w.empty() || !lines_.next(line_)) return w;
    }

    /// Keywords of two parts are written as one word or as two: endfacet, end facet.
    bool isEnd(std::string_view w, std::string_view what)
    {
        if (!isWord(w.substr(0, 3), "end")) return false;
        return isWord(w.size() > 3 ? w.substr(3) : word(), what);
    }

    [[noreturn]] void fail(const std::string& expected, std::string_view found) const
    {
        if (found.empty())
            lines_.fail(fmt::format("it ends within facet {}, where {} was expected: it is truncated", mesh_.triangles.size(), expected));
        lines_.fail(fmt::format("facet {}: expected {}, found {}", mesh_.triangles.size(), expected, quoted(found)));
    }

    /// Reads a facet from its normal on, which may be anything, or missing.
    void readFacet(int region)
    {
        constexpr int normalWords = 4;
        auto w = word();
        for (int n = 0; !isWord(w, "outer"); ++n, w = word())
            if (n == normalWords || w.empty()) fail("outer loop", w);
        if (w = word(); !isWord(w, "loop")) fail("outer loop", w);
        std::array<Vector<3>, 3> corners;
        for (auto& x : corners)
        {
            if (w = word(); !isWord(w, "vertex")) fail("a vertex", w);
            x = takePoint(lines_, line_);
        }
        if (w = word(); !isEnd(w, "loop")) fail("endloop after three vertices", w);
        if (w = word(); !isEnd(w, "facet")) fail("endfacet", w);
        addFacet(mesh_, corners, region);
    }

    void readSolid()
    {
        const auto name = trimmed(line_);
        line_ = {};
        for (auto w = word();; w = word())
            if (isWord(w, "facet")) readFacet(regions_.index(name));
            else if (!w.empty() && isEnd(w, "solid")) break;
            else if (w.empty()) lines_.fail(fmt::format("it ends within solid {}, without endsolid: it is truncated", quoted(name)));
            else fail("facet or endsolid", w);
        line_ = {}; // its name once more
    }

public:
    AsciiStl(std::string_view text, Notes& notes) : lines_(text), regions_(notes) {}

    NumberedMesh read()
    {
        for (auto w = word(); !w.empty(); w = word())
            if (isWord(w, "solid")) readSolid();
            else if (lines_.number() <= 1 && mesh_.triangles.empty())
                lines_.fail(fmt::format("expected solid, found {}: this is no STL file", quoted(w)));
            else lines_.fail(fmt::format("expected solid or the end, found {}", quoted(w)));
        mesh_.regions = regions_.words();
        return std::move(mesh_);
    }
};

}

NumberedMesh readStl(std::string_view bytes, Notes& notes)
{
    return isBinary(bytes) ? fromBinary(bytes, notes) : AsciiStl(bytes, notes).read();
}

}
