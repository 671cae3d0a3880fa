/// Walls as layers of particles that lie still in the solid, Morris et al. (1997), in the place of ghosts: what a particle of the fluid sees
/// in one, pair by pair.
///
///   v_j = v_g(v_i, d_i, d_j)                      the wall's rule for a ghost: v_w - (d_j/d_i) (v_i - v_w), or of second order
///   p_j = sum_i W_ij p_g(p_i, d_i, d_j)/sum_i W_ij            and any field whose tag says `extrapolated`
///   q_j = q_i, mirrored at the wall where q is a vector      volume, density, viscosity, phi, stress ...
///   q_j = sum_i w_ij q_g(q_i, d_i, d_j)                      of fields that a scene interpolates (Images::interpolateInLayers)
///   w_ij = W_ij (1 - u.(t_i - t_m))/sum_i W_ij,   u = C^-1 t_m min(1, 3/(t_m.C^-1 t_m))
///
/// t_i [m] way from j to i along the wall, t_m its mean with weights W, C that of (t_i - t_m)(t_i - t_m): the w take the value at t = 0 of what is fitted to the q_g along the wall, exact for
/// values that are linear there. Where j lies beyond those of the fluid, above its surface, the fit is flattened.
///
/// d_i, d_j [m] distances from the wall, v_w [m/s] its velocity. The factor 1 + d_j/d_i is not limited to 1.5, as it is in print: limited (`wallVelocity
/// morris`), the fluid slips, and steady plane Poiseuille flow by the first rule has an error of 6.8 and 3.2 % at 16 and 32 across, not 0.69 and 0.18 %
/// (order 2). d_i is taken for a quarter of a spacing where it is less, which no row at a wall is.
///
/// Behind n walls at once, in a corner, v_j - v_w = (1 - prod_k (1 + d_jk/d_ik)) (v_i - v_w), which for one wall is the above. A pair knows
/// nothing of how v changes along the wall; over one wall those errors are even and cancel in the viscous sum, and with this continuation
/// they do in a corner: on a lattice the sum over v = x y, or x y z, is 0, as it should be.
///
/// Sums over the fluid are of all ranks: each adds up those of its own particles, and ranks that see the same particle of a layer tell one another.
///
/// What j has follows from i alone: no flux of a scalar passes the wall, and the viscous sum over the wall is a multiple of v_i - v_w, so
/// that an implicit solve stays symmetric. The pressure has to be one of j's own: with p_j = p_i a gradient along the wall loses the share
/// of the neighbours that are wall. The sum is that of Adami, Hu & Adams (2012), eq. (27). Verified by test/unit/plan and
/// tutorials/powderMoulding/channel9.
#pragma once
#include "FieldStore.hpp"
#include "Geometry.hpp"
#include "GhostRules.hpp"
#include "Halo.hpp"
#include "Kernel.hpp"
#include "NeighbourLists.hpp"
#include "Stencil.hpp"
#include <algorithm>
#include <concepts>
#include <optional>
#include <span>
#include <vector>

namespace sph
{

/// Extrapolation of a layer particle's own value from those of the fluid: with weights W, or w as above.
enum class Extrapolation
{
    mean,
    fit
};

/// Source of a stencil column's values in particles of layers: the rule, of the field's own type, for each pair; or, `interpolated`, a value of their own.
struct InLayersOf
{
    const AnyGhostRule* rule;
    bool interpolated;
};

template<int dim> class WallLayers
{
public:
    /// The particles geometry.layers, with their periodic copies within `reach` [m] of the domain. The geometry must outlive them. Throws
    /// CaseError where one does not lie in a wall, or where layers end within the support or are of another spacing.
    WallLayers(const Geometry&, const Kernel<dim>&, double reach, double spacing);

    /// Keeps the particles of layers alone that this rank's particles may see. The halo must outlive them.
    void keepNear(const Halo<dim>&);
    std::size_t count() const { return placed().size(); }
    /// Whether some particle differs from the fluid's in volume.
    bool weighted() const { return weighted_; }

    /// Writes positions, and walls and volume factors where the store has them, from place `first` on.
    void place(FieldStore<dim>&, std::size_t first);
    /// Lists the pairs of which each particle's pressure is made, after the neighbour lists have been built.
    void list(const NeighbourLists<dim>&, std::size_t owned);

    /// Values of a field of their own, of those within the support of the fluid. Without a rule of the fluid's values as they are.
    void extrapolate(FieldStore<dim>&, const std::string& field, const AnyGhostRule* rule, Extrapolation) const;

    /// Gives the wall particles of a stencil what its particle sees in them. `columns`: the fields that the stencil has gathered, each with
    /// its `info` and `type`, first to last; `own`: where each column comes from; `scale`: the column of gradientScale, or -1.
    void continueInto(Stencil<dim>&, std::span<const InLayersOf> inLayers, const auto& columns, std::span<const double* const> own,
                      int scale) const;

    std::size_t bytes() const;

private:
    struct Behind ///< one wall, of those that a particle lies behind
    {
        int patch, wall;
        Foot foot;
        Vector<3> surface; ///< the foot point
    };
    struct Particle
    {
        Vector<dim> x;
        double weight;
        int original; ///< that this is a periodic copy of: itself, or one before
        unsigned firstWall, walls;
    };
    struct PressurePair
    {
        int i, j; ///< fluid; place of the wall particle or its copy
    };
    /// Another rank that sees some of what this one sees.
    struct Sharer
    {
        int rank;
        std::vector<int> originals;
    };

    const Geometry& geometry_;
    Kernel<dim> kernel_;
    double closest_; ///< least d_i [m]
    bool weighted_ = false;
    std::size_t first_ = 0;
    std::vector<Particle> particles_; ///< originals, and periodic copies of them
    const Halo<dim>* halo_ = nullptr;
    std::vector<Particle> near_; ///< those of them that are placed where ranks share the fluid
    std::vector<Sharer> sharers_;
    std::vector<Behind> walls_;
    std::vector<PressurePair> pairs_; ///< of original k: pairs_[firstPair_[k]] to pairs_[firstPair_[k + 1] - 1]
    std::vector<std::size_t> firstPair_;

    const std::vector<Particle>& placed() const { return halo_ ? near_ : particles_; }
    void findSharers();
    /// Adds what other ranks have of each original; those of the ranks that do not see it stay as they are.
    template<class Sums> void addOtherRanks(std::vector<Sums>&) const;
    std::span<const Behind> wallsOf(const Particle& p) const { return {walls_.data() + p.firstWall, p.walls}; }
    template<class Value>
    void extrapolateAs(FieldStore<dim>&, const std::string& field, const GhostRule<Value, dim>* rule, Extrapolation) const;
    void checkDepth(double spacing) const;

    /// 1 - u.(t - t_m) for a way t [m] from a particle of a layer.
    class Fit;
    bool turns(int wall) const { return geometry_.walls[std::size_t(wall)].omega != Vector<3>{}; }

    /// Feet of one fluid particle on the few patches that its neighbours lie behind: d_i, and how fast the wall is there.
    class Feet;

    /// The pair as the rules of ghosts know it. The weight is that of a mirror image where d_j = d_i.
    static Reflection<dim> reflection(const Behind& b, double d_i)
    {
        const double d_j = -b.foot.distance, k1 = b.foot.k1, k2 = b.foot.k2;
        const bool flat = k1 == 0 && k2 == 0;
        return {d_i,
                flat ? 1 : (1 + k1 * d_j) * (1 + k2 * d_j) / ((1 - k1 * d_i) * (1 - k2 * d_i)),
                in<dim>(b.foot.normal),
                b.wall,
                b.surface,
                d_j / d_i};
    }
};

template<int dim> class WallLayers<dim>::Feet
{
    struct Known
    {
        int patch;
        double distance;
        Vector<dim> velocity;
    };
    const WallLayers& layers_;
    Vector<dim> x_;
    std::array<Known, 4> known_;
    std::size_t n_ = 0;

public:
    Feet(const WallLayers& layers, Vector<dim> x) : layers_(layers), x_(x) {}
    const Known& on(const Behind& behind)
    {
        for (std::size_t k = 0; k < std::min(n_, known_.size()); ++k)
            if (known_[k].patch == behind.patch) return known_[k];
        const auto x = in3D(x_);
        const Foot foot = layers_.geometry_.patches[std::size_t(behind.patch)].shape->foot(x);
        Known& fresh = known_[n_++ % known_.size()];
        fresh = {behind.patch, std::max(layers_.closest_, foot.distance), {}};
        if (layers_.turns(behind.wall))
            fresh.velocity = in<dim>(layers_.geometry_.wallVelocity(behind.wall, x - foot.distance * foot.normal));
        return fresh;
    }
};

template<int dim>
void WallLayers<dim>::continueInto(Stencil<dim>& stencil, std::span<const InLayersOf> inLayers, const auto& columns,
                                   std::span<const double* const> own, int scale) const
{
    const long first = long(first_);
    const auto& particles = placed();
    const auto count = static_cast<unsigned long>(particles.size());
    const auto isWall = [&](long j) { return static_cast<unsigned long>(j - first) < count; };
    int found = 0;
#pragma omp simd reduction(+ : found)
    for (int t = 0; t < stencil.n; ++t) found += isWall(stencil.j[t]);
    if (found == 0) return;

    const auto i = std::size_t(stencil.i);
    const auto isSeenByWalls = [&](std::size_t field)
    {
        const auto image = columns[field].info.image;
        return image != Image::copied && image != Image::placed && !inLayers[field].interpolated;
    };
    bool seenByWalls = false;
    for (std::size_t field = 0; field < columns.size(); ++field) seenByWalls = seenByWalls || isSeenByWalls(field);
    std::optional<Feet> feet;
    std::array<Reflection<dim>, dim> at;
    for (int t = 0; t < stencil.n; ++t)
    {
        if (!isWall(stencil.j[t])) continue;
        const Particle& particle = particles[std::size_t(stencil.j[t] - first)];
        if (!feet && seenByWalls)
        {
            Vector<dim> x_ij;
            fetch(x_ij, [&](int c) { return stencil.x[c][t]; });
            feet.emplace(*this, particle.x + x_ij);
        }
        const auto walls = wallsOf(particle);
        for (std::size_t k = 0; seenByWalls && k < walls.size(); ++k) at[k] = reflection(walls[k], feet->on(walls[k]).distance);

        // v_i + Delta, where each wall behind the first multiplies Delta = v_g - v_i by 1 + d_j/d_i
        const auto continued = [&](const GhostVelocity<dim>& rule, Vector<dim> v_i, Vector<dim> v_g)
        {
            auto Delta = v_g - v_i;
            for (std::size_t k = 1; k < walls.size(); ++k) Delta = Delta - rule.change(Delta, at[k]);
            return v_i + Delta;
        };
        const auto seen = [&](auto q, Image image, const AnyGhostRule* any)
        {
            // A change or a gradient follows the rule of the velocity.
            [[maybe_unused]] const auto* const rule = static_cast<const GhostVelocity<dim>*>(any);
            if constexpr (std::same_as<decltype(q), Vector<dim>>)
            {
                // Relative to the wall, each at its own foot: where it turns the two are not the same.
                if (image == Image::ruled && turns(walls[0].wall))
                    q = q - feet->on(walls[0]).velocity + in<dim>(geometry_.wallVelocity(walls[0].wall, walls[0].surface));
                if (image == Image::ruled) return continued(*rule, q, (*rule)(q, i, at[0], walls.size() == 1));
                if (image == Image::ruledChange) return continued(*rule, q, rule->change(q, at[0]));
            }
            for (std::size_t k = 0; k < walls.size(); ++k)
            {
                if (image == Image::ruled && any)
                {
                    q = (*static_cast<const GhostRule<decltype(q), dim>*>(any))(q, i, at[k], walls.size() == 1);
                    continue;
                }
                if constexpr (std::same_as<decltype(q), Tensor<dim>>)
                    if (image == Image::ruledGradient)
                    {
                        q = gradientBeyond(*rule, q, at[k]);
                        continue;
                    }
                q = mirrored(q, at[k].normal);
            }
            return q;
        };
        int column = 0;
        std::size_t field = 0;
        for (const auto& f : columns)
        {
            const auto see = [&](auto q)
            {
                fetch(q, [&](int c) { return own[std::size_t(column + c)][i]; });
                store(seen(q, f.info.image, inLayers[field].rule), [&](int c, double a) { stencil.field[column + c][t] = a; });
            };
            if (f.info.image == Image::copied)
                for (int c = 0; c < f.type.components; ++c) stencil.field[column + c][t] = own[std::size_t(column + c)][i];
            else if (isSeenByWalls(field)) withDirectedValue<dim>(f.type, see);
            column += f.type.components;
            ++field;
        }
        if (scale >= 0) stencil.field[scale][t] = own[std::size_t(scale)][i];
    }
}

}
