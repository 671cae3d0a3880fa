/// A field of particles at any point: what colours the surface in a picture.
#pragma once
#include "surfaces/ColourFunction.hpp"
#include "surfaces/IsoSurface.hpp"

namespace sph
{

/// Shepard's mean over the particles of a phase (Shepard 1968)
///
///     f(x) = sum_j V_j f_j W(x - x_j) / sum_j V_j W(x - x_j)
///
/// V_j volume, W kernel. A constant field stays constant up to the surface, where half of the kernel is empty. Both sums are known at the nodes of the grid and
/// linear between them.
class SmoothedField
{
    const RegularGrid& grid_;
    std::vector<double> sum_, weight_;

public:
    /// `values` are those of all particles; those of other phases do not count. Keeps the grid by reference.
    SmoothedField(const RegularGrid&, PhaseParticles, const std::vector<double>& values, const std::string& kernel, double support);

    /// 0 where no particle is near.
    double operator()(const Vector<3>& x) const;

    /// Gives the points of a mesh their values, as its scalars.
    void colour(vtkPolyData*) const;
};

}
