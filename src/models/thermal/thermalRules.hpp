/// Rules for the ghosts behind walls that conduct heat, and for the pressure there where fluid is buoyant.
#pragma once
#include "models/thermal/ThermalProperties.hpp"
#include "models/walls/ghostRules.hpp"

namespace sph
{

/// Linear continuation of the temperature through a wall:
///
///   T_g = T_f - q (T - T_f),    T_f the temperature of the wall at the foot of the particle (HeatAtWall::atFoot)
///
/// q = d_g/d ratio of the distances, 1 in a mirror: 2 T_w - T behind a wall of given temperature, T + 2 d q_w/kappa behind one of given heat flux q_w, and T
/// behind an adiabatic one. Of second order at a plane wall. In a corner each reflection follows the rule of its own wall.
template<int dim> class ContinuedTemperature final : public GhostRule<double, dim>
{
    const ThermalProperties& thermal_;
    FieldStore<dim>& store_;
    const double* phase_ = nullptr;

public:
    ContinuedTemperature(const ThermalProperties& t, FieldStore<dim>& store) : thermal_(t), store_(store) {}
    double operator()(double T, std::size_t source, const Reflection<dim>& r) const override
    {
        const double kappa = thermal_.kappa[phase_ ? std::size_t(phase_[source]) : 0];
        const double T_f = thermal_.walls[std::size_t(r.wall)].atFoot(T, r.distance, kappa);
        return T_f - r.ratio * (T - T_f);
    }
    double change(double dT, const Reflection<dim>& r) const override { return thermal_.walls[std::size_t(r.wall)].T ? -r.ratio * dT : dT; }
    void bind() override { phase_ = store_.has(Phase{}) ? store_.component(Phase::info.name, 0) : nullptr; }
};

/// HeatedWall of a ghost, from that of what is mirrored. `even`: ghosts behind walls that nothing passes exchange pairwise, and take part in conduction.
template<int dim> class HeatedWallOfGhost final : public GhostRule<double, dim>
{
    const ThermalProperties& thermal_;
    bool even_;

public:
    HeatedWallOfGhost(const ThermalProperties& t, bool even) : thermal_(t), even_(even) {}
    double operator()(double before, std::size_t, const Reflection<dim>& r) const override
    {
        const double withoutPart = 1 + double(thermal_.walls.size());
        if (before == withoutPart) return before;
        if (thermal_.walls[std::size_t(r.wall)].passes()) return before > 0 ? before : 1 + r.wall;
        return even_ ? before : withoutPart;
    }
    double change(double, const Reflection<dim>&) const override { return 0; }
};

/// Continuation of the pressure through a wall beside buoyant fluid: that of `ofWeight`, with the weight g (1 - beta (T_f - T0)) in place of g,
///
///   p_g = p - (1 + q) d rho n.(g (1 - beta (T_f - T0)) + f/rho)
///
/// T_f [K] temperature of the wall at the foot (HeatAtWall::atFoot), beta [1/K]. Without it dp/dn at a wall above or below is that of fluid at T0. In a corner
/// T_f is that beside the particle, not beside the ghost that is mirrored on.
template<int dim> class BuoyantPressure final : public GhostPressure<dim>
{
    const ThermalProperties& thermal_;
    FieldStore<dim>& store_;
    const Vector<3>& g_;
    std::unique_ptr<GhostPressure<dim>> ofWeight_;
    const double *rho_ = nullptr, *T_ = nullptr, *phase_ = nullptr;

public:
    BuoyantPressure(const ThermalProperties& t, FieldStore<dim>& store, const Vector<3>& g, std::unique_ptr<GhostPressure<dim>> ofWeight)
        : thermal_(t), store_(store), g_(g), ofWeight_(std::move(ofWeight))
    {}
    double operator()(double p, std::size_t source, const Reflection<dim>& r) const override
    {
        const auto k = phase_ ? std::size_t(phase_[source]) : 0;
        const double T_f = thermal_.walls[std::size_t(r.wall)].atFoot(T_[source], r.distance, thermal_.kappa[k]);
        const double lift = -thermal_.beta[k] * (T_f - thermal_.T0);
        const double byLift = -(1 + r.ratio) * r.distance * rho_[source] * lift * dot(r.normal, in<dim>(g_));
        return (*ofWeight_)(p + byLift, source, r);
    }
    double change(double dp, const Reflection<dim>& r) const override { return ofWeight_->change(dp, r); }
    void bind() override
    {
        ofWeight_->bind();
        rho_ = store_.component(Density::info.name, 0);
        T_ = store_.component(Temperature::info.name, 0);
        phase_ = store_.has(Phase{}) ? store_.component(Phase::info.name, 0) : nullptr;
    }
};

}
