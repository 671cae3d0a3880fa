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
/// Which images there are is decided when lists are built (makeImages.hpp). From then on this class stores them, moves them with their sources, and computes their
/// values, in each pass only of the fields that it reads.
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
    void build(FieldStore<dim>& store, std::size_t owned, bool remember = true)
    {
        buildPlaces(store, owned, remember);
        store.resize(nullParticle() + 1, owned);
    }
    /// The same, but with room for images in the fields alone that say where and what they are: the other fields get it by `keepSeen`.
    void buildPlaces(FieldStore<dim>& store, std::size_t owned, bool remember = true);
    bool recalls() const { return way_ > 0; }
    /// Searches anew for all images the next time.
    void forget() { recalled_.clear(); }
    /// Forgets images that no list names: the others, and what stands behind them, take their places, in the arrays and in the lists. Resizes the store.
    void keepSeen(FieldStore<dim>& store, NeighbourLists<dim>& lists);

    /// Updates the positions of the images, their volume factors and walls where the store has them, and the null particle's position.
    void move(FieldStore<dim>& store);

    /// The null particle's value in one array: it has W = 0, but enters the arithmetic, and must be finite.
    double ofNullParticle(const double* array) const { return owned_ > 0 ? array[0] : 1.0; }
    void setNullParticle(double* array) const { array[nullParticle()] = ofNullParticle(array); }

    /// Refreshes the images' values of one field that has room for them, by the rule that its tag states; `name` is the field's in this scene.
    template<class F> static void refresh(const Images& images, FieldStore<dim>& store, const std::string& name = F::info.name);
    /// Computes the values that `n` images from place `first` on, the null particle among them, have of a field without room for them: component c to to[c]. Not where
    /// ranks share the particles or walls are layers.
    template<class F>
    static void compute(const Images& images, FieldStore<dim>& store, const std::string& name, std::size_t first, std::size_t n,
                        double* const* to);

    /// Largest speed at which a particle and an image may part, over twice the largest speed of a particle. It is 1 but for images inside concave walls,
    /// which move along them (R + d)/(R - d) times as far as their sources.
    double closingSpeed() const { return 0.5 * (1 + fastest_); }

    std::size_t owned() const { return owned_; }
    /// Number of images, copies of other ranks' particles among them.
    std::size_t count() const { return sources_ - owned_ + entries_.size(); }
    /// Particle j, or what it is an image of; j < owned() + count().
    std::size_t sourceOf(std::size_t j) const { return j < sources_ ? j : std::size_t(entries_[j - sources_].source); }
    std::size_t nullParticle() const { return sources_ + entries_.size() + (layers_ ? layers_->count() : 0); }
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
    template<class F> class ValuesOf;
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
    std::vector<Entry> entries_;          ///< image k stands in place sources_ + k
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

/// The values of one field at images, from those of their sources: mirrored in every wall that an image was reflected in, and not changed by periodic shifts.
template<int dim> template<class F> class Images<dim>::ValuesOf
{
    static_assert(F::info.image != Image::placed);
    using Value = FieldValue<F, dim>;
    static constexpr bool ofGradient = F::info.image == Image::ruledGradient,
                          turned = F::info.image == Image::mirrored || F::info.image == Image::interface;
    using Rule = GhostRule<std::conditional_t<ofGradient, Vector<dim>, Value>, dim>;

    const Images& images_;
    std::array<double*, fieldComponents<F, dim>> of_, ofGhosts_;
    std::array<double*, fieldComponents<Position, dim>> position_;
    const Rule* rule_ = nullptr;

public:
    ValuesOf(const Images& images, FieldStore<dim>& store, const std::string& name)
        : images_(images), of_(store.template pointers<F>(name)), ofGhosts_(of_), position_(store.pointers(Position{}))
    {
        if constexpr (F::info.ofGhosts != nullptr)
            if (store.has(F::info.ofGhosts))
                for (std::size_t c = 0; c < of_.size(); ++c) ofGhosts_[c] = store.component(F::info.ofGhosts, int(c));
        if constexpr (!turned) rule_ = images.rules_.template of<std::conditional_t<ofGradient, Vector<dim>, Value>>(F::info.ofRule);
    }
    const Rule* rule() const { return rule_; }

    /// The value at image k.
    Value operator()(std::size_t k) const
    {
        const Entry& e = images_.entries_[k];
        Value q;
        if constexpr (F::info.ofGhosts != nullptr) fetch(q, [&](int c) { return (e.ghost() ? ofGhosts_ : of_)[c][e.source]; });
        else fetch(q, [&](int c) { return of_[c][e.source]; });
        if constexpr (F::info.image != Image::copied)
        {
            const Feet* feet = images_.feet_.data() + images_.firstFoot_[k];
            [[maybe_unused]] Vector<dim> x; // position of the source, then of its ghost
            const bool straight = turned ? F::info.image == Image::interface && images_.continuesInterfaces_ : !rule_;
            const int reflections = straight ? 0 : e.reflections;
            if constexpr (!turned) fetch(x, [&](int c) { return position_[c][e.source]; });
            for (int r = 0; r < reflections; ++r)
            {
                if constexpr (turned) q = mirrored(q, feet[r].normal);
                else
                {
                    const auto foot = x - feet[r].distance * feet[r].normal;
                    const double facing = r == 0 ? 1 : -dot(feet[r].normal, feet[r - 1].normal);
                    const Reflection<dim> reflection{feet[r].distance, feet[r].weight, feet[r].normal, feet[r].wall, in3D(foot), 1, facing};
                    x = foot - feet[r].distance * feet[r].normal;
                    if constexpr (ofGradient) q = gradientBeyond(*rule_, q, reflection);
                    else if constexpr (F::info.image == Image::ruled) q = (*rule_)(q, e.source, reflection);
                    else q = rule_->change(q, reflection);
                }
            }
        }
        return q;
    }
};

template<int dim> template<class F> void Images<dim>::refresh(const Images& images, FieldStore<dim>& store, const std::string& name)
{
    if constexpr (F::info.image != Image::placed)
    {
        if (!store.imaged(name)) return;
        const ValuesOf<F> values(images, store, name);
        const auto p = store.template pointers<F>(name);
        const std::size_t n = images.entries_.size(), sources = images.sources_;
#pragma omp parallel for schedule(static)
        for (std::size_t k = 0; k < n; ++k) sph::store(values(k), [&](int c, double a) { p[c][sources + k] = a; });
        // All other fields of wall particles are computed pair by pair.
        if (images.layers_ && images.rules_.interpolates(F::info))
            images.layers_->extrapolate(store, name, values.rule(),
                                        F::info.inLayers == InLayers::extrapolated ? Extrapolation::mean : Extrapolation::fit);
        for (double* a : p) images.setNullParticle(a);
    }
}

template<int dim>
template<class F>
void Images<dim>::compute(const Images& images, FieldStore<dim>& store, const std::string& name, std::size_t first, std::size_t n,
                          double* const* to)
{
    if constexpr (F::info.image != Image::placed)
    {
        const ValuesOf<F> values(images, store, name);
        const std::size_t last = std::min(n, images.nullParticle() - first);
        for (std::size_t k = 0; k < last; ++k) sph::store(values(first - images.sources_ + k), [&](int c, double a) { to[c][k] = a; });
        if (last == n) return;
        const auto p = store.template pointers<F>(name);
        for (std::size_t c = 0; c < p.size(); ++c) to[c][last] = images.ofNullParticle(p[c]);
    }
}

}
