/// Weights of the fit that takes a field of the fluid to a particle j of a wall layer:
///
///   q_j  = sum_i w_ij q_g(q_i, d_i, d_j)
///   w_ij = W_ij (1 - u.(t_i - t_m))/sum_i W_ij,   u = C^-1 t_m min(1, 3/(t_m.C^-1 t_m))
///
/// t_i [m] way from j to i along the wall, t_m its mean with weights W, C that of (t_i - t_m)(t_i - t_m): the w take the value at t = 0 of what is fitted to the
/// q_g along the wall, exact for values that are linear there. Where j lies beyond those of the fluid, above its surface, the fit is flattened.
#pragma once
#include "base/SymmTensor.hpp"
#include "base/Vector.hpp"
#include <array>
#include <cmath>

namespace sph
{

template<int dim> class LayerFit
{
    std::array<Vector<dim>, dim> across_{}; ///< unit vectors that span the normals of the walls that j lies behind
    int walls_ = 0;
    double weight_ = 0;
    Vector<dim> sum_{}, mean_{}, slope_{};
    SymmTensor<dim> square_{};

    Vector<dim> along(Vector<dim> t) const
    {
        for (int k = 0; k < walls_; ++k) t -= dot(t, across_[std::size_t(k)]) * across_[std::size_t(k)];
        return t;
    }

public:
    /// Lets the fit run along a wall of this unit normal, too.
    void addWall(const Vector<dim>& normal)
    {
        if (const auto n = along(normal); mag(n) > 1e-6) across_[std::size_t(walls_++)] = 1 / mag(n) * n;
    }
    /// A pair of kernel weight W, `way` [m] from j to the particle of the fluid.
    void add(double W, Vector<dim> way)
    {
        const auto t = along(way);
        weight_ += W;
        sum_ += W * t;
        square_ += W * outer(t);
    }
    /// Adds the pairs that another rank has of the same particle.
    LayerFit& operator+=(const LayerFit& b)
    {
        weight_ += b.weight_;
        sum_ += b.sum_;
        square_ += b.square_;
        return *this;
    }
    /// Solves for u after the last pair; `H` [m] is the support.
    void solve(double H)
    {
        if (!(weight_ > 0)) return;
        mean_ = 1 / weight_ * sum_;
        auto C = 1 / weight_ * square_ - outer(mean_) + 1e-12 * sqr(H) * identity(square_); // one particle alone has no C
        for (int k = 0; k < walls_; ++k) C += sqr(H) * outer(across_[std::size_t(k)]);
        const auto u = 1 / determinant(C) * (adjugate(C) * mean_);
        slope_ = std::fmin(1, 3 / dot(mean_, u)) * u; // 3 is at the end of an even spread
    }
    /// 1 - u.(t - t_m), the factor of W_ij in w_ij
    double operator()(Vector<dim> way) const { return 1 - dot(slope_, along(way) - mean_); }
};

}
