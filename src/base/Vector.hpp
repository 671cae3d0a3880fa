/// Vectors with named components, in two and three dimensions. Named, not indexed: loops over components inside a pair loop cost a
/// factor 2 in GCC 12. What a value is made of, `parts`, and what it is on disk are declared with its type; values.hpp makes use of them.
#pragma once
#include "base/FieldClass.hpp"
#include <array>
#include <cmath>
#include <type_traits>

namespace sph
{

template<int dim, class Real = double> struct Vector;

template<class Real> struct Vector<2, Real>
{
    Real x = 0, y = 0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.x, q.y); }
    static constexpr auto fieldClass = FieldClass::vector;
    static constexpr auto names = std::to_array<std::string_view>({"x", "y"});
    constexpr Vector& operator+=(Vector b)
    {
        x += b.x;
        y += b.y;
        return *this;
    }
    constexpr Vector& operator-=(Vector b)
    {
        x -= b.x;
        y -= b.y;
        return *this;
    }
    constexpr Vector& operator*=(Real s)
    {
        x *= s;
        y *= s;
        return *this;
    }
    friend constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vector operator-(Vector a) { return {-a.x, -a.y}; }
    friend constexpr Vector operator*(Real s, Vector a) { return {s * a.x, s * a.y}; }
    friend constexpr Vector operator/(Vector a, Real s) { return {a.x / s, a.y / s}; }
    friend constexpr bool operator==(Vector, Vector) = default;
    friend constexpr Real dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
};

template<class Real> struct Vector<3, Real>
{
    Real x = 0, y = 0, z = 0;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.x, q.y, q.z); }
    static constexpr auto fieldClass = FieldClass::vector;
    static constexpr auto names = std::to_array<std::string_view>({"x", "y", "z"});
    constexpr Vector& operator+=(Vector b)
    {
        x += b.x;
        y += b.y;
        z += b.z;
        return *this;
    }
    constexpr Vector& operator-=(Vector b)
    {
        x -= b.x;
        y -= b.y;
        z -= b.z;
        return *this;
    }
    constexpr Vector& operator*=(Real s)
    {
        x *= s;
        y *= s;
        z *= s;
        return *this;
    }
    friend constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vector operator-(Vector a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vector operator*(Real s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr Vector operator/(Vector a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
    friend constexpr bool operator==(Vector, Vector) = default;
    friend constexpr Real dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend constexpr Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
};

constexpr double sqr(double a) { return a * a; }

template<int dim, class Real> Real mag(Vector<dim, Real> a) { return sqrt(dot(a, a)); }

/// a - 2 (a.n) n: the mirror image in a plane of unit normal n. A scalar is its own.
template<int dim> constexpr Vector<dim> mirrored(Vector<dim> a, Vector<dim> n) { return a - 2 * dot(a, n) * n; }
template<int dim> constexpr double mirrored(double a, Vector<dim>) { return a; }

/// The number of dimensions of the space that the argument lives in.
template<int dim, class Real> constexpr int dimensions(Vector<dim, Real>) { return dim; }

/// Positions and vectors on disk and in dictionaries always have three components; a 2-D scene lives in the x-y plane.
template<int dim> constexpr Vector<dim> in(Vector<3> a)
{
    if constexpr (dim == 3) return a;
    else return {a.x, a.y};
}
constexpr Vector<3> in3D(Vector<2> a) { return {a.x, a.y, 0}; }
constexpr Vector<3> in3D(Vector<3> a) { return a; }

}
