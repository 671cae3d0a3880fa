/// Particles of a case that go on from the state of another case of the same scene: what mapParticles does.
#pragma once
#include "case/Case.hpp"
#include "mapping/mapState.hpp"

namespace sph
{

struct MapReport
{
    std::string time;   ///< of the source
    std::string folder; ///< of the target that was written
    std::string text;
};

/// Reads the particles of `source` at a time, by its name or "latestTime", and those that packParticles has put into the folder that a run of `target` starts
/// from, and writes the latter anew: phase, m, rho and U by mapState, and each field that the target's scene has as a property of its fluid (Evolving::ofMaterial)
/// where the source has it. V and p stand there in place of rho where the packing has a pressure at the start; p is then the source's. All that
/// follows from these is left to the solver, as are fields that the source has not: they start as the dictionaries say.
///
/// Throws CaseError, with file and line of the target, where dimension, domain, periodic directions, walls or phases of the two cases differ, where one has
/// no particles, where the source has no such time, where the target's folder was written by a run, and as mapState does. Mistakes in
/// dictionaries of the source are told as its own.
MapReport mapCase(const Case& target, const std::filesystem::path& source, const std::string& sourceTime, const Say&);

}
