/// Shapes of one wall from its dictionary.
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Geometry.hpp"

namespace sph
{

/// The smooth surfaces of a wall within the space of `geometry` (dimension, domain, periodic directions, reach). None where an
/// entry is wrong: the mistake is then in the dictionary's Diagnostics. Spheres of a bed that are further than the reach
/// outside a domain that does not repeat are left out.
std::vector<std::shared_ptr<const Shape>> readShapes(const Dictionary& wall, const Geometry& geometry);

/// The bodies of a mesh as meshToGhost has prepared it, and the names of its regions; nothing, and an error, where it is missing or damaged.
struct WallMesh
{
    std::vector<std::string> regions;
    std::vector<std::shared_ptr<const Shape>> bodies;
};
std::optional<WallMesh> readMesh(const std::string& wall, const Geometry&, Diagnostics&);
/// A patch of `wall` for each of its bodies; `walls` are those of its regions.
void addBodies(const WallMesh&, int wall, const std::vector<int>& walls, Geometry&);
bool isMesh(const Dictionary& wall);
/// The dictionaries of walls of `type triSurface` in constant/geometry.
std::vector<Dictionary> meshWalls(const Dictionary& geometry);

/// True where `type` names one shape, which may turn around `origin` with `omega`.
bool isSingleShape(const std::string& type);
bool isSingleShape(const Dictionary& wall);
/// The choice `type` of a wall, and the entries of each.
const Choice& shapeType();
Cases shapes();

}
