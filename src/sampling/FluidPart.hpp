/// The part of the kernel's sphere that lies in the fluid's space.
#pragma once
#include "sampling/Interpolator.hpp"
#include <vector>

namespace sph
{

/// D(x) = int W dV over the part of the kernel's sphere about x that lies in the domain and outside of solids, by points within it that carry weights of the kernel. A sum over particles that
/// fill this space, sum_j V_j W_j, is D: below it lies the surface of a liquid whose gas is left out. With images beyond planes of symmetry the space goes on there.
class FluidPart
{
    struct Part
    {
        Vector<3> offset; ///< from the middle [m]
        double weight;
    };
    double support_;          ///< [m]
    std::vector<Part> parts_; ///< of the sphere, of equal size
    std::vector<const Shape*> mirrors_;

public:
    /// Of the view's kernel; the planes are those of its geometry, which must outlive it.
    explicit FluidPart(const ParticleView&, Mirrored = Mirrored::no);
    double operator()(const Vector<3>& x, const Geometry&) const;
};

}
