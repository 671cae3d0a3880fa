#include "models/forces/forces.hpp"
#include "models/forces/Damping.hpp"
#include "models/forces/Shaking.hpp"
#include "models/forces/forceTerms.hpp"

namespace sph
{

namespace entry
{
const SubDictionary damping{"damping", notGiven, "of all velocities, for a start far off equilibrium"};
const Scalar rate{"rate", units::none / units::s, 0, nonNegative, "dv/dt = -rate v"},
    until{"until", units::s, 0, nonNegative, "when damping ends"};
}

namespace
{
void read(const Reading& reading)
{
    auto& settings = reading.settings;
    if (settings.hasGravity()) reading.select("gravity");
    if (!settings.shaking.empty()) settings.runningModels.push_back(running<Shaking>(settings.coefficients.g, settings.shaking));
    if (!settings.shaking.empty() && !settings.integration.moves)
        reading.schemes.error("integration", "scheme quasiSteady leaves particles where they are, and constant/g has `shaking`");
    if (mag(settings.coefficients.bodyForce) > 0) reading.select("bodyForce");
    const auto damping = entry::damping(reading.schemes.subDictOrEmpty("integration"));
    const double rate = entry::rate(damping), until = entry::until(damping);
    if ((rate > 0) != (until > 0))
        (rate > 0 ? entry::rate : entry::until)
            .error(damping, rate > 0 ? "does nothing without `until`, the time at which damping ends" : "does nothing without `rate`");
    if (until > 0) settings.runningModels.push_back(running<Damping>(rate, until));
}
}

const Model& forcesModel()
{
    static const Model model{"forces",
                             "gravity, that of a shaken vessel, a uniform force per volume, and damping from a start far off equilibrium",
                             read,
                             forceTerms<2>(),
                             forceTerms<3>(),
                             nullptr,
                             {},
                             {},
                             {{"system/sphSchemes",
                               {{SubDictionary{"integration", notGiven, ""}, {{entry::damping, {entry::rate, entry::until}}}}}}}};
    return model;
}

}
