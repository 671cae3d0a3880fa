/// The entries of `resolution` in system/sphSchemes, which packParticles, meshToGhost and the solver read.
#pragma once
#include "dictionary/EntryList.hpp"
#include "kernels/Kernel.hpp"
#include "kernels/defaultSupport.hpp"

namespace sph::entry::resolution
{

const SubDictionary dictionary{"resolution", required, "spacing of the particles and reach of the kernel"};
const Scalar spacing{"spacing", units::m, required, positive, "dim-th root of a particle's volume"};
const Scalar support{"support", Unit{units::none, "spacings"}, byScene(defaultSupports()),
                     between(1.5, 6).saying("the kernel support is given in spacings and lies between 1.5 and 6"),
                     "radius of the kernel's support"};
const Choice kernel{"kernel", kernelNames(), "wendlandC2", "of all sums over neighbours"};

inline EntryList entries() { return {{dictionary, {spacing, support, kernel}}}; }

}
