/// Artificial viscosity with the speed of sound of the soil's present stiffness: Monaghan & Gingold (1983), eq. (11) of Peng, Wu & Yu (2014), who take c = 600 m/s.
///
///   dv_i/dt = alpha h/m_i sum_j V_i V_j (c_i + c_j)/2 (rho_i + rho_j)/2 q_ij/(r_ij^2 + 0.01 h^2) gradW_ij,    q = min(0, v_ij . x_ij)
///
/// alpha [1], h = H/2 [m], c [m/s] = sqrt(M/rho) of each particle, rho [kg/m^3], V [m^3], m [kg]. On approach alone, or q = v_ij . x_ij with `viscosityActs always`. Conserves linear
/// and angular momentum exactly and takes kinetic energy only. Verified by test/unit/soil (momentum).
#pragma once
#include "models/soil/SoilFields.hpp"
#include "operators/VelocityGradient.hpp"
#include "plan/Coefficients.hpp"
#include <cmath>

namespace sph
{

struct SoilViscosity
{
    static constexpr auto name = "soilViscosity";
    using Adds = Acceleration;
    using Reads = Fields<Volume, Velocity, Density, SoilSound>;
    using ReadsOwn = Fields<Mass>;
    double coefficient, small, onRecession;

    explicit SoilViscosity(const Coefficients& c)
        : coefficient(c.of<SoilNumbers>().alpha * 0.5 * c.support),
          small(0.01 * sqr(0.5 * c.support)),
          onRecession(c.of<SoilNumbers>().actsOnRecession)
    {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double vx = dot(i.v - j.v, ij.x), q = std::fmin(0.0, vx) + onRecession * std::fmax(0.0, vx);
        return of(q, ij, i, j);
    }

protected:
    auto of(double q, const auto& ij, const auto& i, const auto& j) const
    {
        return coefficient / i.m * i.V * j.V * 0.25 * (i.c + j.c) * (i.rho + j.rho) * q / (ij.rr + small) * ij.gradW;
    }
};

/// The same upon what is no smooth flow, `viscosityActs onNoise`: of the relative velocity, what is left of it when the gradients of both have been taken off.
///
///   q = v_ij . x_ij - x_ij . (L_i + L_j) . x_ij/2
///
/// L [1/s] velocity gradient (VelocityGradient.hpp): velocities that are linear in space are not resisted, and motion from particle to particle, which no strain and so no stress answers, is. Soil that flows
/// plastically is full of it: beneath a footing particles went at 15 times its speed, and its load was half of Prandtl's. Conserves linear and angular momentum exactly; the velocities are those of the forces.
struct SoilNoiseViscosity : SoilViscosity
{
    static constexpr auto name = "soilNoiseViscosity";
    using Reads = Fields<Volume, Velocity, Density, SoilSound, VelocityGradient>;
    using SoilViscosity::SoilViscosity;
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return of(dot(i.v - j.v - 0.5 * ((i.L + j.L) * ij.x), ij.x), ij, i, j);
    }
};

}
