/// Water that stands on the soil, up to `waterLevel`: at rest, of the pressure p_o = rho_w g (level - y) on free surfaces, y [m] the height against gravity. Soil beneath it is in equilibrium with
///
///   rho dv/dt = div(sigma - (chi p - p_o) I) + rho g - grad p_o
///
/// in which p_o goes on into the soil as it is outside. It is the same equation, whatever p_o is in there; but a free surface, where nothing answers (ActingStress.hpp), has so the traction -p_o n, and water
/// at rest within water at rest exerts no force at all: what is left is its lift. At the level the gradient rises from 0 to that of water over a spacing, since particles that the level passes would start.
///
/// p_o [Pa], rho_w [kg/m^3]. Verified by test/unit/soil (a column and a slope below water).
#pragma once
#include "models/soil/PoreWater.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

class OuterWater
{
    const PoreWater* water_; ///< null: none stands there
    const Vector<3>& g_;

public:
    explicit OuterWater(const Coefficients& c)
        : water_(c.has<PoreWater>() && c.of<PoreWater>().level ? &c.of<PoreWater>() : nullptr), g_(c.g)
    {}
    bool exists() const { return water_; }
    /// p_o
    template<int dim> double pressure(Vector<dim> x) const
    {
        if (!water_) return 0;
        const double depth = depthOf(x), a = 0.5 * water_->lattice.spacing;
        return water_->density * mag(g_) * (depth <= -a ? 0 : depth < a ? sqr(depth + a) / (4 * a) : depth);
    }
    /// grad p_o
    template<int dim> Vector<dim> gradient(Vector<dim> x) const
    {
        if (!water_) return {};
        return water_->density * std::clamp(depthOf(x) / water_->lattice.spacing + 0.5, 0.0, 1.0) * in<dim>(g_);
    }

private:
    /// The depth of a place below the level [m].
    template<int dim> double depthOf(Vector<dim> x) const
    {
        const double g = mag(g_);
        return water_->level->now + (g > 0 ? dot(in<dim>(g_), x) / g : 0);
    }
};

/// -grad p_o/max(rho, rho_0): a grain that is thrown ahead loses density as it leaves the others, and displaces no more water for it.
struct LiftOfOuterWater
{
    static constexpr auto name = "outerWater";
    using Adds = Acceleration;
    using ReadsOwn = Fields<Position, Density>;
    OuterWater standing;
    double rho_0;

    explicit LiftOfOuterWater(const Coefficients& c) : standing(c), rho_0(c.restDensity[0]) {}
    auto operator()(const auto& i) const { return -1 / std::fmax(i.rho, rho_0) * standing.gradient(i.x); }
};

}
