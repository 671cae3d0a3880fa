#include "PhaseCloud.hpp"
#include "words.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{

const std::vector<double>* scalars(const Cloud& cloud, const std::string& name)
{
    const auto found = cloud.fields.find(name);
    return found == cloud.fields.end() || componentsOf(found->second.type) != 1 ? nullptr : &found->second.component[0];
}

}

PhaseParticles phaseParticles(const Cloud& cloud, int phase, double uniformVolume, const std::string& folder,
                              Diagnostics& diagnostics)
{
    PhaseParticles particles;
    particles.position.resize(cloud.size());
    for (std::size_t p = 0; p < cloud.size(); ++p) particles.position[p] = {cloud.x[p], cloud.y[p], cloud.z[p]};

    particles.inPhase.assign(cloud.size(), phase == 0);
    if (const auto* number = scalars(cloud, "phase"))
        for (std::size_t p = 0; p < cloud.size(); ++p) particles.inPhase[p] = (*number)[p] == phase;

    particles.volume.assign(cloud.size(), uniformVolume);
    const auto *m = scalars(cloud, "m"), *rho = scalars(cloud, "rho");
    if (!m) return particles;
    if (!rho)
    {
        diagnostics.error({folder, 0}, "there is a mass m but no density rho: volumes are m/rho");
        return particles;
    }
    for (std::size_t p = 0; p < cloud.size(); ++p)
    {
        if (!((*rho)[p] > 0) || !((*m)[p] > 0))
        {
            const bool wrongMass = !((*m)[p] > 0);
            diagnostics.error({folder + (wrongMass ? "/m" : "/rho"), 0},
                              fmt::format("particle {} has the {} {}, which must be positive", p, wrongMass ? "mass" : "density",
                                          wrongMass ? (*m)[p] : (*rho)[p]));
            break;
        }
        particles.volume[p] = (*m)[p] / (*rho)[p];
    }
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
        diagnostics.error(
            where, fmt::format("the cloud has no scalar or vector field \"{}\". {}", field, suggestion(field, "fields", known)));
        return values;
    }
    const auto& component = found->second.component;
    if (component.size() == 1) return component[0];
    for (std::size_t p = 0; p < cloud.size(); ++p)
        values[p] = std::sqrt(sqr(component[0][p]) + sqr(component[1][p]) + sqr(component[2][p]));
    return values;
}

}
