#include "images/chainTable.hpp"
#include <cmath>

namespace sph
{

namespace
{
/// Two planes that meet at an angle from about 15 to 75 degrees, by its cosine. From 75 degrees on two reflections fill the corner. Planes that all but
/// face one another are a slit, whose third image is far.
bool isAcute(const Vector<3>& n, const Vector<3>& m)
{
    const double cosine = -dot(n, m);
    return cosine > 0.26 && cosine < 0.97;
}
/// Whether two images count as one place.
bool coincide(const Chain& a, const Chain& b, double spacing) { return mag(a.x - b.x) < 0.25 * spacing; }
}

// clang-format off
ChainStep stepInto(int p, const Chain& chain, std::span<const Reflector> reflectors, int dim)
{
    using enum ChainStep;
    const int n = chain.reflections;
    if (n == 0)                return newWall;       // each wall within reach mirrors the particle itself
    if (n == mostReflections)  return none;          // what is narrower is a gap, which no spacing resolves
    const int last = chain.lastPatch();
    const auto &wall = reflectors[std::size_t(p)], &before = reflectors[std::size_t(last)];
    const bool isNew = !chain.holds(p), isLast = p == last, isMesh = wall.kind == Reflector::Kind::mesh;
    const bool planes = arePlanes(p, last, reflectors), acute = planes && isAcute(wall.normal, before.normal);
    const bool isOfThree = !chain.isOfOnly(p, last);
    if (isNew && n < dim)      return newWall;       // a corner of `dim` walls has an image in all of them
    if (isNew)                 return none;          // more walls than dimensions do not meet in one corner
    if (isLast && isMesh)      return sameMesh;      // what one face has made another mirrors, at edges and corners
    if (isLast)                return none;          // the image lies behind the surface that made it
    if (acute && n == 2)       return thirdOfPlanes; // at 60 degrees five images fill the wedge
    if (planes)                return none;          // two reflections fill the corner of two planes
    if (isOfThree)             return none;          // between three bodies each mirrors once
    return inTurn;                                   // the wedge of two bodies is filled as that of one mesh
}
// clang-format on

bool isOfWedge(const Chain& chain, std::span<const Reflector> reflectors)
{
    const std::size_t last = std::size_t(chain.reflections) - 1;
    const int p = chain.lastPatch();
    int q = -1;
    bool square = true;
    for (std::size_t r = 0; r < last; ++r)
        if (const int other = chain.mirrors[r].patch; other != p)
        {
            if (q >= 0 && other != q) return false;
            q = other;
            square = std::abs(dot(chain.faces[r].normal, chain.faces[last].normal)) < rightAngle;
        }
    return q >= 0 && !square && !arePlanes(p, q, reflectors);
}

bool hasTwin(const Chain& chain, std::span<const Chain> others, double spacing, bool inSame)
{
    return std::ranges::any_of(others,
                               [&](const Chain& other)
                               {
                                   return other.reflections == chain.reflections &&
                                          (!inSame || std::ranges::is_permutation(other.used(), chain.used())) &&
                                          coincide(other, chain, spacing);
                               });
}

bool pilesUp(const Chain& chain, std::span<const Chain> others, double spacing)
{
    return others.size() > mostInCorners &&
           std::ranges::any_of(others, [&](const Chain& other)
                               { return other.reflections < chain.reflections && coincide(other, chain, spacing); });
}

}
