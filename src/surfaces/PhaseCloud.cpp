#include "surfaces/PhaseCloud.hpp"
#include "base/words.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

PhaseParticles phaseParticles(const Cloud& cloud, int phase, std::size_t phases, double uniformVolume)
{
    PhaseParticles particles;
    for (std::size_t p = 0; p < cloud.size(); ++p) particles.position.push_back({cloud.x[p], cloud.y[p], cloud.z[p]});
    for (const int its : phasesOf(cloud, phases)) particles.inPhase.push_back(its == phase);
    particles.volume = cloud.fields.contains("m") ? volumesOf(cloud) : std::vector<double>(cloud.size(), uniformVolume);
    return particles;
}

std::vector<double> colouringValues(const Cloud& cloud, const std::string& field, const Location& where, Diagnostics& diagnostics)
{
    std::vector<double> values(cloud.size());
    const auto found = cloud.fields.find(field);
    const auto hasSize = [](const CloudField& f) { return componentsOf(f.type) <= 3; };
    if (found == cloud.fields.end() || !hasSize(found->second))
    {
        std::vector<std::string> known;
        for (const auto& [name, content] : cloud.fields)
            if (hasSize(content)) known.push_back(name);
        diagnostics.error(where,
                          fmt::format("the cloud has no scalar or vector field \"{}\". {}", field, suggestion(field, "fields", known)));
        return values;
    }
    const auto& component = found->second.component;
    if (component.size() == 1) return component[0];
    for (std::size_t p = 0; p < cloud.size(); ++p)
        values[p] = std::sqrt(sqr(component[0][p]) + sqr(component[1][p]) + sqr(component[2][p]));
    return values;
}

}
