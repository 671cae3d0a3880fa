#include "models/density/DensityScale.hpp"
#include "kernels/overLattice.hpp"
#include "parallel/reduce.hpp"
#include <cmath>

namespace sph
{

namespace
{
constexpr const char* densityScale = "densityScale";
}

template<int dim>
DensityScale<dim>::DensityScale(Particles<dim>& particles, const Numbers& restored) : coefficients_(particles.coefficients())
{
    if (const auto found = restored.find(densityScale); found != restored.end()) restored_ = found->second;
}

template<int dim> double DensityScale<dim>::ofLattice(const Particles<dim>& particles) const
{
    const double dx = coefficients_.spacing;
    const auto& kernel = particles.kernel();
    return 1 / (std::pow(dx, dim) * sumOverLattice(kernel, dx, [&](double r) { return kernel.W(r); }));
}

template<int dim> double DensityScale<dim>::ofPacking(const Particles<dim>& particles) const
{
    const auto& store = particles.store();
    const double *m = store.component(Mass::info.name, 0), *V = store.component(Volume::info.name, 0);
    const double* phase = coefficients_.phases.size() > 1 ? store.component(Phase::info.name, 0) : nullptr;
    const double compression = *coefficients_.of<StartCompression>().mean;
    const int inPart = particles.settings().facts.template get<PhaseInPart>().phase; // it ends where others go on
    const auto counts = [&](std::size_t i) { return !phase || int(phase[i]) != inPart; };
    return coefficients_.densityScale *
           (compression * double(count(particles.size(), counts)) /
            sum(particles.size(), [&](std::size_t i)
                { return counts(i) ? m[i] / coefficients_.restDensity[phase ? std::size_t(phase[i]) : 0] / V[i] : 0.0; }));
}

template<int dim> std::vector<Stage<dim>> DensityScale<dim>::stages(JoinPoint place)
{
    if (place != JoinPoint::start) return {};
    return {{"density scale", "mean of rho/rho_0 is exact",
             [this](Particles<dim>& p, const Substep&)
             {
                 if (restored_) return p.setDensityScale(*restored_);
                 p.setDensityScale(p.settings().endsInside() ? ofLattice(p) : ofPacking(p));
                 p.evaluate();
             }}};
}

template<int dim> void DensityScale<dim>::save(Numbers& numbers) const { numbers[densityScale] = coefficients_.densityScale; }

template class DensityScale<2>;
template class DensityScale<3>;

}
