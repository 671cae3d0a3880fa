/// Energy of the interfaces between phases, and what walls may give by being wetted.
///
///   S = sum_(k < l) gamma_kl A_kl,    A_kl = sum_(i of k, j of l) V_i V_j/(2 H^3/3) in 2-D, /(pi H^4/4) in 3-D
///
/// S [J] (per metre of depth in 2-D), gamma_kl [N/m], A_kl the area by the pairs across the interface nearer than the support H [m]: exact for plane
/// interfaces, and rising with every particle that strays into the other phase. Walls may give the largest difference of their tensions with the phases, on the
/// area of the row of particles at them: an upper bound.
///
/// A body of a few particles has no curvature that a kernel sees: what its tension makes of it is noise, which may stir it and all around it for good. Where more than a fifth of a phase is in such bodies, that is warned of, unless the phase is less than a hundredth of all (gas that a mould has left over);
/// a body is what lies within 1.5 spacings of one another, on one rank and one side of periodic faces.
#pragma once
#include "scene/Particles.hpp"
#include <set>

namespace sph
{

template<int dim> class InterfaceArea final : public RunningModel<dim>
{
    std::set<std::size_t> warned_; ///< phases that have been warned of

public:
    static constexpr std::size_t few = dim == 2 ? 4 : 8;
    static constexpr double reach = 1.5, tooMuch = 0.2, negligible = 0.01;

    InterfaceArea(Particles<dim>&, const Numbers&) {}
    std::optional<StoredEnergy> energy(const Particles<dim>&) const override;
    double supply(const Particles<dim>&, const std::vector<double>& mass) const override;
    std::string warning(const Particles<dim>&) override;
};

}
