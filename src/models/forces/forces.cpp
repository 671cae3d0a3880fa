#include "forces.hpp"
#include "Damping.hpp"
#include "forceTerms.hpp"

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
    if (mag(settings.coefficients.g) > 0) reading.select("gravity");
    if (mag(settings.coefficients.bodyForce) > 0) reading.select("bodyForce");
    const auto damping = entry::damping(reading.schemes.subDictOrEmpty("integration"));
    const double rate = entry::rate(damping), until = entry::until(damping);
    if (until > 0) settings.parts.push_back(partOf<Damping>(rate, until));
}
}

const Model& forcesModel()
{
    static const Model model{"forces",
                             "gravity, a uniform force per volume, and damping from a start far off equilibrium",
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
