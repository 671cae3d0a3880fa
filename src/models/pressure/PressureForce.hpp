/// Acceleration by pressure, in the volumes V = 1/sigma.
#pragma once
#include "fields/fieldTags.hpp"

namespace sph
{

/// Hu & Adams (2006), eq. (8) of Barker et al. (2012):
///
///   dv_i/dt = -1/m_i sum_j (p_i V_i^2 + p_j V_j^2) gradW_ij
///
/// p [Pa], V [m^3], m [kg]. Conserves linear and angular momentum exactly. Verified by test/unit/pressure and
/// tutorials/verification/hydrostatic.
struct HuAdamsPressure
{
    static constexpr auto name = "huAdamsPressure";
    using Adds = Acceleration;
    using Reads = Fields<Pressure, Volume>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return -1 / i.m * (i.p * sqr(i.V) + j.p * sqr(j.V)) * ij.gradW; }
};

/// The pair's pressure weighed by the densities, Hu & Adams (2007): across an interface p/rho, not p, is what both sides share.
///
///   dv_i/dt = -1/m_i sum_j (V_i^2 + V_j^2) (rho_j p_i + rho_i p_j)/(rho_i + rho_j) gradW_ij
///
/// Allows the same sound speed in both phases at a density ratio of 1000. Conserves linear momentum exactly, but is not the
/// gradient of an energy, as the sum of Hu & Adams (2006) is: the gas compresses the liquid and does not feel its pressure. Where little
/// damps, what is at rest sets itself in motion (tutorials/stiff/dropOnFilm, liquidBridge).
struct DensityWeightedPressure
{
    static constexpr auto name = "densityWeightedPressure";
    using Adds = Acceleration;
    using Reads = Fields<Pressure, Volume, Density>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return -1 / i.m * (sqr(i.V) + sqr(j.V)) * (j.rho * i.p + i.rho * j.p) / (i.rho + j.rho) * ij.gradW;
    }
};

/// The form of single-phase codes, Monaghan (1992):
///
///   dv_i/dt = -1/m_i sum_j V_i V_j (p_i + p_j) gradW_ij
struct MonaghanPressure
{
    static constexpr auto name = "monaghanPressure";
    using Adds = Acceleration;
    using Reads = Fields<Pressure, Volume>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return -1 / i.m * i.V * j.V * (i.p + j.p) * ij.gradW; }
};

/// Acceleration by pressure in the form of p/rho^2, Monaghan (1992), as eq. (3.2) of Kauzlaric et al. (2011):
///
///   dv_i/dt = -sum_j m_j (p_i/rho_i^2 + p_j/rho_j^2) gradW_ij
///
/// p [Pa], rho [kg/m^3], m [kg]. With V = m/rho and equal masses the sum of Hu & Adams (2006). Conserves linear and angular momentum exactly; with the
/// continuity equation by mass it is the gradient of an energy. Verified by test/unit/pressure (plain loop).
struct MassWeightedPressure
{
    static constexpr auto name = "massWeightedPressure";
    using Adds = Acceleration;
    using Reads = Fields<Pressure, Density, Mass>;
    static constexpr bool bearsSingle = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return -j.m * (i.p / sqr(i.rho) + j.p / sqr(j.rho)) * ij.gradW; }
};

/// Acceleration by pressure in the form of differences:
///
///   dv_i/dt = -1/m_i sum_j V_i V_j (p_j - p_i) gradW_ij
///
/// No force where p is uniform, however the particles lie. The forms above leave p times the disorder of the particles, which keep themselves in order by it; with this one particle
/// shifting has to. Does not conserve momentum exactly. In Taylor-Green's vortices (tutorials/verification) it is what the error hangs on: 12 %
/// after half a turn with a sum of pressures, 2 % with differences.
struct DifferencePressure
{
    static constexpr auto name = "differencePressure";
    using Adds = Acceleration;
    using Reads = Fields<Pressure, Volume>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return -1 / i.m * i.V * j.V * (j.p - i.p) * ij.gradW; }
};

/// The form of differences with the gradient corrected (GradientCorrection.hpp):
///
///   dv_i/dt = -V_i/m_i L_i sum_j V_j (p_j - p_i) gradW_ij
///
/// Exact for a pressure that is linear, however the particles lie.
struct CorrectedDifferencePressure
{
    static constexpr auto name = "correctedDifferencePressure";
    using Adds = Acceleration;
    using Reads = Fields<Pressure, Volume>;
    using ReadsOwn = Fields<Mass, CorrectionTensor>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return j.V * (j.p - i.p) * ij.gradW; }
    auto finish(const auto& i, const auto& sum) const { return -(i.V / i.m) * (i.L * sum); }
};

/// Monaghan's form with the tensile instability control of Sun et al. (2018), eq. (9): under tension inside the fluid the sum changes sign,
///
///   dv_i/dt = -1/m_i sum_j V_i V_j F_ij gradW_ij,    F_ij = p_j - p_i where p_i < 0 and lambda_i > 0.93, else p_i + p_j
///
/// A pair under p_i + p_j < 0 attracts and clumps; p_j - p_i is the same gradient and has no such force. Within two rows of a free surface
/// (lambda of FreeSurface.hpp) p_i + p_j stays: p = 0 at the surface is its natural boundary condition. Does not conserve momentum
/// where it is at work. Verified by test/unit/pressure (plain loop) and tutorials/verification/rotatingSquarePatch.
struct TensileControlledPressure
{
    static constexpr auto name = "tensileControlledPressure";
    using Adds = Acceleration;
    using Reads = Fields<Pressure, Volume>;
    using ReadsOwn = Fields<Mass, LeastEigenvalue>;
    static constexpr double inside = 0.93;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double sign = i.p < 0 && i.lambda > inside ? -1.0 : 1.0;
        return -1 / i.m * i.V * j.V * (j.p + sign * i.p) * ij.gradW;
    }
};

/// The acceleration by pressure, and by surface tension, where it is kept apart, as part of the whole.
struct AddPressure
{
    static constexpr auto name = "addPressure";
    using Adds = Acceleration;
    using ReadsOwn = Fields<PressureAcceleration>;
    auto operator()(const auto& i) const { return i.a_p; }
};

}
