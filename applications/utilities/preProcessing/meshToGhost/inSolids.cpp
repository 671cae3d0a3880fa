#include "inSolids.hpp"
#include "geometry/periodicShifts.hpp"
#include "report.hpp"
#include <algorithm>
#include <fmt/format.h>

Solid solidOfFile(const std::string& wall, sph::SolidOfFile solid, const sph::Geometry& g)
{
    std::vector<sph::Vector<3>> shifts{{}};
    sph::forEachPeriodicShift(g, [&](const sph::Vector<3>& by) { shifts.push_back(by); });
    const auto shared = std::make_shared<sph::SolidOfFile>(std::move(solid));
    return {wall, [shared, shifts](const sph::Vector<3>& x)
            { return std::ranges::any_of(shifts, [&](const auto& by) { return shared->contains(x + by); }); }};
}

std::vector<Solid> solidsOfShapes(const sph::Geometry& g)
{
    std::vector<Solid> solids;
    for (std::size_t w = 0; w < g.walls.size(); ++w)
    {
        std::vector<std::shared_ptr<const sph::Shape>> shapes;
        for (const auto& patch : g.patches)
            if (!patch.mesh && patch.wall == int(w)) shapes.push_back(patch.shape);
        if (!shapes.empty())
            solids.push_back({g.walls[w].name, [shapes](const sph::Vector<3>& x)
                              { return std::ranges::any_of(shapes, [&](const auto& shape) { return shape->foot(x).distance < 0; }); }});
    }
    return solids;
}

std::string reportInSolids(const std::vector<sph::Cloud>& clouds, const std::vector<Solid>& solids)
{
    std::vector<Row> rows{{"time", "particles"}};
    for (const auto& solid : solids) rows[0].push_back(solid.wall);
    std::size_t found = 0, positions = 0;
    std::string first;
    for (const auto& cloud : clouds)
    {
        const auto time = cloud.folder.substr(0, cloud.folder.find('/'));
        std::vector<std::size_t> in(solids.size(), 0);
        for (std::size_t i = 0; i < cloud.size(); ++i)
        {
            bool inAny = false;
            for (std::size_t s = 0; s < solids.size(); ++s)
                if (solids[s].contains({cloud.x[i], cloud.y[i], cloud.z[i]}))
                {
                    ++in[s];
                    inAny = true;
                    if (first.empty()) first = fmt::format("First: {} in \"{}\" at time {}\n", cloud.particle(i), solids[s].wall, time);
                }
            found += inAny;
        }
        positions += cloud.size();
        rows.push_back({time, fmt::format("{}", cloud.size())});
        for (const auto n : in) rows.back().push_back(fmt::format("{}", n));
    }
    return fmt::format(
        "Particles in walls: in meshes by CGAL, as their files have them, in shapes by distance\n\n{}\n{}In solids: {} of {} positions\n",
        table(rows), first, found, positions);
}
