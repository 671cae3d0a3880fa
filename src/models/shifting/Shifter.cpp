#include "models/shifting/Shifter.hpp"
#include "parallel/reduce.hpp"
#include <cmath>
#include <limits>

namespace sph
{

template<int dim> std::vector<Stage<dim>> Shifter<dim>::stages(JoinPoint place)
{
    if (place != JoinPoint::afterDrift) return {};
    return {{"shift", byImplicitSteps_ ? "x += min(C |v| dt Delta_x, H^2/50) shift" : "x += C |v| dt Delta_x shift",
             [this](Particles<dim>& p, const Substep& s) { shift(p, s.deltaT); }}};
}

template<int dim> void Shifter<dim>::shift(Particles<dim>& p, double deltaT) const
{
    auto& store = p.store();
    const auto x = store.pointers(Position{}), v = store.pointers(Velocity{}), s = store.pointers(ShiftDirection{});
    const double spacing = p.coefficients().spacing, by = C_ * deltaT * spacing, furthest = 0.1 * spacing;
    const double largest = byImplicitSteps_ ? sqr(p.coefficients().support) / 50 : std::numeric_limits<double>::infinity();
    p.moved(most(p.size(),
                 [&](std::size_t i)
                 {
                     const auto x_i = valueAt<Vector<dim>>(x, i), v_i = valueAt<Vector<dim>>(v, i);
                     auto dx = std::fmin(largest, by * (byLargestSpeed_ ? p.maxSpeed() : mag(v_i))) * valueAt<Vector<dim>>(s, i);
                     if (const double d = mag(dx); d > furthest) dx = furthest / d * dx;
                     sph::store(x_i + dx, [&](int c, double q) { x[c][i] = q; });
                     return mag(dx);
                 }));
}

template<int dim> std::vector<Stage<dim>> Transporter<dim>::stages(JoinPoint place)
{
    if (place != JoinPoint::beforeDrift) return {};
    return {{"transport velocity", "w = dt/2 a",
             [](Particles<dim>& p, const Substep& substep)
             {
                 auto& store = p.store();
                 const auto w = store.pointers(TransportVelocity{}), a = store.pointers(TransportAcceleration{});
                 const double furthest = 0.1 * p.coefficients().spacing / substep.deltaT;
                 p.moved(substep.deltaT * most(p.size(),
                                               [&](std::size_t i)
                                               {
                                                   auto w_i = 0.5 * substep.deltaT * valueAt<Vector<dim>>(a, i);
                                                   if (const double speed = mag(w_i); speed > furthest) w_i = furthest / speed * w_i;
                                                   sph::store(w_i, [&](int c, double q) { w[c][i] = q; });
                                                   return mag(w_i);
                                               }));
             }}};
}

template class Shifter<2>;
template class Shifter<3>;
template class Transporter<2>;
template class Transporter<3>;

}
