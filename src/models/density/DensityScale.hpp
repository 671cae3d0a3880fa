/// Scale of the number density at the start of a run: the mean of rho/rho_0 becomes exact, 1 or what a pressure at the start asks for, since the kernel
/// sum over a packing is 0.7 to 1 % off by itself.
///
///   s <- s <rho/rho_0>_p/(1/N sum_i m_i/(rho_0 V_i)),    rho = s m sigma
///
/// <rho/rho_0>_p [-] mean of the compression that the pressure of the time folder means. Where some particles lack neighbours a square or cubic lattice
/// stands for the packing. A restart goes on with the scale of its time folder.
#pragma once
#include "scene/Particles.hpp"
#include <memory>
#include <optional>

namespace sph
{

/// Mean of density over that at rest which a pressure at the start asks for: known once particles have been loaded.
struct StartCompression
{
    std::shared_ptr<double> mean = std::make_shared<double>(1);
};

template<int dim> class DensityScale final : public RunningModel<dim>
{
    std::optional<double> restored_;
    const Coefficients& coefficients_;

    double ofLattice(const Particles<dim>&) const;
    double ofPacking(const Particles<dim>&) const;

public:
    DensityScale(Particles<dim>&, const Numbers& restored);
    std::vector<Stage<dim>> stages(JoinPoint) override;
    void save(Numbers&) const override;
};

}
