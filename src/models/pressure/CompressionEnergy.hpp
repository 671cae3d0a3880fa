/// Energy of the compression of a fluid by its state equation, and what its pressure may yield to motion.
///
///   E = sum_i m_i e(rho_i),    e = int (p - p_b)/rho^2 drho
///
/// E [J], e [J/kg] (src/stateEquation), p_b [Pa] background pressure; i: particles that no opening holds. At the start of a run a lattice may yield 0.02 p_0 sum_i V_i under the background
/// pressure, p_0 = min(|p_b|, max rho c^2/20), since a weakly compressible fluid does no more work against a uniform pressure beyond it; and any start makes
/// sound of Mach 0.01, sum_i m_i (c/100)^2/2. In 2-D all are per metre of depth.
#pragma once
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class CompressionEnergy final : public RunningModel<dim>
{
public:
    CompressionEnergy(Particles<dim>&, const Numbers&) {}
    std::optional<StoredEnergy> energy(const Particles<dim>&) const override;
    double supply(const Particles<dim>&, const std::vector<double>& mass) const override;
};

}
