/// Values of particle fields at points: a kernel sum over the particles around a point, periodic copies included.
#pragma once
#include "kernels/Kernel.hpp"
#include "sampling/ParticleView.hpp"
#include <array>
#include <functional>
#include <variant>

namespace sph
{

/// f(x) = sum_j w_j f_j with sum_j w_j = 1; empty where no particle is within reach of x.
struct PointWeights
{
    std::vector<std::size_t> particle;
    std::vector<double> weight;
    double coverage = 0; ///< sum_j V_j W_j: 1 inside the fluid, about a half on a free surface or wall, 0 far from it

    bool empty() const { return particle.empty(); }
    /// NaN where there is nothing to interpolate: gnuplot and ParaView leave such points out. A null array is zero.
    double operator()(const double* values) const;
};

/// shepard: w_j = V_j W_j/sum_k V_k W_k, between the smallest and the largest f_j, first order.
/// linear: w_j = V_j W_j b(0).M^-1 b(x_j - x), b = (1, dx/H, ...), M = sum_j V_j W_j b b: exact for linear fields, second order,
/// also at walls and surfaces. Where the eigenvalues of M are too unequal (few particles, all on one line or far to one side),
/// shepard.
enum class Interpolation
{
    shepard,
    linear
};

class Interpolator
{
    std::variant<Kernel<2>, Kernel<3>> kernel_;
    double H_;
    const double* volume_;
    Vector<3> low_, period_;   ///< period 0: not periodic in that direction
    std::vector<Vector<3>> x_; ///< of the particles and their periodic copies, in the order of the cells
    std::vector<std::size_t> source_;
    std::vector<std::size_t> cellStart_;
    Vector<3> origin_;
    std::array<long, 3> cells_{1, 1, 1};
    Vector<3> cellSize_{1, 1, 1};

    std::array<long, 3> cellOf(const Vector<3>&) const;
    Vector<3> wrapped(Vector<3>) const;

public:
    /// Keeps a pointer to the view's volumes; positions are copied, sorted by cell. Particles at NaN are left out.
    explicit Interpolator(const ParticleView&);

    /// Whether a particle counts: its number, and the way to it, or to its periodic copy, from the point [m].
    using Admits = std::function<bool(std::size_t particle, const Vector<3>& offset)>;

    /// Of the particles that `admits` lets count; all where it is empty.
    PointWeights weights(const Vector<3>& point, Interpolation = Interpolation::linear, const Admits& admits = {}) const;
};

}
