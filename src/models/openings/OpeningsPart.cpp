#include "OpeningsPart.hpp"
#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace sph
{

template<int dim>
OpeningsPart<dim>::OpeningsPart(Particles<dim>& particles, const Numbers& restored, const std::vector<Opening>& openings)
    : openings_(openings, particles.geometry(), particles.coefficients(), particles.settings().state, restored)
{}

template<int dim> std::vector<Stage<dim>> OpeningsPart<dim>::stages(Place place)
{
    if (place == Place::afterEvaluation)
        return {{"hold", "dq/dt = 0 of what openings hold", [this](Particles<dim>& p, const Substep&) { openings_.hold(p.store()); }}};
    if (place == Place::afterKick)
        return {{"drive", "U and p of what openings hold",
                 [this](Particles<dim>& p, const Substep& s) { openings_.drive(p.store(), s.deltaT); }}};
    return {};
}

template<int dim> std::size_t OpeningsPart<dim>::exchange(Particles<dim>& particles, std::size_t owned)
{
    return openings_.exchange(particles.store(), owned, particles.predicted());
}

template<int dim> void OpeningsPart<dim>::moved(Particles<dim>& particles)
{
    openings_.follow(particles.store(), particles.predicted());
    particles.hold({openings_.held().begin(), openings_.held().end()});
}

template<int dim> void OpeningsPart<dim>::sorted(Particles<dim>& particles)
{
    openings_.locate(particles.store(), particles.size());
    particles.hold({openings_.held().begin(), openings_.held().end()});
}

template<int dim> void OpeningsPart<dim>::holdRate(Particles<dim>& particles, const std::string& field, double deltaT)
{
    openings_.holdRate(particles.store(), field, deltaT);
}

template<int dim> std::string OpeningsPart<dim>::introduction() const
{
    std::string lines;
    for (const auto& flow : openings_.flows())
        lines += fmt::format("Opening   : {}, {} of {:.4g} {}, {} particles held beyond its plane{}\n", flow.name,
                             flow.inlet ? "inlet" : "outlet", flow.area, dim == 3 ? "m^2" : "m", flow.held,
                             flow.taken > 0 ? fmt::format(", {:.6g} kg further beyond taken away at the start", flow.taken) : "");
    return lines;
}

template<int dim> std::string OpeningsPart<dim>::report(const Particles<dim>& particles) const
{
    auto names = openings_.amounts();
    for (auto& name : names) name[0] = char(std::tolower(name[0]));
    std::string lines;
    for (const auto& flow : openings_.flows())
    {
        std::string with;
        for (std::size_t q = 0; q < names.size(); ++q)
            with += fmt::format("{}{:.10g} m^3 of {}", q == 0 ? " with " : ", ", flow.amounts[q], names[q]);
        lines += fmt::format("{}: {:.6g} m^3/s at {:.4g} Pa, passed {:.10g} kg{}{}\n", flow.name, flow.flowRate, flow.pressure, flow.mass,
                             with, flow.taken > 0 ? fmt::format(", took away {:.10g} kg at the start", flow.taken) : "");
    }
    const auto off = openings_.imbalance(particles.store());
    lines += fmt::format("balance: mass off by {:.2g}", off.mass);
    for (std::size_t q = 0; q < names.size(); ++q) lines += fmt::format(", {} by {:.2g}", names[q], off.amounts[q]);
    return lines + '\n';
}

template<int dim> void OpeningsPart<dim>::save(Numbers& numbers) const { numbers.merge(openings_.state()); }

template class OpeningsPart<2>;
template class OpeningsPart<3>;

}
