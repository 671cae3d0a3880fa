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
/// With `unsaturated` pores drain above a water table. Water that is sucked neither pushes grains nor gives way to them, and passes the pores that it still fills:
///
///   rho dv/dt = div(sigma - chi p I) + rho g,    C(p) dp/dt = -chi div v - div(k_r q),    chi = 0 for p < 0, else 1 (suction is cut off)
///   S_e = min(1, max(0, 1 + p/(rho_w g h_c))),   k_r = k_min + (1 - k_min) S_e,           C = n/K_w, and S_y/(rho_w g h_c) more where 0 < S_e < 1
///
/// h_c [m] `capillaryHead`, S_y [1] `specificYield`, k_min [1] `leastRelativePermeability`, in the way of Bathe and Khoshgoftaar (1979, Int. J. Numer. Anal. Meth. Geomech. 3, 13), who let k fall where p is
/// negative and so find the free surface of the water. The density of the soil stays that with its water.
///
/// PoreWaterStep.hpp is the step, Seepage.hpp the sum over neighbours, OuterWater.hpp what stands on the soil. Verified by test/unit/soil, tutorials/geomechanics/consolidation (Terzaghi's series) and
/// damSeepage (discharge of a dam).
#pragma once
#include "base/StressTensor.hpp"
#include "dictionary/timeExpression.hpp"
#include "fields/fieldTags.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

// clang-format off
struct PorePressure       { static constexpr FieldInfo info{"porePressure", "Pa", Image::ruled, nullptr, "porePressure"};              template<int dim, class Real = double> struct At { Real p_w; }; };
struct PorePressureChange { static constexpr FieldInfo info{"porePressureChange", "Pa", Image::ruledChange, nullptr, "porePressure"};  template<int dim, class Real = double> struct At { Real dp_w; }; };
struct RelativePermeability { static constexpr FieldInfo info{"relativePermeability", "1"};            template<int dim, class Real = double> struct At { Real k_r; }; };
/// -dp I of a change that is tried. Images have that of their source: what continues it through walls is in the total stress, by the weight of soil and water (ContinuedStress.hpp).
struct PoreStress         { static constexpr FieldInfo info{"poreStress", "Pa", Image::mirrored};  template<int dim, class Real = double> struct At { SymmTensor<dim, Real> S; }; };
// clang-format on

/// Acceleration by a change of the pore pressure, summed apart.
inline constexpr const char* poreAcceleration = "dUdtByPorePressure";

/// A height of water that may vary with time, against gravity, from the origin: an expression of `$t`, and its value at present [m].
struct WaterLevel
{
    std::string expression;
    double now = 0;

    bool varies() const { return expression.find('$') != std::string::npos; }
    /// Throws ExpressionError where the expression gives no height.
    double at(double t) const { return numberAt(expression, t, "a height"); }
};

/// A wall of geometry: a pressure, water that stands behind it up to a level, or a flux into the soil; nothing passes one with none of them, nor what rises above the level.
struct WaterAtWall
{
    std::optional<double> pressure; ///< [Pa]
    std::optional<WaterLevel> level;
    double flux = 0; ///< [m/s]
};

/// How pores drain where the water is sucked.
struct Retention
{
    double capillaryHead = 0;     ///< h_c [m]
    double specificYield = 0;     ///< S_y [1]
    double leastPermeability = 0; ///< k_min [1]
};

/// Sums over a cubic lattice at rest, which those over particles are measured by.
struct LatticeSums
{
    double spacing = 1;          ///< [m]
    double secondMoment = 1;     ///< -1/d sum_j V (dW/dr) r, 1 in the continuum
    double weight = 0;           ///< sum_j w_ij/V of Seepage.hpp [1/m^2]
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
    bool projects = false;     ///< the divergence that grains have by a change of p is that of the forces, and no Laplacian
    double tolerance = 1e-6;   ///< of the solve, of the residual at its start [1]
    int maxIter = 1000;
    std::vector<WaterAtWall> walls;
    std::optional<Retention> unsaturated; ///< none: pores are full, and suction pulls
    std::optional<WaterLevel> level;      ///< of what stands on free surfaces; none: air
    LatticeSums lattice;

    /// m/s^2, of the unit weight that permeabilities are measured with, whatever gravity the scene has.
    static constexpr double standardGravity = 9.81;
    /// n/K_w [1/Pa]
    double storage() const { return porosity / bulkModulus; }
    /// Whether solves need the Laplacian of the change that they try.
    bool sumsChange() const { return !projects || permeability > 0; }
    /// kappa [m^2/(Pa s)]
    double mobility() const { return permeability / (density * standardGravity); }
    /// S_e of a pressure p [Pa] under a gravity of g [m/s^2].
    double saturation(double p, double g) const
    {
        return unsaturated ? std::clamp(1 + p / (density * g * unsaturated->capillaryHead), 0.0, 1.0) : 1.0;
    }
    /// k_r
    double relativePermeability(double p, double g) const
    {
        return unsaturated ? unsaturated->leastPermeability + (1 - unsaturated->leastPermeability) * saturation(p, g) : 1.0;
    }
    /// C [1/Pa]
    double capacity(double p, double g) const
    {
        const double head = unsaturated ? density * g * unsaturated->capillaryHead : 0;
        return storage() + (p < 0 && p > -head ? unsaturated->specificYield / head : 0);
    }
    /// chi
    double acts(double p) const { return unsaturated && p < 0 ? 0.0 : 1.0; }
    /// The same of k_r, which images have of their source whatever their pressure.
    static double actsAt(double k_r) { return k_r < 1 ? 0.0 : 1.0; }
};

}
