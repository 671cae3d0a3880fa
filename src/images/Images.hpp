/// Images: every particle that is not owned is an image (source, walls, shift) behind the owned ones.
///
///   x' = mirror_n(... mirror_1(x)) + shift
///
/// Terms see one contiguous array and never ask what a neighbour is:
///
///     owned | periodic images of the fluid and wall ghosts | null particle
///
/// Where ranks share the particles, copies of those of others stand behind the owned ones (Halo.hpp), and have images as they do.
///
/// Where walls are layers of particles (WallLayers.hpp) nothing is mirrored, and they lie between the images and the null particle.
///
/// Which images there are is decided when lists are built (makeImages.hpp). From then on this class stores them, moves them with their sources, and refreshes their
/// values: before each pass only the fields that the pass reads.
#pragma once
#include "fields/FieldStore.hpp"
#include "images/FieldRules.hpp"
#include "images/WallLayers.hpp"
#include "images/makeImages.hpp"
#include "neighbours/Halo.hpp"
#include "neighbours/records.hpp"
#include <optional>

namespace sph
{

template<int dim> class Images
{
public:
    /// The geometry, and the halo where there is one, must outlive the images. Images are made within `reach` [m] of the domain's periodic faces and of walls: the kernel's
    /// support and the `skin` [m] of the lists; `nearWalls` knows walls within `reachOfWalls` [m], where that is more. Those of particles that have moved by less than `recalled` [m] since they were made
    /// are made again without a search (Recall); the store then has ImagesMade as a state.
    Images(const Geometry&, double reach, double spacing, double skin = 0, Halo<dim>* halo = nullptr, double reachOfWalls = 0,
           double recalled = 0);

    /// Units of records in single precision, those of columns 1.
    PlaceUnits<dim> placeUnits() const { return {in<dim>(walls_.geometry().low), in<dim>(walls_.geometry().high)}; }
    /// The walls around a place, as far as images reach.
    const NearWalls& nearWalls() const { return walls_.near(); }
    /// Rules by which images beyond walls get the values of fields.
    FieldRules<dim>& rules() { return rules_; }
    const FieldRules<dim>& rules() const { return rules_; }
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

    /// Makes the images of the first `owned` particles and resizes the store. `remember`: those that recall images go on from these.
    void build(FieldStore<dim>& store, std::size_t owned, bool remember = true);
    bool recalls() const { return way_ > 0; }
    /// Searches anew for all images the next time.
    void forget() { recalled_.clear(); }
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

    /// The particles that lay nearer than this [m] to a face that they are mirrored in when images were last moved, ascending, with the least of the
    /// distances: from the planes of faces, and half of it from smooth patches, so that no wall is nearer.
    std::vector<std::pair<std::size_t, double>> nearFaces(double distance) const;

private:
    using Entry = ImageEntry<dim>;
    /// A foot point of one image as last moved; images mirrored once need one, which is most of them.
    struct Feet
    {
        Vector<dim> normal;
        double distance, weight;
        int wall;
    };

    ReflectingWalls walls_;
    Halo<dim>* halo_;
    double way_;                            ///< within which images are recalled [m]; 0: none are
    std::vector<MadeImages<dim>> recalled_; ///< as they were last made for this rank's particles
    FieldRules<dim> rules_;
    double fastest_ = 1;
    bool continuesInterfaces_ = false;
    std::optional<WallLayers<dim>> layers_;
    std::size_t owned_ = 0, sources_ = 0; ///< owned particles, and copies of others' behind them
    std::size_t made_ = 0;                ///< images that the arrays have room for
    std::vector<Entry> entries_;          ///< images that some list names
    std::vector<Vector<dim>> places_;     ///< positions, while images are made
    std::vector<Mirror> mirrors_;         ///< mirrors of all ghosts, as many for each as it has reflections, in order
    std::vector<Feet> feet_;              ///< feet of all ghosts, likewise
    std::vector<unsigned> firstFoot_;

    /// Appends the images of some sources.
    void append(const std::vector<MadeImages<dim>>&);
    /// Makes the images of the owned particles, of which it recalls what it may.
    void makeOfOwned(FieldStore<dim>& store, bool remember);
    struct Reflections;
    /// Moves x to the image of it. Returns the product of its shares in each face that it was mirrored in, if images are `weighted`.
    double place(const Entry&, Mirror* mirrors, Vector<dim>& x, Feet* feet, bool weighted, Reflections& known) const;
    void prefetchFacets(std::size_t begin, std::size_t end) const;
    void keepIf(const auto& kept);
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
    [[maybe_unused]] const auto* const rule = images.rules_.template of<std::conditional_t<ofGradient, Vector<dim>, Value>>(F::info.ofRule);
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
                    const double facing = r == 0 ? 1 : -dot(feet[r].normal, feet[r - 1].normal);
                    const Reflection<dim> reflection{feet[r].distance, feet[r].weight, feet[r].normal, feet[r].wall, in3D(foot), 1, facing};
                    x = foot - feet[r].distance * feet[r].normal;
                    if constexpr (ofGradient) q = gradientBeyond(*rule, q, reflection);
                    else if constexpr (F::info.image == Image::ruled) q = (*rule)(q, e.source, reflection);
                    else q = rule->change(q, reflection);
                }
            }
        }
        sph::store(q, [&](int c, double a) { p[c][sources + std::size_t(e.place)] = a; });
    }
    // All other fields of wall particles are computed pair by pair.
    if (images.layers_ && images.rules_.interpolates(F::info))
        images.layers_->extrapolate(store, name, rule,
                                    F::info.inLayers == InLayers::extrapolated ? Extrapolation::mean : Extrapolation::fit);
    for (double* a : p) images.setNullParticle(a);
}

}
