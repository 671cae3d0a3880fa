/// Sums over neighbours at a plane free surface: the part that they lack, as functions of the sum of slopes alone.
///
///   t = (|g_i| V_0/g_m)^2,    g_i = sum_j gradW_ij,    g_m = int W dA over a plane through the particle
///   1 - s = c_1 t + c_2 t^2 + c_3 t^3                                        s = sum_j W_ij over its value inside, j = i included
///   z = H (1 - sqrt t)^(1/2) (a_0 + a_1 (1 - sqrt t) + a_2 (1 - sqrt t)^2 + a_3 (1 - sqrt t)^3)
///
/// z [m] depth below the surface, which lies half a row outside the outermost particles; g [1/m^(d + 1)]; V_0 [m^d] volume of a particle; H [m] support. The coefficients are those of least squares
/// over the rows of square or cubic half lattices cut along three planes, (100), (110), (111) in 3-D, (10), (11), (21) in 2-D: these fall onto one curve within 0.01 of s. The continuum
/// gives 0.02 more of c in the outermost row of a lattice. Verified by test/unit/gas.
#pragma once
#include <array>
#include <cmath>
#include <string>

namespace sph
{

struct FlatSurface
{
    double normalisation = 1;                  ///< N_0 of that lattice inside (operators/KernelMoment.hpp)
    double slope = 1;                          ///< g_m/V_0 [1/m^(d + 1)]
    double support = 1;                        ///< H [m]
    std::array<double, 3> density{};           ///< c
    std::array<double, 4> depth{};             ///< a
    double densityMisfit = 0, depthMisfit = 0; ///< largest that the rows are off [-], [spacings]

    static FlatSurface of(const std::string& kernel, int dimension, double H, double spacing);

    double share(double g) const { return std::fmin(1.0, g * g / (slope * slope)); }
    double lackOfDensity(double t) const { return t * (density[0] + t * (density[1] + t * density[2])); }
    double depthAt(double t) const
    {
        const double q = 1 - std::sqrt(t);
        return support * std::sqrt(q) * (depth[0] + q * (depth[1] + q * (depth[2] + q * depth[3])));
    }
};

}
