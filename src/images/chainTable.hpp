/// Decision table of chains: in which patches a chain of reflections goes on, and which of the images that it makes are kept. Each row is a condition, its
/// outcome and the reason; the first row whose condition holds decides.
///
/// Verified by test/unit/images/chainTableTest.cpp, row by row.
#pragma once
#include "images/Chain.hpp"

namespace sph
{

/// The kind of reflection by which a chain goes on in a patch.
enum class ChainStep : unsigned char
{
    none,          ///< the chain ends before this patch
    newWall,       ///< it is mirrored in a wall that it has not used yet
    sameMesh,      ///< it goes round the edges of one mesh
    thirdOfPlanes, ///< it is mirrored again in the first of two planes that meet at an acute angle
    inTurn         ///< two bodies mirror it in turn, as often as their wedge needs
};

/// Whether, and how, a chain goes on in a patch. `reflectors` are all patches by index.
ChainStep stepInto(int patch, const Chain&, std::span<const Reflector> reflectors, int dim);

/// Whether an image that a chain has made is kept, or why not.
enum class Kept : unsigned char
{
    yes,
    negligible,
    inNeither, ///< it lies in neither of the two solids whose corner it should fill
    twin       ///< another chain has made the same image
};

/// Images in several bodies, and third and later ones in one, with less than this weight are left out. In the pinch between spheres that touch images of images are many and small: with a support of 3.05
/// spacings and ten of them across a sphere one particle had 1877 neighbours, and has 636, which fill 0.0013 less of its kernel.
inline constexpr double leastWeight = 0.01;
/// Chains of a particle beyond which those that come back to others end. A groove of 20 degrees has 18.
inline constexpr std::size_t mostInCorners = 64;
/// Normals whose product is less are at right angles: images in either order are one.
inline constexpr double rightAngle = 1e-6;

inline bool arePlanes(int p, int q, std::span<const Reflector> reflectors)
{
    return reflectors[std::size_t(p)].kind == Reflector::Kind::plane && reflectors[std::size_t(q)].kind == Reflector::Kind::plane;
}
/// Whether reflection number `last` is one more than walls that do not meet in a wedge would have: a later one of two bodies in turn.
inline bool goesOnInWedge(const Mirror* mirrors, int last, std::span<const Reflector> reflectors, int dim)
{
    if (last < dim) return false;
    const int p = mirrors[last].patch, q = mirrors[last - 1].patch;
    return p != q && !arePlanes(p, q, reflectors);
}
/// Whether a chain is of two surfaces alone, not both planes, that do not meet at right angles: their images have shares of what is behind both.
bool isOfWedge(const Chain&, std::span<const Reflector>);
/// Whether some chain of as many reflections, in the same surfaces where `inSame`, has its image within a quarter of a spacing.
bool hasTwin(const Chain&, std::span<const Chain> others, double spacing, bool inSame);
/// Whether a particle that has more images than any corner needs (`mostInCorners`) gets one more within a quarter of a spacing of itself or of an image of fewer reflections. Beside an edge that all
/// but touches another wall they had no end: 1946 of one particle.
bool pilesUp(const Chain&, std::span<const Chain> others, double spacing);

/// `next` ends with the step; `others` are the chains of its particle so far. The rows that need it call `fillsCorner()`: whether the image lies in what the last two
/// solids leave to it.
// clang-format off
Kept keepsImage(const Chain& next, ChainStep step, std::span<const Chain> others, std::span<const Reflector> reflectors, double spacing,
                const auto& fillsCorner)
{
    using enum Kept;
    const bool isOfOneBody = next.isOfOnly(next.lastPatch(), next.lastPatch()), isThird = step == ChainStep::thirdOfPlanes;
    const bool fadesSlowly = !isOfOneBody || next.reflections > 2; // beside blunt edges a weight grows faster than it is foreseen
    if (next.weight < leastWeight && fadesSlowly)            return negligible; // between bodies that touch chains have no end
    if (pilesUp(next, others, spacing))                      return twin;       // in a gap that no spacing resolves images pile up
    if (step == ChainStep::sameMesh)                         return yes;        // each place behind a mesh belongs to one of its faces
    if (next.reflections > 1 && !fillsCorner())              return inNeither;  // there is nothing to fill in front of both solids
    if (isThird && hasTwin(next, others, spacing, false))    return twin;       // at 60 degrees both orders give the same third image
    if (isThird)                                             return yes;        // at other angles the third images of both orders differ
    if (isOfWedge(next, reflectors))                         return yes;        // both orders share what lies behind two bodies
    if (hasTwin(next, others, spacing, true))                return twin;       // at right angles both orders give the same image
    return yes;                                                                 // nobody else fills this place
}
// clang-format on

}
