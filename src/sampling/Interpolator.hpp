/// Values of particle fields at points: a kernel sum over the particles around a point, periodic copies included.
#pragma once
#include "kernels/Kernel.hpp"
#include "sampling/ParticleView.hpp"
#include <array>
#include <cmath>
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

/// Whether particles count once more beyond walls that are planes of symmetry, mirrored in them.
enum class Mirrored
{
    no,
    atSymmetryPlanes
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
    /// Calls f(first, last) for each row of cells within reach of a point of the domain: positions first .. last - 1.
    template<class F> void forEachRow(const Vector<3>& centre, const F& f) const
    {
        const Vector<3> reach{H_, H_, H_};
        const auto first = cellOf(centre - reach), last = cellOf(centre + reach);
        for (long cz = first[2]; cz <= last[2]; ++cz)
            for (long cy = first[1]; cy <= last[1]; ++cy)
            {
                const auto row = std::size_t((cz * cells_[1] + cy) * cells_[0]);
                f(row + std::size_t(first[0]), row + std::size_t(last[0]) + 1);
            }
    }

public:
    /// Keeps a pointer to the view's volumes; positions are copied, sorted by cell. Particles at NaN are left out.
    explicit Interpolator(const ParticleView&, Mirrored = Mirrored::no);

    /// Whether a particle counts: its number, and the way to it, or to its periodic copy, from the point [m].
    using Admits = std::function<bool(std::size_t particle, const Vector<3>& offset)>;

    /// Of the particles that `admits` lets count; all where it is empty.
    PointWeights weights(const Vector<3>& point, Interpolation = Interpolation::linear, const Admits& admits = {}) const;

    /// Calls f(particle, offset, kernel) for each particle, or copy of it, within reach of a point; `offset` [m] leads to it, `kernel` is W [1/m^dim].
    template<class F> void forEachNear(const Vector<3>& point, const F& f) const
    {
        const auto centre = wrapped(point);
        if (!std::isfinite(centre.x + centre.y + centre.z)) return; // it lies in no cell
        std::visit(
            [&](const auto& kernel)
            {
                forEachRow(centre,
                           [&](std::size_t from, std::size_t to)
                           {
                               for (auto i = cellStart_[from]; i < cellStart_[to]; ++i)
                               {
                                   const auto d = x_[i] - centre;
                                   if (const double r2 = dot(d, d); r2 < H_ * H_) f(source_[i], d, kernel.W(std::sqrt(r2)));
                               }
                           });
            },
            kernel_);
    }

    /// sum_j V_j W_j f_j and sum_j V_j W_j at a point.
    struct Sums
    {
        double ofValues = 0, coverage = 0;
    };
    Sums sums(const Vector<3>& point, const double* values) const;

    /// The gradient by the kernel's, corrected to be exact for linear fields:
    ///
    ///   grad f = [sum_j V_j (x_j - x) grad W_j]^-1 sum_j V_j (f_j - f) grad W_j
    ///
    /// of values f_j at particles, with f = `here` at the point. After Bonet and Lok (1999), Comput. Methods Appl. Mech. Eng. 180:97. Along directions in which the particles around the point do not spread
    /// it is 0.
    Vector<3> gradient(const Vector<3>& point, double here, const double* values) const;

    /// Least and largest value of the particles in a cell; of none +infinity and -infinity.
    struct Range
    {
        double low, high;
    };
    std::vector<Range> rangesOfCells(const double* values) const;
    /// Over the cells around a point, and so over all particles within reach of it.
    Range range(const Vector<3>& point, const std::vector<Range>& ofCells) const;
};

}
