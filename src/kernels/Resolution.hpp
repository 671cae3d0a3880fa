/// Resolution of a scene, as all programs of the suite read it from system/sphSchemes:
/// `resolution { spacing 1e-4; support 2.6; kernel wendlandC2; }`, and by the set of words that `scheme` names (schemeSets.hpp).
#pragma once
#include "dictionary/Dictionary.hpp"

namespace sph
{

struct Resolution
{
    double spacing = 1;    ///< [m]
    double support = 3.05; ///< H in spacings
    std::string kernel = "wendlandC2";
    Location where; ///< of the spacing
    double H() const { return support * spacing; }
};

/// Throws CaseError, with every mistake found until then, where it cannot be read: nothing can be made of a scene without.
Resolution readResolution(const Dictionary& sphSchemes);

}
