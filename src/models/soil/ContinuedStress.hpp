/// Continuation of the acting stress to a wall ghost, from that of the particle it mirrors:
///
///   S_g = R S R + 2 d rho n.(g + f/rho) n n      behind a wall that slips: no shear stress at the wall, R = I - 2 n n
///   S_g = S     + 2 d rho n.(g + f/rho) n n      behind a wall that holds the soil: its shear stress goes on
///   S_g = S + n b + b n + ...,  b = 2 (T n - S n)_t      behind one of a given friction angle: on the wall T acts (WallFriction.hpp)
///
/// d [m] distance of the source from the wall, n normal into the soil, rho [kg/m^3], f [N/m^3] body force, with -grad p_o where water stands on the soil (OuterWater.hpp). The second part is the momentum balance of soil at rest across the wall; of the
/// stresses along a plane wall nothing pushes at it, and they are those of the source. With `wallPressure detaching` S_nn <= max(S_nn of the source, 0): no suction; with `mirrored` it is
/// left out. Verified by test/unit/soil.
#pragma once
#include "images/Images.hpp"
#include "models/soil/OuterWater.hpp"
#include "models/soil/SoilFields.hpp"
#include "plan/Coefficients.hpp"
#include <string>

namespace sph
{

template<int dim> class ContinuedStress final : public GhostRule<SymmTensor<dim>, dim>
{
    const Geometry& geometry_;
    FieldStore<dim>& store_;
    const Vector<3>& g_;
    Vector<dim> f_;
    bool slips_, continues_, detaches_;
    OuterWater standing_;
    const double* rho_ = nullptr;
    std::array<const double*, dim> x_{};
    std::array<double*, fieldComponents<WallShear, dim>> shear_{};

public:
    /// `slips`: all walls do; `pressure`: word of wallPressure.
    ContinuedStress(const Geometry& geometry, FieldStore<dim>& store, const Coefficients& c, bool slips, const std::string& pressure)
        : geometry_(geometry),
          store_(store),
          g_(c.g),
          f_(in<dim>(c.bodyForce)),
          slips_(slips),
          continues_(pressure != "mirrored"),
          detaches_(pressure == "detaching"),
          standing_(c)
    {}
    SymmTensor<dim> operator()(SymmTensor<dim> S, std::size_t source, const Reflection<dim>& r) const override
    {
        const auto beyond = rubs(r) ? S + withShear(S, source, r.normal) : change(S, r);
        if (!continues_) return beyond;
        const double S_nn = dot(r.normal, S * r.normal), apart = (1 + r.ratio) * r.distance;
        const double rise = apart * dot(r.normal, rho_[source] * in<dim>(g_) + f_) + liftTo(apart, source, r);
        const double allowed = detaches_ ? std::fmin(rise, std::fmax(0.0, -S_nn)) : rise;
        return beyond + allowed * outer(r.normal);
    }
    SymmTensor<dim> change(SymmTensor<dim> dS, const Reflection<dim>& r) const override
    {
        return slips_ || geometry_.walls[std::size_t(r.wall)].slips || rubs(r) ? mirrored(dS, r.normal) : dS;
    }
    void bind() override
    {
        rho_ = store_.component(Density::info.name, 0);
        if (standing_.exists()) x_ = std::as_const(store_).pointers(Position{});
        if (geometry_.withFriction()) shear_ = store_.pointers(WallShear{});
    }

private:
    bool rubs(const Reflection<dim>& r) const { return geometry_.walls[std::size_t(r.wall)].frictionAngle.has_value(); }
    /// p_o of the ghost less that of its source
    double liftTo(double apart, std::size_t source, const Reflection<dim>& r) const
    {
        if (!standing_.exists()) return 0;
        const auto x = valueAt<Vector<dim>>(x_, source);
        return standing_.pressure(x - apart * r.normal) - standing_.pressure(x);
    }
    /// n b + b n
    SymmTensor<dim> withShear(SymmTensor<dim> S, std::size_t source, Vector<dim> n) const
    {
        const auto lacking = (valueAt<SymmTensor<dim>>(shear_, source) - S) * n, b = 2 * (lacking - dot(n, lacking) * n);
        return 2.0 * symm(outer(n, b));
    }
};

}
