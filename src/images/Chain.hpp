/// The chain of reflections that makes one image: the surfaces that it was mirrored in, their tangent planes, and what follows for the image.
///
///   x' = mirror_n(... mirror_1(x))
#pragma once
#include "base/Vector.hpp"
#include <algorithm>
#include <array>
#include <span>

namespace sph
{

/// Reflections of the longest chain: a groove of 20 degrees is filled by as many.
inline constexpr int mostReflections = 9;

/// One surface that an image was mirrored in.
struct Mirror
{
    int patch, facet = -1; ///< the facet of a mesh that the image lies behind now
    bool operator==(const Mirror&) const = default;
};
using Mirrors = std::array<Mirror, mostReflections>;

/// The tangent plane that an image was mirrored in.
struct Face
{
    Vector<3> normal, foot;
    double turn = 0; ///< largest angle by which the normal turns until lists are built anew [rad]; known while images are made
    double depthOf(const Vector<3>& y) const { return dot(normal, foot - y); }
};
using Faces = std::array<Face, mostReflections>;

/// A patch as chains know it.
struct Reflector
{
    enum class Kind : unsigned char
    {
        plane,
        body, ///< curved, or with edges of its own
        mesh
    };
    Kind kind;
    Vector<3> normal = {}; ///< the unit normal of a plane, into the fluid
};

struct Chain
{
    Vector<3> x;      ///< position of the image, or of the particle before the first reflection
    double speed = 1; ///< speed of the image over that of its source
    int reflections = 0;
    Mirrors mirrors = {};
    Faces faces = {};
    double weight = 1; ///< largest weight, share times volume factor, until lists are built anew

    std::span<const Mirror> used() const { return {mirrors.data(), std::size_t(reflections)}; }
    int lastPatch() const { return used().back().patch; }
    bool holds(int patch) const
    {
        return std::ranges::any_of(used(), [patch](const Mirror& m) { return m.patch == patch; });
    }
    bool isOfOnly(int p, int q) const
    {
        return std::ranges::all_of(used(), [p, q](const Mirror& m) { return m.patch == p || m.patch == q; });
    }
};

}
