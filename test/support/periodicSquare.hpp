/// A doubly periodic square of side 1, and the settings of a case in it.
#pragma once
#include "Case.hpp"
#include "readSettings.hpp"
#include "smallCases.hpp"
#include <regex>

namespace sph::test
{

inline Geometry periodicSquare()
{
    Geometry g;
    g.dimension = 2;
    g.high = {1, 1, 0};
    g.periodic = {true, true, false};
    return g;
}

/// What a case says of the rule at its walls is left out: the square has none.
inline Settings settingsOf(Files files)
{
    auto& schemes = files["system/sphSchemes"];
    schemes = std::regex_replace(schemes, std::regex("wallVelocity [A-Za-z]+;"), "");
    const TestCase folder(files);
    const Case c(folder.folder());
    auto settings = readSettings(c, periodicSquare());
    c.diagnostics().throwIfAny();
    return settings;
}

}
