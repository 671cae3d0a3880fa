#include "meshes/SolidOfFile.hpp"
#include "meshes/cleanSoup.hpp"
#include "meshes/continuePeriodically.hpp"
#include "meshes/importSource.hpp"
#include "meshes/orientShells.hpp"
#include "meshes/placeMesh.hpp"
#include "meshes/repairSurface.hpp"
#include "meshes/workingMesh.hpp"
#include <CGAL/Side_of_triangle_mesh.h>
#include <deque>

namespace sph
{

struct SolidOfFile::Shells
{
    struct Shell
    {
        WorkingMesh mesh;
        CGAL::Side_of_triangle_mesh<WorkingMesh, Kernel> side;
        int sign; ///< 1: solid within, -1: fluid
        Shell(WorkingMesh m, int s) : mesh(std::move(m)), side(mesh), sign(s) {}
    };
    std::deque<Shell> all; ///< what `side` refers to stays where it is
    int outside;           ///< 1: solid beyond all of them
};

SolidOfFile::SolidOfFile(const std::filesystem::path& caseFolder, const TriSurface& t, const MeshSpace& space)
    : shells_(std::make_unique<Shells>())
{
    if (t.wrap) throw UnusableMesh("it is to be wrapped: by itself it bounds no solid");
    std::vector<std::string> notes;
    auto m = importSource(caseFolder / "constant" / "triSurface" / t.file, t, notes);
    place(m, t);
    const double weld = weldOf(boundingBox(m));
    weldPoints(m, t.weld.value_or(weld), notes);
    removeDuplicates(m, notes);
    continuePeriodically(m, space, t.weld.value_or(weld), notes);
    if (t.removeSelfIntersections) splitEdges(m);
    checkManifold(m);
    orientFacets(m, notes);
    splitPoints(m, notes);
    closeHoles(m, t.closeHoles, notes);
    if (t.removeSelfIntersections) removeSelfIntersections(m, contactOf(t.weld.value_or(weld), weld), notes);
    orientShells(m, t.fluid, notes);

    shells_->outside = t.fluid == FluidSide::inside;
    const auto found = findShells(m);
    const auto parts = apart(m, found);
    for (std::size_t k = 0; k < parts.size(); ++k) shells_->all.emplace_back(toWorkingMesh(parts[k]), found.volume[k] > 0 ? 1 : -1);
}

SolidOfFile::SolidOfFile(SolidOfFile&&) noexcept = default;
SolidOfFile::~SolidOfFile() = default;

bool SolidOfFile::contains(const Vector<3>& x) const
{
    int depth = shells_->outside;
    for (const auto& shell : shells_->all)
    {
        const auto side = shell.side(toPoint(x));
        if (side == CGAL::ON_BOUNDARY) return false;
        if (side == CGAL::ON_BOUNDED_SIDE) depth += shell.sign;
    }
    return depth > 0;
}

}
