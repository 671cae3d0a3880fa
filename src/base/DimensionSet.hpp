/// Exponents of the SI base units in OpenFOAM's order: [kg m s K mol A cd].
#pragma once
#include <array>
#include <string>

namespace sph
{

struct DimensionSet
{
    std::array<double, 7> exponent{};

    constexpr DimensionSet(double kg = 0, double m = 0, double s = 0, double K = 0, double mol = 0, double A = 0, double cd = 0)
        : exponent{kg, m, s, K, mol, A, cd}
    {}
    friend constexpr bool operator==(const DimensionSet&, const DimensionSet&) = default;
    friend constexpr DimensionSet operator*(DimensionSet a, const DimensionSet& b)
    {
        for (int k = 0; k < 7; ++k) a.exponent[k] += b.exponent[k];
        return a;
    }
    friend constexpr DimensionSet operator/(DimensionSet a, const DimensionSet& b)
    {
        for (int k = 0; k < 7; ++k) a.exponent[k] -= b.exponent[k];
        return a;
    }
};

/// "[1 -1 -2 0 0 0 0]"
std::string toString(const DimensionSet&);

namespace units
{
inline constexpr DimensionSet none, kg{1}, m{0, 1}, s{0, 0, 1}, m2 = m * m, m3 = m * m * m, mPerS = m / s, mPerS2 = m / s / s;
inline constexpr DimensionSet density = kg / m3, pressure = kg / m / s / s, viscosity = kg / m / s, kinematicViscosity = m2 / s,
                              surfaceTension = kg / s / s, forcePerVolume = pressure / m;
}

}
