#include "readMeshes.hpp"
#include "meshes/readers/importMesh.hpp"
#include "solids/rocks/closedSurface.hpp"
#include <algorithm>
#include <fstream>
#include <numbers>
#include <unistd.h>

namespace sph
{

Figures readMeshes()
{
    const auto torus = parametricSurface(1000, 500,
                                         [](double u, double v)
                                         {
                                             const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v,
                                                          r = 1 + 0.3 * std::cos(b);
                                             return Vector<3>{r * std::cos(a), r * std::sin(a), 0.3 * std::sin(b)};
                                         });
    const auto file = std::filesystem::temp_directory_path() / ("sphBenchmark" + std::to_string(::getpid()) + ".stl");
    std::ofstream(file, std::ios::binary) << stlBytes(torus);
    double best = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < 3; ++turn)
    {
        std::vector<std::string> notes;
        best = std::min(best, secondsOf([&] { importMesh(file, notes); }));
    }
    std::filesystem::remove(file);
    return {{"readMillionFacets", best, "s"}};
}

}
