/// A doubly periodic square of side 1, a vortex that fills it, and the settings of a case in it.
#pragma once
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "smallCases.hpp"
#include "solver/readSettings.hpp"
#include <cmath>
#include <numbers>
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

/// 20 x 20 particles on a lattice that fills the square, with a Taylor-Green vortex of this largest velocity [m/s].
inline Cloud vortexOf(double speed)
{
    Cloud cloud;
    const double k = 2 * std::numbers::pi;
    auto& U = cloud.fields["U"];
    U.type = FieldClass::vector;
    U.component.resize(3);
    for (int a = 0; a < 20; ++a)
        for (int b = 0; b < 20; ++b)
        {
            const double x = (a + 0.5) / 20, y = (b + 0.5) / 20;
            cloud.x.push_back(x);
            cloud.y.push_back(y);
            cloud.z.push_back(0);
            U.component[0].push_back(speed * std::sin(k * x) * std::cos(k * y));
            U.component[1].push_back(-speed * std::cos(k * x) * std::sin(k * y));
            U.component[2].push_back(0);
        }
    return cloud;
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
