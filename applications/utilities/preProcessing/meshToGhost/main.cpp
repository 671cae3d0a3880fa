/// Prepares the walls of a case for the solver: constant/geometry, checked against the kernel support of system/sphSchemes,
/// becomes constant/walls, each of its meshes constant/wallMeshes/<wall>, and constant/triSurface/walls.{stl,vtp} to look at; with `walls
/// layers;` also constant/lagrangian/wallLayers.
#include "base/CommandLine.hpp"
#include "base/OutputFile.hpp"
#include "case/Case.hpp"
#include "geometry/GeometryCheck.hpp"
#include "geometry/Walls.hpp"
#include "geometry/makeWallLayers.hpp"
#include "geometry/readShapes.hpp"
#include "geometry/readSpace.hpp"
#include "geometry/wallSurfaces.hpp"
#include "inSolids.hpp"
#include "meshes/prepareMesh.hpp"
#include "meshes/readers/NumberedMesh.hpp"
#include "report.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace
{

sph::MeshSpace spaceOf(const sph::Geometry& g, const sph::Resolution& resolution)
{
    return {.low = g.low, .high = g.high, .periodic = g.periodic, .spacing = resolution.spacing, .H = resolution.H()};
}

/// Before the geometry is read, which takes meshes from what is written here. The names of the files.
std::vector<std::string> prepareMeshes(const sph::Case& theCase, const sph::Dictionary& source, const sph::Resolution& resolution,
                                       bool full)
{
    std::vector<std::string> files;
    const auto meshes = sph::meshWalls(source);
    if (meshes.empty()) return files;

    sph::Geometry space;
    sph::readSpace(source, space);
    theCase.diagnostics().throwIfAny();
    if (space.dimension == 2) return files; // no place for them
    for (const auto& wall : meshes)
    {
        const auto before = theCase.diagnostics().errors();
        const auto mesh = sph::readTriSurface(wall);
        if (theCase.diagnostics().errors() > before) continue;
        const auto prepared = sph::prepareMesh(theCase.folder(), mesh, spaceOf(space, resolution), theCase.diagnostics());
        fmt::print("{}\n", sph::meshReport(prepared, resolution.H(), full));
        std::fflush(stdout);
        if (!prepared.usable) continue;
        const auto written = sph::writePrepared(theCase.folder(), prepared);
        files.insert(files.end(), written.begin(), written.end());
    }
    theCase.diagnostics().throwIfAny();
    return files;
}

int prepare(const std::filesystem::path& folder, bool full)
{
    const sph::Case theCase(folder);
    const auto schemes = theCase.dictionary("system/sphSchemes");
    const auto resolution = sph::readResolution(schemes);
    const bool layered = sph::wallsAreLayers(schemes);
    const auto source = theCase.dictionary("constant/geometry");
    theCase.diagnostics().throwIfAny();

    const double H = resolution.H();
    const auto meshFiles = prepareMeshes(theCase, source, resolution, full);
    const auto geometry = sph::readGeometry(source, resolution, 1, folder);
    source.reportUnused();
    theCase.diagnostics().throwIfAny();

    const auto checked = sph::checkGeometry(geometry, H, theCase.diagnostics());
    fmt::print("{}", report(geometry, checked, H, full));
    for (const auto& line : theCase.diagnostics().warnings()) fmt::print("\nWarning: {}\n", line);
    std::fflush(stdout);
    const auto layers =
        layered ? sph::makeWallLayers(geometry, H, resolution.spacing, theCase.diagnostics()) : std::vector<sph::LayerParticle>{};
    theCase.diagnostics().throwIfAny();

    // Fine enough to look round: a fortieth of the domain, or half a support where that is coarser.
    const double largest = std::max({geometry.length(0), geometry.length(1), geometry.dimension == 3 ? geometry.length(2) : 0.0});
    const auto surfaces = sph::wallSurfaces(geometry, H, std::max(0.5 * H, largest / 40));
    sph::createFolders(folder / "constant" / "triSurface");
    sph::writeFile(folder / "constant" / "triSurface" / "walls.stl", sph::stlText(geometry, surfaces));
    sph::writeFile(folder / "constant" / "triSurface" / "walls.vtp", sph::vtpText(geometry, surfaces));
    if (layered) sph::writeWallLayers(folder, layers);
    else sph::removeWallLayers(folder);
    // Last: with its stamp it says that all else belongs to the present geometry.
    sph::writeFile(folder / "constant" / "walls",
                   sph::wallsText(geometry, sph::geometryStamp(folder, resolution.spacing, resolution.support)));
    fmt::print("\nWritten constant/walls, constant/triSurface/walls.stl, constant/triSurface/walls.vtp{}{}\n\nEnd\n",
               meshFiles.empty() ? "" : fmt::format(", {}", fmt::join(meshFiles, ", ")),
               layered ? fmt::format(", constant/lagrangian/wallLayers: {} particles", layers.size()) : "");
    return 0;
}

/// An independent check of a run: whether particles of its time folders lie in walls.
int countInSolids(const std::filesystem::path& folder)
{
    const sph::Case theCase(folder);
    const auto resolution = sph::readResolution(theCase.dictionary("system/sphSchemes"));
    const auto source = theCase.dictionary("constant/geometry");
    theCase.diagnostics().throwIfAny();
    const auto geometry = sph::readGeometry(source, resolution, 1, folder);
    theCase.diagnostics().throwIfAny();

    std::vector<Solid> solids;
    for (const auto& wall : sph::meshWalls(source))
    {
        const auto mesh = sph::readTriSurface(wall);
        try
        {
            solids.push_back(solidOfFile(wall.keyword(), sph::SolidOfFile(folder, mesh, spaceOf(geometry, resolution)), geometry));
        }
        catch (const sph::UnusableMesh& e)
        {
            wall.error("file", fmt::format("constant/triSurface/{}: {}", mesh.file, e.what()));
        }
    }
    theCase.diagnostics().throwIfAny();
    for (auto& solid : solidsOfShapes(geometry)) solids.push_back(std::move(solid));
    std::vector<sph::Cloud> clouds;
    for (const auto& time : theCase.times())
        if (sph::hasCloud(folder, time, "sph")) clouds.push_back(sph::readCloud(folder, time, "sph", theCase.diagnostics()));
    theCase.diagnostics().throwIfAny();
    if (clouds.empty()) throw sph::CaseError("no time folder has particles: has packParticles been run?");
    fmt::print("{}\nEnd\n", reportInSolids(clouds, solids));
    return 0;
}

}

int main(int argc, char** argv)
{
    bool check = false, inSolids = false;
    return sph::runApplication(
        "meshToGhost", argc, argv,
        "Prepares the walls of constant/geometry, shapes and meshes, for the solver and checks that reflection can represent them.",
        [&](sph::CommandLine& line)
        {
            line.flag("check", check, "Print curvature, gaps, contacts and motion of every wall, and of meshes what surfaceCheck prints");
            line.flag("inSolids", inSolids,
                      "Prepare nothing, but count the particles of all time folders that lie in walls: in meshes, as their files have "
                      "them, by CGAL");
        },
        [&](const std::filesystem::path& folder) { return inSolids ? countInSolids(folder) : prepare(folder, check); });
}
