#include "geometry/FacetSurface.hpp"
#include "base/OutputFile.hpp"
#include "case/FoamHeader.hpp"
#include "case/FoamScanner.hpp"
#include "case/MappedFile.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

void expect(FoamScanner& in, char c, const char* where)
{
    if (!in.take(c)) in.fail(fmt::format("expected '{}' {}, found {}", c, where, in.found()));
}

/// `name <count> (`, and the count.
std::size_t beginList(FoamScanner& in, const std::string& name)
{
    if (const auto found = in.word(); found != name) in.fail(fmt::format("expected {}, found \"{}\"", name, found));
    std::int64_t count = 0;
    in.skip();
    // Each element takes at least "(0 0 0)".
    if (!in.integer(count) || count < 0 || std::size_t(count) > in.remaining() / 7)
        in.fail(fmt::format("the number of {} is missing, or greater than what follows", name));
    expect(in, '(', "before the first element");
    return std::size_t(count);
}

FacetSurface parse(FoamScanner& in)
{
    FacetSurface s;
    if (const auto header = readFoamHeader(in); header.className != "wallMesh" || header.binary)
        throw ScanError(header.classLine,
                        fmt::format("class \"{}\" in {}, not wallMesh in ascii", header.className, header.binary ? "binary" : "ascii"));
    if (in.word() != "regions") in.fail("expected regions");
    expect(in, '(', "before the first region");
    while (!in.take(')'))
    {
        if (in.atEnd()) in.fail("ends within its regions");
        s.regions.push_back(in.word());
    }
    if (s.regions.empty()) in.fail("has no regions");
    s.points.resize(beginList(in, "points"));
    for (auto& p : s.points)
    {
        expect(in, '(', "before a point");
        for (double* q : {&p.x, &p.y, &p.z})
        {
            in.skip();
            if (!in.number(*q) || !std::isfinite(*q)) in.fail(fmt::format("expected a coordinate, found {}", in.found()));
        }
        expect(in, ')', "after a point");
    }
    expect(in, ')', "after the points");
    s.triangles.resize(beginList(in, "facets"));
    s.region.resize(s.triangles.size());
    for (std::size_t f = 0; f < s.triangles.size(); ++f)
    {
        expect(in, '(', "before a facet");
        for (int k = 0; k < 4; ++k)
        {
            std::int64_t value = 0;
            in.skip();
            const auto limit = std::int64_t(k < 3 ? s.points.size() : s.regions.size());
            if (!in.integer(value) || value < 0 || value >= limit)
                in.fail(fmt::format("expected the number of a {}, found {}", k < 3 ? "point" : "region", in.found()));
            (k < 3 ? s.triangles[f][std::size_t(k)] : s.region[f]) = int(value);
        }
        expect(in, ')', "after a facet");
    }
    expect(in, ')', "after the facets");
    return s;
}

}

std::string wallMeshFile(const std::string& wall) { return "constant/wallMeshes/" + wall; }

void writeWallMesh(const std::filesystem::path& caseFolder, const std::string& wall, const FacetSurface& s)
{
    createFolders(caseFolder / "constant" / "wallMeshes");
    std::string text = foamHeader(WriteFormat::ascii, "wallMesh", "constant/wallMeshes", wall);
    const auto to = std::back_inserter(text);
    fmt::format_to(to, "\nregions ({})\n\npoints {}\n(\n", fmt::join(s.regions, " "), s.points.size());
    for (const auto& p : s.points) fmt::format_to(to, "({} {} {})\n", p.x, p.y, p.z);
    fmt::format_to(to, ")\n\nfacets {}\n(\n", s.triangles.size());
    for (std::size_t f = 0; f < s.triangles.size(); ++f)
    {
        const auto& [a, b, c] = s.triangles[f];
        fmt::format_to(to, "({} {} {} {})\n", a, b, c, s.region[f]);
    }
    text += ")\n";
    writeFile(caseFolder / wallMeshFile(wall), text);
}

FacetSurface readWallMesh(const std::filesystem::path& caseFolder, const std::string& wall, Diagnostics& diagnostics)
{
    const auto file = wallMeshFile(wall);
    std::error_code none;
    if (!std::filesystem::exists(caseFolder / file, none))
    {
        diagnostics.error({file, 0}, "is missing: run meshToGhost, which makes it from the mesh that constant/geometry names");
        return {};
    }
    try
    {
        const MappedFile bytes(caseFolder / file);
        FoamScanner in(bytes.text());
        return parse(in);
    }
    catch (const ScanError& e)
    {
        diagnostics.error({file, e.line}, fmt::format("{}. Run meshToGhost again", e.what()));
    }
    catch (const std::runtime_error& e)
    {
        diagnostics.error({file, 0}, fmt::format("cannot be read: {}", e.what()));
    }
    return {};
}

}
