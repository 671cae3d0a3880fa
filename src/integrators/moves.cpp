#include "integrators/moves.hpp"
#include "parallel/reduce.hpp"
#include "scene/TwoLevels.hpp"

namespace sph
{

namespace
{
/// to = from + dt rate, component by component
template<int dim>
void advance(Particles<dim>& particles, const StateField& field, const std::string& to, const std::string& from, const std::string& rate,
             double deltaT)
{
    auto& store = particles.store();
    const std::size_t n = particles.size();
    for (int c = 0; c < field.in(dim); ++c)
    {
        double* const t = store.component(to, c);
        const double *const f = store.component(from, c), *const r = store.component(rate, c);
#pragma omp parallel for simd schedule(static)
        for (std::size_t i = 0; i < n; ++i) t[i] = f[i] + deltaT * r[i];
    }
}
/// Calls f for all fields that a kick acts on.
template<int dim> void forEachKicked(Particles<dim>& particles, const auto& f)
{
    for (const auto& evolving : particles.settings().state)
        if (evolving.rate && !evolving.advancedByModel) f(evolving);
}
}

template<int dim> void drift(Particles<dim>& p, double deltaT)
{
    const std::string x = Position::info.name;
    advance(p, stateField(Position{}), x, x, Velocity::info.name, deltaT);
    if (const auto added = p.settings().facts.template get<DriftVelocity>().field; !added.empty())
        advance(p, stateField(Position{}), x, x, added, deltaT);
    p.driftWalls(deltaT);
}

template<int dim> void driftByAcceleration(Particles<dim>& p, double square)
{
    const std::string x = Position::info.name;
    advance(p, stateField(Position{}), x, x, Acceleration::info.name, square);
}

template<int dim> void kick(Particles<dim>& p, double deltaT)
{
    forEachKicked(p, [&](const Evolving& q) { advance(p, q.value, q.value.name, q.value.name, q.rate->name, deltaT); });
}

template<int dim> void kickCarried(Particles<dim>& p, double deltaT)
{
    forEachKicked(p,
                  [&](const Evolving& q)
                  {
                      if (q.value.name != Velocity::info.name && q.value.name != Density::info.name)
                          advance(p, q.value, q.value.name, q.value.name, q.rate->name, deltaT);
                  });
}

template<int dim> void kickFromTwoLevels(Particles<dim>& p, double deltaT, double lastDeltaT)
{
    const double span = lastDeltaT + deltaT, kept = lastDeltaT > 0 ? 1 : 0;
    forEachKicked(p,
                  [&](const Evolving& q)
                  {
                      for (int c = 0; c < q.value.in(dim); ++c)
                      {
                          double *const value = p.store().component(q.value.name, c), *const d =
                                                                                          p.store().component(incrementOf(q.value), c);
                          const double* const rate = p.store().component(q.rate->name, c);
                          const std::size_t n = p.size();
#pragma omp parallel for simd schedule(static)
                          for (std::size_t i = 0; i < n; ++i)
                          {
                              d[i] = span * rate[i] - kept * d[i];
                              value[i] += d[i];
                          }
                      }
                  });
}

template<int dim> void kickSlowly(Particles<dim>& p, double deltaT)
{
    advance(p, stateField(Velocity{}), Velocity::info.name, Velocity::info.name, SlowAcceleration::info.name, deltaT);
}

template<int dim> void predict(Particles<dim>& p, double deltaT)
{
    forEachKicked(p,
                  [&](const Evolving& q)
                  {
                      for (int c = 0; c < q.value.in(dim); ++c)
                      {
                          const double* const value = p.store().component(q.value.name, c);
                          double* const start = p.store().component(q.startName(), c);
                          const std::size_t n = p.size();
#pragma omp parallel for simd schedule(static)
                          for (std::size_t i = 0; i < n; ++i) start[i] = value[i];
                      }
                  });
    kick(p, deltaT);
    p.setPredicted(true);
}

template<int dim> void correct(Particles<dim>& p, double deltaT)
{
    p.setPredicted(false);
    forEachKicked(p, [&](const Evolving& q) { advance(p, q.value, q.value.name, q.startName(), q.rate->name, deltaT); });
}

template<int dim> double largestAcceleration(const Particles<dim>& p)
{
    const auto a = p.store().pointers(Acceleration{});
    return std::sqrt(reduce(
        p.size(), 0.0,
        [&](std::size_t i)
        {
            double a2 = 0;
            for (int c = 0; c < dim; ++c) a2 += sqr(a[c][i]);
            return a2;
        },
        Larger{}));
}

template void drift(Particles<2>&, double);
template void drift(Particles<3>&, double);
template void driftByAcceleration(Particles<2>&, double);
template void driftByAcceleration(Particles<3>&, double);
template void kick(Particles<2>&, double);
template void kick(Particles<3>&, double);
template void kickCarried(Particles<2>&, double);
template void kickCarried(Particles<3>&, double);
template void kickSlowly(Particles<2>&, double);
template void kickSlowly(Particles<3>&, double);
template void predict(Particles<2>&, double);
template void predict(Particles<3>&, double);
template void correct(Particles<2>&, double);
template void correct(Particles<3>&, double);
template void kickFromTwoLevels(Particles<2>&, double, double);
template void kickFromTwoLevels(Particles<3>&, double, double);
template double largestAcceleration(const Particles<2>&);
template double largestAcceleration(const Particles<3>&);

}
