#include "sampling/Forces.hpp"
#include "base/words.hpp"
#include "case/forcesOnWalls.hpp"
#include "geometry/components.hpp"
#include "geometry/wallNames.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace column
{
const Column force{"force_<wall>", "N", "of the fluid or soil on the wall, per metre of depth in 2-D; a vector"},
    displacement{"displacement_<wall>", "m", "by the wall's velocity or load since the time 0; a vector"};
}

Forces::Forces(const Dictionary& d, const FunctionContext& context) : context_(context), where_(entry::patches.where(d))
{
    for (const auto& name : entry::patches(d))
        if (const auto wall = std::ranges::find(context.geometry.walls, name, &WallProperties::name); wall != context.geometry.walls.end())
            walls_.push_back({name, wall->velocity, wall->load.has_value(), {}});
        else
            entry::patches.error(d,
                                 fmt::format("wall \"{}\" is unknown. {}", name, suggestion(name, "walls", wallNames(context.geometry))));
}

EntryList Forces::entries() { return {entry::patches}; }

TableInfo Forces::table() { return {forcesType, "forces.dat", "forces on walls", {column::force, column::displacement}}; }

void Forces::execute(const ParticleView& view)
{
    const auto number = [&](const std::string& name)
    {
        const auto found = view.numbers.find(name);
        if (found == view.numbers.end())
            throw CaseError(where_, "forces on walls are known while a case runs alone: run sphFoamLike with this function object");
        return found->second;
    };
    TableRow row;
    for (auto& wall : walls_)
    {
        auto displacement = view.time * wall.velocity;
        for (int k = 0; k < 3; ++k)
        {
            wall.force.*component(k) = number(forceOnWall(wall.name, k));
            if (wall.underLoad) displacement.*component(k) = number(displacementOfWall(wall.name, k));
        }
        row.add(column::force.of(wall.name), wall.force);
        row.add(column::displacement.of(wall.name), displacement);
    }
    if (!table_) table_.emplace(context_.file("forces.dat"), std::vector<std::string>{}, row.columns);
    table_->row(view.time, row.cells);
}

std::string Forces::report() const
{
    auto line = context_.name + ":";
    for (const auto& wall : walls_)
        line += fmt::format("{} {} ({:.6g} {:.6g} {:.6g}) N", &wall == &walls_.front() ? "" : ",", wall.name, wall.force.x, wall.force.y,
                            wall.force.z);
    return line;
}

}
