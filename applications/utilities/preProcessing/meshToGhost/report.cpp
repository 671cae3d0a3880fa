#include "report.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

std::string table(const std::vector<Row>& rows)
{
    std::vector<std::size_t> width(rows.front().size(), 0);
    for (const auto& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
    std::string out;
    for (const auto& row : rows)
    {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) line += fmt::format("{:<{}}  ", row[c], width[c]);
        out += "  " + line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return out;
}

namespace
{

std::string angles(const sph::WallProperties& wall)
{
    if (!wall.wets) return "-";
    if (wall.contactAngles.empty()) return fmt::format("{:.4g}", wall.contactAngle);
    std::string all;
    for (const auto& [first, second, angle] : wall.contactAngles)
        all += fmt::format("{}{} {} {:.4g}", all.empty() ? "" : ", ", first, second, angle);
    return all;
}

std::string motion(const sph::WallProperties& wall)
{
    const auto text = [](const sph::Vector<3>& a) { return fmt::format("({:.4g} {:.4g} {:.4g})", a.x, a.y, a.z); };
    const std::string slips = wall.slips ? ", slips" : "";
    if (mag(wall.omega) > 0) return fmt::format("{} + {} x (x - {})", text(wall.velocity), text(wall.omega), text(wall.origin)) + slips;
    if (wall.load) return "under load" + slips;
    return (mag(wall.velocity) > 0 ? text(wall.velocity) : "at rest") + slips;
}

}

std::string report(const sph::Geometry& g, const sph::GeometryReport& report, double H, bool full)
{
    std::string periodic;
    for (int k = 0; k < 3; ++k)
        if (g.periodic[k]) periodic += std::string(periodic.empty() ? "" : " ") + "xyz"[k];
    auto out = fmt::format("Kernel support H = {:.6g} m\n{}-D domain ({:.6g} {:.6g} {:.6g}) ({:.6g} {:.6g} {:.6g}), periodic in ({})\n"
                           "{} walls of {} shapes, {} with their periodic copies within H\nFluid: {:.4f} +- {:.4f} of the domain\n",
                           H, g.dimension, g.low.x, g.low.y, g.low.z, g.high.x, g.high.y, g.high.z, periodic, g.walls.size(),
                           g.originals.size(), g.patches.size(), report.fluidFraction, report.fluidFractionError);
    if (report.contacts > 0) out += fmt::format("Contacts: {}\n", report.contacts);
    if (report.overlap > 0)
        out += fmt::format("Largest overlap: {:.2g} of the smaller diameter, at ({:.6g} {:.6g} {:.6g})\n", report.overlap,
                           report.overlapAt.x, report.overlapAt.y, report.overlapAt.z);
    if (g.walls.empty()) return out;

    Row head{"wall", "shape", "number", "fluid"};
    if (full) head.insert(head.end(), {"radius/m", "radius/H", "gap/m", "gap/H", "gap to", "contacts", "angle/deg", "velocity/(m/s)"});
    std::vector<Row> rows{head};
    for (std::size_t w = 0; w < g.walls.size(); ++w)
    {
        const auto& wall = report.walls[w];
        Row row{g.walls[w].name, wall.type, fmt::format("{}", wall.shapes), wall.fluid};
        if (full)
        {
            const auto length = [](double a) { return std::isfinite(a) ? fmt::format("{:.4g}", a) : std::string("-"); };
            const auto& gap = wall.narrowest;
            row.insert(row.end(), {length(wall.smallestRadius), length(wall.smallestRadius / H), length(gap.width),
                                   std::isfinite(gap.width) ? fmt::format("{:.3g}", gap.width / H) : "> 2",
                                   gap.wall >= 0 ? g.walls[gap.wall].name : "-", fmt::format("{}", wall.contacts), angles(g.walls[w]),
                                   motion(g.walls[w])});
        }
        rows.push_back(row);
    }
    return out + "\n" + table(rows);
}
