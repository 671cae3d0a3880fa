#include "models/walls/ghostRules.hpp"

namespace sph
{

template<int dim> Vector<dim> ReflectedVelocity<dim>::operator()(Vector<dim> v, std::size_t, const Reflection<dim>& r) const
{
    const auto v_w = in<dim>(geometry_.wallVelocity(r.wall, r.foot));
    return v_w + change(v - v_w, r);
}

template<int dim> Vector<dim> ReflectedVelocity<dim>::change(Vector<dim> dv, const Reflection<dim>& r) const { return -r.ratio * dv; }

template<int dim> Vector<dim> LimitedVelocity<dim>::change(Vector<dim> dv, const Reflection<dim>& r) const
{
    constexpr double beta = 1.5;
    return -std::fmin(r.ratio, beta - 1) * dv;
}

double evenShare(double facing)
{
    constexpr double nothing = 0.174, whole = 0.5; // 80 and 60 degrees
    return smoothStep((facing - nothing) / (whole - nothing));
}

template<int dim>
SecondOrderVelocity<dim>::SecondOrderVelocity(const Geometry& geometry, FieldStore<dim>& store, const Coefficients& c, bool varies)
    : geometry_(geometry), store_(store), g_(c.g), f_(in<dim>(c.bodyForce)), rho_(c.restDensity[0]), mu_(c.viscosity[0]), varies_(varies)
{}

template<int dim> void SecondOrderVelocity<dim>::bind()
{
    a_ = store_.pointers(WallAcceleration{});
    if (!varies_) return;
    rhoOf_ = store_.component(Density::info.name, 0);
    muOf_ = store_.component(DynamicViscosity::info.name, 0);
}

template<int dim> void SecondOrderVelocity<dim>::filter()
{
    const double share = 0.1; // 0.1, 0.3 and 1 were stable; 0.1 keeps sound waves out of the wall
    const auto a_p = store_.pointers(PressureAcceleration{});
    const std::size_t n = store_.owned();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < dim; ++c) a_[c][i] += share * (a_p[c][i] - a_[c][i]);
}

template<int dim> Vector<dim> SecondOrderVelocity<dim>::operator()(Vector<dim> v, std::size_t source, const Reflection<dim>& r) const
{
    const auto v_w = in<dim>(geometry_.wallVelocity(r.wall, r.foot));
    const auto continued = v_w + change(v - v_w, r);
    const double share = evenShare(r.facing);
    if (share == 0) return continued;
    auto a = valueAt<Vector<dim>>(a_, source);
    const WallProperties& wall = geometry_.walls[r.wall];
    const double rho = varies_ ? rhoOf_[source] : rho_, nu = (varies_ ? muOf_[source] : mu_) / rho;
    a += in<dim>(g_) + f_ / rho - in<dim>(cross(wall.omega, cross(wall.omega, r.foot - wall.origin)));
    const double evenPart = share * 0.25 * (1 + 1 / std::sqrt(r.weight)) * r.ratio * (1 + r.ratio) * sqr(r.distance) / nu;
    return continued - evenPart * (a - dot(a, r.normal) * r.normal);
}

template<int dim> Vector<dim> SecondOrderVelocity<dim>::change(Vector<dim> dv, const Reflection<dim>& r) const
{
    return -r.ratio / std::sqrt(r.weight) * dv;
}

template<int dim> Vector<dim> SlippingVelocity<dim>::operator()(Vector<dim> v, std::size_t, const Reflection<dim>& r) const
{
    const auto v_w = in<dim>(geometry_.wallVelocity(r.wall, r.foot));
    return v_w + change(v - v_w, r);
}

template<int dim> Vector<dim> SlippingVelocity<dim>::change(Vector<dim> dv, const Reflection<dim>& r) const
{
    return dv - (1 + r.ratio) * dot(r.normal, dv) * r.normal;
}

template<int dim> double HydrostaticPressure<dim>::operator()(double p, std::size_t source, const Reflection<dim>& r) const
{
    return p - (1 + r.ratio) * r.distance * dot(r.normal, rho_[source] * in<dim>(g_) + f_);
}

template<int dim> double DetachingPressure<dim>::operator()(double p, std::size_t source, const Reflection<dim>& r) const
{
    return std::fmax(HydrostaticPressure<dim>::operator()(p, source, r), std::fmin(p, 0.0));
}

template class DetachingPressure<2>;
template class DetachingPressure<3>;
template class HydrostaticPressure<2>;
template class HydrostaticPressure<3>;
template class LimitedVelocity<2>;
template class LimitedVelocity<3>;
template class ReflectedVelocity<2>;
template class ReflectedVelocity<3>;
template class SecondOrderVelocity<2>;
template class SecondOrderVelocity<3>;
template class SlippingVelocity<2>;
template class SlippingVelocity<3>;

}
