/// Repulsion that spaces particles evenly: the gradient of a pressure without unit, in the antisymmetric form that leaves the centre of mass where
/// it is.
///
///   f_i = V_0 sum_j w_j (P_i + P_j) gradW_ij     [1/m]
///
/// V_0 [m^d] volume of a particle; W [1/m^d] kernel; w_j volume factor of a ghost, 1 for fluid, already in gradW_ij; P of an image is that of its
/// source, and a particle sees its own in a wall's layer. Particles move down it. Verified by test/unit/packing (centre of mass).
#pragma once
#include "fields/fieldTags.hpp"

namespace sph
{

// clang-format off
struct PackingPressure { static constexpr FieldInfo info{"packingPressure", "1"};                     template<int dim, class Real = double> struct At { Real P; }; };
struct PackingGradient { static constexpr FieldInfo info{"packingGradient", "1/m", Image::mirrored};  template<int dim, class Real = double> struct At { Vector<dim, Real> f; }; };
// clang-format on

struct Repulsion
{
    static constexpr auto name = "repulsion";
    using Provides = PackingGradient;
    using Reads = Fields<PackingPressure>;
    double V0;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return (i.P + j.P) * ij.gradW; }
    auto finish(const auto&, const auto& sum) const { return V0 * sum; }
};

}
