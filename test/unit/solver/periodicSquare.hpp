/// A doubly periodic square of side 1, and the settings of a case in it.
#pragma once
#include "Case.hpp"
#include "readSettings.hpp"
#include "smallCases.hpp"

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

inline Settings settingsOf(const Files& files)
{
    const TestCase folder(files);
    const Case c(folder.folder());
    auto settings = readSettings(c, periodicSquare());
    c.diagnostics().throwIfAny();
    return settings;
}

}
