#include "meshes/prepareMesh.hpp"
#include "base/words.hpp"
#include "geometry/components.hpp"
#include "meshes/cleanSoup.hpp"
#include "meshes/continuePeriodically.hpp"
#include "meshes/importSource.hpp"
#include "meshes/meshFiles.hpp"
#include "meshes/orientShells.hpp"
#include "meshes/placeMesh.hpp"
#include "meshes/repairSurface.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// Ratio of a mesh's extent to the domain's, or of a spacing to the mesh's extent, from which a wrong unit is meant: mm for m makes 1000.
constexpr double wrongUnit = 100;

/// Single precision far from the origin of a file has lost the digits that say where a point is.
void checkDigits(const NumberedMesh& m, const TriSurface& t, double spacing, Diagnostics& diagnostics)
{
    constexpr double share = 0.01; // of a spacing that rounding may take
    const auto box = boundingBox(m);
    double farthest = 0;
    for (const auto c : coordinates) farthest = std::max({farthest, std::abs(box.low.*c), std::abs(box.high.*c)});
    if (const double rounding = t.scale * m.rounding; rounding > share * spacing)
        diagnostics.warning(
            t.at,
            fmt::format("the coordinates of constant/triSurface/{} are up to {:.4g} and in single precision, seven digits, within "
                        "{:.2g} m: write the file in double precision (ascii STL, OBJ, OFF, PLY), or nearer to its origin and move it "
                        "back by translation",
                        t.file, farthest, rounding));
}

struct WrongPlace : std::runtime_error
{
    Location where;
    WrongPlace(const Location& at, const std::string& what) : runtime_error(what), where(at) {}
};

void checkPlace(const NumberedMesh& m, const TriSurface& t, const MeshSpace& space)
{
    const auto box = boundingBox(m);
    double size = 0, domain = 0;
    for (const auto c : coordinates)
    {
        size = std::max(size, box.high.*c - box.low.*c);
        domain = std::max(domain, space.high.*c - space.low.*c);
    }
    const auto range = fmt::format("{} to {}", inWords(box.low), inWords(box.high));
    if (size > wrongUnit * domain)
        throw WrongPlace(t.scaleAt,
                         fmt::format("the mesh is {:.4g} m long, {:.3g} x the domain ({}). Are its lengths mm? Then scale {:.3g};", size,
                                     size / domain, range, t.scale / 1000));
    if (size < space.spacing)
        throw WrongPlace(t.scaleAt,
                         fmt::format("the mesh is {:.4g} m long, less than a spacing, {:.4g} m ({}).{}", size, space.spacing, range,
                                     size * wrongUnit < domain
                                         ? fmt::format(" Is its scale too small? 1000 x as large: scale {:.3g};", 1000 * t.scale)
                                         : ""));
    for (int k = 0; k < 3; ++k)
    {
        const auto c = component(k);
        if (!space.periodic[std::size_t(k)] && (box.high.*c < space.low.*c || box.low.*c > space.high.*c))
            throw WrongPlace(t.at, fmt::format("the mesh, {}, lies outside the domain, {} to {}: see its scale, rotation and translation",
                                               range, inWords(space.low), inWords(space.high)));
    }
}

void checkRegions(const NumberedMesh& m, const TriSurface& t)
{
    for (const auto& name : t.regions)
        if (std::find(m.regions.begin(), m.regions.end(), name) == m.regions.end())
            throw WrongPlace(t.at, fmt::format("has no region \"{}\". {}", name, suggestion(name, "regions", m.regions)));
}

/// Steps from loose triangles to a closed surface, in their order.
void repair(NumberedMesh& m, const TriSurface& t, double tolerance, PreparedMesh& result)
{
    auto& repairs = result.repairs;
    double contact = contactOf(tolerance, weldOf(boundingBox(m)));
    if (t.wrap) wrap(m, *t.wrap, repairs);
    if (m.triangles.empty()) throw UnusableMesh("no facet is left: the surface has no volume, each facet has its opposite");
    if (t.removeSelfIntersections) splitEdges(m);
    checkManifold(m);
    orientFacets(m, repairs);
    splitPoints(m, repairs);
    closeHoles(m, t.closeHoles, repairs);
    removeSlivers(m, tolerance, repairs);
    if (t.removeSelfIntersections) contact = removeSelfIntersections(m, contact, repairs);
    orientShells(m, t.fluid, repairs);
    checkSelfIntersections(m, contact,
                           t.removeSelfIntersections ? "Wrap the mesh: wrap { tolerance ...; }"
                                                     : "Have it repaired: removeSelfIntersections yes; or wrap { tolerance ...; }");
    if (t.edgeLength)
    {
        remesh(m, *t.edgeLength, t.featureAngle, repairs);
        checkSelfIntersections(m, contact, "Remeshing did it: choose another edgeLength, or a smaller featureAngle");
    }
}

}

PreparedMesh prepareMesh(const std::filesystem::path& caseFolder, const TriSurface& t, const MeshSpace& space, Diagnostics& diagnostics)
{
    PreparedMesh result;
    result.source = t;
    removeDefects(caseFolder, t.wall);
    const auto file = "constant/triSurface/" + t.file;
    try
    {
        auto m = importSource(caseFolder / file, t, result.notes);
        result.regions = m.regions;
        checkRegions(m, t);
        checkDigits(m, t, space.spacing, diagnostics);
        place(m, t);
        checkPlace(m, t, space);
        const auto box = boundingBox(m);
        const double tolerance = t.weld.value_or(weldOf(box));
        weldPoints(m, tolerance, result.repairs);
        if (m.triangles.empty()) throw UnusableMesh("no facet is left after welding: all are smaller than the entry weld");
        result.asRead = meshStatistics(m);
        removeDuplicates(m, result.repairs);
        continuePeriodically(m, space, tolerance, result.repairs);
        repair(m, t, tolerance, result);

        result.prepared = meshStatistics(m);
        result.surface = m;
        result.edges = dihedralEdges(result.surface);
        result.features = meshFeatures(result.surface, result.edges, t.featureAngle);
        result.clearances = meshClearances(result.surface);
        result.hollows = meshHollows(m, result.edges, t.featureAngle, space.H);
        result.usable = true;
        if (const auto& [width, at] = result.clearances.thinnest; width < 2 * space.H)
            diagnostics.warning(
                t.at,
                fmt::format(
                    "wall \"{}\" is {:.3g} m thin at {}, less than two supports of the kernel, {:.3g} m: the mirror "
                    "images of its two sides lie in one another, and fluid on both of them sees too much of it; a finer spacing ends that",
                    t.wall, width, inWords(at), 2 * space.H));
        if (const auto& [count, radius, facet, at] = result.hollows; count > 0)
            diagnostics.warning(
                t.at, fmt::format("wall \"{}\" has {} tighter than the support of the kernel, {:.3g} m, which cannot resolve {}: the "
                                  "tightest has a radius of {:.3g} m at {}, {}",
                                  t.wall, counted(count, "hollow"), space.H, count == 1 ? "it" : "them", radius, inWords(at), facet));
        if (const auto& f = result.features; f.grooves > 0)
            diagnostics.warning(
                t.at,
                fmt::format("wall \"{}\" has {} of less than {:.0f} degrees, behind whose edge mirror images leave gaps: the sum of the "
                            "kernel there is 0.83 of that in the fluid at 15 degrees, 0.60 at 10, 0.32 at 5. The narrowest leaves "
                            "{:.3g} degrees to the fluid, at {}. Fill it, or bridge it: wrap {{ tolerance ...; alpha ...; }}",
                            t.wall, counted(f.grooves, "groove"), leastFilled, f.least, inWords(f.leastAt)));
    }
    catch (const UnusableMesh& e)
    {
        auto text = fmt::format("{}: {}", file, e.what());
        if (!e.facets.triangles.empty() || !e.edges.empty()) text += "\nTo be seen in " + writeDefects(caseFolder, t.wall, e);
        diagnostics.error(t.at, text);
    }
    catch (const WrongPlace& e)
    {
        diagnostics.error(e.where, fmt::format("{}: {}", file, e.what()));
    }
    return result;
}

std::vector<std::string> writePrepared(const std::filesystem::path& caseFolder, const PreparedMesh& p)
{
    const auto& wall = p.source.wall;
    writeWallMesh(caseFolder, wall, p.surface);
    return {wallMeshFile(wall), writeEdges(caseFolder, wall, p.surface, p.edges, p.source.featureAngle)};
}

}
