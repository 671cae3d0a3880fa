#include "meshes/prepareMesh.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

std::string statistics(const MeshStatistics& s, const std::vector<std::string>& regions)
{
    auto out = fmt::format("    Triangles    : {} in {} region(s)\n    Vertices     : {}\n    Bounding Box : {} {}\n\n    {:<20} Size\n",
                           s.triangles, s.inRegion.size(), s.points, inWords(s.box.low), inWords(s.box.high), "Region");
    for (std::size_t r = 0; r < s.inRegion.size(); ++r) out += fmt::format("    {:<20} {}\n", regions[r], s.inRegion[r]);
    out +=
        s.illegal == 0 ? "\n    Surface has no illegal triangles.\n" : fmt::format("\n    Surface has {} illegal triangles.\n", s.illegal);
    out += "    Triangle quality (equilateral=1, collapsed=0):\n";
    for (std::size_t b = 0; b < s.quality.size(); ++b)
        if (s.quality[b] > 0)
            out += fmt::format("        {:.2f} .. {:.2f}  {:.4g}\n", 0.05 * double(b), 0.05 * double(b + 1),
                               double(s.quality[b]) / double(s.triangles));
    out += fmt::format("        min {:.4g}, max {:.4g}\n", s.leastQuality, s.greatestQuality);
    for (const auto& [what, edge] : {std::pair{"min", s.shortest}, {"max", s.longest}})
        out += fmt::format("    Edges: {} {:.4g} m between {} {}\n", what, edge.length, inWords(edge.a), inWords(edge.b));
    if (s.open == 0 && s.multiple == 0) out += "    Surface is closed. All edges connected to two faces.\n";
    else out += fmt::format("    Surface is not closed: edges connected to one face: {}, to more than two: {}\n", s.open, s.multiple);
    return out + fmt::format("    Number of unconnected parts : {}\n    Number of zones (connected area with consistent normal) : {}\n",
                             s.parts, s.zones);
}

std::string width(const char* what, const MeshClearances::Place& place, double H)
{
    if (place.width == Box::infinity) return fmt::format("    {}: none\n", what);
    return fmt::format("    {}: {:.4g} m = {:.3g} H at {}\n", what, place.width, place.width / H, inWords(place.at));
}

std::string sharpest(const char* what, double angle, const Vector<3>& at)
{
    return angle == 180 ? fmt::format("    Sharpest {} edge: none\n", what)
                        : fmt::format("    Sharpest {} edge: the fluid has {:.4g} degrees at {}\n", what, angle, inWords(at));
}

}

std::string meshReport(const PreparedMesh& p, double H, bool full)
{
    const auto& t = p.source;
    auto out =
        fmt::format("Wall \"{}\": constant/triSurface/{}, fluid {}\n", t.wall, t.file, t.fluid == FluidSide::inside ? "inside" : "outside");
    for (const auto& note : p.notes) out += "    " + note + "\n";
    const auto asRead = statistics(p.asRead, p.regions), prepared = statistics(p.prepared, p.regions);
    if (full && p.asRead.triangles > 0) out += "  As read:\n" + asRead;
    out += p.repairs.empty() ? "  Repairs: none\n" : "  Repairs:\n";
    for (const auto& line : p.repairs) out += "    " + line + "\n";
    if (!p.usable) return out + "  The mesh cannot be used.\n";

    const auto& f = p.features;
    if (full) out += prepared == asRead ? "  Prepared: the same\n" : "  Prepared:\n" + prepared;
    else
        out += fmt::format("  {} triangles in {} region(s), {} vertices, {} {}\n", p.prepared.triangles, p.prepared.inRegion.size(),
                           p.prepared.points, inWords(p.prepared.box.low), inWords(p.prepared.box.high));
    // Normals point into the fluid: where it is outside, the flux through them is the volume of the solid.
    out += fmt::format("  Volume of the {}: {:.6g} m3; as read {}\n", t.fluid == FluidSide::outside ? "solid" : "space for the fluid",
                       std::abs(p.prepared.volume),
                       p.asRead.open + p.asRead.multiple > 0 ? "it was open" : fmt::format("{:.6g} m3", std::abs(p.asRead.volume)));
    out += fmt::format("  Sharp edges (more than {:.3g} degrees): {} convex, {} concave\n", t.featureAngle, f.convex, f.concave);
    if (!full) return t.volume ? out + width("Narrowest gap", p.clearances.narrowest, H) : out;
    out += sharpest("convex", f.most, f.mostAt) + sharpest("concave", f.least, f.leastAt);
    if (f.grooves > 0) out += fmt::format("    Grooves of less than {:.0f} degrees: {}\n", leastFilled, f.grooves);
    if (f.convex + f.concave > 0)
        out += fmt::format("    Smallest face between sharp edges: {:.4g} m = {:.3g} H (square root of its area) at {}\n", f.smallest,
                           f.smallest / H, inWords(f.smallestAt));
    if (const auto& h = p.hollows; h.count == 0) out += "    Hollows tighter than H: none\n";
    else
        out += fmt::format("    Hollows tighter than H: {}, the tightest of radius {:.4g} m = {:.3g} H at {}, {}\n", h.count, h.radius,
                           h.radius / H, inWords(h.at), h.facet);
    out += fmt::format(
        "  In {} points, evenly over the area, and centroids of facets, along their normals, to what is parallel within 30 degrees:\n",
        p.clearances.sampled);
    return out + width("Thinnest wall", p.clearances.thinnest, H) + width("Narrowest gap", p.clearances.narrowest, H);
}

}
