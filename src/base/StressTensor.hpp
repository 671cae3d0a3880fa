/// The stress tensor, with three principal values also where the flow has two dimensions. In plane strain the velocity out of the plane is 0 and so are
/// the strain rates xz, yz and zz, but the stress zz is not: elasticity and plasticity change it, and pressure and invariants need it.
///
///     StressTensor<3>   the symmetric tensor
///     StressTensor<2>   xx xy yy zz; on disk OpenFOAM's symmTensor with xz = yz = 0
///
/// Tension is positive. Verified by test/unit/base against the three-dimensional tensor.
#pragma once
#include "base/Tensor.hpp"
#include <algorithm>
#include <functional>

namespace sph
{

struct PlaneStrainStress
{
    double xx = 0, xy = 0, yy = 0, zz = 0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.xx, q.xy, q.yy, q.zz); }
    static constexpr auto fieldClass = FieldClass::symmTensor;
    static constexpr auto names = std::to_array<std::string_view>({"xx", "xy", "yy", "zz"});
    constexpr PlaneStrainStress& operator+=(PlaneStrainStress b) { return *this = *this + b; }
    friend constexpr PlaneStrainStress operator+(PlaneStrainStress a, PlaneStrainStress b)
    {
        return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy, a.zz + b.zz};
    }
    friend constexpr PlaneStrainStress operator-(PlaneStrainStress a, PlaneStrainStress b)
    {
        return {a.xx - b.xx, a.xy - b.xy, a.yy - b.yy, a.zz - b.zz};
    }
    friend constexpr PlaneStrainStress operator*(double s, PlaneStrainStress a) { return {s * a.xx, s * a.xy, s * a.yy, s * a.zz}; }
    friend constexpr Vector<2> operator*(PlaneStrainStress a, Vector<2> b) { return {a.xx * b.x + a.xy * b.y, a.xy * b.x + a.yy * b.y}; }
    friend constexpr double trace(PlaneStrainStress a) { return a.xx + a.yy + a.zz; }
};

namespace detail
{
template<int dim> struct StressTensor
{
    using type = SymmTensor<3>;
};
template<> struct StressTensor<2>
{
    using type = PlaneStrainStress;
};
}
template<int dim> using StressTensor = typename detail::StressTensor<dim>::type;

constexpr PlaneStrainStress identity(PlaneStrainStress) { return {1, 0, 1, 1}; }

/// A strain rate among stresses, zz = 0 in plane strain; and the components that act in the plane of the flow.
constexpr PlaneStrainStress inSpace(SymmTensor<2> a) { return {a.xx, a.xy, a.yy, 0}; }
constexpr SymmTensor<3> inSpace(SymmTensor<3> a) { return a; }
constexpr SymmTensor<2> inPlane(PlaneStrainStress a) { return {a.xx, a.xy, a.yy}; }
constexpr SymmTensor<3> in3D(PlaneStrainStress a) { return {a.xx, a.xy, 0, a.yy, 0, a.zz}; }

/// S : b, also with a strain rate: its zz is 0.
constexpr double doubleDot(PlaneStrainStress a, PlaneStrainStress b) { return a.xx * b.xx + 2 * a.xy * b.xy + a.yy * b.yy + a.zz * b.zz; }
constexpr double doubleDot(PlaneStrainStress a, SymmTensor<2> rate) { return a.xx * rate.xx + 2 * a.xy * rate.xy + a.yy * rate.yy; }

/// S - tr(S)/3 I
constexpr PlaneStrainStress deviator(PlaneStrainStress S) { return S - trace(S) / 3 * identity(S); }
constexpr SymmTensor<3> deviator(SymmTensor<3> S) { return S - trace(S) / 3 * identity(S); }

/// Mirrored, rotated and turning in the plane: zz stays as it is, and does not change.
constexpr PlaneStrainStress mirrored(PlaneStrainStress S, Vector<2> n)
{
    auto image = inSpace(mirrored(inPlane(S), n));
    image.zz = S.zz;
    return image;
}
constexpr PlaneStrainStress rotated(PlaneStrainStress S, Tensor<2> Q)
{
    auto turned = inSpace(rotated(inPlane(S), Q));
    turned.zz = S.zz;
    return turned;
}
constexpr PlaneStrainStress turning(PlaneStrainStress S, Tensor<2> W) { return inSpace(turning(inPlane(S), W)); }

/// The largest first. In three dimensions by the trigonometric form (Smith 1961).
inline std::array<double, 3> principalValues(PlaneStrainStress S)
{
    const double mean = 0.5 * (S.xx + S.yy), radius = std::sqrt(0.25 * sqr(S.xx - S.yy) + sqr(S.xy));
    std::array<double, 3> values{mean + radius, mean - radius, S.zz};
    std::sort(values.begin(), values.end(), std::greater<>());
    return values;
}
inline std::array<double, 3> principalValues(SymmTensor<3> S)
{
    const double least = leastEigenvalue(S), largest = -leastEigenvalue(-1.0 * S);
    return {largest, trace(S) - largest - least, least};
}

}
