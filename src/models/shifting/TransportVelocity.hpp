/// Transport velocity: particles are moved not by v but by v + w, which also keeps them evenly spaced, Adami, Hu & Adams (2013).
///
///   dx_i/dt = v_i + w_i,    w_i = dt/2 a_i,    a_i = -(p_b/m_i) sum_j (V_i^2 + V_j^2) gradW_ij,    p_b = C rho_i c^2
///
/// v [m/s] is that of momentum and of all else. The uniform background pressure p_b [Pa] has no gradient: its sum a [m/s^2] is that of the
/// particles' unevenness alone. C is 1 in the paper, c [m/s] the largest sound speed, dt [s] the step. The momentum that particles carry past one
/// another by w is given back by the stress A = rho v w:
///
///   dv_i/dt += 1/(2 m_i) sum_j (V_i^2 + V_j^2) (A_i + A_j) . gradW_ij     ->  (1/rho) div(rho v w)
///
/// Conserves linear momentum exactly. On evenly spaced particles of order 2; where they lie unevenly A sum gradW stays, as the pressure
/// does of any sum of pressures. Unlike w . grad v it depends on the frame: a mean flow multiplies that rest.
/// Verified by test/unit/shifting (plain loop, momentum, order) and tutorials/verification/taylorGreen, lidDrivenCavity and
/// sphereArray.
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

/// C of the transport velocity.
struct TransportNumber
{
    double C = 0;
};

struct UniformTransport
{
    static constexpr auto name = "transportVelocity";
    using Provides = TransportAcceleration;
    using Reads = Fields<Volume>;
    double pressureOverDensity; ///< p_b/rho [m^2/s^2]

    explicit UniformTransport(const Coefficients& c)
        : pressureOverDensity(c.of<TransportNumber>().C * sqr(*std::max_element(c.soundSpeed.begin(), c.soundSpeed.end())))
    {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return -pressureOverDensity / i.V * (sqr(i.V) + sqr(j.V)) * ij.gradW;
    }
};

/// Transport velocity by a background pressure of each particle's own, Zhang, Hu & Adams (2017):
///
///   p_b = min(10 |p_i|, C rho_i c^2)
///
/// At a free surface p = 0, and nothing drives particles out of it; near one little moves them at all, and the margins of
/// tutorials/verification/rotatingSquarePatch tear as without. Here with the kernel of all other sums; in the paper with half its support.
struct LocalTransport : UniformTransport
{
    static constexpr auto name = "localTransportVelocity";
    using ReadsOwn = Fields<Pressure, Density>;

    using UniformTransport::UniformTransport;
    auto finish(const auto& i, const auto& sum) const { return std::fmin(1.0, 10 * std::fabs(i.p) / (pressureOverDensity * i.rho)) * sum; }
};

struct TransportStress
{
    static constexpr auto name = "transportStress";
    using Adds = Acceleration;
    using Reads = Fields<Volume, Density, Velocity, TransportVelocity>;
    using ReadsOwn = Fields<Mass>;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return 0.5 / i.m * (sqr(i.V) + sqr(j.V)) * (i.rho * dot(i.w, ij.gradW) * i.v + j.rho * dot(j.w, ij.gradW) * j.v);
    }
};

}
