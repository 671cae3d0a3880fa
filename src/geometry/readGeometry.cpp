#include "base/words.hpp"
#include "case/Case.hpp"
#include "dictionary/timeExpression.hpp"
#include "geometry/Geometry.hpp"
#include "geometry/components.hpp"
#include "geometry/readShapes.hpp"
#include "geometry/readSpace.hpp"
#include "geometry/triSurface.hpp"
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Count dimension{"dimension", required, between(2, 3).saying("dimension must be 2 or 3"), "of space"};
const SubDictionary domain{"domain", required, "the box that is computed"};
const VectorParameter min{"min", units::m, required, "lowest corner"}, max{"max", units::m, required, "highest corner"};
const ListOf<std::string> periodic{"periodic", std::vector<std::string>{}, "directions x, y, z in which the domain repeats"};
const SubDictionary walls{"walls", notGiven, "the walls"};
const FreeName wall{"<wall>", "dictionary", "a wall of the case's own name"};
const Scalar contactAngle{"contactAngle", degrees, byScene("90, and no wetting"),
                          between(0, 180).saying("contactAngle must be between 0 and 180 degrees, not {}"),
                          "of two phases, through the first of them"};
const PairValues contactAngles{
    "contactAngles", "contact angle", degrees, between(0, 180).saying("a contact angle must be between 0 and 180 degrees, not {}"),
    "of pairs of phases, each through the first-named of its pair; as many as tell all others, one less than phases"};
const VectorParameter velocity{"velocity", units::mPerS, Vector<3>{},
                               "of the wall, which goes where it leads; meshes and what touches another solid move along themselves alone"},
    omega{"omega", units::none / units::s, Vector<3>{}, "rate at which it turns"},
    origin{"origin", units::m, Vector<3>{}, "point about which it turns"};
const SubDictionary load{"load", notGiven, "in place of velocity: the wall goes by what pushes it"};
const Text force{"force", required,
                 "that pushes it along direction [N], per metre of depth in 2-D; an expression of $t; its weight included"};
const VectorParameter direction{"direction", units::none, required, "along which it goes, without turning"};
const Scalar mass{"mass", units::kg, required, positive,
                  "of the wall, per metre of depth in 2-D; at least that of the particles within a spacing of it"};
const Scalar loadDamping{"damping", units::none / units::s, 0.0, atLeast(0), "rate at which its velocity fades"};
const Switch slip{"slip", false, "the fluid slides along the wall freely; else wallVelocity of system/sphSchemes decides"};
const Scalar frictionAngle{"frictionAngle", degrees, byScene("none: soil sticks to the wall, or slips"),
                           Range{.low = 0, .high = 90, .highIncluded = false}, "of soil that slides along the wall"};
}

void readSpace(const Dictionary& dict, Geometry& g)
{
    const auto before = dict.diagnostics().errors();
    g.dimension = entry::dimension(dict);
    if (dict.diagnostics().errors() != before) g.dimension = 3;
    const auto domain = entry::domain(dict);
    const bool given = entry::min.given(domain) && entry::max.given(domain);
    g.low = entry::min(domain);
    g.high = entry::max(domain);
    for (int k = 0; k < 3; ++k)
    {
        const auto c = component(k);
        if (g.high.*c > g.low.*c) continue;
        if (k < g.dimension && given)
            entry::max.error(domain, fmt::format("max must be greater than min; in {} it is {} against {}", coordinateNames[k], g.high.*c,
                                                 g.low.*c));
        g.high.*c = g.low.*c + 1;
    }
    static const std::vector<std::string> directions{"x", "y", "z"};
    for (const auto& word : entry::periodic(domain))
    {
        if (word == "x" || word == "y" || (word == "z" && g.dimension == 3)) g.periodic[word[0] - 'x'] = true;
        else if (word == "z") entry::periodic.error(domain, "a 2-D scene does not vary with z: it cannot be periodic there");
        else entry::periodic.error(domain, fmt::format("\"{}\" is no direction. {}", word, suggestion(word, "directions", directions)));
    }
}

Geometry readDomain(const Case& c)
{
    Geometry g;
    readSpace(c.dictionary(c.has("constant/walls") ? "constant/walls" : "constant/geometry"), g);
    return g;
}

BoundingBox boundingBox(const Geometry& g)
{
    const double thickness = 0.01 * std::max(g.length(0), g.length(1));
    const bool isFlat = g.dimension == 2;
    return {{g.low.x, g.low.y, isFlat ? -thickness : g.low.z}, {g.high.x, g.high.y, isFlat ? thickness : g.high.z}};
}

void checkFit(const Geometry& g, const Resolution& resolution, Diagnostics& diagnostics)
{
    const double mostPlaces = 1e9; // indices are 32 bits wide, images included
    const auto before = diagnostics.errors();
    double places = 1;
    for (int k = 0; k < g.dimension; ++k) places *= g.length(k) / resolution.spacing;
    if (places > mostPlaces)
        diagnostics.error(resolution.where,
                          fmt::format("spacing {:.4g} m makes {:.2g} particles in the domain; at most {:.2g} are possible",
                                      resolution.spacing, places, mostPlaces));
    for (int k = 0; k < g.dimension; ++k)
    {
        const double least = resolution.H() + resolution.spacing;
        if (resolution.spacing > g.length(k) * (1 + 1e-6))
            diagnostics.error(resolution.where, fmt::format("spacing {:.4g} m is larger than the domain, {:.4g} m along {}",
                                                            resolution.spacing, g.length(k), coordinateNames[k]));
        else if (g.periodic[k] && g.length(k) < least)
            diagnostics.error(
                resolution.where,
                fmt::format("the domain's periodic length {:.4g} m along {} is less than the kernel support and a spacing, {:.4g} m",
                            g.length(k), coordinateNames[k], least));
    }
    if (diagnostics.errors() > before) diagnostics.throwIfAny();
}

double WallLoad::at(double t) const { return numberAt(force, t, "a force"); }

void readLoad(const Dictionary& wall, WallProperties& properties, int dimension)
{
    if (!entry::load.given(wall)) return;
    const auto d = entry::load(wall);
    WallLoad load{entry::force(d), entry::direction(d), entry::mass(d), entry::loadDamping(d)};
    entry::direction.checkPlane(d, load.direction, dimension);
    if (mag(load.direction) > 0) load.direction = load.direction / mag(load.direction);
    else entry::direction.error(d, "the direction must not be (0 0 0)");
    if (mag(properties.velocity) > 0) entry::load.error(wall, "a wall goes by its velocity or by its load: leave out the one or the other");
    try
    {
        if (!load.force.empty()) load.at(0);
    }
    catch (const ExpressionError& e)
    {
        entry::force.error(d, fmt::format("\"{}\": {}", load.force, e.what()));
    }
    properties.load = load;
}

WallProperties readWallProperties(const Dictionary& dict, int dimension, bool mayTurn)
{
    WallProperties wall;
    wall.name = dict.keyword();
    wall.where = dict.location();
    const bool one = entry::contactAngle.given(dict), pairs = entry::contactAngles.given(dict);
    wall.wets = one || pairs;
    wall.contactAngle = entry::contactAngle(dict, wall.contactAngle);
    for (const auto& [first, second, angle] : entry::contactAngles(dict)) wall.contactAngles.push_back({first, second, angle});
    if (one && pairs)
        entry::contactAngles.error(dict, "contactAngle and contactAngles say the same of a wall: leave out the one or the other");
    if (wall.wets) wall.anglesAt = one ? entry::contactAngle.where(dict) : entry::contactAngles.where(dict);
    wall.velocity = entry::velocity(dict);
    entry::velocity.checkPlane(dict, wall.velocity, dimension);
    wall.slips = entry::slip(dict);
    if (entry::frictionAngle.given(dict))
    {
        wall.frictionAngle = entry::frictionAngle.needed(dict);
        if (wall.slips) entry::frictionAngle.error(dict, "a wall with `slip yes;` has no friction: leave out the one or the other");
    }
    if (mayTurn)
    {
        wall.omega = entry::omega(dict);
        wall.origin = entry::origin(dict);
        if (entry::origin.given(dict) && !entry::omega.given(dict))
            entry::origin.error(dict, "does nothing without omega: the wall does not turn. Give omega, or leave origin out");
        if (dimension == 2 && (wall.omega.x != 0 || wall.omega.y != 0))
            entry::omega.error(dict,
                               fmt::format("in 2-D a wall turns about z: the x and y components of \"omega\" must be 0, found {} and {}",
                                           wall.omega.x, wall.omega.y));
    }
    return wall;
}

std::optional<double> WallProperties::angleOf(const std::string& first, const std::string& second) const
{
    for (const auto& pair : contactAngles)
        if (pair.first == first && pair.second == second) return pair.angle;
        else if (pair.first == second && pair.second == first) return 180 - pair.angle;
    return {};
}

EntryList geometryEntries()
{
    auto types = shapes();
    for (auto& [type, entries] : types)
    {
        if (isSingleShape(type.word)) entries += {entry::omega, entry::origin};
        if (type.word == "triSurface")
            entries += triSurfaceEntries({entry::contactAngle, entry::contactAngles, entry::velocity, entry::omega, entry::origin,
                                          entry::slip, entry::frictionAngle});
    }
    return {entry::dimension,
            {entry::domain, {entry::min, entry::max, entry::periodic}},
            {entry::walls,
             {{entry::wall,
               {{shapeType(), types},
                entry::contactAngle,
                entry::contactAngles,
                entry::velocity,
                {entry::load, {entry::force, entry::direction, entry::mass, entry::loadDamping}},
                entry::slip,
                entry::frictionAngle}}}}};
}

namespace
{

/// The wall itself, and one for each region of its mesh that has properties of its own: "<wall>.<region>".
void readMeshWall(const Dictionary& dict, Geometry& g)
{
    const auto name = dict.keyword();
    readTriSurface(dict); // meshToGhost acts on it
    const auto whole = readWallProperties(dict, g.dimension, true);
    const int base = int(g.walls.size());
    g.walls.push_back(whole);
    const auto own = regionsOf(dict);
    for (const auto& region : own)
    {
        auto wall = readWallProperties(region, g.dimension, true);
        wall.name = name + "." + region.keyword();
        // A region that states neither slip nor friction has those of the rest of the mesh.
        if (!entry::slip.given(region) && !wall.frictionAngle)
        {
            wall.slips = whole.slips;
            wall.frictionAngle = whole.frictionAngle;
        }
        if (!wall.wets)
        {
            wall.wets = whole.wets;
            wall.contactAngle = whole.contactAngle;
            wall.contactAngles = whole.contactAngles;
            wall.anglesAt = whole.anglesAt;
        }
        g.walls.push_back(wall);
    }
    if (g.dimension == 2)
        return shapeType().error(dict, "a mesh is a surface in space, and a 2-D scene does not vary with z: use planes and circles");
    const auto mesh = readMesh(name, g, dict.diagnostics());
    if (!mesh) return;
    std::vector ofRegions(mesh->regions.size(), base);
    for (std::size_t k = 0; k < own.size(); ++k)
    {
        const auto found = std::ranges::find(mesh->regions, own[k].keyword());
        if (found != mesh->regions.end()) ofRegions[std::size_t(found - mesh->regions.begin())] = base + 1 + int(k);
        else
            dict.error("regions", fmt::format("region \"{}\" is unknown. {}", own[k].keyword(),
                                              suggestion(own[k].keyword(), "regions of this mesh", mesh->regions)));
    }
    addBodies(*mesh, base, ofRegions, g);
}

void readWallsAndRepeat(const Dictionary& dict, Geometry& g)
{
    const auto walls = entry::walls(dict);
    for (const auto& name : walls.keys())
    {
        if (!walls.isDictionary(name))
        {
            walls.error(name, fmt::format("wall \"{0}\" must be a dictionary: {0} {{ type plane; ... }}", name));
            continue;
        }
        const auto wall = walls.subDict(name);
        if (isMesh(wall))
        {
            readMeshWall(wall, g);
            continue;
        }
        auto shapes = readShapes(wall, g);
        g.walls.push_back(readWallProperties(wall, g.dimension, isSingleShape(wall)));
        readLoad(wall, g.walls.back(), g.dimension);
        for (auto& shape : shapes) g.originals.push_back({std::move(shape), int(g.walls.size()) - 1});
    }
    repeatPeriodically(g, g.reach);
}
}

Geometry readGeometry(const Dictionary& dict, double reach)
{
    Geometry g;
    g.reach = reach;
    g.facetScale = {reach / 3, reach};
    readSpace(dict, g);
    readWallsAndRepeat(dict, g);
    return g;
}

Geometry readGeometry(const Dictionary& dict, const Resolution& resolution, double supports, const std::filesystem::path& folder)
{
    Geometry g;
    g.reach = supports * resolution.H();
    g.folder = folder;
    g.facetScale = {resolution.spacing, resolution.H()};
    readSpace(dict, g);
    checkFit(g, resolution, dict.diagnostics());
    readWallsAndRepeat(dict, g);
    return g;
}

}
