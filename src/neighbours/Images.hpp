/// Images: every particle that is not owned is an image (source, walls, shift) behind the owned ones.
///
///   x' = mirror_n(... mirror_1(x)) + shift
///
/// Mirrored in up to `dim` walls (corners), in an acute wedge of planes once more in the first, in two bodies in turn as often as their wedge or the gap between
/// them needs, each image with its share of what lies in both, in
/// the faces of one mesh as often as its edges need (FacetBody.hpp), then shifted by periods. Terms see one
/// contiguous array and never ask what a neighbour is:
///
///   owned | periodic images of the fluid and wall ghosts | null particle
///
/// Where ranks share the particles, copies of those of others stand behind the owned ones (Halo.hpp), and have images as they do.
///
/// Where walls are layers of particles (WallLayers.hpp) nothing is mirrored, and they lie between the images and the null particle.
///
/// Before each pass only the fields that the pass reads are refreshed.
#pragma once
#include "FieldStore.hpp"
#include "GhostRules.hpp"
#include "Halo.hpp"
#include "PatchGrid.hpp"
#include "TriangleMesh.hpp"
#include "WallLayers.hpp"
#include "forEachFoot.hpp"
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace sph
{

template<int dim> class Images
{
public:
    /// The geometry, and the halo where there is one, must outlive the images. Images are made within `reach` [m] of the domain's periodic faces and of walls: the kernel's
    /// support and the `skin` [m] of the lists.
    Images(const Geometry&, double reach, double spacing, double skin = 0, Halo<dim>* halo = nullptr);

    /// Sets the rule by which images beyond walls get the values of a field.
    template<class F> void setRule(F, std::unique_ptr<GhostRule<FieldValue<F, dim>, dim>> rule) { rules_[F::info.name] = std::move(rule); }
    /// The rule of a field; null where images have their sources' values.
    template<class Value> const GhostRule<Value, dim>* rule(const char* field) const
    {
        return dynamic_cast<const GhostRule<Value, dim>*>(anyRule(field));
    }
    const AnyGhostRule* anyRule(const char* field) const
    {
        const auto found = field ? rules_.find(field) : rules_.end();
        return found == rules_.end() ? nullptr : found->second.get();
    }
    /// Gives particles of layers one value of this field each from now on, a fit to the fluid's, and not the one that the rule makes of each pair.
    template<class F> void interpolateInLayers(F) { interpolated_.insert(F::info.name); }
    bool interpolates(const FieldInfo& info) const { return info.inLayers == InLayers::extrapolated || interpolated_.contains(info.name); }
    /// Ends a step for the rules that keep a state.
    void filterRules() const
    {
        for (const auto& [_, rule] : rules_) rule->filter();
    }
    /// Makes walls of these particles, in layers; they mirror nothing from now on.
    void setLayers(WallLayers<dim> layers) { layers_.emplace(std::move(layers)); }
    /// The layers of wall particles; null where walls mirror.
    const WallLayers<dim>* layers() const { return layers_ ? &*layers_ : nullptr; }
    /// Lists the layers' particles, after the neighbour lists have been built.
    void listLayers(const NeighbourLists<dim>& lists)
    {
        if (layers_) layers_->list(lists, owned_);
    }
    /// Lets interfaces go straight on behind walls from now on; else they are mirrored, and meet every wall at 90 degrees.
    void continueInterfaces() { continuesInterfaces_ = true; }
    /// Binds the rules to the arrays, after each change of them.
    void bindRules()
    {
        for (const auto& [_, rule] : rules_) rule->bind();
    }

    /// Makes the images of the first `owned` particles and resizes the store.
    void build(FieldStore<dim>& store, std::size_t owned);
    /// Forgets images that no list names, NeighbourLists::seen(): nobody reads their values in the arrays any more. The others stay in place.
    void keepSeen(std::span<const char> seen);

    /// Updates the positions of the images, their volume factors and walls where the store has them, and the null particle's position.
    void move(FieldStore<dim>& store);

    /// Sets the null particle's value in one array: it has W = 0, but enters the arithmetic, and must be finite.
    void setNullParticle(double* array) const { array[nullParticle()] = owned_ > 0 ? array[0] : 1.0; }

    /// Refreshes the images' values of one field, by the rule that its tag states; `name` is the field's in this scene.
    template<class F> static void refresh(const Images& images, FieldStore<dim>& store, const std::string& name = F::info.name);

    /// Largest speed at which a particle and an image may part, over twice the largest speed of a particle. It is 1 but for images inside concave walls,
    /// which move along them (R + d)/(R - d) times as far as their sources.
    double closingSpeed() const { return 0.5 * (1 + fastest_); }

    std::size_t owned() const { return owned_; }
    /// Number of images, copies of other ranks' particles among them.
    std::size_t count() const { return sources_ - owned_ + entries_.size(); }
    std::size_t nullParticle() const { return sources_ + made_ + (layers_ ? layers_->count() : 0); }
    /// Calls f(source) for each image, images of copies included.
    void forEachSource(const auto& f) const
    {
        for (const auto& entry : entries_) f(entry.source);
    }
    /// Null where one process is alone.
    const Halo<dim>* halo() const { return halo_; }
    std::size_t bytes() const;

    /// Calls f(foot, patch) for each patch that may be within reach of a place, also where an edge or a vertex is the nearest place of the
    /// patch and there is no image, but not where that place lies in another solid.
    template<class F> void forEachWallNear(Vector<dim> x, const F& f) const
    {
        forEachFoot(*geometry_, wallsNear(x), in3D(x), Box::infinity,
                    [&](const Foot& foot, int p) { f(foot, geometry_->patches[std::size_t(p)]); });
    }

    /// The nearest foot of x within `reach` [m] that bounds the fluid, on a face, an edge or a vertex, or one that is infinitely far.
    NearestFoot nearestFoot(Vector<dim> x, double reach) const;

    /// The particles that lay nearer than this [m] to a face that they are mirrored in when images were last moved, ascending, with the least of the
    /// distances: from the planes of faces, and half of it from smooth patches, so that no wall is nearer.
    std::vector<std::pair<std::size_t, double>> nearFaces(double distance) const;

    /// Patches that may be within reach of a point.
    std::span<const int> wallsNear(Vector<dim> x) const { return grid_.near(in3D(x)); }

private:
    static constexpr int mostReflections = 9;
    struct Entry
    {
        int source;
        std::array<signed char, dim> shift;
        unsigned char reflections = 0;
        int place = 0; ///< place in the arrays, behind the owned particles and the copies of other ranks'
        bool ghost() const { return reflections > 0; }
    };
    static_assert(sizeof(Entry) <= 12);
    /// One face that an image was mirrored in.
    struct Mirror
    {
        int patch, facet = -1; ///< the facet of a mesh that the image lies behind now
        bool operator==(const Mirror&) const = default;
    };
    using Mirrors = std::array<Mirror, mostReflections>;
    /// A foot point of one image as last moved; images mirrored once need one, which is most of them.
    struct Feet
    {
        Vector<dim> normal;
        double distance, weight;
        int wall;
    };
    /// The tangent plane that an image was mirrored in.
    struct Face
    {
        Vector<3> normal, foot;
        double turn = 0; ///< largest angle by which the normal turns until lists are built anew [rad]; known while images are made
        double depthOf(const Vector<3>& y) const { return dot(normal, foot - y); }
    };
    using Faces = std::array<Face, mostReflections>;
    /// One image while images are made.
    struct Ghost
    {
        Entry entry;
        Mirrors mirrors;
        Vector<dim> x;
        double speed; ///< speed of the image over that of its source
        Faces faces = {};
        double weight = 1; ///< largest weight, share times volume factor, until lists are built anew
        bool isOfSeveral() const
        {
            return std::any_of(mirrors.begin(), mirrors.begin() + entry.reflections,
                               [&](const Mirror& m) { return m.patch != mirrors[0].patch; });
        }
    };

    /// Images of some particles, by one thread.
    struct Made
    {
        std::vector<Entry> entries;
        std::vector<Vector<dim>> places;
        std::vector<Mirror> mirrors;
        double fastest = 1;
        void add(const Entry& e, const Vector<dim>& place, const Mirrors& of)
        {
            entries.push_back(e);
            places.push_back(place);
            mirrors.insert(mirrors.end(), of.begin(), of.begin() + e.reflections);
        }
    };

    const Geometry* geometry_;
    Halo<dim>* halo_;
    PatchGrid grid_;
    double reach_, spacing_, skin_, fastest_ = 1;
    std::map<std::string, std::unique_ptr<AnyGhostRule>, std::less<>> rules_; ///< rules by field
    std::set<std::string, std::less<>> interpolated_; ///< fields of which particles of layers have values of their own
    bool continuesInterfaces_ = false;
    std::optional<WallLayers<dim>> layers_;
    std::size_t owned_ = 0, sources_ = 0; ///< owned particles, and copies of others' behind them
    std::size_t made_ = 0;                ///< images that the arrays have room for
    std::vector<Entry> entries_;          ///< images that some list names
    std::vector<Vector<dim>> places_;     ///< positions, while images are made
    std::vector<Mirror> mirrors_;         ///< mirrors of all ghosts, as many for each as it has reflections, in order
    std::vector<Feet> feet_;              ///< feet of all ghosts, likewise
    std::vector<unsigned> firstFoot_;

    const TriangleMesh* meshOf(int patch) const { return geometry_->patches[std::size_t(patch)].mesh; }
    /// Position of the image of x. Multiplies `share` by that of the image in each face that it was mirrored in.
    Vector<dim> place(const Entry&, Mirror* mirrors, Vector<dim> x, Feet* feet, double* share = nullptr) const;
    void prefetchFacets(std::size_t begin, std::size_t end) const;
    Foot footOf(Mirror&, int reflection, const Vector<3>& x, const Vector<3>& source) const;
    double speedOf(const Foot&) const;
    double turnOf(const Ghost& from, int patch, const Foot&) const;
    bool fillsCorner(int patch, int before, const Vector<3>& x) const;
    bool isPlane(int patch) const;
    bool isOfWedge(const Ghost&) const;
    bool mayGoOn(const Ghost&, int patch) const;
    double weightSoon(const Ghost&, Foot, double speed) const;
    bool goesOnInWedge(const Mirror* mirrors, int last) const;
    double shareAmong(const Mirror* mirrors, const Face* faces, int last, const Vector<3>& y, double slack = 0) const;
    /// Makes the images of these sources, and appends them.
    void make(const std::array<double*, dim>& x, std::size_t begin, std::size_t end);
    void reflect(int source, const Vector<dim>& x, Made&) const;
    void reflectInShape(const Ghost& from, int patch, const Vector<3>& source, std::vector<Ghost>& ghosts) const;
    void reflectInMesh(const Ghost& from, int patch, std::vector<Ghost>& ghosts) const;
    bool isTwin(const Ghost&, const std::vector<Ghost>&) const;
    /// Whether a ghost of two planes that meet at an acute angle is mirrored a third time, in the first of them: at 60 degrees, five images fill the wedge.
    bool mirrorsAgain(const Mirrors& twice, int patch) const;
    void shift(int source, const Vector<dim>& x, int axis, std::size_t first, std::size_t firstMirror, Made&) const;
    void keepNear();
    void keepIf(const auto& kept);
    Vector<dim> period(const Entry&) const;
};

/// Computes the image's value: mirrored in every wall that it was reflected in, and not changed by periodic shifts.
template<int dim> template<class F> void Images<dim>::refresh(const Images& images, FieldStore<dim>& store, const std::string& name)
{
    if (F::info.image == Image::placed) return;
    using Value = FieldValue<F, dim>;
    const auto p = store.template pointers<F>(name);
    [[maybe_unused]] auto ofGhosts = p;
    if constexpr (F::info.ofGhosts != nullptr)
        if (store.has(F::info.ofGhosts))
            for (std::size_t c = 0; c < p.size(); ++c) ofGhosts[c] = store.component(F::info.ofGhosts, int(c));
    [[maybe_unused]] const auto position = store.pointers(Position{});
    constexpr bool ofGradient = F::info.image == Image::ruledGradient;
    [[maybe_unused]] const auto* const rule = images.template rule<std::conditional_t<ofGradient, Vector<dim>, Value>>(F::info.ofRule);
    const std::size_t n = images.entries_.size(), sources = images.sources_;
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < n; ++k)
    {
        const Entry& e = images.entries_[k];
        Value q;
        if constexpr (F::info.ofGhosts != nullptr) fetch(q, [&](int c) { return (e.ghost() ? ofGhosts : p)[c][e.source]; });
        else fetch(q, [&](int c) { return p[c][e.source]; });
        if constexpr (F::info.image != Image::copied)
        {
            const Feet* feet = images.feet_.data() + images.firstFoot_[k];
            [[maybe_unused]] Vector<dim> x; // position of the source, then of its ghost
            constexpr bool turned = F::info.image == Image::mirrored || F::info.image == Image::interface;
            const bool straight = turned ? F::info.image == Image::interface && images.continuesInterfaces_ : !rule;
            const int reflections = straight ? 0 : e.reflections;
            if constexpr (!turned) fetch(x, [&](int c) { return position[c][e.source]; });
            for (int r = 0; r < reflections; ++r)
            {
                if constexpr (turned) q = mirrored(q, feet[r].normal);
                else
                {
                    const auto foot = x - feet[r].distance * feet[r].normal;
                    const Reflection<dim> reflection{feet[r].distance, feet[r].weight, feet[r].normal, feet[r].wall, in3D(foot)};
                    x = foot - feet[r].distance * feet[r].normal;
                    if constexpr (ofGradient) q = gradientBeyond(*rule, q, reflection);
                    else if constexpr (F::info.image == Image::ruled) q = (*rule)(q, e.source, reflection, r == 0);
                    else q = rule->change(q, reflection);
                }
            }
        }
        sph::store(q, [&](int c, double a) { p[c][sources + std::size_t(e.place)] = a; });
    }
    // All other fields of wall particles are computed pair by pair.
    if (images.layers_ && images.interpolates(F::info))
        images.layers_->extrapolate(store, name, rule,
                                    F::info.inLayers == InLayers::extrapolated ? Extrapolation::mean : Extrapolation::fit);
    for (double* a : p) images.setNullParticle(a);
}

}
