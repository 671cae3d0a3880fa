#include "kernels/Resolution.hpp"
#include "kernels/defaultSupport.hpp"
#include "kernels/resolutionEntries.hpp"
#include "schemes/schemeSets.hpp"

namespace sph
{

Resolution readResolution(const Dictionary& sphSchemes)
{
    addSchemeSet(sphSchemes);
    const auto before = sphSchemes.diagnostics().errors();
    const auto dict = entry::resolution::dictionary(sphSchemes);
    const auto kernel = entry::resolution::kernel(dict);
    const Resolution resolution{entry::resolution::spacing(dict), entry::resolution::support(dict, defaultSupport(kernel)), kernel,
                                entry::resolution::spacing.where(dict)};
    if (sphSchemes.diagnostics().errors() > before) sphSchemes.diagnostics().throwIfAny();
    return resolution;
}

}
