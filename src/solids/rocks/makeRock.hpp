/// Shapes of rocks, as closed surfaces with outward normals about their centroid.
#pragma once
#include "geometry/TriangleSurface.hpp"
#include <cstdint>
#include <string>

namespace sph
{

struct RockKind
{
    std::string name, meaning;
    TriangleSurface (*make)(int facets, std::uint64_t seed);
};

/// angular, rounded, elongated, flat, concave
const std::vector<RockKind>& rockKinds();

/// Fewest facets of a rock.
inline constexpr int fewestFacets = 20;

/// A rock of the volume of a sphere of that diameter. The number of facets is the next possible: 4 n for angular, elongated and flat ones
/// (polyhedra whose corners have three edges each), 20 n^2 for rounded and concave ones (an icosahedron whose edges are cut into n).
TriangleSurface makeRock(const RockKind&, int facets, double diameter, std::uint64_t seed);

/// The rounded rock as a scanner might give it: points off by 0.5 % of the diameter, four holes, 1 % of the facets twice, 2 % the wrong way
/// round, and two points that stand where their facets cross others.
TriangleSurface makeScan(int facets, double diameter, std::uint64_t seed);

}
