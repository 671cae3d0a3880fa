/// Contact angle as a tension that the wall exerts on the fluid next to it:
///
///   S_w,i = sum_(walls within H of i) 2 gamma_sk w_1(d) (I - n n),    w_1(d) = integral of W over the plane at distance d
///
/// n [-] normal and d [m] distance of the wall, gamma_sk [N/m] its tension with the particle's phase k, w_1 [1/m] the kernel's marginal:
/// 2 w_1 integrates to 1 over the fluid's side, so that a wall covered by phase k carries gamma_sk. With gamma_sl - gamma_sg =
/// -gamma cos(theta), ghosts of their parents' phase and their parents' stress mirrored, fluid plus image carries no shear across the wall:
/// Young's law is then the tangential momentum balance itself. 2 w_1(d) n is what the sum over the ghosts of a plane wall gives
/// for its colour gradient; taken from the wall itself it needs no sum, has no noise, and keeps two walls apart whose ghosts meet in
/// the pinch between grains, where the summed normal means nothing.
#pragma once
#include "Coefficients.hpp"
#include "Images.hpp"
#include "Kernel.hpp"

namespace sph
{

template<int dim> class WallTension
{
    const double* tension_;              ///< [N/m], walls x phases
    std::size_t phases_;
    double H_;
    std::vector<double> marginal_;       ///< w_1 at equal steps of d from 0 to H

public:
    WallTension(const Coefficients&, const Kernel<dim>&);
    /// w_1(d) [1/m]
    double marginal(double d) const;
    /// S_w of all owned particles from the images as last moved.
    void evaluate(const Images<dim>&, FieldStore<dim>&) const;
};

}
