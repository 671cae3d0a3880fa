/// A gradient of differences and the divergence that is its adjoint, exact for linear fields and uniform stresses however the particles lie: the integration correction of Bonet and Kulasegaram (2000,
/// Int. J. Numer. Meth. Engng 47, 1189), which Chen, Hillman and Ruter (2013, ibid. 95, 387) call variational consistency, of the corrected gradient (VelocityGradient.hpp).
///
///   g_ij = f_ij (b_i + A_i x_ji),    A_i = C_i - b_i (x) a_i,    f_ij = -W'(r_ij)/r_ij,    x_ji = x_j - x_i        C gradW + b f (1 - a.x_ji), in other words
///   (grad v)_i = sum_j V_j (v_j - v_i) (x) g_ij
///   dv_i/dt = V_i/m_i sum_j V_j (S_i g_ij - S_j g_ji)
///
/// C_i is that of the corrected velocity gradient, a_i = B_i^-1 sum_j V_j f_ij x_ji, so that b leaves the gradient of a linear field alone. Whatever b is, forces cancel in pairs, and their power is
/// -sum V S:grad v: energy goes where strain has it. b makes a uniform stress exert no force inside, where the corrected gradient alone makes the disorder of particles one:
///
///   r_i = sum_j V_j (g_ji - g_ij),    b_i += 0.9 w_i r_i/p_i once a step,    p_i = sum_j V_j f_ij (1 - a_i.x_ji)
///
/// By one sweep r falls to a quarter, by ten to an eightieth; b goes with the particles. w rises from 0 to 1 for lambda from 0.75 to 0.85, whatever the velocity gradient takes: at a surface the force of a uniform stress is that
/// of its traction, and stays. What the rows next to it cannot bear goes on below as a b that is harmonic, of up to 0.6 spacings on a lattice.
///
/// A [1], b [m], r [1/m], w/p [m^2], f [1/m^(d + 2)]. Of the raw gradient. Verified by test/unit/soil.
#pragma once
#include "operators/VelocityGradient.hpp"

namespace sph
{

// clang-format off
struct GradientMap       { static constexpr FieldInfo info{"gradientMap", "1", Image::mirrored};           template<int dim, class Real = double> struct At { Tensor<dim, Real> A; }; };
struct GradientOffset    { static constexpr FieldInfo info{"gradientOffset", "m", Image::mirrored};        template<int dim, class Real = double> struct At { Vector<dim, Real> b; }; };
struct GradientImbalance { static constexpr FieldInfo info{"gradientImbalance", "1/m", Image::mirrored};   template<int dim, class Real = double> struct At { Vector<dim, Real> r; }; };
struct DivergenceOfChange { static constexpr FieldInfo info{"divergenceOfChange", "1/s"};                  template<int dim, class Real = double> struct At { Real divergence; }; };
struct BalanceStep       { static constexpr FieldInfo info{"balanceStep", "m^2"};                          template<int dim, class Real = double> struct At { Real q; }; };
// clang-format on

/// g_ij/f_ij, and g_ji/f_ij; x = x_ij.
constexpr auto affine(const auto& ij, const auto& i) { return i.b - i.A * ij.x; }
constexpr auto affineBack(const auto& ij, const auto& j) { return j.b + j.A * ij.x; }

template<int dim> struct AffineMoments
{
    SymmTensor<dim> B;
    Vector<dim> m_1;
    double m_0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.B, q.m_1, q.m_0); }
};

/// A, and w/p: 0 where b is to be 0.
struct BalancedGradientMap
{
    static constexpr auto name = "gradientMap";
    using Provides = Fields<GradientMap, BalanceStep>;
    using Reads = Fields<Volume>;
    using ReadsOwn = Fields<GradientOffset>;
    static constexpr bool ofRawGradient = true;
    static constexpr double leastSpread = 0.1; ///< of p beside sum V f, below which all neighbours are on one side
    CorrectedFrom corrected, inside{0.85};

    explicit BalancedGradientMap(const Coefficients& c) : corrected(correctedFrom(c)) {}
    auto operator()(const auto& ij, const auto&, const auto& j) const
    {
        const double f = -j.V * ij.dWdrOverR;
        return AffineMoments<dimensions(decltype(ij.x){})>{f * outer(ij.x), -f * ij.x, f};
    }
    auto finish(const auto& i, const auto& sum) const
    {
        constexpr int dim = dimensions(decltype(sum.m_1){});
        const double lambda = leastEigenvalue(sum.B), w = corrected.share(lambda);
        const double share = inside.share(lambda);
        auto C = identity(sum.B);
        auto a = 0 * sum.m_1;
        double p = 0;
        if (w > 0 || share > 0)
        {
            const auto inverse = 1 / determinant(sum.B) * adjugate(sum.B);
            C = w * inverse + (1 - w) * identity(sum.B);
            a = inverse * sum.m_1;
            p = sum.m_0 - dot(a, sum.m_1);
        }
        const bool balances = share > 0 && p > leastSpread * sum.m_0;
        return Values<Fields<GradientMap, BalanceStep>, dim>{{full(C) - outer(i.b, a)}, {balances ? share / p : 0.0}};
    }
};

/// r
struct ImbalanceOfGradient
{
    static constexpr auto name = "gradientImbalance";
    using Provides = GradientImbalance;
    using Reads = Fields<Volume, GradientMap, GradientOffset>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return -j.V * ij.dWdrOverR * (affineBack(ij, j) - affine(ij, i));
    }
};

/// b
struct AdvanceOffset
{
    static constexpr auto name = "gradientOffset";
    using Advances = GradientOffset;
    using ReadsOwn = Fields<GradientOffset, GradientImbalance, BalanceStep>;
    static constexpr double relaxation = 0.9;

    auto operator()(const auto& i, double) const { return i.q > 0 ? i.b + relaxation * i.q * i.r : 0 * i.b; }
};

struct BalancedVelocityGradient
{
    static constexpr auto name = "balancedVelocityGradient";
    using Provides = VelocityGradient;
    using Reads = Fields<Volume, Velocity>;
    using ReadsOwn = Fields<GradientMap, GradientOffset>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return outer(-j.V * ij.dWdrOverR * (j.v - i.v), affine(ij, i)); }
};

/// div of a change of velocities.
struct BalancedDivergenceOfChange
{
    static constexpr auto name = "balancedDivergenceOfChange";
    using Provides = DivergenceOfChange;
    using Reads = Fields<Volume, VelocityChange>;
    using ReadsOwn = Fields<GradientMap, GradientOffset>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return -j.V * ij.dWdrOverR * dot(j.dv - i.dv, affine(ij, i)); }
};

template<class OfStress> struct BalancedDivergenceOf
{
    using Adds = Acceleration;
    using Reads = Fields<OfStress, Volume, GradientMap, GradientOffset>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return -i.V * j.V / i.m * ij.dWdrOverR * (i.S * affine(ij, i) - j.S * affineBack(ij, j));
    }
};

}
