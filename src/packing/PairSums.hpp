/// The two sums over neighbours that packing needs, vectorised; compiled with the stencil flags, so nothing here tests for NaN.
#pragma once
#include "Kernel.hpp"
#include "NeighbourTable.hpp"
#include "Points.hpp"

namespace sph
{

/// Number density of each point of the table, w the volume factors of the images:
///
///   sigma_i = W(0) + sum_j w_j W_ij     [1/m^dim]
template<int dim>
void numberDensity(const Kernel<dim>&, const NeighbourTable&, const Points&, const std::vector<double>& w,
                   std::vector<double>& sigma);

/// Gradient of a pressure P without unit, in the antisymmetric form that leaves the centre of mass where it is:
///
///   f_i = V0 sum_j w_j (P_i + P_j) (dW_ij/dr)/r x_ij     [1/m]
///
/// with x_ij = x_i - x_j. Particles move down it. P of an image is that of its source.
template<int dim>
void pressureGradient(const Kernel<dim>&, const NeighbourTable&, const Points&, const std::vector<double>& w,
                      const std::vector<double>& P, double V0, Points& f);

}
