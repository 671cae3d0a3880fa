#include "forces.hpp"
#include "Damping.hpp"
#include "forceTerms.hpp"

namespace sph
{

namespace
{
void read(const Reading& reading)
{
    auto& settings = reading.settings;
    if (mag(settings.coefficients.g) > 0) reading.select("gravity");
    if (mag(settings.coefficients.bodyForce) > 0) reading.select("bodyForce");
    const auto damping = reading.schemes.subDictOrEmpty("integration").subDictOrEmpty("damping");
    const double rate = damping.getNonNegative("rate", units::none/units::s, 0), until = damping.getNonNegative("until", units::s, 0);
    if (until > 0) settings.parts.push_back(partOf<Damping>(rate, until));
}
}

const Model& forcesModel()
{
    static const Model model{"forces", "gravity, a uniform force per volume, and damping from a start far off equilibrium", read, forceTerms<2>(), forceTerms<3>()};
    return model;
}

}
