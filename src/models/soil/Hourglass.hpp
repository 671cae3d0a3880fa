/// Stiffness against motion from particle to particle that no strain answers (hourglass modes), by the energy of Ganzenmueller (2015, Comput. Methods Appl. Mech. Engrg 286, 87) with the weights by which
/// the gradient is fitted.
///
///   E = 1/2 sum_ij V_i V_j f_ij k M_i e_ij^2,    e_ij = xi_j - xi_i - H_i x_ji,    H_i = sum_j V_j f_ij (xi_j - xi_i) (x) x_ji B_i^-1
///   dv_i/dt = V_i/m_i sum_j V_j f_ij k (M_i e_ij - M_j e_ji),    f_ij = -W'(r_ij)/r_ij,    B_i = sum_j V_j f_ij x_ji (x) x_ji
///   dxi_i/dt = v_i + M |dev D_i|/|sigma_i| e_i,    e_i = sum_j V_j f_ij e_ij/sum_j V_j f_ij
///
/// xi [m] is the displacement; what of it is no straight line through its neighbours' is forgotten by a shear of |sigma|/M, so that soil may flow: the force stays below k times that of its stress; k [1]
/// `hourglassStiffness`; M = rho c^2 [Pa] the stiffness of the soil. Since H fits xi with the weights f, E does not change with it, and the force is the gradient of E: it conserves linear momentum, and a displacement
/// that is linear in space is not resisted, up to the surface. Ghosts of walls, whose displacement is not known, are left out, as in LinearFit.hpp. Lone particles, whose B has an eigenvalue below 0.4, have no
/// share in E. The highest mode has c dt/H sqrt(56 k), to be below 2. E is not in the account of energy. Verified by test/unit/soil.
#pragma once
#include "models/soil/SoilFields.hpp"
#include "operators/LinearFit.hpp"
#include "operators/VelocityGradient.hpp"
#include "soilLaws/ConstitutiveLaw.hpp"
#include <cmath>

namespace sph
{

// clang-format off
struct UnstrainedMotion   { static constexpr FieldInfo info{"unstrainedMotion", "m", Image::mirrored};   template<int dim, class Real = double> struct At { Vector<dim, Real> xi; }; };
struct UnstrainedGradient { static constexpr FieldInfo info{"unstrainedGradient", "1", Image::mirrored}; template<int dim, class Real = double> struct At { Tensor<dim, Real> H; }; };
struct UnstrainedOffFit   { static constexpr FieldInfo info{"unstrainedOffFit", "m", Image::mirrored};   template<int dim, class Real = double> struct At { Vector<dim, Real> e; }; };
struct HourglassModulus   { static constexpr FieldInfo info{"hourglassModulus", "Pa"};                   template<int dim, class Real = double> struct At { Real kM; }; };
// clang-format on

template<int dim> struct MeanOff
{
    Vector<dim> off;
    double f;
    static constexpr auto parts(auto& q, const auto& g) { return g(q.off, q.f); }
};

struct FitOfUnstrained
{
    static constexpr auto name = "unstrainedGradient";
    using Provides = Fields<UnstrainedGradient, HourglassModulus>;
    using Reads = Fields<Volume, UnstrainedMotion, GhostWall>;
    using ReadsOwn = Fields<Density, SoilSound>;
    static constexpr bool ofRawGradient = true;
    static constexpr double least = 0.4;
    double k;

    explicit FitOfUnstrained(const Coefficients& c) : k(c.of<SoilNumbers>().hourglass) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double f = fitWeight(ij, j);
        return GradientSums<dimensions(decltype(ij.x){})>{f * outer(ij.x), outer(f * (i.xi - j.xi), ij.x)};
    }
    auto finish(const auto& i, const auto& sum) const
    {
        constexpr int dim = dimensions(decltype(i.xi){});
        const bool fits = leastEigenvalue(sum.B) > least;
        const auto inverse = (fits ? 1 / determinant(sum.B) : 0.0) * adjugate(sum.B);
        return Values<Fields<UnstrainedGradient, HourglassModulus>, dim>{{sum.G * full(inverse)}, {fits ? k * i.rho * sqr(i.c) : 0}};
    }
};

struct HourglassForce
{
    static constexpr auto name = "hourglassForce";
    using Adds = Acceleration;
    using Reads = Fields<Volume, UnstrainedMotion, UnstrainedGradient, HourglassModulus, GhostWall>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return i.V / i.m * fitWeight(ij, j) * ((i.kM + j.kM) * (j.xi - i.xi) + (i.kM * i.H + j.kM * j.H) * ij.x);
    }
};

/// e_i
struct OffFitOfUnstrained
{
    static constexpr auto name = "unstrainedOffFit";
    using Provides = UnstrainedOffFit;
    using Reads = Fields<Volume, UnstrainedMotion, GhostWall>;
    using ReadsOwn = Fields<UnstrainedGradient, HourglassModulus>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double f = fitWeight(ij, j);
        return MeanOff<dimensions(decltype(ij.x){})>{f * (j.xi - i.xi + i.H * ij.x), f};
    }
    auto finish(const auto& i, const auto& sum) const { return (i.kM > 0 ? 1 / sum.f : 0.0) * sum.off; }
};

/// xi, of the velocities at the end of a step.
struct AdvanceUnstrained
{
    static constexpr auto name = "unstrainedMotion";
    using Advances = UnstrainedMotion;
    using ReadsOwn = Fields<UnstrainedMotion, Velocity, UnstrainedOffFit, VelocityGradient, SoilStress, Density, SoilSound>;

    auto operator()(const auto& i, double dt) const
    {
        constexpr double all = 50; // exp(-50) is nothing
        const double change = i.rho * sqr(i.c) * norm(deviator(symm(in3D(i.L)))) * dt, stress = norm(in3D(i.sigma));
        return i.xi + dt * i.v - std::expm1(change < all * stress ? -change / stress : -all) * i.e;
    }
};

}
