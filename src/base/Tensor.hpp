/// Tensors of the second rank without symmetry, such as the velocity gradient L_ij = dv_i/dx_j, in two and three dimensions.
#pragma once
#include "base/SymmTensor.hpp"

namespace sph
{

template<int dim, class Real = double> struct Tensor;

template<class Real> struct Tensor<2, Real>
{
    Real xx = 0, xy = 0, yx = 0, yy = 0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.xx, q.xy, q.yx, q.yy); }
    static constexpr auto fieldClass = FieldClass::tensor;
    static constexpr auto names = std::to_array<std::string_view>({"xx", "xy", "yx", "yy"});
    constexpr Tensor& operator+=(Tensor b) { return *this = *this + b; }
    friend constexpr Tensor operator+(Tensor a, Tensor b) { return {a.xx + b.xx, a.xy + b.xy, a.yx + b.yx, a.yy + b.yy}; }
    friend constexpr Tensor operator-(Tensor a, Tensor b) { return {a.xx - b.xx, a.xy - b.xy, a.yx - b.yx, a.yy - b.yy}; }
    friend constexpr Tensor operator*(Real s, Tensor a) { return {s * a.xx, s * a.xy, s * a.yx, s * a.yy}; }
    friend constexpr Vector<2, Real> operator*(Tensor a, Vector<2, Real> b) { return {a.xx * b.x + a.xy * b.y, a.yx * b.x + a.yy * b.y}; }
    friend constexpr Tensor operator*(Tensor a, Tensor b)
    {
        return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx, a.yx * b.xy + a.yy * b.yy};
    }
    friend constexpr bool operator==(Tensor, Tensor) = default;
    friend constexpr Real trace(Tensor a) { return a.xx + a.yy; }
};

template<class Real> struct Tensor<3, Real>
{
    Real xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.xx, q.xy, q.xz, q.yx, q.yy, q.yz, q.zx, q.zy, q.zz); }
    static constexpr auto fieldClass = FieldClass::tensor;
    static constexpr auto names = std::to_array<std::string_view>({"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"});
    constexpr Tensor& operator+=(Tensor b) { return *this = *this + b; }
    friend constexpr Tensor operator+(Tensor a, Tensor b)
    {
        return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yx + b.yx, a.yy + b.yy, a.yz + b.yz, a.zx + b.zx, a.zy + b.zy, a.zz + b.zz};
    }
    friend constexpr Tensor operator-(Tensor a, Tensor b) { return a + -1.0 * b; }
    friend constexpr Tensor operator*(Real s, Tensor a)
    {
        return {s * a.xx, s * a.xy, s * a.xz, s * a.yx, s * a.yy, s * a.yz, s * a.zx, s * a.zy, s * a.zz};
    }
    friend constexpr Vector<3, Real> operator*(Tensor a, Vector<3, Real> b)
    {
        return {a.xx * b.x + a.xy * b.y + a.xz * b.z, a.yx * b.x + a.yy * b.y + a.yz * b.z, a.zx * b.x + a.zy * b.y + a.zz * b.z};
    }
    friend constexpr Tensor operator*(Tensor a, Tensor b)
    {
        const auto x = a * Vector<3, Real>{b.xx, b.yx, b.zx}, y = a * Vector<3, Real>{b.xy, b.yy, b.zy},
                   z = a * Vector<3, Real>{b.xz, b.yz, b.zz};
        return {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
    }
    friend constexpr bool operator==(Tensor, Tensor) = default;
    friend constexpr Real trace(Tensor a) { return a.xx + a.yy + a.zz; }
};

/// a b: a_i b_j
template<class Real> constexpr Tensor<2, Real> outer(Vector<2, Real> a, Vector<2, Real> b)
{
    return {a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y};
}
template<class Real> constexpr Tensor<3, Real> outer(Vector<3, Real> a, Vector<3, Real> b)
{
    return {a.x * b.x, a.x * b.y, a.x * b.z, a.y * b.x, a.y * b.y, a.y * b.z, a.z * b.x, a.z * b.y, a.z * b.z};
}

template<class Real> constexpr Tensor<2, Real> transpose(Tensor<2, Real> a) { return {a.xx, a.yx, a.xy, a.yy}; }
template<class Real> constexpr Tensor<3, Real> transpose(Tensor<3, Real> a)
{
    return {a.xx, a.yx, a.zx, a.xy, a.yy, a.zy, a.xz, a.yz, a.zz};
}

/// (a + a^T)/2, the strain rate of a velocity gradient, and (a - a^T)/2, its spin.
template<class Real> constexpr SymmTensor<2, Real> symm(Tensor<2, Real> a) { return {a.xx, 0.5 * (a.xy + a.yx), a.yy}; }
template<class Real> constexpr SymmTensor<3, Real> symm(Tensor<3, Real> a)
{
    return {a.xx, 0.5 * (a.xy + a.yx), 0.5 * (a.xz + a.zx), a.yy, 0.5 * (a.yz + a.zy), a.zz};
}
template<int dim, class Real> constexpr Tensor<dim, Real> skew(Tensor<dim, Real> a) { return 0.5 * (a - transpose(a)); }

/// A symmetric tensor with all its components.
template<class Real> constexpr Tensor<2, Real> full(SymmTensor<2, Real> a) { return {a.xx, a.xy, a.xy, a.yy}; }
template<class Real> constexpr Tensor<3, Real> full(SymmTensor<3, Real> a)
{
    return {a.xx, a.xy, a.xz, a.xy, a.yy, a.yz, a.xz, a.yz, a.zz};
}

/// a : b = a_ij b_ij
template<class Real> constexpr Real doubleDot(Tensor<2, Real> a, Tensor<2, Real> b)
{
    return a.xx * b.xx + a.xy * b.xy + a.yx * b.yx + a.yy * b.yy;
}
template<class Real> constexpr Real doubleDot(Tensor<3, Real> a, Tensor<3, Real> b)
{
    return a.xx * b.xx + a.xy * b.xy + a.xz * b.xz + a.yx * b.yx + a.yy * b.yy + a.yz * b.yz + a.zx * b.zx + a.zy * b.zy + a.zz * b.zz;
}

constexpr Tensor<2> adjugate(Tensor<2> a) { return {a.yy, -a.xy, -a.yx, a.xx}; }
constexpr Tensor<3> adjugate(Tensor<3> a)
{
    return {a.yy * a.zz - a.yz * a.zy, a.xz * a.zy - a.xy * a.zz, a.xy * a.yz - a.xz * a.yy,
            a.yz * a.zx - a.yx * a.zz, a.xx * a.zz - a.xz * a.zx, a.xz * a.yx - a.xx * a.yz,
            a.yx * a.zy - a.yy * a.zx, a.xy * a.zx - a.xx * a.zy, a.xx * a.yy - a.xy * a.yx};
}
constexpr double determinant(Tensor<2> a) { return a.xx * a.yy - a.xy * a.yx; }
constexpr double determinant(Tensor<3> a)
{
    const auto b = adjugate(a);
    return a.xx * b.xx + a.xy * b.yx + a.xz * b.zx;
}
/// Inverse of a tensor, not finite for a singular one.
template<int dim> constexpr Tensor<dim> inverse(Tensor<dim> a) { return 1 / determinant(a) * adjugate(a); }

/// R a R with R = I - 2 n n: the mirror image in a plane of unit normal n.
template<int dim> constexpr Tensor<dim> mirrored(Tensor<dim> a, Vector<dim> n)
{
    const auto an = a * n, na = transpose(a) * n;
    return a - 2 * outer(n, na) - 2 * outer(an, n) + 4 * dot(n, an) * outer(n, n);
}

/// Q S Q^T: turned by the rotation Q.
template<int dim> constexpr SymmTensor<dim> rotated(SymmTensor<dim> S, Tensor<dim> Q) { return symm(Q * full(S) * transpose(Q)); }

/// W.S - S.W, the rate of a stress that turns with the spin W = skew(dv_i/dx_j) and does not change otherwise. The Jaumann rate is
/// dS/dt - turning(S, W) = dS/dt + S.W - W.S.
template<int dim> constexpr SymmTensor<dim> turning(SymmTensor<dim> S, Tensor<dim> W)
{
    const auto WS = W * full(S); // its transpose is -S.W
    return symm(WS + transpose(WS));
}

}
