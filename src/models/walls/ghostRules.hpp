/// Rules for the velocity of a wall ghost, from that of the particle it mirrors: they make a wall stick or slip. Particles of wall layers
/// (images/layerPairs.hpp) have the same rules at distances d_g = q d of their own; q = 1 for a mirror image.
#pragma once
#include "images/Images.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

/// No slip, of first order in the distance; with q = 1 the mirror's rule of Barker et al. (2012), and in layers that of Morris et al. (1997) but for their limit:
///
///   v_g = v_w - q (v - v_w)
template<int dim> class ReflectedVelocity : public GhostVelocity<dim>
{
    const Geometry& geometry_;

public:
    explicit ReflectedVelocity(const Geometry& g) : geometry_(g) {}
    Vector<dim> operator()(Vector<dim> v, std::size_t source, const Reflection<dim>&) const override;
    Vector<dim> change(Vector<dim> dv, const Reflection<dim>&) const override;
};

/// No slip in layers as Morris et al. (1997) print it:
///
///   v_g = v_w - min(q, beta - 1) (v - v_w),    beta = 1.5
///
/// They limit beta = 1 + d_g/d so that a particle close to the wall sees no large velocity behind it. On a lattice every row within a support of the wall is limited, and the fluid slips
/// (images/layerPairs.hpp). The rule is of first order.
template<int dim> class LimitedVelocity final : public ReflectedVelocity<dim>
{
public:
    using ReflectedVelocity<dim>::ReflectedVelocity;
    Vector<dim> change(Vector<dim> dv, const Reflection<dim>&) const override;
};

/// Share of the even part d^2 v'' that a ghost of a ghost has, by the cosine `facing` = -n.m of the angle alpha between its two walls: 1 up to 60 degrees, 0 from 80 on.
///
///   v = a/(2 nu cos(alpha)) d_1 d_2 + C r^(pi/alpha) sin(pi theta/alpha)
///
/// is the steady flow along the edge of a wedge, d_1, d_2 [m] distances from its two planes. Its second part changes its sign in every reflection. The first has v'' = -a/nu across either plane and is a polynomial: what
/// continues it through one plane continues it through the other as well, and it is the larger part where alpha < 90 degrees. Parallel plates, alpha = 0, have a parabola at any width. At 90 degrees one image stands for those of both orders,
/// whose even parts, of x^2 - y^2 and y^2 - x^2, cancel; in an open corner the second part is the larger one.
double evenShare(double facing);

/// Second-order no slip: the smooth continuation of the flow through the wall, from its momentum balance there.
///
///   v_g = v_w - q c (v - v_w) - (1 + c)/2 q (1 + q)/2 d^2/nu (a_p + g - dv_w/dt)_t,    c = 1/sqrt(w)
///
/// w volume factor of the reflection: c = (R + d)/(R - d) outside a sphere; d [m] distance of the source, nu = mu/rho [m^2/s] of the source
/// where it is not the same everywhere, a_p = (-grad p + surface tension)/rho of the source, low-passed; t the part along the wall. From
/// nu laplacian(v) = -(a_p + g) at the wall, where v - v_w = 0: the ghost carries the even part d^2 v'' that a bare sign change loses. Outside a sphere the rule is exact
/// for the flow -a/(6 nu) (r^2 - 3 R^2 + 2 R^3/r) + B (1/R - 1/r), at other curved walls to the third order in d. A gradient of
/// mu at the wall is left out. A ghost of a ghost has evenShare of the even part.
template<int dim> class SecondOrderVelocity : public GhostVelocity<dim>
{
    const Geometry& geometry_;
    FieldStore<dim>& store_;
    const Vector<3>& g_;
    Vector<dim> f_;
    double rho_, mu_;
    bool varies_;

public:
    /// `varies`: mu and rho are the source's own.
    SecondOrderVelocity(const Geometry&, FieldStore<dim>&, const Coefficients&, bool varies);
    Vector<dim> operator()(Vector<dim> v, std::size_t source, const Reflection<dim>&) const override;
    Vector<dim> change(Vector<dim> dv, const Reflection<dim>&) const override;
    /// Binds the rule again after each change of the arrays.
    void bind() override;
    /// Moves a_w, the low-passed a_p, a tenth of the way to the latest a_p. Once a step: an evaluation leaves no trace.
    void filter() override;

private:
    std::array<double*, dim> a_{};
    const double *rhoOf_ = nullptr, *muOf_ = nullptr;
};

/// Hydrostatic continuation of the pressure through the wall (Barker et al. 2012 do not say what they took):
///
///   p_g = p - (1 + q) d rho n.(g + f/rho)
///
/// d [m] distance of the source from the wall, n normal into the fluid, rho [kg/m^3] of the source, f [N/m^3] body force. A ghost with its
/// source's pressure says that dp/dn = 0 where a fluid at rest has rho g: measured on a column of 32 spacings, the pressure is
/// 3 to 5 % off, in alternating rows from the walls inwards.
template<int dim> class HydrostaticPressure : public GhostPressure<dim>
{
protected:
    FieldStore<dim>& store_;
    const Vector<3>& g_;
    Vector<dim> f_;
    const double* rho_ = nullptr;

public:
    HydrostaticPressure(FieldStore<dim>& store, const Coefficients& c) : store_(store), g_(c.g), f_(in<dim>(c.bodyForce)) {}
    double operator()(double p, std::size_t source, const Reflection<dim>&) const override;
    double change(double dp, const Reflection<dim>&) const override { return dp; }
    void bind() override { rho_ = store_.component(Density::info.name, 0); }
};

/// Hydrostatic continuation of the pressure without suction, for a liquid with a free surface, which may leave the wall:
///
///   p_g = max(p - (1 + q) d rho n.(g + f/rho), min(p, 0))
///
/// Under a lid the hydrostatic continuation of a drop's p = 0 is a tension, by which it hangs there for good.
template<int dim> class DetachingPressure final : public HydrostaticPressure<dim>
{
public:
    using HydrostaticPressure<dim>::HydrostaticPressure;
    double operator()(double p, std::size_t source, const Reflection<dim>&) const override;
    double change(double dp, const Reflection<dim>&) const override { return dp; }
};

/// Slip, a mirror where q = 1:
///
///   v_g = v - (1 + q) n.(v - v_w) n
///
/// In layers it goes with values interpolated along the wall.
template<int dim> class SlippingVelocity : public GhostVelocity<dim>
{
    const Geometry& geometry_;

public:
    explicit SlippingVelocity(const Geometry& g) : geometry_(g) {}
    Vector<dim> operator()(Vector<dim> v, std::size_t source, const Reflection<dim>&) const override;
    Vector<dim> change(Vector<dim> dv, const Reflection<dim>&) const override;
};

/// Walls that slip beside others: each ghost by the rule of the wall that it was mirrored in. A wall of friction slips, too: what it does along itself its shear stress says (models/soil/WallFriction.hpp).
template<int dim> class VelocityByWall final : public GhostVelocity<dim>
{
    const Geometry& geometry_;
    SlippingVelocity<dim> slipping_;
    std::unique_ptr<GhostVelocity<dim>> ofOthers_;

    const GhostVelocity<dim>& of(const Reflection<dim>& r) const
    {
        const auto& wall = geometry_.walls[std::size_t(r.wall)];
        if (wall.slips || wall.frictionAngle) return slipping_;
        return *ofOthers_;
    }

public:
    VelocityByWall(const Geometry& g, std::unique_ptr<GhostVelocity<dim>> ofOthers)
        : geometry_(g), slipping_(g), ofOthers_(std::move(ofOthers))
    {}
    Vector<dim> operator()(Vector<dim> v, std::size_t source, const Reflection<dim>& r) const override { return of(r)(v, source, r); }
    Vector<dim> change(Vector<dim> dv, const Reflection<dim>& r) const override { return of(r).change(dv, r); }
    void bind() override { ofOthers_->bind(); }
    void filter() override { ofOthers_->filter(); }
};

}
