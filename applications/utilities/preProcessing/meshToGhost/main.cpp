/// Prepares the walls of a case for the solver: constant/geometry, checked against the kernel support of system/sphSchemes,
/// becomes constant/walls, and constant/triSurface/walls.{stl,vtp} to look at; with `walls layers;` also
/// constant/lagrangian/wallLayers.
#include "Case.hpp"
#include "CommandLine.hpp"
#include "GeometryCheck.hpp"
#include "OutputFile.hpp"
#include "Walls.hpp"
#include "report.hpp"
#include "wallLayers.hpp"
#include "wallSurfaces.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

namespace
{

int prepare(const std::filesystem::path& folder, bool full)
{
    const sph::Case theCase(folder);
    const auto schemes = theCase.dictionary("system/sphSchemes");
    const auto resolution = sph::readResolution(schemes);
    const bool layered = sph::wallsAreLayers(schemes);
    const auto source = theCase.dictionary("constant/geometry");
    theCase.diagnostics().throwIfAny();

    const double H = resolution.H();
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
    fmt::print("\nWritten constant/walls, constant/triSurface/walls.stl, constant/triSurface/walls.vtp{}\n\nEnd\n",
               layered ? fmt::format(", constant/lagrangian/wallLayers: {} particles", layers.size()) : "");
    return 0;
}

}

int main(int argc, char** argv)
{
    bool check = false;
    return sph::runApplication(
        "meshToGhost", argc, argv, "Prepares the walls of constant/geometry for the solver and checks that reflection can represent them.",
        [&](CLI::App& app) { app.add_flag("--check", check, "Print curvature, gaps, contacts and motion of every wall"); },
        [&](const std::filesystem::path& folder) { return prepare(folder, check); });
}
