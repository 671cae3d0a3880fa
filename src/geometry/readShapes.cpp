#include "geometry/readShapes.hpp"
#include "base/readText.hpp"
#include "geometry/Cone.hpp"
#include "geometry/Cylinder.hpp"
#include "geometry/Ellipsoid.hpp"
#include "geometry/Plane.hpp"
#include "geometry/ShapeOfRow.hpp"
#include "geometry/SolidBox.hpp"
#include "geometry/Sphere.hpp"
#include "geometry/Torus.hpp"
#include "geometry/TriangleMesh.hpp"
#include "geometry/components.hpp"
#include "geometry/sphereTable.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Choice fluid{"fluid", {"inside", "outside"}, required, "side of the surface on which the fluid is"};
const VectorParameter point{"point", units::m, required, "a point of the plane or of the axis"},
    centre{"centre", units::m, required, "of the shape"}, apex{"apex", units::m, required, "tip of the cone"},
    semiAxes{"semiAxes", units::m, required, "along x, y and z, each > 0"}, boxMin{"min", units::m, required, "lowest corner"},
    boxMax{"max", units::m, required, "highest corner"},
    latticeOrigin{"origin", units::m, byScene("the lowest corner of the domain"), "where a cell of the lattice begins"};
const Direction normal{"normal", required, "into the fluid"},
    axis{"axis", required, "along the axis; of a cylinder in 2-D (0 0 1), which is its default there"};
const Scalar radius{"radius", units::m, required, positive, "of the shape, or of each sphere"},
    halfAngle{"halfAngle", degrees, required, positiveBelow(90).saying("halfAngle must be between 0 and 90 degrees, not {}"),
              "between axis and surface"},
    ringRadius{"ringRadius", units::m, required, positive, "of the circle in the middle of the tube"},
    tubeRadius{"tubeRadius", units::m, required, positive, "of the tube, less than ringRadius"},
    period{"period", units::m, required, positive, "edge of the lattice's cubic cell, of hcp the distance of neighbours"};
const Word lattice{"lattice", required, "sc, bcc, fcc or hcp; in 2-D sc or hcp"};
const ListOf<std::vector<double>> spheres{"spheres", units::m, notGiven, "(x y z radius) of each"};
const FileName file{"file", "constant", notGiven,
                    "in constant/: a table of x, y, z and r or d, with commas or blanks, in place of `spheres`"};
const Scalar scale{"scale", units::none, 1.0, positive, "of the file's lengths to m: 1e-3 for mm"};
const VectorParameter translation{"translation", units::m, Vector<3>{}, "of the file's spheres, after scaling"};
}

namespace
{

using Shapes = std::vector<std::shared_ptr<const Shape>>;

/// Steps between a domain's length and a whole number of cells that are taken for rounding in the dictionary.
constexpr double rounding = 1e-6;

FluidSide fluidSide(const Dictionary& wall) { return entry::fluid(wall) == "inside" ? FluidSide::inside : FluidSide::outside; }

Shapes plane(const Dictionary& wall, const Geometry& g)
{
    const auto point = entry::point(wall);
    const auto normal = entry::normal.asGiven(wall);
    entry::normal.checkPlane(wall, normal, g.dimension);
    return {std::make_shared<Plane>(point, normal)};
}

/// A round body of the 3-D scene, or the circle of a 2-D scene.
std::shared_ptr<const Shape> ball(const Vector<3>& centre, double radius, FluidSide fluid, const Geometry& g)
{
    if (g.dimension == 3) return std::make_shared<Sphere>(centre, radius, fluid);
    return std::make_shared<Cylinder>(Vector<3>{centre.x, centre.y, 0}, Vector<3>{0, 0, 1}, radius, fluid);
}

/// The ball of a row of a table.
std::shared_ptr<const Shape> ballOfRow(const TableRow& row, const Vector<3>& centre, double radius, const Geometry& g)
{
    constexpr auto fluid = FluidSide::outside;
    if (g.dimension == 3) return std::make_shared<ShapeOfRow<Sphere>>(Sphere(centre, radius, fluid), row);
    return std::make_shared<ShapeOfRow<Cylinder>>(Cylinder({centre.x, centre.y, 0}, {0, 0, 1}, radius, fluid), row);
}

Shapes sphere(const Dictionary& wall, const Geometry& g)
{
    const auto centre = entry::centre(wall);
    const double radius = entry::radius(wall);
    return {ball(centre, radius, fluidSide(wall), g)};
}

Shapes cylinder(const Dictionary& wall, const Geometry& g)
{
    const auto point = entry::point(wall);
    const bool axisGiven = g.dimension == 3 || entry::axis.given(wall);
    const auto axis = axisGiven ? entry::axis.asGiven(wall) : Vector<3>{0, 0, 1};
    if (g.dimension == 2 && (axis.x != 0 || axis.y != 0)) entry::axis.error(wall, "in 2-D the axis of a cylinder must be (0 0 1)");
    const double radius = entry::radius(wall);
    return {std::make_shared<Cylinder>(point, axis, radius, fluidSide(wall))};
}

void refuse2D(const Dictionary& wall, const Geometry& g, const std::string& instead)
{
    if (g.dimension == 2) shapeType().error(wall, fmt::format("a {} varies with z, a 2-D scene does not: {}", shapeType()(wall), instead));
}

Shapes cone(const Dictionary& wall, const Geometry& g)
{
    refuse2D(wall, g, "use two planes");
    const auto apex = entry::apex(wall);
    const auto axis = entry::axis.asGiven(wall);
    const double halfAngle = entry::halfAngle(wall);
    return {std::make_shared<Cone>(apex, axis, halfAngle, fluidSide(wall))};
}

Shapes torus(const Dictionary& wall, const Geometry& g)
{
    refuse2D(wall, g, "use circles (type sphere)");
    const auto centre = entry::centre(wall);
    const auto axis = entry::axis.asGiven(wall);
    const double ring = entry::ringRadius(wall), tube = entry::tubeRadius(wall);
    if (entry::ringRadius.given(wall) && entry::tubeRadius.given(wall) && tube >= ring)
        entry::tubeRadius.error(wall, fmt::format("tubeRadius {} must be smaller than ringRadius {}", tube, ring));
    return {std::make_shared<Torus>(centre, axis, ring, tube, fluidSide(wall))};
}

Shapes ellipsoid(const Dictionary& wall, const Geometry& g)
{
    const auto centre = entry::centre(wall);
    auto semiAxes = entry::semiAxes(wall);
    if (g.dimension == 2) semiAxes.z = Box::infinity;
    if (entry::semiAxes.given(wall) && !(semiAxes.x > 0 && semiAxes.y > 0 && semiAxes.z > 0))
        entry::semiAxes.error(wall, "each of the semiAxes must be > 0");
    return {std::make_shared<Ellipsoid>(centre, semiAxes, fluidSide(wall))};
}

Shapes box(const Dictionary& wall, const Geometry& g)
{
    auto low = entry::boxMin(wall), high = entry::boxMax(wall);
    const bool given = entry::boxMin.given(wall) && entry::boxMax.given(wall);
    for (int k = 0; k < g.dimension && given; ++k)
        if (!(high.*component(k) > low.*component(k)))
            entry::boxMax.error(wall, fmt::format("max must be greater than min; in {} it is {} against {}", coordinateNames[k],
                                                  high.*component(k), low.*component(k)));
    // Along these the box does not end: z in 2-D, and periodic directions through which it passes.
    std::array<bool, 3> endless{false, false, g.dimension == 2};
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        const double slack = rounding * g.length(k);
        if (g.periodic[k] && low.*c <= g.low.*c + slack && high.*c >= g.high.*c - slack) endless[k] = true;
    }

    Shapes shapes;
    if (fluidSide(wall) == FluidSide::inside)
    {
        for (int k = 0; k < 3; ++k)
        {
            if (endless[k]) continue;
            Vector<3> normal;
            normal.*component(k) = 1;
            shapes.push_back(std::make_shared<Plane>(low, normal));
            shapes.push_back(std::make_shared<Plane>(high, -normal));
        }
        if (shapes.empty()) entry::boxMax.error(wall, "the box lies outside the domain in every direction: there is no wall");
        return shapes;
    }
    for (int k = 0; k < 3; ++k)
        if (endless[k])
        {
            low.*component(k) = -Box::infinity;
            high.*component(k) = Box::infinity;
        }
    if (endless[0] && endless[1] && endless[2]) entry::boxMax.error(wall, "the box fills the domain: there is no fluid");
    return {std::make_shared<SolidBox>(low, high)};
}

Shapes sphereBed(const Dictionary& wall, const Geometry& g)
{
    static const std::vector<std::string> lattices{"sc", "bcc", "fcc", "hcp"}, flatLattices{"sc", "hcp"};
    const auto name = entry::lattice.among(wall, g.dimension == 2 ? flatLattices : lattices);
    const double radius = entry::radius(wall), period = entry::period(wall);
    const auto origin = entry::latticeOrigin(wall, g.low);
    if (!(radius > 0 && period > 0) || std::find(lattices.begin(), lattices.end(), name) == lattices.end()) return {};

    auto lattice = sphereLattice(name, period);
    if (g.dimension == 2) std::erase_if(lattice.centres, [](const Vector<3>& c) { return c.z != 0; });
    std::array<int, 3> first{}, last{};
    Vector<3> stretch{1, 1, 1}; // takes out the rounding of the domain's length
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        const double L = g.length(k), cells = std::round(L / (lattice.period.*c));
        if (g.periodic[k])
        {
            if (cells < 1 || std::abs(cells * (lattice.period.*c) - L) > rounding * L)
                entry::period.error(wall,
                                    fmt::format("the domain repeats in {0} after {1:.9g} m, which is not a whole number of cells of the "
                                                "{2} lattice ({3:.9g} m each): make it {4:.9g} m",
                                                coordinateNames[k], L, name, lattice.period.*c,
                                                std::max(1.0, cells) * (lattice.period.*c)));
            else stretch.*c = L / (cells * (lattice.period.*c));
            first[k] = 0;
            last[k] = int(cells) - 1;
        }
        else
        {
            first[k] = int(std::floor((g.low.*c - origin.*c - radius - g.reach) / (lattice.period.*c))) - 1;
            last[k] = int(std::ceil((g.high.*c - origin.*c + radius + g.reach) / (lattice.period.*c)));
        }
    }
    if (double(last[0] - first[0] + 1) * (last[1] - first[1] + 1) * (last[2] - first[2] + 1) > 1e7)
    {
        entry::period.error(wall, fmt::format("a period of {} m makes more than ten million spheres in this domain", period));
        return {};
    }

    Shapes shapes;
    for (int l = first[2]; l <= last[2]; ++l)
        for (int k = first[1]; k <= last[1]; ++k)
            for (int i = first[0]; i <= last[0]; ++i)
                for (const auto& inCell : lattice.centres)
                {
                    const auto x = inCell + Vector<3>{i * lattice.period.x, k * lattice.period.y, l * lattice.period.z};
                    const Vector<3> centre = origin + Vector<3>{stretch.x * x.x, stretch.y * x.y, stretch.z * x.z};
                    bool near = true;
                    for (int d = 0; d < g.dimension; ++d)
                        near = near && (g.periodic[d] || (centre.*component(d) + radius >= g.low.*component(d) - g.reach &&
                                                          centre.*component(d) - radius <= g.high.*component(d) + g.reach));
                    if (near) shapes.push_back(ball(centre, radius, FluidSide::outside, g));
                }
    return shapes;
}

/// The spheres of a table on disk. Where they, and the way to them, take hundreds of times the extent of the domain they are refused: as a rule it is their unit.
Shapes spheresOfFile(const Dictionary& wall, const Geometry& g)
{
    const std::string file = "constant/" + entry::file.needed(wall);
    std::string reason;
    const auto text = readText(g.folder / file, reason);
    if (!text)
    {
        entry::file.error(wall, fmt::format("cannot read {}: {}", file, reason));
        return {};
    }
    const double scale = entry::scale(wall);
    const auto shift = entry::translation(wall);
    Shapes shapes;
    Box bounds{{Box::infinity, Box::infinity, Box::infinity}, {-Box::infinity, -Box::infinity, -Box::infinity}};
    for (const auto& [centre, radius, line] : spheresInTable(*text, file, wall.diagnostics()))
    {
        shapes.push_back(ballOfRow({file, line}, scale * centre + shift, scale * radius, g));
        const auto b = shapes.back()->bounds();
        for (int k = 0; k < g.dimension; ++k)
        {
            const auto c = component(k);
            bounds.low.*c = std::min(bounds.low.*c, b.low.*c);
            bounds.high.*c = std::max(bounds.high.*c, b.high.*c);
        }
    }
    double largest = 0; // extent of spheres and domain over that of the domain
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        largest = std::max(largest, (std::max(bounds.high.*c, g.high.*c) - std::min(bounds.low.*c, g.low.*c)) / g.length(k));
    }
    const double ofMillimetres = 300;
    if (largest > ofMillimetres)
        entry::file.error(wall, fmt::format("the spheres of {} reach over {:.3g} times the extent of the domain{}", file, largest,
                                            entry::scale.given(wall) ? ": see scale" : ": are they in mm? Then `scale 1e-3;`"));
    return shapes;
}

Shapes spheres(const Dictionary& wall, const Geometry& g)
{
    if (entry::spheres.given(wall) == entry::file.given(wall))
    {
        wall.error("type", "a bed of `type spheres` has either a list `spheres` or a `file`");
        return {};
    }
    if (entry::file.given(wall)) return spheresOfFile(wall, g);
    const auto rows = entry::spheres.needed(wall);
    Shapes shapes;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const auto& row = rows[i];
        if (row.size() != 4)
            entry::spheres.error(wall, fmt::format("sphere {} has {} numbers; each must be (x y z radius)", i + 1, row.size()));
        else if (!(row[3] > 0)) entry::spheres.error(wall, fmt::format("sphere {} has the radius {}; it must be > 0", i + 1, row[3]));
        else shapes.push_back(ballOfRow({"", int(i) + 1}, {row[0], row[1], row[2]}, row[3], g));
    }
    if (rows.empty()) entry::spheres.error(wall, "there are no spheres in the list");
    return shapes;
}

/// Read by readMesh, with its regions.
Shapes triSurface(const Dictionary&, const Geometry&) { return {}; }

/// A surface that ends the fluid cannot have a copy of itself beside it.
void checkPeriodicity(const Dictionary& wall, const Geometry& g, const Shape& shape)
{
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        const auto b = shape.bounds();
        if (!g.periodic[k] || shape.invariantAlong(k)) continue;
        if (shape.enclosesFluid())
            shapeType().error(wall,
                              fmt::format("the fluid ends at this wall, so that the domain cannot be periodic in {}", coordinateNames[k]));
        else if (std::isinf(b.low.*c) || std::isinf(b.high.*c))
            shapeType().error(wall, fmt::format("a {} that does not end, oblique to the periodic direction {}, does not repeat there",
                                                shape.description().type, coordinateNames[k]));
    }
}

}

namespace
{

struct ShapeType
{
    ChoiceWord name;
    Shapes (*read)(const Dictionary&, const Geometry&);
    EntryList entries;
};

const std::vector<ShapeType>& catalogue()
{
    using namespace entry;
    static const std::vector<ShapeType> types{
        {{"plane", ""}, plane, {point, entry::normal}},
        {{"box", "with the fluid inside: planes, but none across a periodic direction that it spans"},
         box,
         {entry::boxMin, entry::boxMax, fluid}},
        {{"sphere", "in 2-D a circle"}, sphere, {centre, radius, fluid}},
        {{"cylinder", "without ends"}, cylinder, {point, axis, radius, fluid}},
        {{"cone", "one nappe, without end; in 3-D"}, cone, {apex, axis, halfAngle, fluid}},
        {{"torus", "in 3-D"}, torus, {centre, axis, ringRadius, tubeRadius, fluid}},
        {{"ellipsoid", "axes along x, y and z; in 2-D an ellipse"}, ellipsoid, {centre, semiAxes, fluid}},
        {{"sphereBed", "equal spheres in the fluid, on all points of a lattice"}, sphereBed, {lattice, radius, period, latticeOrigin}},
        {{"spheres", "spheres in the fluid, one by one, as from a table"},
         spheres,
         {entry::spheres, entry::file, entry::scale, entry::translation}},
        {{"triSurface", "a closed surface of triangles from a file; in 3-D"}, triSurface, {}}};
    return types;
}

}

std::optional<WallMesh> readMesh(const std::string& wall, const Geometry& g, Diagnostics& diagnostics)
{
    const auto before = diagnostics.errors();
    const auto surface = readWallMesh(g.folder, wall, diagnostics);
    if (diagnostics.errors() != before) return {};
    WallMesh mesh{surface.regions, {}};
    for (auto& body : bodiesOf(surface, g.facetScale)) mesh.bodies.push_back(std::make_shared<TriangleMesh>(std::move(body)));
    return mesh;
}

void addBodies(const WallMesh& mesh, int wall, const std::vector<int>& walls, Geometry& g)
{
    for (const auto& body : mesh.bodies) g.originals.push_back({body, wall, walls});
}

bool isMesh(const Dictionary& wall) { return shapeType().is(wall, "triSurface"); }

std::vector<Dictionary> meshWalls(const Dictionary& geometry)
{
    const auto walls = geometry.subDictOrEmpty("walls");
    std::vector<Dictionary> meshes;
    for (const auto& name : walls.keys())
        if (walls.isDictionary(name) && isMesh(walls.subDict(name))) meshes.push_back(walls.subDict(name));
    return meshes;
}

bool isSingleShape(const std::string& type) { return type != "sphereBed" && type != "spheres"; }

bool isSingleShape(const Dictionary& wall) { return !shapeType().is(wall, "sphereBed") && !shapeType().is(wall, "spheres"); }

Cases shapes()
{
    Cases all;
    for (const auto& type : catalogue()) all.push_back({type.name, type.entries});
    return all;
}

const Choice& shapeType()
{
    static const Choice type{"type", wordsOf(shapes()), required, "shape of the wall"};
    return type;
}

double bedPeriod(const Dictionary& geometry)
{
    const auto walls = geometry.subDictOrEmpty("walls");
    for (const auto& name : walls.keys())
        if (walls.isDictionary(name))
            if (const auto wall = walls.subDict(name); shapeType().is(wall, "sphereBed")) return entry::period(wall, 0);
    return 0;
}

std::vector<std::shared_ptr<const Shape>> readShapes(const Dictionary& wall, const Geometry& g)
{
    const auto before = wall.diagnostics().errors();
    const auto type = shapeType().known(wall);
    if (!type && shapeType().is(wall, "slip"))
        shapeType().error(wall, "`type` of a wall is its shape; one that the fluid slides along has a shape and `slip yes;`");
    if (!type) return {};
    auto shapes = catalogue()[std::size_t(shapeType().indexOf(*type))].read(wall, g);
    if (wall.diagnostics().errors() != before) return {};
    for (const auto& shape : shapes) checkPeriodicity(wall, g, *shape);
    return wall.diagnostics().errors() == before ? shapes : Shapes{};
}

}
