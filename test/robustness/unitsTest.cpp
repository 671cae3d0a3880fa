/// The same scene from nanometres to kilometres, from picoseconds to hours: every length, time and mass of its dictionaries times a power
/// of two gives the same digits, to the last bit. A constant with a hidden unit anywhere between reading and writing would show.
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "smallCases.hpp"
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <regex>

namespace sph::test::unitsTest
{
namespace
{

/// Powers of two: a length of 1 m becomes 2^length m.
struct Units
{
    int length = 0, time = 0, mass = 0;
};
/// Powers of metre, second and kilogram.
struct Dimension
{
    int length, time, mass;
    double in(const Units& u) const { return std::ldexp(1.0, length * u.length + time * u.time + mass * u.mass); }
};

constexpr Dimension metre{1, 0, 0}, second{0, 1, 0}, speed{1, -1, 0};
const std::vector<std::pair<std::string, Dimension>> entries{{"spacing", metre},       {"min", metre},        {"max", metre},
                                                             {"point", metre},         {"centre", metre},     {"radius", metre},
                                                             {"period", metre},        {"L", metre},          {"U", speed},
                                                             {"soundSpeed", speed},    {"rho", {-3, 0, 1}},   {"mu", {-1, -1, 1}},
                                                             {"sigma", {0, -2, 1}},    {"value", {1, -2, 0}}, {"endTime", second},
                                                             {"writeInterval", second}};

/// The numbers of all entries that have a unit, in the new units.
std::string inUnits(const Units& u, std::string text)
{
    static const std::regex number(R"([0-9]+\.?[0-9]*(e-?[0-9]+)?)");
    for (const auto& [key, dimension] : entries)
    {
        const std::regex entry("\\b" + key + "\\b ([^;a-z]*|\\( \\([a-z ]+\\)[^;]*);");
        std::string scaled;
        auto rest = text.cbegin();
        for (std::sregex_iterator e(text.begin(), text.end(), entry), none; e != none; ++e)
            for (std::sregex_iterator n(text.begin() + e->position(1), text.begin() + e->position(1) + e->length(1), number); n != none;
                 ++n)
            {
                const auto at = text.cbegin() + e->position(1) + n->position();
                scaled.append(rest, at);
                scaled += fmt::format("{}", dimension.in(u)*std::stod(n->str()));
                rest = at + n->length();
            }
        text = scaled.append(rest, text.cend());
    }
    return text;
}

Cloud ranIn(const Units& u, Files files)
{
    for (auto& [name, text] : files) text = inUnits(u, text);
    const TestCase c(files);
    for (const char* step : {"packParticles", "meshToGhost", "sphFoamLike"}) c.runWell(step);
    const Case theCase(c.folder());
    auto cloud = readCloud(c.folder(), theCase.times().back(), "sph", theCase.diagnostics());
    theCase.diagnostics().throwIfAny();
    return cloud;
}

void expectSame(const std::vector<double>& a, const std::vector<double>& b, double factor, const std::string& what)
{
    ASSERT_EQ(a.size(), b.size()) << what;
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) different += a[i] * factor != b[i];
    EXPECT_EQ(different, 0u) << what << " of " << different << " in " << a.size() << " particles differ";
}

void expectSameInAllUnits(const Files& files, int dimension)
{
    const auto base = ranIn({}, files);
    for (const Units& u : {Units{-30, -40, -80}, Units{-10, 0, 0}, Units{10, 12, 40}, Units{0, -3, 5}})
    {
        SCOPED_TRACE(fmt::format("metre 2^{}, second 2^{}, kilogram 2^{}", u.length, u.time, u.mass));
        const auto other = ranIn(u, files);
        expectSame(base.x, other.x, metre.in(u), "x");
        expectSame(base.y, other.y, metre.in(u), "y");
        expectSame(base.z, other.z, metre.in(u), "z");
        const std::map<std::string, Dimension> fields{{"U", speed},         {"rho", {-3, 0, 1}},
                                                      {"p", {-1, -2, 1}},   {"m", {dimension - 3, 0, 1}},
                                                      {"phase", {0, 0, 0}}, {"dUdtAtWall", {1, -2, 0}}};
        for (const auto& [name, field] : base.fields)
            for (std::size_t k = 0; k < field.component.size(); ++k)
                expectSame(field.component[k], other.fields.at(name).component[k], fields.at(name).in(u), name);
    }
}

TEST(Units, SecondOrderWallsAndGravity) { expectSameInAllUnits(channelCase(), 2); }
TEST(Units, SurfaceTensionAndContactAngles) { expectSameInAllUnits(dropCase(), 2); }
TEST(Units, InterfaceStress)
{
    auto files = dropCase();
    files["system/sphSchemes"] += "surfaceTension interfaceStress;\n";
    expectSameInAllUnits(files, 2);
}
TEST(Units, RelaxedCurvedWallsDiffusionAndShifting) { expectSameInAllUnits(grainCase(), 2); }
TEST(Units, BedInThreeDimensions) { expectSameInAllUnits(bedCase(), 3); }

}
}
