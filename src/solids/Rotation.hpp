/// Rotation by a unit quaternion (w, v) = (cos(a/2), sin(a/2) n), a the angle about the axis n.
#pragma once
#include "base/Vector.hpp"
#include "base/noise.hpp"
#include <algorithm>

namespace sph
{

struct Rotation
{
    double w = 1;
    Vector<3> v;

    Vector<3> operator()(const Vector<3>& x) const { return x + 2 * cross(v, cross(v, x) + w * x); }
    /// First b, then a
    friend Rotation operator*(const Rotation& a, const Rotation& b)
    {
        return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
    }
};

/// Uniform over all rotations (Shoemake 1992)
inline Rotation randomRotation(Noise& noise)
{
    const double u = noise(), a = 2 * std::numbers::pi * noise(), b = 2 * std::numbers::pi * noise();
    return {std::sqrt(u) * std::cos(b), {std::sqrt(1 - u) * std::sin(a), std::sqrt(1 - u) * std::cos(a), std::sqrt(u) * std::sin(b)}};
}

/// Rotation whose matrix has these columns: a right-handed system of unit vectors (Shepperd 1978, with the largest of the four)
inline Rotation rotationTo(const Vector<3>& ex, const Vector<3>& ey, const Vector<3>& ez)
{
    const double trace = ex.x + ey.y + ez.z;
    Rotation q{1 + trace, {ey.z - ez.y, ez.x - ex.z, ex.y - ey.x}};
    const double largest = std::max({trace, ex.x, ey.y, ez.z});
    if (largest == ex.x) q = {ey.z - ez.y, {1 + ex.x - ey.y - ez.z, ex.y + ey.x, ex.z + ez.x}};
    else if (largest == ey.y) q = {ez.x - ex.z, {ex.y + ey.x, 1 + ey.y - ex.x - ez.z, ey.z + ez.y}};
    else if (largest == ez.z) q = {ex.y - ey.x, {ex.z + ez.x, ey.z + ez.y, 1 + ez.z - ex.x - ey.y}};
    const double length = std::sqrt(q.w * q.w + dot(q.v, q.v));
    return {q.w / length, q.v / length};
}

}
