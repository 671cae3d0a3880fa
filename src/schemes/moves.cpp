#include "moves.hpp"

namespace sph
{

namespace
{
/// to = from + dt rate, component by component
template<int dim, class To, class From, class Rate> void advance(ParticleSystem<dim>& particles, To, From, Rate, double deltaT)
{
    auto& store = particles.store();
    const auto to = store.pointers(To{});
    const auto from = store.pointers(From{});
    const auto rate = store.pointers(Rate{});
    const std::size_t n = particles.size();
    for (std::size_t c = 0; c < to.size(); ++c)
    {
        double* const t = to[c];
        const double *const f = from[c], *const r = rate[c];
        #pragma omp parallel for simd schedule(static)
        for (std::size_t i = 0; i < n; ++i) t[i] = f[i] + deltaT*r[i];
    }
}
template<int dim, class To, class From> void copy(ParticleSystem<dim>& particles, To, From)
{
    const auto to = particles.store().pointers(To{});
    const auto from = particles.store().pointers(From{});
    for (std::size_t c = 0; c < to.size(); ++c) std::copy_n(from[c], particles.size(), to[c]);
}
template<int dim> bool integratesDensity(const ParticleSystem<dim>& p) { return p.store().has(StartDensity{}); }
}

template<int dim> void drift(ParticleSystem<dim>& p, double deltaT)
{
    advance(p, Position{}, Position{}, Velocity{}, deltaT);
    if (p.store().has(TransportVelocity{})) advance(p, Position{}, Position{}, TransportVelocity{}, deltaT);
}

template<int dim> void kick(ParticleSystem<dim>& p, double deltaT)
{
    advance(p, Velocity{}, Velocity{}, Acceleration{}, deltaT);
    if (integratesDensity(p)) advance(p, Density{}, Density{}, DensityRate{}, deltaT);
}

template<int dim> void kickSlowly(ParticleSystem<dim>& p, double deltaT) { advance(p, Velocity{}, Velocity{}, SlowAcceleration{}, deltaT); }

template<int dim> void predict(ParticleSystem<dim>& p, double deltaT)
{
    copy(p, StartVelocity{}, Velocity{});
    if (integratesDensity(p)) copy(p, StartDensity{}, Density{});
    kick(p, deltaT);
}

template<int dim> void correct(ParticleSystem<dim>& p, double deltaT)
{
    advance(p, Velocity{}, StartVelocity{}, Acceleration{}, deltaT);
    if (integratesDensity(p)) advance(p, Density{}, StartDensity{}, DensityRate{}, deltaT);
}

template<int dim> void damp(ParticleSystem<dim>& p, double factor)
{
    for (double* v : p.store().pointers(Velocity{}))
        for (std::size_t i = 0; i < p.size(); ++i) v[i] *= factor;
}

template<int dim> void transport(ParticleSystem<dim>& p, const Settings& settings, double deltaT)
{
    auto& store = p.store();
    const auto w = store.pointers(TransportVelocity{}), a = store.pointers(TransportAcceleration{});
    const double most = 0.1*settings.resolution.spacing/deltaT;
    const std::size_t n = p.size();
    double fastest = 0;
    #pragma omp parallel for schedule(static) reduction(max: fastest)
    for (std::size_t i = 0; i < n; ++i)
    {
        Vector<dim> a_i;
        fetch(a_i, [&](int c) { return a[c][i]; });
        auto w_i = 0.5*deltaT*a_i;
        if (const double speed = mag(w_i); speed > most) w_i = most/speed*w_i;
        fastest = std::max(fastest, mag(w_i));
        sph::store(w_i, [&](int c, double q) { w[c][i] = q; });
    }
    p.moved(deltaT*fastest);
}

template<int dim> void shift(ParticleSystem<dim>& p, const Settings& settings, double maxSpeed, double deltaT)
{
    auto& store = p.store();
    const auto x = store.pointers(Position{}), v = store.pointers(Velocity{}), s = store.pointers(ShiftDirection{});
    const double spacing = settings.resolution.spacing, by = settings.shifting*deltaT*spacing, most = 0.1*spacing;
    const std::size_t n = p.size();
    double furthest = 0;
    #pragma omp parallel for schedule(static) reduction(max: furthest)
    for (std::size_t i = 0; i < n; ++i)
    {
        Vector<dim> v_i, s_i, x_i;
        fetch(v_i, [&](int c) { return v[c][i]; });
        fetch(s_i, [&](int c) { return s[c][i]; });
        fetch(x_i, [&](int c) { return x[c][i]; });
        auto dx = by*(settings.shiftsByLargestSpeed ? maxSpeed : mag(v_i))*s_i;
        if (const double d = mag(dx); d > most) dx = most/d*dx;
        furthest = std::max(furthest, mag(dx));
        sph::store(x_i + dx, [&](int c, double q) { x[c][i] = q; });
    }
    p.moved(furthest);
}

template void drift(ParticleSystem<2>&, double);
template void drift(ParticleSystem<3>&, double);
template void kick(ParticleSystem<2>&, double);
template void kick(ParticleSystem<3>&, double);
template void kickSlowly(ParticleSystem<2>&, double);
template void kickSlowly(ParticleSystem<3>&, double);
template void predict(ParticleSystem<2>&, double);
template void predict(ParticleSystem<3>&, double);
template void correct(ParticleSystem<2>&, double);
template void correct(ParticleSystem<3>&, double);
template void damp(ParticleSystem<2>&, double);
template void damp(ParticleSystem<3>&, double);
template void transport(ParticleSystem<2>&, const Settings&, double);
template void transport(ParticleSystem<3>&, const Settings&, double);
template void shift(ParticleSystem<2>&, const Settings&, double, double);
template void shift(ParticleSystem<3>&, const Settings&, double, double);

}
