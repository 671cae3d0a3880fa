#include "solver/summarise.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

/// A structure with vectors and maps: as numbers, the columns of models aside, which are sums of all ranks already.
template<> struct OfRanks<Summary>
{
    static void forEachNumber(auto& s, const auto& f)
    {
        for (auto* q : {&s.maxSpeed, &s.maxAcceleration, &s.maxSlowAcceleration, &s.kineticEnergy, &s.power, &s.momentum.x, &s.momentum.y,
                        &s.momentum.z, &s.force.x, &s.force.y, &s.force.z})
            f(*q);
        for (auto* of : {&s.mass, &s.minDensity, &s.maxDensity, &s.maxSpeedOf, &s.held.mass, &s.held.minDensity, &s.held.maxDensity})
            for (auto& q : *of) f(q);
        for (auto* of : {&s.count, &s.held.count})
            for (auto& n : *of) f(n);
    }
    static std::vector<Summary> gather(const Ranks& all, const Summary& part)
    {
        std::vector<double> numbers;
        forEachNumber(part, [&](const auto& q) { numbers.push_back(double(q)); });
        std::vector<Summary> parts;
        for (const auto& of : OfRanks<std::vector<double>>::gather(all, numbers))
        {
            auto next = of.begin();
            forEachNumber(parts.emplace_back(part), [&]<class Q>(Q& q) { q = Q(*next++); });
        }
        return parts;
    }
};

template<int dim> Summary summarise(const Particles<dim>& particles)
{
    const auto& store = particles.store();
    const auto& c = particles.coefficients();
    const auto v = store.pointers(Velocity{}), a = store.pointers(Acceleration{});
    const auto slow = store.has(SlowAcceleration{}) ? store.pointers(SlowAcceleration{}) : std::array<const double*, dim>{};
    const double *m = store.component("m", 0), *rho = store.component("rho", 0);
    const double* phase = store.has(Phase{}) ? store.component("phase", 0) : nullptr;
    const double* const holder = store.has(Holder{}) ? store.component(Holder::info.name, 0) : nullptr;
    const auto force = c.bodyForce; // [N/m^3]
    const bool driven = mag(force) > 0;
    const std::size_t phases = c.phases.size();
    Summary nothing;
    const auto clear = [&](auto& of)
    {
        of.mass.assign(phases, 0);
        of.count.assign(phases, 0);
        of.minDensity.assign(phases, std::numeric_limits<double>::infinity());
        of.maxDensity.assign(phases, -std::numeric_limits<double>::infinity());
    };
    clear(nothing);
    clear(nothing.held);
    nothing.maxSpeedOf.assign(phases, 0);
    const Smaller smaller;
    const Larger larger;
    const auto addTo = [&](auto& of, std::size_t k, double mass, double density)
    {
        of.mass[k] += mass;
        ++of.count[k];
        smaller(of.minDensity[k], density);
        larger(of.maxDensity[k], density);
    };
    const auto join = [&](auto& sum, const auto& s)
    {
        for (std::size_t k = 0; k < phases; ++k)
        {
            sum.mass[k] += s.mass[k];
            sum.count[k] += s.count[k];
            smaller(sum.minDensity[k], s.minDensity[k]);
            larger(sum.maxDensity[k], s.maxDensity[k]);
        }
    };

    auto total = reduceBlocks(
        particles.size(), nothing,
        [&](std::size_t begin, std::size_t end)
        {
            Summary s = nothing;
            double v2 = 0, a2 = 0, slow2 = 0;
            for (std::size_t i = begin; i < end; ++i)
            {
                Vector<dim> v_i, a_i;
                fetch(v_i, [&](int k) { return v[k][i]; });
                fetch(a_i, [&](int k) { return a[k][i]; });
                const std::size_t k = phase ? std::size_t(phase[i]) : 0;
                larger(v2, dot(v_i, v_i));
                larger(a2, dot(a_i, a_i));
                if (slow[0])
                {
                    fetch(a_i, [&](int d) { return slow[d][i]; });
                    larger(slow2, dot(a_i, a_i));
                }
                if (holder && holder[i] > 0)
                {
                    addTo(s.held, k, m[i], rho[i]);
                    continue;
                }
                larger(s.maxSpeedOf[k], dot(v_i, v_i)); // its square, to the end of the block
                s.kineticEnergy += 0.5 * m[i] * dot(v_i, v_i);
                s.momentum += m[i] * in3D(v_i);
                if (driven)
                {
                    s.power += m[i] / rho[i] * dot(force, in3D(v_i));
                    s.force += m[i] / rho[i] * force;
                }
                addTo(s, k, m[i], rho[i]);
            }
            for (double& speed : s.maxSpeedOf) speed = std::sqrt(speed);
            s.maxSpeed = std::sqrt(v2);
            s.maxAcceleration = std::sqrt(a2);
            s.maxSlowAcceleration = std::sqrt(slow2);
            return s;
        },
        [&](Summary& sum, const Summary& s)
        {
            larger(sum.maxSpeed, s.maxSpeed);
            larger(sum.maxAcceleration, s.maxAcceleration);
            larger(sum.maxSlowAcceleration, s.maxSlowAcceleration);
            sum.kineticEnergy += s.kineticEnergy;
            sum.momentum += s.momentum;
            sum.power += s.power;
            sum.force += s.force;
            join(sum, s);
            join(sum.held, s.held);
            for (std::size_t k = 0; k < phases; ++k) larger(sum.maxSpeedOf[k], s.maxSpeedOf[k]);
        });
    total.power += dot(c.g, total.momentum);
    for (const double mass : total.mass) total.force += mass * c.g;
    for (const auto& model : particles.runningModels()) total.columns.merge(model->columns(particles));
    const auto finite = [](double q) { return std::isfinite(q); };
    total.finite = finite(total.kineticEnergy) && finite(total.maxSpeed) && finite(total.power) && finite(total.maxAcceleration) &&
                   finite(total.maxSlowAcceleration) &&
                   std::ranges::all_of(total.columns, finite, [](const auto& column) { return column.second; });
    const auto densitiesFinite = [&](const auto& of, std::size_t k)
    { return of.count[k] == 0 || (finite(of.minDensity[k]) && finite(of.maxDensity[k])); };
    for (std::size_t k = 0; k < phases; ++k) total.finite = total.finite && densitiesFinite(total, k) && densitiesFinite(total.held, k);
    return total;
}

template Summary summarise(const Particles<2>&);
template Summary summarise(const Particles<3>&);

}
