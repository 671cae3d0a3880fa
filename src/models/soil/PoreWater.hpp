/// Water in the pores of saturated soil: Biot's equations of displacement and pore pressure, Zienkiewicz and Shiomi (1984), with incompressible grains.
///
///   rho dv/dt     = div(sigma - p I) + rho g                  sigma [Pa] effective stress, of the law, tension positive
///   n/K_w dp/dt   = -div v - div q,    q = -kappa (grad p - rho_w g),    kappa = k/gamma_w
///
/// p [Pa] pore pressure, compression positive, rho [kg/m^3] of the soil with its water, v [m/s] of the grains, n [1] porosity, K_w [Pa] bulk modulus of the
/// water, q [m/s] what seeps, per area of soil, k [m/s] permeability, gamma_w = rho_w 9.81 m/s^2 the unit weight that k is of, g [m/s^2] gravity. The acceleration of the water
/// relative to the grains is left out, which holds where they move slower than waves of the second kind (Zienkiewicz, Chang and Bettess 1980). n and k stay as they are given, and the water
/// that leaves is not taken off the mass of particles: for strains of some per cent.
///
/// PoreWaterStep.hpp is the step, Seepage.hpp the sum over neighbours. Verified by test/unit/soil and tutorials/geomechanics/consolidation (Terzaghi's series).
#pragma once
#include "base/StressTensor.hpp"
#include "fields/fieldTags.hpp"
#include <array>
#include <optional>
#include <vector>

namespace sph
{

// clang-format off
struct PorePressure       { static constexpr FieldInfo info{"porePressure", "Pa", Image::ruled, nullptr, "porePressure"};              template<int dim, class Real = double> struct At { Real p_w; }; };
struct PorePressureChange { static constexpr FieldInfo info{"porePressureChange", "Pa", Image::ruledChange, nullptr, "porePressure"};  template<int dim, class Real = double> struct At { Real dp_w; }; };
/// -p I. Images have that of their source: what continues it through walls is in the total stress, by the weight of soil and water (ContinuedStress.hpp).
struct PoreStress         { static constexpr FieldInfo info{"poreStress", "Pa", Image::mirrored};  template<int dim, class Real = double> struct At { SymmTensor<dim, Real> S; }; };
// clang-format on

/// Acceleration by a change of the pore pressure, summed apart.
inline constexpr const char* poreAcceleration = "dUdtByPorePressure";

/// A wall of geometry: a pressure or a flux into the soil; nothing passes one with neither.
struct WaterAtWall
{
    std::optional<double> pressure; ///< [Pa]
    double flux = 0;                ///< [m/s]
};

/// Sums over a cubic lattice at rest, which those over particles are measured by.
struct LatticeSums
{
    double spacing = 1;          ///< [m]
    double secondMoment = 1;     ///< -1/d sum_j V (dW/dr) r, 1 in the continuum
    int rows = 0;                ///< rows below a plane surface that lack neighbours
    std::array<double, 8> m_1{}; ///< first moment of the slope in each, |sum_j V (dW/dr)/r x_ij| [1/m]

    /// Distance from a plane free surface by the first moment [m], between the rows, which lie 1/2, 3/2, .. spacings deep; 0 where no neighbours are
    /// missing: m_1 below half of that of the last row.
    double depth(double slope) const
    {
        if (rows == 0 || slope < 0.5 * m_1[std::size_t(rows - 1)]) return 0;
        if (slope >= m_1[0]) return 0.5 * spacing;
        for (int row = 1; row < rows; ++row)
        {
            const double above = m_1[std::size_t(row - 1)], here = m_1[std::size_t(row)];
            if (slope >= here) return (row + 0.5 - (slope - here) / (above - here)) * spacing;
        }
        return (rows - 0.5) * spacing;
    }
};

struct PoreWater
{
    double permeability = 0;   ///< k [m/s]
    double porosity = 1;       ///< n [1]
    double bulkModulus = 1;    ///< K_w [Pa]
    double density = 1000;     ///< rho_w [kg/m^3]
    bool surfaceDrains = true; ///< p = 0 on free surfaces; else nothing passes them
    double tolerance = 1e-6;   ///< of the solve, of the residual at its start [1]
    int maxIter = 1000;
    std::vector<WaterAtWall> walls;
    LatticeSums lattice;

    /// m/s^2, of the unit weight that permeabilities are measured with, whatever gravity the scene has.
    static constexpr double standardGravity = 9.81;
    /// n/K_w [1/Pa]
    double storage() const { return porosity / bulkModulus; }
    /// kappa [m^2/(Pa s)]
    double mobility() const { return permeability / (density * standardGravity); }
};

}
