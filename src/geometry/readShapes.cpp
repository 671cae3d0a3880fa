#include "readShapes.hpp"
#include "Cone.hpp"
#include "Cylinder.hpp"
#include "Ellipsoid.hpp"
#include "Plane.hpp"
#include "SolidBox.hpp"
#include "Sphere.hpp"
#include "Torus.hpp"
#include "components.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace sph
{

namespace
{

using Shapes = std::vector<std::shared_ptr<const Shape>>;

/// Steps between a domain's length and a whole number of cells that are taken for rounding in the dictionary.
constexpr double rounding = 1e-6;

FluidSide fluidSide(const Dictionary& wall)
{
    static const std::vector<std::string> sides{"inside", "outside"};
    return wall.choose("fluid", sides) == "inside" ? FluidSide::inside : FluidSide::outside;
}

Vector<3> direction(const Dictionary& wall, const std::string& key)
{
    const auto d = wall.getVector(key, units::none);
    if (mag(d) > 0) return d;
    if (wall.found(key)) wall.error(key, fmt::format("{} must have a direction, not (0 0 0)", key));
    return {1, 0, 0};
}

Shapes plane(const Dictionary& wall, const Geometry& g)
{
    const auto point = wall.getVector("point", units::m);
    const auto normal = direction(wall, "normal");
    if (g.dimension == 2 && normal.z != 0) wall.error("normal", "in 2-D the z component of a normal must be 0");
    return {std::make_shared<Plane>(point, normal)};
}

/// A round body of the 3-D scene, or the circle of a 2-D scene.
std::shared_ptr<const Shape> ball(const Vector<3>& centre, double radius, FluidSide fluid, const Geometry& g)
{
    if (g.dimension == 3) return std::make_shared<Sphere>(centre, radius, fluid);
    return std::make_shared<Cylinder>(Vector<3>{centre.x, centre.y, 0}, Vector<3>{0, 0, 1}, radius, fluid);
}

Shapes sphere(const Dictionary& wall, const Geometry& g)
{
    const auto centre = wall.getVector("centre", units::m);
    const double radius = wall.getPositive("radius", units::m);
    return {ball(centre, radius, fluidSide(wall), g)};
}

Shapes cylinder(const Dictionary& wall, const Geometry& g)
{
    const auto point = wall.getVector("point", units::m);
    const bool axisGiven = g.dimension == 3 || wall.found("axis");
    const auto axis = axisGiven ? direction(wall, "axis") : Vector<3>{0, 0, 1};
    if (g.dimension == 2 && (axis.x != 0 || axis.y != 0)) wall.error("axis", "in 2-D the axis of a cylinder must be (0 0 1)");
    const double radius = wall.getPositive("radius", units::m);
    return {std::make_shared<Cylinder>(point, axis, radius, fluidSide(wall))};
}

void refuse2D(const Dictionary& wall, const Geometry& g, const std::string& instead)
{
    if (g.dimension == 2)
        wall.error("type", fmt::format("a {} varies with z, a 2-D scene does not: {}", wall.get<std::string>("type"), instead));
}

Shapes cone(const Dictionary& wall, const Geometry& g)
{
    refuse2D(wall, g, "use two planes");
    const auto apex = wall.getVector("apex", units::m);
    const auto axis = direction(wall, "axis");
    const double halfAngle = wall.getPositive("halfAngle", units::none);
    if (halfAngle >= 90) wall.error("halfAngle", fmt::format("halfAngle must be between 0 and 90 degrees, not {}", halfAngle));
    return {std::make_shared<Cone>(apex, axis, halfAngle, fluidSide(wall))};
}

Shapes torus(const Dictionary& wall, const Geometry& g)
{
    refuse2D(wall, g, "use circles (type sphere)");
    const auto centre = wall.getVector("centre", units::m);
    const auto axis = direction(wall, "axis");
    const double ring = wall.getPositive("ringRadius", units::m), tube = wall.getPositive("tubeRadius", units::m);
    if (wall.found("ringRadius") && wall.found("tubeRadius") && tube >= ring)
        wall.error("tubeRadius", fmt::format("tubeRadius {} must be smaller than ringRadius {}", tube, ring));
    return {std::make_shared<Torus>(centre, axis, ring, tube, fluidSide(wall))};
}

Shapes ellipsoid(const Dictionary& wall, const Geometry& g)
{
    const auto centre = wall.getVector("centre", units::m);
    auto semiAxes = wall.getVector("semiAxes", units::m);
    if (g.dimension == 2) semiAxes.z = Box::infinity;
    if (wall.found("semiAxes") && !(semiAxes.x > 0 && semiAxes.y > 0 && semiAxes.z > 0))
        wall.error("semiAxes", "each of the semiAxes must be > 0");
    return {std::make_shared<Ellipsoid>(centre, semiAxes, fluidSide(wall))};
}

Shapes box(const Dictionary& wall, const Geometry& g)
{
    auto low = wall.getVector("min", units::m), high = wall.getVector("max", units::m);
    const bool given = wall.found("min") && wall.found("max");
    for (int k = 0; k < g.dimension && given; ++k)
        if (!(high.*component(k) > low.*component(k)))
            wall.error("max", fmt::format("max must be greater than min; in {} it is {} against {}", coordinateNames[k],
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
        if (shapes.empty()) wall.error("max", "the box lies outside the domain in every direction: there is no wall");
        return shapes;
    }
    for (int k = 0; k < 3; ++k)
        if (endless[k])
        {
            low.*component(k) = -Box::infinity;
            high.*component(k) = Box::infinity;
        }
    if (endless[0] && endless[1] && endless[2]) wall.error("max", "the box fills the domain: there is no fluid");
    return {std::make_shared<SolidBox>(low, high)};
}

Shapes sphereBed(const Dictionary& wall, const Geometry& g)
{
    static const std::vector<std::string> lattices{"sc", "bcc", "fcc", "hcp"}, flatLattices{"sc", "hcp"};
    const auto name = wall.choose("lattice", g.dimension == 2 ? flatLattices : lattices);
    const double radius = wall.getPositive("radius", units::m), period = wall.getPositive("period", units::m);
    const auto origin = wall.getVector("origin", units::m, g.low);
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
                wall.error("period",
                           fmt::format("the domain repeats in {0} after {1:.9g} m, which is not a whole number of cells of the "
                                       "{2} lattice ({3:.9g} m each): make it {4:.9g} m",
                                       coordinateNames[k], L, name, lattice.period.*c,
                                       std::max(1.0, cells) * (lattice.period.*c)));
            else
                stretch.*c = L / (cells * (lattice.period.*c));
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
        wall.error("period", fmt::format("a period of {} m makes more than ten million spheres in this domain", period));
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

Shapes spheres(const Dictionary& wall, const Geometry& g)
{
    const auto rows = wall.get<std::vector<std::vector<double>>>("spheres");
    Shapes shapes;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const auto& row = rows[i];
        if (row.size() != 4)
            wall.error("spheres", fmt::format("sphere {} has {} numbers; each must be (x y z radius)", i + 1, row.size()));
        else if (!(row[3] > 0))
            wall.error("spheres", fmt::format("sphere {} has the radius {}; it must be > 0", i + 1, row[3]));
        else
            shapes.push_back(ball({row[0], row[1], row[2]}, row[3], FluidSide::outside, g));
    }
    if (rows.empty() && wall.found("spheres")) wall.error("spheres", "there are no spheres in the list");
    return shapes;
}

/// A surface that ends the fluid cannot have a copy of itself beside it.
void checkPeriodicity(const Dictionary& wall, const Geometry& g, const Shape& shape)
{
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        const auto b = shape.bounds();
        if (!g.periodic[k] || shape.invariantAlong(k)) continue;
        if (shape.enclosesFluid())
            wall.error("type", fmt::format("the fluid ends at this wall, so that the domain cannot be periodic in {}",
                                           coordinateNames[k]));
        else if (std::isinf(b.low.*c) || std::isinf(b.high.*c))
            wall.error("type", fmt::format("a {} that does not end, oblique to the periodic direction {}, does not repeat there",
                                           shape.description().type, coordinateNames[k]));
    }
}

}

bool isSingleShape(const std::string& type) { return type != "sphereBed" && type != "spheres"; }

std::vector<std::shared_ptr<const Shape>> readShapes(const Dictionary& wall, const Geometry& g)
{
    using Reader = Shapes (*)(const Dictionary&, const Geometry&);
    static const std::map<std::string, Reader> readers{
        {"plane", plane},    {"box", box},     {"sphere", sphere},       {"cylinder", cylinder},
        {"cone", cone},      {"torus", torus}, {"ellipsoid", ellipsoid}, {"sphereBed", sphereBed},
        {"spheres", spheres}};
    static const std::vector<std::string> types{"plane", "box",       "sphere",    "cylinder", "cone",
                                                "torus", "ellipsoid", "sphereBed", "spheres"};

    const auto before = wall.diagnostics().errors();
    const auto type = wall.choose("type", types);
    if (wall.diagnostics().errors() != before)
    {
        for (const auto& key : wall.keys()) wall.ignore(key); // which entries belong here is not known
        return {};
    }
    auto shapes = readers.at(type)(wall, g);
    if (wall.diagnostics().errors() != before) return {};
    for (const auto& shape : shapes) checkPeriodicity(wall, g, *shape);
    return wall.diagnostics().errors() == before ? shapes : std::vector<std::shared_ptr<const Shape>>{};
}

}
