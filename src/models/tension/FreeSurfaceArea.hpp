/// Energy of the free surface of a liquid whose gas is left out, and what its tension may give to motion.
///
///   E = gamma (A - sum_i V_i k_w,i),    A = 2 sum_i V_i^2 |g_i|,    g_i = sum_j gradW_ij
///
/// E [J] (per metre of depth in 2-D), A the area by what half of the kernel sees of a plane surface: int_0^H int W dA dz = 1/2. The second sum is cos(theta) times the wetted area of each wall (WallWetting.hpp): what wetting gives.
#pragma once
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class FreeSurfaceArea final : public RunningModel<dim>
{
public:
    FreeSurfaceArea(Particles<dim>&, const Numbers&) {}
    std::optional<StoredEnergy> energy(const Particles<dim>&) const override;
    /// Twice what wetting has given at the start: the energy may begin near 0, where water lies between grains, and what is held against it is then that of both areas.
    double supply(const Particles<dim>&, const std::vector<double>& mass) const override;
};

}
