/// Symmetric tensors of the second rank with named components, in two and three dimensions.
#pragma once
#include "base/Vector.hpp"

namespace sph
{

template<int dim, class Real = double> struct SymmTensor;

template<class Real> struct SymmTensor<2, Real>
{
    Real xx = 0, xy = 0, yy = 0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.xx, q.xy, q.yy); }
    static constexpr auto fieldClass = FieldClass::symmTensor;
    static constexpr auto names = std::to_array<std::string_view>({"xx", "xy", "yy"});
    constexpr SymmTensor& operator+=(SymmTensor b)
    {
        xx += b.xx;
        xy += b.xy;
        yy += b.yy;
        return *this;
    }
    friend constexpr SymmTensor operator+(SymmTensor a, SymmTensor b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }
    friend constexpr SymmTensor operator-(SymmTensor a, SymmTensor b) { return {a.xx - b.xx, a.xy - b.xy, a.yy - b.yy}; }
    friend constexpr SymmTensor operator*(Real s, SymmTensor a) { return {s * a.xx, s * a.xy, s * a.yy}; }
    friend constexpr Vector<2, Real> operator*(SymmTensor a, Vector<2, Real> b)
    {
        return {a.xx * b.x + a.xy * b.y, a.xy * b.x + a.yy * b.y};
    }
    friend constexpr Real trace(SymmTensor a) { return a.xx + a.yy; }
};

template<class Real> struct SymmTensor<3, Real>
{
    Real xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.xx, q.xy, q.xz, q.yy, q.yz, q.zz); }
    static constexpr auto fieldClass = FieldClass::symmTensor;
    static constexpr auto names = std::to_array<std::string_view>({"xx", "xy", "xz", "yy", "yz", "zz"});
    constexpr SymmTensor& operator+=(SymmTensor b) { return *this = *this + b; }
    friend constexpr SymmTensor operator+(SymmTensor a, SymmTensor b)
    {
        return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
    }
    friend constexpr SymmTensor operator-(SymmTensor a, SymmTensor b) { return a + -1.0 * b; }
    friend constexpr SymmTensor operator*(Real s, SymmTensor a) { return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz}; }
    friend constexpr Vector<3, Real> operator*(SymmTensor a, Vector<3, Real> b)
    {
        return {a.xx * b.x + a.xy * b.y + a.xz * b.z, a.xy * b.x + a.yy * b.y + a.yz * b.z, a.xz * b.x + a.yz * b.y + a.zz * b.z};
    }
    friend constexpr Real trace(SymmTensor a) { return a.xx + a.yy + a.zz; }
};

/// a a
template<class Real> constexpr SymmTensor<2, Real> outer(Vector<2, Real> a) { return {a.x * a.x, a.x * a.y, a.y * a.y}; }
template<class Real> constexpr SymmTensor<3, Real> outer(Vector<3, Real> a)
{
    return {a.x * a.x, a.x * a.y, a.x * a.z, a.y * a.y, a.y * a.z, a.z * a.z};
}

/// a b + b a, by components: a and b may have any units, so that outer(a + b) - outer(a) - outer(b) would lose the smaller of them.
template<class Real> constexpr SymmTensor<2, Real> twiceSymm(Vector<2, Real> a, Vector<2, Real> b)
{
    return {2 * a.x * b.x, a.x * b.y + a.y * b.x, 2 * a.y * b.y};
}
template<class Real> constexpr SymmTensor<3, Real> twiceSymm(Vector<3, Real> a, Vector<3, Real> b)
{
    return {2 * a.x * b.x, a.x * b.y + a.y * b.x, a.x * b.z + a.z * b.x, 2 * a.y * b.y, a.y * b.z + a.z * b.y, 2 * a.z * b.z};
}

/// a : b, and what the inverse is made of. The inverse of a singular tensor is not finite.
template<class Real> constexpr Real doubleDot(SymmTensor<2, Real> a, SymmTensor<2, Real> b)
{
    return a.xx * b.xx + 2 * a.xy * b.xy + a.yy * b.yy;
}
template<class Real> constexpr Real doubleDot(SymmTensor<3, Real> a, SymmTensor<3, Real> b)
{
    return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}
constexpr SymmTensor<2> adjugate(SymmTensor<2> a) { return {a.yy, -a.xy, a.xx}; }
constexpr SymmTensor<3> adjugate(SymmTensor<3> a)
{
    return {a.yy * a.zz - a.yz * a.yz, a.xz * a.yz - a.xy * a.zz, a.xy * a.yz - a.xz * a.yy,
            a.xx * a.zz - a.xz * a.xz, a.xy * a.xz - a.xx * a.yz, a.xx * a.yy - a.xy * a.xy};
}
constexpr double determinant(SymmTensor<2> a) { return a.xx * a.yy - a.xy * a.xy; }
constexpr double determinant(SymmTensor<3> a)
{
    const auto b = adjugate(a);
    return a.xx * b.xx + a.xy * b.xy + a.xz * b.xz;
}

/// The least of the real eigenvalues; in three dimensions by the trigonometric form (Smith 1961).
inline double leastEigenvalue(SymmTensor<2> a) { return 0.5 * (a.xx + a.yy) - std::sqrt(0.25 * sqr(a.xx - a.yy) + sqr(a.xy)); }
inline double leastEigenvalue(SymmTensor<3> a)
{
    const double mean = trace(a) / 3;
    const SymmTensor<3> b = a - mean * SymmTensor<3>{1, 0, 0, 1, 0, 1};
    const double p = std::sqrt(doubleDot(b, b) / 6);
    if (p <= 1e-12 * std::abs(mean)) return mean - p;
    const double r = std::fmax(-1.0, std::fmin(1.0, determinant(b) / (2 * p * p * p)));
    constexpr double turn = 2.0943951023931953; // 2 pi/3
    return mean + 2 * p * std::cos(std::acos(r) / 3 + turn);
}

/// (a b + b a)/2
template<int dim, class Real> constexpr SymmTensor<dim, Real> symm(Vector<dim, Real> a, Vector<dim, Real> b)
{
    return 0.5 * twiceSymm(a, b);
}

/// The unit tensor of the space that the argument lives in.
template<class Real> constexpr SymmTensor<2, Real> identity(Vector<2, Real>) { return {1, 0, 1}; }
template<class Real> constexpr SymmTensor<3, Real> identity(Vector<3, Real>) { return {1, 0, 0, 1, 0, 1}; }
template<class Real> constexpr SymmTensor<2, Real> identity(SymmTensor<2, Real>) { return {1, 0, 1}; }
template<class Real> constexpr SymmTensor<3, Real> identity(SymmTensor<3, Real>) { return {1, 0, 0, 1, 0, 1}; }

/// R S R with R = I - 2 n n: the mirror image in a plane of unit normal n.
template<int dim> constexpr SymmTensor<dim> mirrored(SymmTensor<dim> S, Vector<dim> n)
{
    const auto s = S * n;
    return S + -2.0 * twiceSymm(s, n) + 4 * dot(n, s) * outer(n);
}

}
