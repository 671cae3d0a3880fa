/// Names by which the function object `forces` asks for forces on walls, and by which it is told them.
#pragma once
#include "dictionary/Parameter.hpp"
#include <string>

namespace sph
{

inline constexpr const char* forcesType = "forces";

namespace entry
{
inline const ListOf<std::string> patches{"patches", required, "walls of constant/geometry whose forces are written"};
}

/// "force(footing).x" for component 0.
inline std::string forceOnWall(const std::string& wall, int component) { return "force(" + wall + ")." + "xyz"[component]; }
/// The same of the way that a wall under load has gone.
inline std::string displacementOfWall(const std::string& wall, int component) { return "displacement(" + wall + ")." + "xyz"[component]; }

}
