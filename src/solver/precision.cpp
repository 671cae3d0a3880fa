#include "solver/precision.hpp"
#include "scene/singlePrecision.hpp"

namespace sph
{

namespace entry
{
const Choice precision{"precision",
                       {{"double", "all of them in double precision"},
                        {"mixed", "those that can in single precision, on places relative to the particle; sums and state stay in double"}},
                       "double",
                       "of the terms of pairs"}; // of system/sphSchemes
}

namespace
{
void read(const Reading& reading)
{
    auto& settings = reading.settings;
    settings.mixedPrecision = reading.choose(entry::precision) == "mixed";
    if (!settings.mixedPrecision) return;
    if (const auto reason = singlePrecisionFails(settings.resolution.spacing, reading.geometry); !reason.empty())
        entry::precision.error(reading.schemes, reason);
    settings.reasons.push_back("terms of pairs in single precision, sums and state in double (precision mixed)");
}
}

const Model& precisionModel()
{
    static const Model model{"precision", "single or double precision of pairs",      read, {}, {}, {}, {},
                             {},          {{"system/sphSchemes", {entry::precision}}}};
    return model;
}

}
