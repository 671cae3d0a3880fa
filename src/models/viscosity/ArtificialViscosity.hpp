/// Artificial viscosity of Monaghan & Gingold (1983), in the form of delta-SPH (Antuono et al. 2010, eq. 5): along the line of centres.
///
///   dv_i/dt = alpha h c rho_0/m_i sum_j V_i V_j (v_ij . x_ij)/(r_ij^2 + 0.01 h^2) gradW_ij
///
/// alpha about 0.02 for free surfaces of liquids that are taken as inviscid, h = H/2 [m], c [m/s] the largest sound speed, rho_0 [kg/m^3]
/// the rest density of the first phase, V [m^3], m [kg]. Acts on approach and on recession; as a kinematic viscosity it is alpha h c/8 in
/// two dimensions and alpha h c/10 in three (Monaghan 2005), which vanishes with the spacing. Conserves linear and angular momentum exactly
/// and takes kinetic energy only. Verified by test/unit/viscosity (plain loop, energy) and tutorials/verification/rotatingSquarePatch.
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include "scene/soundDamping.hpp"
#include <algorithm>

namespace sph
{

struct ArtificialViscosity
{
    static constexpr auto name = "artificialViscosity";
    using Adds = Acceleration;
    using Reads = Fields<Volume, Velocity>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;
    double coefficient, small;

    explicit ArtificialViscosity(const Coefficients& c) : coefficient(c.of<ArtificialNumber>().mu), small(0.01 * sqr(0.5 * c.support)) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return coefficient / i.m * i.V * j.V * dot(i.v - j.v, ij.x) / (ij.rr + small) * ij.gradW;
    }
};

}
