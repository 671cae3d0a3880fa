#include "StoredCase.hpp"
#include "Walls.hpp"
#include "viewOfScene.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{

/// The walls that the solver saw, or, where meshToGhost has not made them, constant/geometry itself.
Geometry loadGeometry(const Case& c)
{
    const double H = readResolution(c.dictionary("system/sphSchemes")).H();
    if (c.has("constant/walls")) return readWalls(c.dictionary("constant/walls"), 1.5 * H);
    return readGeometry(c.dictionary("constant/geometry"), 1.5 * H);
}

const double* scalarField(const Cloud& cloud, const std::string& time, const std::string& name)
{
    const auto found = cloud.fields.find(name);
    if (found == cloud.fields.end())
        throw CaseError(Location{fmt::format("{}/lagrangian/{}/{}", time, StoredCase::cloudName, name), 0}, "is missing");
    return found->second.component.at(0).data();
}

}

StoredCase::StoredCase(const Case& c) : case_(c), geometry_(loadGeometry(c)), settings_(readSettings(c, geometry_)) {}

std::vector<std::string> StoredCase::times() const
{
    auto times = case_.times();
    std::erase_if(times, [this](const auto& time) { return !hasCloud(case_.folder(), time, cloudName); });
    if (times.empty())
        throw CaseError(fmt::format("No time folder of {} has a cloud lagrangian/{}", case_.folder().string(), cloudName));
    return times;
}

ParticleView StoredCase::load(const std::string& time)
{
    cloud_ = readCloud(case_.folder(), time, cloudName, case_.diagnostics());
    case_.diagnostics().throwIfAny();
    const auto& c = settings_.coefficients;
    auto v = viewOfScene(c, settings_.resolution.kernel, geometry_);
    v.n = cloud_.size();
    v.x = cloud_.x.data();
    v.y = cloud_.y.data();
    v.z = geometry_.dimension == 3 ? cloud_.z.data() : nullptr;
    for (const auto& [name, field] : cloud_.fields)
    {
        FieldView f{name, field.type, {}};
        for (const auto& component : field.component) f.component.push_back(component.data());
        v.fields.push_back(std::move(f));
    }
    v.mass = scalarField(cloud_, time, "m");
    if (cloud_.fields.contains("V")) v.volume = scalarField(cloud_, time, "V");
    else
    {
        const auto* rho = scalarField(cloud_, time, "rho");
        volume_.resize(v.n);
        for (std::size_t i = 0; i < v.n; ++i) volume_[i] = v.mass[i] / rho[i];
        v.volume = volume_.data();
    }
    if (c.phases.size() > 1)
    {
        v.phase = scalarField(cloud_, time, "phase");
        for (std::size_t i = 0; i < v.n; ++i)
            if (!(v.phase[i] >= 0 && v.phase[i] < double(c.phases.size())))
                throw CaseError(Location{fmt::format("{}/lagrangian/{}/phase", time, cloudName), 0},
                                fmt::format("particle {} has phase {}, but constant/phaseProperties names {}", i, v.phase[i],
                                            c.phases.size()));
    }
    v.time = std::stod(time);
    v.executionTime = std::numeric_limits<double>::quiet_NaN();
    return v;
}

}
