/// Walls as layers of particles that lie still in the solid, Morris et al. (1997), in the place of ghosts: what a particle of the fluid sees
/// in one, pair by pair.
///
///   v_j = v_w - (d_j/d_i) (v_i - v_w)                       so that the velocity is linear and the fluid sticks to the surface
///   p_j = sum_i W_ij p_g(p_i)/sum_i W_ij                     p_g the wall's rule for a ghost, over (d_i + d_j)/2 on either side
///   q_j = q_i, mirrored at the wall where q is a vector      volume, density, viscosity, phi, stress ...
///
/// d_i, d_j [m] distances from the wall, v_w [m/s] its velocity at the foot of j. The factor d_j/d_i is not limited to 1.5, as it is in print:
/// limited, the fluid slips (tutorials/powderMoulding/channel9); d_i is taken for a quarter of a spacing where it is less, which no lattice
/// at a wall has. In a corner a particle lies behind several walls, and their rules follow one another, as those of a ghost of ghosts do.
///
/// What j has follows from i alone: no flux of a scalar passes the wall, and the viscous sum over the wall is a multiple of v_i - v_w, so
/// that an implicit solve stays symmetric. The pressure has to be one of j's own: with p_j = p_i a gradient along the wall loses the share
/// of the neighbours that are wall. The sum is that of Adami, Hu & Adams (2012), eq. (27).
#pragma once
#include "FieldStore.hpp"
#include "Geometry.hpp"
#include "Kernel.hpp"
#include "NeighbourLists.hpp"
#include "Stencil.hpp"
#include <optional>
#include <span>
#include <vector>

namespace sph
{

template<int dim> class GhostPressure;

template<int dim> class WallLayers
{
public:
    /// The particles geometry.layers, with their periodic copies within `reach` [m] of the domain. The geometry must outlive them. Throws
    /// CaseError where one does not lie in a wall.
    WallLayers(const Geometry&, const Kernel<dim>&, double reach, double spacing);

    std::size_t count() const { return particles_.size(); }
    /// Whether some particle differs from the fluid's in volume.
    bool weighted() const { return weighted_; }

    /// Writes positions, and walls and volume factors where the store has them, from place `first` on.
    void place(FieldStore<dim>&, std::size_t first);
    /// After the lists have been built: which pairs each particle's pressure is made of.
    void list(const NeighbourLists<dim>&, std::size_t owned);

    /// Pressures, of those within the support of the fluid. Without a rule they are means of the fluid's.
    void evaluatePressure(FieldStore<dim>&, const GhostPressure<dim>* rule) const;

    /// Gives the wall particles of a stencil what its particle sees in them. `columns`: the fields that the stencil has gathered, each with
    /// its `info` and number of `components`, first to last; `own`: where each column comes from; `scale`: the column of gradientScale, or -1.
    void continueInto(Stencil<dim>&, const auto& columns, std::span<const double* const> own, int scale) const;

    std::size_t bytes() const;

private:
    struct Behind                ///< one wall, of those that a particle lies behind
    {
        int patch;
        double distance;         ///< > 0, of the particle from its foot
        Vector<dim> normal, velocity;
    };
    struct Particle
    {
        Vector<dim> x;
        double weight;
        int original;            ///< that this is a periodic copy of: itself, or one before
        unsigned firstWall, walls;
    };
    struct PressurePair
    {
        int i, j;                ///< fluid; copy of the wall particle
    };
    /// Distances of one fluid particle from the few patches that its neighbours lie behind.
    class Distances;
    /// d_j/d_i for each wall of one pair.
    struct Extrapolation
    {
        std::array<double, dim> ratio;
        std::span<const Behind> walls;
    };

    const Geometry& geometry_;
    Kernel<dim> kernel_;
    double closest_;                         ///< least d_i [m]
    bool weighted_ = false;
    std::size_t first_ = 0;
    std::vector<Particle> particles_;
    std::vector<Behind> walls_;
    std::vector<PressurePair> pairs_;        ///< of original k: pairs_[firstPair_[k]] to pairs_[firstPair_[k + 1] - 1]
    std::vector<std::size_t> firstPair_;

    std::span<const Behind> wallsOf(const Particle& p) const { return {walls_.data() + p.firstWall, p.walls}; }
    double distance(int patch, Vector<dim> x) const
    {
        return std::max(closest_, geometry_.patches[std::size_t(patch)].shape->foot(in3D(x)).distance);
    }
    template<class Value> static Value seen(Value q, Image image, const Extrapolation&);
};

template<int dim> class WallLayers<dim>::Distances
{
    const WallLayers& layers_;
    Vector<dim> x_;
    std::array<std::pair<int, double>, 4> known_;
    std::size_t n_ = 0;

public:
    Distances(const WallLayers& layers, Vector<dim> x) : layers_(layers), x_(x) {}
    double operator()(int patch)
    {
        for (std::size_t k = 0; k < std::min(n_, known_.size()); ++k)
            if (known_[k].first == patch) return known_[k].second;
        const auto& fresh = known_[n_++%known_.size()] = {patch, layers_.distance(patch, x_)};
        return fresh.second;
    }
};

template<int dim> template<class Value> Value WallLayers<dim>::seen(Value q, Image image, const Extrapolation& at)
{
    for (std::size_t k = 0; k < at.walls.size(); ++k)
    {
        const Behind& wall = at.walls[k];
        if constexpr (components<Value> == dim)
        {
            if (image == Image::velocity) q = wall.velocity - at.ratio[k]*(q - wall.velocity);
            else if (image == Image::velocityChange) q = -at.ratio[k]*q;
            else q = mirrored(q, wall.normal);
        }
        else q = mirrored(q, wall.normal);
    }
    return q;
}

template<int dim>
void WallLayers<dim>::continueInto(Stencil<dim>& stencil, const auto& columns, std::span<const double* const> own, int scale) const
{
    const long first = long(first_);
    const auto count = static_cast<unsigned long>(particles_.size());
    const auto isWall = [&](long j) { return static_cast<unsigned long>(j - first) < count; };
    int found = 0;
    #pragma omp simd reduction(+: found)
    for (int t = 0; t < stencil.n; ++t) found += isWall(stencil.j[t]);
    if (found == 0) return;

    const int i = stencil.i;
    Vector<dim> x_i;
    std::optional<Distances> distances;
    for (int t = 0; t < stencil.n; ++t)
    {
        if (!isWall(stencil.j[t])) continue;
        const Particle& particle = particles_[std::size_t(stencil.j[t] - first)];
        if (!distances)
        {
            Vector<dim> x_ij;
            fetch(x_ij, [&](int c) { return stencil.x[c][t]; });
            distances.emplace(*this, particle.x + x_ij);
        }
        Extrapolation at{{}, wallsOf(particle)};
        for (std::size_t k = 0; k < at.walls.size(); ++k) at.ratio[k] = at.walls[k].distance/(*distances)(at.walls[k].patch);

        int column = 0;
        for (const auto& f : columns)
        {
            const auto see = [&]<class Value>(Value q)
            {
                fetch(q, [&](int c) { return own[std::size_t(column + c)][i]; });
                store(seen(q, f.info.image, at), [&](int c, double a) { stencil.field[column + c][t] = a; });
            };
            if (f.info.image == Image::copied)
                for (int c = 0; c < f.components; ++c) stencil.field[column + c][t] = own[std::size_t(column + c)][i];
            else if (f.info.image != Image::placed && f.info.image != Image::pressure)
            {
                if (f.components == dim) see(Vector<dim>{});
                else see(SymmTensor<dim>{});
            }
            column += f.components;
        }
        if (scale >= 0) stencil.field[scale][t] = own[std::size_t(scale)][i];
    }
}

}
