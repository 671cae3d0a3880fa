#include "Resolution.hpp"
#include "resolutionEntries.hpp"
#include "schemeSets.hpp"

namespace sph
{

Resolution readResolution(const Dictionary& sphSchemes)
{
    addSchemeSet(sphSchemes);
    const auto before = sphSchemes.diagnostics().errors();
    const auto dict = entry::resolution::dictionary(sphSchemes);
    const Resolution resolution{entry::resolution::spacing(dict), entry::resolution::support(dict), entry::resolution::kernel(dict),
                                entry::resolution::spacing.where(dict)};
    if (sphSchemes.diagnostics().errors() > before) sphSchemes.diagnostics().throwIfAny();
    return resolution;
}

}
