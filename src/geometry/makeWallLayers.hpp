/// Walls as layers of particles that lie in the solid, Morris et al. (1997), in the place of mirrored ghosts.
///
/// Layers lie at depths (k + 1/2) spacings behind the surface, as far as the kernel reaches into the solid. Planes and boxes take up the
/// lattice that packParticles fills the domain with; rings and shells behind curved walls have as many particles as make them as large
/// as the fluid's, and a volume factor for what is left of the difference. Where the solids of several surfaces overlap, as in the corners
/// of a box, a place is filled once, from the surface behind which it lies deepest.
///
/// Verified by test/unit/geometry (volume, corners) and tutorials/powderMoulding/channel9.
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Geometry.hpp"

namespace sph
{

namespace entry
{
extern const Choice wallKind;
}

/// The word `walls` of system/sphSchemes: `reflected` (default) or `layers`.
bool wallsAreLayers(const Dictionary& sphSchemes);
EntryList wallLayersEntries();

/// The particles of one period, for kernels of support `H` [m]; `spacing` [m] that of the fluid. Errors at the walls that have no
/// layers: shapes other than plane, box, cylinder and sphere, and boxes thinner than two supports, whose layers would overlap.
std::vector<LayerParticle> makeWallLayers(const Geometry&, double H, double spacing, Diagnostics&);

/// `constant/lagrangian/wallLayers`, a cloud with the fields `wall` and `volumeFactor`; `remove` for a case that has none.
void writeWallLayers(const std::filesystem::path& caseFolder, const std::vector<LayerParticle>&);
void removeWallLayers(const std::filesystem::path& caseFolder);
/// Records what is wrong with the files. `walls` the number of walls that the particles may belong to.
std::vector<LayerParticle> readWallLayers(const std::filesystem::path& caseFolder, std::size_t walls, Diagnostics&);

}
