#include "EnergyBalance.hpp"
#include "reduce.hpp"
#include "words.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

namespace sph
{

namespace
{
constexpr std::pair<const char*, double Vector<3>::*> impulseComponents[]{{"impulseX", &Vector<3>::x},
                                                                          {"impulseY", &Vector<3>::y},
                                                                          {"impulseZ", &Vector<3>::z}};

template<int dim> const double* componentOf(const Particles<dim>& particles, const char* name, int c = 0)
{
    return particles.store().fields().at(name).component[std::size_t(c)].data();
}

/// x(i) [m]
template<int dim> auto positionsOf(const Particles<dim>& particles)
{
    std::array<const double*, dim> at;
    for (int c = 0; c < dim; ++c) at[std::size_t(c)] = componentOf(particles, Position::info.name, c);
    return [at](std::size_t i) { return valueAt<Vector<dim>>(at, i); };
}
}

std::string sourceInWords(const std::map<std::string, double>& workOfEach)
{
    std::vector<std::pair<double, std::string>> all;
    for (const auto& [operation, work] : workOfEach) all.emplace_back(work, operation);
    std::sort(all.rbegin(), all.rend());
    std::vector<std::string> each;
    for (const auto& [work, operation] : all) each.push_back(fmt::format("{} {:.3g} J", operation, work));
    const bool isFed = !all.empty() && all.front().first > 0;
    return fmt::format("{}: work of {}",
                       isFed ? "what feeds it is " + all.front().second : "no operation feeds it any more, each takes energy", list(each));
}

template<int dim>
EnergyBalance<dim>::EnergyBalance(const Particles<dim>& particles, const Settings& settings, const Geometry& geometry,
                                  const Summary& summary)
    : settings_(settings)
{
    given_ = summary.kineticEnergy + interfaces(particles) + compression(particles) + allowance(particles, summary) +
             walls(particles, geometry, summary);
}

template<int dim> void EnergyBalance<dim>::addWork(double work)
{
    work_ += work;
    mostWork_ = std::max(mostWork_, work_);
}

template<int dim> void EnergyBalance<dim>::save(Numbers& numbers) const
{
    numbers["energyGiven"] = given_;
    numbers["work"] = work_;
    numbers["mostWork"] = mostWork_;
    for (const auto& [name, c] : impulseComponents) numbers[name] = impulse_.*c;
}

template<int dim> void EnergyBalance<dim>::restore(const Numbers& numbers)
{
    const auto given = numbers.find("energyGiven"), work = numbers.find("work"), most = numbers.find("mostWork");
    if (given == numbers.end() || work == numbers.end() || most == numbers.end()) return;
    given_ = given->second;
    work_ = work->second;
    mostWork_ = most->second;
    for (const auto& [name, c] : impulseComponents)
        if (const auto found = numbers.find(name); found != numbers.end()) impulse_.*c = found->second;
}

template<int dim> double EnergyBalance<dim>::interfaces(const Particles<dim>& particles) const
{
    const auto& c = settings_.coefficients;
    if (!settings_.surfaceTension) return 0;
    const double H = c.support, norm = dim == 2 ? 2 * H * H * H / 3 : std::numbers::pi * H * H * H * H / 4;
    const double *phase = componentOf(particles, Phase::info.name), *V = componentOf(particles, Volume::info.name);
    const auto x = positionsOf(particles);
    const std::size_t n = c.phases.size();
    const double twice = sum(particles.size(),
                             [&](std::size_t i)
                             {
                                 double across = 0;
                                 typename NeighbourLists<dim>::Room room;
                                 for (const int j : particles.lists().of(i, room))
                                     if (phase[j] != phase[i] && mag(x(std::size_t(j)) - x(i)) < H)
                                         across += c.surfaceTension[std::size_t(phase[i]) * n + std::size_t(phase[j])] * V[j];
                                 return V[i] * across;
                             });
    return 0.5 * twice / norm;
}

template<int dim> double EnergyBalance<dim>::compression(const Particles<dim>& particles) const
{
    const auto& c = settings_.coefficients;
    const double *m = componentOf(particles, Mass::info.name), *rho = componentOf(particles, Density::info.name);
    const double* phase = settings_.multiphase() ? componentOf(particles, Phase::info.name) : nullptr;
    return sum(particles.size(),
               [&](std::size_t i)
               {
                   const std::size_t k = phase ? std::size_t(phase[i]) : 0;
                   return m[i] * c.stateEquation[k].energy(rho[i]);
               });
}

template<int dim> double EnergyBalance<dim>::allowance(const Particles<dim>& particles, const Summary& summary) const
{
    const double slack = 0.02, noise = 0.01; // of the background pressure; Mach number
    const double mostBackground =
        0.05; // of rho c^2: what a weakly compressible fluid can answer; a uniform pressure beyond it does no more work
    const auto& c = settings_.coefficients;
    double stiffest = 0;
    for (std::size_t k = 0; k < c.phases.size(); ++k) stiffest = std::max(stiffest, c.restDensity[k] * sqr(c.soundSpeed[k]));
    const double background = std::min(std::fabs(c.backgroundPressure), mostBackground * stiffest);
    const double *m = componentOf(particles, Mass::info.name), *rho = componentOf(particles, Density::info.name);
    double total = slack * background * sum(particles.size(), [&](std::size_t i) { return m[i] / rho[i]; });
    for (std::size_t k = 0; k < c.phases.size(); ++k) total += 0.5 * summary.mass[k] * sqr(noise * c.soundSpeed[k]);
    return total;
}

template<int dim> double EnergyBalance<dim>::walls(const Particles<dim>& particles, const Geometry& geometry, const Summary& summary) const
{
    const auto& c = settings_.coefficients;
    const double* V = componentOf(particles, Volume::info.name);
    const auto at = positionsOf(particles);
    const std::size_t n = c.phases.size();
    struct AtWalls
    {
        double wetting = 0, fastest = 0;
    };
    const Larger larger;
    const auto total = reduce(
        particles.size(), AtWalls{},
        [&](std::size_t i)
        {
            AtWalls here;
            particles.images().forEachWallNear(at(i),
                                               [&](const Foot& foot, const Patch& patch)
                                               {
                                                   if (foot.distance > c.spacing) return; // the row at the wall
                                                   larger(here.fastest,
                                                          mag(geometry.wallVelocity(patch.wallAt(foot.region),
                                                                                    in3D(at(i)) - foot.distance * foot.normal)));
                                                   if (c.wallTension.empty()) return;
                                                   const auto of = c.wallTension.begin() + long(std::size_t(patch.wallAt(foot.region)) * n);
                                                   const auto [least, most] = std::minmax_element(of, of + long(n));
                                                   here.wetting += (*most - *least) * V[i] / c.spacing;
                                               });
            return here;
        },
        [&](AtWalls& sum, const AtWalls& here)
        {
            sum.wetting += here.wetting;
            larger(sum.fastest, here.fastest);
        });
    return total.wetting + 0.5 * std::accumulate(summary.mass.begin(), summary.mass.end(), 0.0) * sqr(total.fastest);
}

template class EnergyBalance<2>;
template class EnergyBalance<3>;

}
