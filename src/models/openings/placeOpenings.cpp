#include "base/CaseError.hpp"
#include "geometry/components.hpp"
#include "geometry/forEachFoot.hpp"
#include "models/openings/PlacedOpening.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{
/// The plane that an opening is a part of, with all its parts: that from which it is cut out, or its own without the others; of a drip that is cut out of none,
/// all of the duct. None where the opening stands alone.
std::optional<OpenPlane> planeOf(const Opening& opening, const std::vector<Opening>& all)
{
    const auto host = std::ranges::find_if(all, [&](const Opening& other) { return other.leavesOut(opening); });
    if (host == all.end() && opening.without.empty() && !opening.radius) return {};
    OpenPlane plane = host == all.end() ? opening : *host;
    plane.point = opening.point;
    plane.without.clear();
    plane.radius.reset();
    return plane;
}

/// The rate that an inlet is to let in [m^3/s]; none where a pressure alone drives it.
std::optional<double> rateOf(const Opening& opening, const Section& section)
{
    if (opening.flowRate) return opening.flowRate;
    if (opening.velocity) return *opening.velocity * section.area();
    return {};
}

/// Rest density of the incoming fluid, the mean over the section [kg/m^3].
double densityOf(const Opening& opening, const Section& section, const Coefficients& c)
{
    const auto& rho = c.restDensity;
    if (opening.layers.empty()) return rho[opening.stream.phase];
    double sum = 0;
    for (const auto& line : section.lines()) sum += rho[opening.streamAt(line.foot, c.dimension).phase];
    return sum / double(section.lines().size());
}

/// Whether a point lies in the domain, or within `beyond` of it.
bool inDomain(const OpenScene& scene, const Vector<3>& x, double beyond)
{
    const auto& geometry = scene.geometry;
    for (int k = 0; k < scene.coefficients.dimension; ++k)
        if (const auto c = component(k); !geometry.periodic[k] && (x.*c < geometry.low.*c - beyond || x.*c > geometry.high.*c + beyond))
            return false;
    return true;
}

[[noreturn]] void fail(const Opening& opening, const std::string& what)
{
    throw CaseError(opening.where, fmt::format("opening \"{}\" {}", opening.name, what));
}

std::string text(const Vector<3>& a) { return fmt::format("({:.4g} {:.4g} {:.4g})", a.x, a.y, a.z); }

/// Least distance of a line from walls [spacings]. Lines that are moved are held 0.2 off walls (packing/Relaxation.cpp), to round-off.
constexpr double leastFromWalls = 0.19;

/// Whether a straight duct of the section leads from the plane out of the domain, before the plane, and with no other opening on the way, or beyond it.
bool leadsOut(const Opening& opening, bool before, const Section& section, const std::vector<Opening>& all, const OpenScene& scene)
{
    constexpr std::size_t looked = 100; // lines
    constexpr double straight = 0.1;    // change of the distance from walls along a line of a straight duct [spacings]
    const double spacing = scene.coefficients.spacing;
    const auto& lines = section.lines();
    for (std::size_t k = 0; k < lines.size(); k += 1 + lines.size() / looked)
    {
        const auto& foot = lines[k].foot;
        const double fromWalls = scene.geometry.distance(foot);
        for (double s = spacing;; s += spacing)
        {
            const auto x = foot + (before ? s : -s) * opening.normal;
            if (!inDomain(scene, x, 0)) break;
            if (std::abs(scene.geometry.distance(x) - fromWalls) > straight * spacing) return false;
            for (const auto& other : all)
                if (before && &other != &opening && other.distance(x) < 0 && other.faces(x, scene.coefficients.dimension)) return false;
        }
    }
    return true;
}

/// An opening has a duct beyond its plane that leads out of the domain: where there is one before the plane alone, the normal points the wrong way.
void checkSide(const Opening& opening, const Section& section, const std::vector<Opening>& all, const OpenScene& scene)
{
    if (section.lines().empty() || !leadsOut(opening, true, section, all, scene) || leadsOut(opening, false, section, all, scene)) return;
    fail(opening,
         fmt::format("has the normal {}, which points out of the scene: before the plane a straight duct leads out of the domain, and "
                     "beyond it none does. It must point into the scene: {}",
                     text(opening.normal), text(Vector<3>{} - opening.normal)));
}

void checkDuct(const Opening& opening, const Section& section, const OpenScene& scene)
{
    const auto& c = scene.coefficients;
    if (section.lines().empty()) fail(opening, "has no fluid in its plane: it lies inside a wall, or outside the domain");
    if (section.width() < c.support)
        fail(opening, fmt::format("is {:.4g} m wide, less than the support of the kernel, {:.4g} m: choose a spacing of at most {:.3g} m, "
                                  "or make it wider",
                                  section.width(), c.support, section.width() / c.support * c.spacing));
    for (const auto& line : section.lines())
    {
        // Less round-off: a domain may be exactly as deep.
        if (!inDomain(scene, line.foot - scene.bufferDepth * opening.normal, (1 + 1e-9) * c.support))
            fail(opening, fmt::format("needs {:.4g} m of domain beyond its plane, for the particles that are held there: the domain of "
                                      "constant/geometry, {} to {}, ends before",
                                      scene.bufferDepth - c.support, text(scene.geometry.low), text(scene.geometry.high)));
        for (double s = 0; s < scene.bufferDepth; s += c.spacing)
        {
            const auto x = line.foot - s * opening.normal;
            if (scene.geometry.distance(x) < leastFromWalls * c.spacing)
                fail(opening, fmt::format("has a wall at {}: its duct must go on straight for {:.4g} m beyond the plane", text(x),
                                          scene.bufferDepth));
        }
    }
}

/// The profile and the layers of what comes in fit the section and its walls.
void checkStream(const Opening& opening, const Section& section, const OpenScene& scene)
{
    const auto& lines = section.lines();
    for (const auto& line : lines)
    {
        if (!opening.developed) break;
        const auto [foot, patch] = nearestFoot(scene.geometry, line.foot);
        if (foot.distance > scene.coefficients.spacing) continue;
        const auto& wall = scene.geometry.walls[std::size_t(scene.geometry.patches[std::size_t(patch)].wallAt(foot.region))];
        if (wall.slips)
            fail(opening, fmt::format("has the profile of developed flow between walls that hold the fluid, and wall \"{}\" slips: take "
                                      "profile uniform",
                                      wall.name));
    }
    const int dim = scene.coefficients.dimension;
    for (std::size_t k = 0; k < opening.layers.size(); ++k)
        if (std::ranges::none_of(lines, [&](const auto& line) { return &opening.streamAt(line.foot, dim) == &opening.layers[k].stream; }))
            fail(opening, fmt::format("has no fluid in the part {} of its layers: it lies outside of the section, or within the parts "
                                      "before it",
                                      k + 1));
}

/// Whether b holds what a sees.
bool meet(const PlacedOpening& a, const PlacedOpening& b, const OpenScene& scene)
{
    const auto& c = scene.coefficients;
    for (const auto& line : a.section.lines())
        for (double s = c.support; s > -scene.bufferDepth; s -= c.spacing)
        {
            const auto x = line.foot + s * a.opening.normal;
            if (const double beyond = b.opening.distance(x); beyond < 0 && beyond > -scene.bufferDepth && b.opening.faces(x, c.dimension))
                return true;
        }
    return false;
}

/// The normal points to the side on which the other openings are and where the scene is deeper than the buffer.
void checkNormal(const PlacedOpening& placed, const std::vector<PlacedOpening>& all, const OpenScene& scene)
{
    const auto& opening = placed.opening;
    const double depth = scene.bufferDepth, spacing = scene.coefficients.spacing;
    const auto wrong = [&](const std::string& what)
    { fail(opening, fmt::format("has {}: its normal, {}, must point into the scene", what, text(opening.normal))); };
    for (const auto& other : all)
        if (std::ranges::any_of(other.section.lines(),
                                [&](const auto& line) {
                                    return opening.distance(line.foot) <= -2 * depth && opening.inSight(scene.geometry, line.foot, spacing);
                                }))
            wrong(fmt::format("\"{}\" beyond its plane, and would take away the fluid between them", other.opening.name));
    double deepest = 0;
    for (const auto& line : placed.section.lines())
    {
        const auto at = [&](double s) { return line.foot + s * opening.normal; };
        // Grains of a bed may stand in the way.
        for (double s = 0.5 * spacing; deepest < depth && inDomain(scene, at(s), 0); s += spacing)
            if (scene.geometry.inFluid(at(s))) deepest = std::max(deepest, s + 0.5 * spacing);
    }
    if (deepest < depth)
        wrong(fmt::format("{:.4g} m of scene before its plane, less than the {:.4g} m that it holds beyond", deepest, depth));
}
}

std::vector<PlacedOpening> placeOpenings(const std::vector<Opening>& openings, const OpenScene& scene)
{
    const auto& c = scene.coefficients;
    const std::vector<double> none(scene.phases(), 0.0);
    std::vector<PlacedOpening> all;
    for (const auto& opening : openings)
    {
        const auto plane = planeOf(opening, openings);
        const Section section(opening, scene.geometry, c.spacing, plane ? &*plane : nullptr);
        checkSide(opening, section, openings, scene);
        checkDuct(opening, section, scene);
        checkStream(opening, section, scene);
        const auto asked = rateOf(opening, section);
        const double most = asked.value_or(std::numeric_limits<double>::infinity()) / section.carried();
        const double pressure = c.backgroundPressure + (opening.inlet ? 0 : opening.pressure.value_or(0));
        all.push_back({opening, plane.value_or(opening), section, asked, most, opening.inlet && !opening.pressure ? most : 0,
                       std::vector(scene.phases(), pressure), none, densityOf(opening, section, c), 0, none,
                       std::vector(section.lines().size(), 0.0)});
    }
    for (const auto& a : all)
        for (const auto& b : all)
            if (&a != &b && meet(a, b, scene))
                fail(b.opening, fmt::format("overlaps \"{}\": the particles that one holds must be out of the other's sight, {:.4g} m "
                                            "before its plane and {:.4g} m behind",
                                            a.opening.name, c.support, scene.bufferDepth));
    for (const auto& placed : all) checkNormal(placed, all, scene);
    return all;
}

}
