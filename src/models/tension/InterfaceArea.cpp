#include "models/tension/InterfaceArea.hpp"
#include "base/JoinedTrees.hpp"
#include "models/tension/Tensions.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

namespace sph
{

template<int dim> std::optional<StoredEnergy> InterfaceArea<dim>::energy(const Particles<dim>& particles) const
{
    const auto& c = particles.coefficients();
    const auto& gamma = tensionsOf(c).between;
    const double H = c.support, norm = dim == 2 ? 2 * H * H * H / 3 : std::numbers::pi * H * H * H * H / 4;
    const double *phase = particles.store().pointers(Phase{})[0], *V = particles.store().pointers(Volume{})[0];
    const auto x = particles.store().pointers(Position{});
    const auto at = [&x](std::size_t i) { return valueAt<Vector<dim>>(x, i); };
    const auto& images = particles.images();
    const std::size_t n = c.phases.size(), last = particles.size() + images.count(); // particles of layers have no phase
    const double twice = sum(particles.size(),
                             [&](std::size_t i)
                             {
                                 double across = 0;
                                 typename NeighbourLists<dim>::Room room;
                                 for (const int j : particles.lists().of(i, room))
                                 {
                                     if (std::size_t(j) >= last) continue;
                                     const std::size_t of = images.sourceOf(std::size_t(j));
                                     if (phase[of] != phase[i] && mag(at(std::size_t(j)) - at(i)) < H)
                                         across += gamma[std::size_t(phase[i]) * n + std::size_t(phase[of])] * V[of];
                                 }
                                 return V[i] * across;
                             });
    return StoredEnergy{"interfaces", 0.5 * twice / norm};
}

template<int dim> double InterfaceArea<dim>::supply(const Particles<dim>& particles, const std::vector<double>&) const
{
    const auto& c = particles.coefficients();
    const auto& tensions = tensionsOf(c).ofWalls;
    if (tensions.empty()) return 0;
    const double* const V = particles.store().pointers(Volume{})[0];
    const auto x = particles.store().pointers(Position{});
    const std::size_t n = c.phases.size();
    return sum(particles.size(),
               [&](std::size_t i)
               {
                   double wetting = 0;
                   particles.nearWalls().forEachFoot(in3D(valueAt<Vector<dim>>(x, i)), c.spacing, // the row at the wall
                                                     [&](const Foot& foot, const Patch& patch)
                                                     {
                                                         const auto of =
                                                             tensions.begin() + long(std::size_t(patch.wallAt(foot.region)) * n);
                                                         const auto [least, most] = std::minmax_element(of, of + long(n));
                                                         wetting += (*most - *least) * V[i] / c.spacing;
                                                     });
                   return wetting;
               });
}

template<int dim> std::string InterfaceArea<dim>::warning(const Particles<dim>& particles)
{
    const auto& c = particles.coefficients();
    const double* const phase = particles.store().pointers(Phase{})[0];
    const auto x = particles.store().pointers(Position{});
    const auto at = [&x](std::size_t i) { return valueAt<Vector<dim>>(x, i); };
    const std::size_t n = particles.size(), phases = c.phases.size();
    JoinedTrees bodies;
    bodies.reset(n);
    typename NeighbourLists<dim>::Room room;
    for (std::size_t i = 0; i < n; ++i)
        for (const int j : particles.lists().of(i, room))
            if (std::size_t(j) < n && phase[j] == phase[i] && mag(at(std::size_t(j)) - at(i)) < reach * c.spacing)
                bodies.join(i, std::size_t(j));
    std::vector<std::size_t> size(n, 0);
    for (std::size_t i = 0; i < n; ++i) ++size[std::size_t(bodies.rootOf(i))];
    // Of each phase what is in larger bodies, and what is in those of a few
    std::vector<std::size_t> counts(2 * phases, 0);
    for (std::size_t i = 0; i < n; ++i) ++counts[std::size_t(phase[i]) + (size[std::size_t(bodies.rootOf(i))] < few ? phases : 0)];
    counts = ofAllRanks(counts, std::vector<std::size_t>(counts.size(), 0), AddEach{});
    const double all = double(std::accumulate(counts.begin(), counts.end(), std::size_t(0)));
    for (std::size_t k = 0; k < phases; ++k)
    {
        const double inFew = double(counts[phases + k]), ofPhase = inFew + double(counts[k]);
        if (!(inFew > tooMuch * ofPhase && ofPhase > negligible * all) || !warned_.insert(k).second) continue;
        return fmt::format(
            "{} has come apart: {:.0f} % of its particles are in bodies of fewer than {}. The tension of so small bodies means nothing, and may stir them for "
            "good: a smaller spacing is needed, four at least across the narrowest body that matters",
            c.phases[k], 100 * inFew / ofPhase, few);
    }
    return "";
}

template class InterfaceArea<2>;
template class InterfaceArea<3>;

}
