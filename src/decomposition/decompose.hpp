/// Decomposition of time folders into folders processor0, processor1, .., and reconstruction of them.
#pragma once
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "decomposition/readDecomposition.hpp"
#include <string>
#include <vector>

namespace sph
{

/// Writes each part of the particles of these times, and the mesh of the whole, into a folder of its own, in place of any that are there;
/// returns how many particles each has, by time. All folders are written or none. Where system/sphSchemes asks for labels that a time does
/// not have yet, the parts get them: the place of a particle in its time folder. Throws CaseError where there are fewer particles than
/// parts.
std::vector<std::vector<std::size_t>> decompose(const Case&, const std::vector<std::string>& times, const Decomposition&,
                                                const WriteOptions&);

/// The times of all processor folders, sorted. Throws CaseError where the folders are not those of one decomposition into as many as there
/// are and, if the case has a dictionary for it, as that says.
std::vector<std::string> processorTimes(const Case&);
/// Times that decomposeParticles has made of a time folder of the case which is still there.
std::vector<std::string> dividedTimes(const Case&);

/// Puts the particles of a time together, those of processor0 first; returns how many there are. Throws CaseError where a folder lacks the
/// time, or has it from another run than processor0.
std::size_t reconstruct(const Case&, const std::string& time, const WriteOptions&);

}
