#include "ghostVelocities.hpp"

namespace sph
{

template<int dim>
Vector<dim> ReflectedVelocity<dim>::operator()(Vector<dim> v, std::size_t, const Reflection<dim>& r, bool) const
{
    return 2*in<dim>(geometry_.wallVelocity(r.wall, r.foot)) - v;
}

template<int dim>
SecondOrderVelocity<dim>::SecondOrderVelocity(const Geometry& geometry, FieldStore<dim>& store, const Coefficients& c)
    : geometry_(geometry), store_(store), g_(in<dim>(c.g) + in<dim>(c.bodyForce)/c.restDensity[0]), nu_(c.viscosity[0]/c.restDensity[0])
{}

template<int dim> void SecondOrderVelocity<dim>::bind()
{
    const auto p = store_.pointers(WallAcceleration{});
    std::copy(p.begin(), p.end(), a_.begin());
}

template<int dim>
Vector<dim> SecondOrderVelocity<dim>::operator()(Vector<dim> v, std::size_t source, const Reflection<dim>& r, bool once) const
{
    const auto v_w = in<dim>(geometry_.wallVelocity(r.wall, r.foot));
    const auto continued = v_w - 1/std::sqrt(r.weight)*(v - v_w);
    if (!once) return continued;
    Vector<dim> a;
    fetch(a, [&](int c) { return a_[c][source]; });
    a += g_ - in<dim>(geometry_.wallAcceleration(r.wall, r.foot));
    return continued - sqr(r.distance)/nu_*(a - dot(a, r.normal)*r.normal);
}

template<int dim>
Vector<dim> SlippingVelocity<dim>::operator()(Vector<dim> v, std::size_t, const Reflection<dim>& r, bool) const
{
    const auto v_w = in<dim>(geometry_.wallVelocity(r.wall, r.foot));
    return v_w + mirrored(v - v_w, r.normal);
}

template class ReflectedVelocity<2>;
template class ReflectedVelocity<3>;
template class SecondOrderVelocity<2>;
template class SecondOrderVelocity<3>;
template class SlippingVelocity<2>;
template class SlippingVelocity<3>;

}
