/// Folders processor0, processor1, .. of a decomposed case: each has a part of the particles, in time folders of its own, and the mesh of the whole.
#pragma once
#include "case/Case.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace sph
{

/// "processor3"
std::string processorFolder(int part);

/// Number of processor folders. Throws CaseError where one is missing among them.
int countProcessorFolders(const std::filesystem::path& caseFolder);
/// Removes all folders that have such a name, whatever is missing.
void removeProcessorFolders(const std::filesystem::path& caseFolder);

/// Description that decomposeParticles writes into a folder, `constant/decomposition`; it tells a folder of another decomposition.
struct Portion
{
    int part = 0, parts = 0;
    std::string stamp;              ///< of the particles that were divided
    std::vector<std::string> times; ///< whose particles were divided
};
void writePortion(const std::filesystem::path& folder, const Portion&);
/// Throws CaseError where the folder is not the one that its name says, one of so many, and of the decomposition that processor0 is of.
Portion readPortion(const Case&, int part, int parts);

}
