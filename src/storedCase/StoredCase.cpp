#include "storedCase/StoredCase.hpp"
#include "case/cloudViews.hpp"
#include "geometry/Walls.hpp"
#include "models/forces/Shaking.hpp"
#include "sampling/viewOfScene.hpp"
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
    const auto resolution = readResolution(c.dictionary("system/sphSchemes"));
    if (c.has("constant/walls")) return readWalls(c, resolution);
    return readGeometry(c.dictionary("constant/geometry"), resolution, supportsOfSolver, c.folder());
}

}

StoredCase::StoredCase(const Case& c)
    : case_(c), geometry_(loadGeometry(c)), settings_(readSettings(c, geometry_)), openEnds_(c, geometry_, settings_.resolution)
{}

std::vector<std::string> StoredCase::times() const
{
    auto times = case_.times();
    std::erase_if(times, [this](const auto& time) { return !hasCloud(case_.folder(), time, cloudName); });
    if (times.empty()) throw CaseError(fmt::format("No time folder of {} has a cloud lagrangian/{}", case_.folder().string(), cloudName));
    return times;
}

ParticleView StoredCase::load(const std::string& time)
{
    cloud_ = readCloud(case_.folder(), time, cloudName, case_.diagnostics(), settings_.writtenClasses());
    case_.diagnostics().throwIfAny();
    const auto& c = settings_.coefficients;
    const double at = std::stod(time);
    auto v = viewOfScene(c, gravityAt(c.g, settings_.shaking, at), settings_.resolution.kernel, geometry_);
    v.n = cloud_.size();
    v.x = cloud_.x.data();
    v.y = cloud_.y.data();
    v.z = geometry_.dimension == 3 ? cloud_.z.data() : nullptr;
    v.fields = fieldsOf(cloud_);
    volume_ = volumesOf(cloud_);
    v.volume = volume_.data();
    v.mass = cloud_.fields.at("m").component[0].data();
    if (c.phases.size() > 1)
    {
        if (!cloud_.fields.contains("phase")) throw CaseError({cloud_.folder + "/phase", 0}, "is missing");
        phasesOf(cloud_, c.phases.size());
        v.phase = cloud_.fields.at("phase").component[0].data();
    }
    if (!openEnds_.none())
    {
        heldBy_.clear();
        for (std::size_t i = 0; i < cloud_.size(); ++i) heldBy_.push_back(openEnds_.beyond({cloud_.x[i], cloud_.y[i], cloud_.z[i]}));
        v.heldBy = heldBy_.data();
    }
    v.time = at;
    v.executionTime = std::numeric_limits<double>::quiet_NaN();
    return v;
}

}
