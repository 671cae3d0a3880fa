#include "models/tension/InterfaceArea.hpp"
#include "models/tension/Tensions.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <numbers>

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
    const std::size_t n = c.phases.size();
    const double twice = sum(particles.size(),
                             [&](std::size_t i)
                             {
                                 double across = 0;
                                 typename NeighbourLists<dim>::Room room;
                                 for (const int j : particles.lists().of(i, room))
                                     if (phase[j] != phase[i] && mag(at(std::size_t(j)) - at(i)) < H)
                                         across += gamma[std::size_t(phase[i]) * n + std::size_t(phase[j])] * V[j];
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

template class InterfaceArea<2>;
template class InterfaceArea<3>;

}
