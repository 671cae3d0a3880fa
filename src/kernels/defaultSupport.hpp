/// Default support of each kernel.
#pragma once
#include <string>

namespace sph
{

/// H in spacings where a file gives none: of each kernel the least that keeps water at rest and the period of a standing wave (README.md).
double defaultSupport(const std::string& kernel);
/// "3.05 of wendlandC2, 3.4 of wendlandC4 ..": for the reference.
std::string defaultSupports();

}
