/// Walls as layers of particles that lie still in the solid, Morris et al. (1997), in the place of ghosts: where they are, and which of them the fluid sees.
///
/// What a particle of the fluid sees in one follows from its own values, pair by pair (layerPairs.hpp): no flux of a scalar passes the wall, and the viscous sum over
/// the wall is a multiple of v_i - v_w, so that an implicit solve stays symmetric. The pressure has to be one of the layer's own: with p_j = p_i a gradient along the
/// wall loses the share of the neighbours that are wall. It is a sum over the fluid (layerValues.cpp), as are the fields that a scene interpolates
/// (FieldRules::interpolateInLayers).
///
/// Sums over the fluid are of all ranks: each adds up those of its own particles, and ranks that see the same particle of a layer tell one another.
///
/// Verified by test/unit/plan and tutorials/powderMoulding/channel9.
#pragma once
#include "fields/FieldStore.hpp"
#include "geometry/Geometry.hpp"
#include "images/GhostRule.hpp"
#include "kernels/Kernel.hpp"
#include "neighbours/Halo.hpp"
#include "neighbours/NeighbourLists.hpp"
#include <span>
#include <vector>

namespace sph
{

/// Extrapolation of a layer particle's own value from those of the fluid: with weights W, or w of LayerFit.hpp.
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
    /// They have been moved to the places from `first` on.
    void placedFrom(std::size_t first) { first_ = first; }
    /// Lists the pairs of which each particle's pressure is made, after the neighbour lists have been built.
    void list(const NeighbourLists<dim>&, std::size_t owned);

    /// Gives particles within the support of the fluid values of a field of their own (layerValues.cpp): from the fluid's by the rule, or as they are without one.
    void extrapolate(FieldStore<dim>&, const std::string& field, const AnyGhostRule* rule, Extrapolation) const;

    /// Gives the wall particles of a stencil what its particle sees in them (layerPairs.hpp). `columns`: the fields that the stencil has gathered, each with
    /// its `info` and `type`, first to last; `own`: where each column comes from; `scale`: the column of gradientScale, or -1.
    void continueInto(auto& stencil, std::span<const InLayersOf> inLayers, const auto& columns, std::span<const double* const> own,
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

    bool turns(int wall) const { return geometry_.walls[std::size_t(wall)].omega != Vector<3>{}; }

    /// Feet of one fluid particle on the few patches that its neighbours lie behind: d_i, and how fast the wall is there.
    class Feet;

    /// The pair as the rules of ghosts know it. The weight is that of a mirror image where d_j = d_i.
    static Reflection<dim> reflection(const Behind&, double d_i, std::size_t walls);
};

}
