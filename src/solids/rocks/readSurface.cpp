#include "base/CaseError.hpp"
#include "meshes/readers/importMesh.hpp"
#include "solids/rocks/closedSurface.hpp"

namespace sph
{

TriangleSurface readSurface(const std::filesystem::path& caseFolder, const std::string& file)
{
    try
    {
        std::vector<std::string> notes;
        return welded(importMesh(caseFolder / file, notes));
    }
    catch (const UnusableMesh& e)
    {
        throw CaseError({file, 0}, e.what());
    }
}

}
