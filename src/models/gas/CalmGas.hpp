/// Gas far from all liquid needs no background pressure: that which surface tension asks for (models/pressure) is left out of its force there.
///
///   s_i = (d_i - 3)/2 within 0 and 1 of gas whose distance from the liquid is d_i [spacings], 0 of all else
///
/// is the share by which the force of AmbientGas.hpp does so; volumes, densities and pressures by the state equation stay as they are. Found before particles are sorted.
///
/// With p_b in it uniform gas is a lattice that is no minimum of its energy: a box of air alone has set itself in motion after 15 ms. And beside walls that
/// images fill with shares (images/imageShares.hpp) the force is not the gradient of an energy: gas between rocks takes energy from it without end, in proportion to the pressure.
/// Figures: README.md. Verified by test/unit/gas.
#pragma once
#include "models/gas/LiquidDistance.hpp"
#include "scene/Particles.hpp"

namespace sph
{

template<int dim> class CalmGas final : public RunningModel<dim>
{
public:
    /// `gas`: number of its phase.
    CalmGas(Particles<dim>&, const Numbers& restored, std::size_t gas);

    std::vector<Stage<dim>> stages(JoinPoint) override;
    std::size_t bytes() const override { return distance_.bytes(); }

private:
    LiquidDistance distance_;
    std::size_t gas_;

    void find(Particles<dim>&);
};

}
