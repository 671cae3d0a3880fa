#include "base/OutputFile.hpp"
#include "case/Cloud.hpp"
#include "case/FoamHeader.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

void writeMeshFile(const std::filesystem::path& caseFolder, const char* className, const char* object, const std::string& list)
{
    writeFile(caseFolder / "constant" / "polyMesh" / object, foamHeader(WriteFormat::ascii, className, "constant/polyMesh", object) + list);
}

/// A direction without extent, as z of a 2-D scene, is given the half of the longest one to each side: a flat cell has no volume.
void thicken(double (&low)[3], double (&high)[3])
{
    double longest = 0;
    for (int k = 0; k < 3; ++k) longest = std::max(longest, high[k] - low[k]);
    const double half = longest > 0 ? 0.5 * longest : 0.5;
    for (int k = 0; k < 3; ++k)
        if (!(high[k] - low[k] > 1e-6 * longest))
        {
            low[k] -= half;
            high[k] += half;
        }
}

}

void writePolyMesh(const std::filesystem::path& folder, const double (&low)[3], const double (&high)[3])
{
    double corner[2][3];
    std::copy(low, low + 3, corner[0]);
    std::copy(high, high + 3, corner[1]);
    thicken(corner[0], corner[1]);

    createFolders(folder / "constant" / "polyMesh");
    std::string points = "8\n(\n";
    for (int k = 0; k < 8; ++k)
        points += fmt::format("({} {} {})\n", shortestText(corner[k & 1][0]), shortestText(corner[k >> 1 & 1][1]),
                              shortestText(corner[k >> 2][2]));
    writeMeshFile(folder, "vectorField", "points", points + ")\n");
    writeMeshFile(folder, "faceList", "faces", "6\n(\n4(0 4 6 2)\n4(1 3 7 5)\n4(0 1 5 4)\n4(2 6 7 3)\n4(0 2 3 1)\n4(4 5 7 6)\n)\n");
    writeMeshFile(folder, "labelList", "owner", "6\n(\n0\n0\n0\n0\n0\n0\n)\n");
    writeMeshFile(folder, "labelList", "neighbour", "0\n(\n)\n");
    writeMeshFile(folder, "polyBoundaryMesh", "boundary",
                  "1\n(\n    box\n    {\n        type            patch;\n        nFaces          6;\n"
                  "        startFace       0;\n    }\n)\n");
}

void writeBoundingMesh(const std::filesystem::path& caseFolder, const double (&low)[3], const double (&high)[3])
{
    writePolyMesh(caseFolder, low, high);
    const auto whole = std::filesystem::weakly_canonical(std::filesystem::absolute(caseFolder));
    const auto name = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    writeFile(caseFolder / ((name.empty() ? "case" : name.string()) + ".foam"), "");
}

}
