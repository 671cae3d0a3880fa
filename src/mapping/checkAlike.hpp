/// Whether two cases are of one scene, of whatever resolution.
#pragma once
#include "case/Case.hpp"
#include "storedCase/StoredCase.hpp"

namespace sph
{

/// Records in the target's Diagnostics, with file and line, where dimension, domain, periodic directions, names of the walls, phases or their densities at rest
/// differ from those of the source.
void checkAlike(const Case& target, const StoredCase& of, const StoredCase& source, const std::string& sourceName);

/// Throws CaseError, with the deepest of them, where particles of the source lie deeper than half their spacing in the target's solid: walls of the same
/// names have another shape.
void checkOutOfSolid(const ParticleView& source, const Geometry& target, const std::string& sourceName);

}
