/// Deviation of a value from the straight line through those around it: moving least squares of first order, its own particle left out.
///
///   off_i = sum_j w_ij (q_i - z_i . x_ji) (f_j - f_i),    q = 1/(m_0 - y . m_1),    z = q y,    y = M_2^-1 m_1
///   w_ij = -V_j W'(r_ij)/r_ij,    m_0 = sum_j w_ij,    m_1 = sum_j w_ij x_ji,    M_2 = sum_j w_ij x_ji (x) x_ji,    x_ji = x_j - x_i
///
/// 0 for what is linear in space, wherever the particles lie and wherever they end. Ghosts of walls are left out: they continue few fields linearly. q and z are 0 where there are too few
/// neighbours for a line: det M_2 below 0.05 (1 in the interior), or all of them on one side.
///
/// V [m^3], W [1/m^d], q [m^2], z [m]. Verified by test/unit/soil (linear values; noise).
#pragma once
#include "fields/fieldTags.hpp"

namespace sph
{

// clang-format off
struct FitScale { static constexpr FieldInfo info{"fitScale", "m^2"}; template<int dim, class Real = double> struct At { Real q; }; };
struct FitSlope { static constexpr FieldInfo info{"fitSlope", "m"};   template<int dim, class Real = double> struct At { Vector<dim, Real> z; }; };
// clang-format on

/// w_ij
constexpr double fitWeight(const auto& ij, const auto& j) { return j.wall > 0 ? 0.0 : -j.V * ij.dWdrOverR; }

template<int dim> struct FitMoments
{
    double m_0;
    Vector<dim> m_1;
    SymmTensor<dim> M_2;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.m_0, q.m_1, q.M_2); }
};

struct FitWeights
{
    static constexpr auto name = "fitWeights";
    using Provides = Fields<FitScale, FitSlope>;
    using Reads = Fields<Volume, GhostWall>;
    static constexpr bool ofRawGradient = true;
    static constexpr double leastMoment = 0.05, leastSpread = 0.1;

    auto operator()(const auto& ij, const auto&, const auto& j) const
    {
        const double w = fitWeight(ij, j);
        return FitMoments<dimensions(decltype(ij.x){})>{w, -w * ij.x, w * outer(ij.x)};
    }
    auto finish(const auto&, const auto& m) const
    {
        constexpr int dim = dimensions(decltype(m.m_1){});
        const double det = determinant(m.M_2);
        const auto y = (det > leastMoment ? 1 / det : 0.0) * (adjugate(m.M_2) * m.m_1);
        const double spread = m.m_0 - dot(y, m.m_1), q = det > leastMoment && spread > leastSpread * m.m_0 ? 1 / spread : 0.0;
        return Values<Fields<FitScale, FitSlope>, dim>{{q}, {q * y}};
    }
};

}
