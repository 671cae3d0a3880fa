#include "images/Images.hpp"
#include "geometry/components.hpp"
#include "images/chainTable.hpp"
#include "images/imageShares.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sph
{

template<int dim>
Images<dim>::Images(const Geometry& geometry, double reach, double spacing, double skin, Halo<dim>* halo, double reachOfWalls,
                    double recalled)
    : walls_(geometry, reach + 2 * recalled, spacing, skin + 2 * recalled, reachOfWalls), halo_(halo), way_(recalled)
{}

/// The reflections of one particle as a tree: images that begin in the same mirrors have those reflections in common, and each is computed once. Beside meshes most
/// images are images of images, and what is shifted has all of its reflections in common with what is not.
template<int dim> struct Images<dim>::Reflections
{
    struct Reflection
    {
        Mirror asked, found; ///< before and after the search for the facet that the image lies behind now
        Feet feet;
        Face face;
        Vector<dim> x;    ///< of the image
        double share;     ///< product of those of the image in each face up to here
        int sibling;      ///< the one before with the same reflections up to here; -1 where there is none
        int further = -1; ///< the last of those that go on from here
    };
    int source = -1;
    std::vector<Reflection> all;
    int first = -1;

    /// Of this mirror, after those up to `before`; -1 where it is not computed yet.
    int find(int before, const Mirror& mirror) const
    {
        int k = last(before);
        while (k >= 0 && !(all[std::size_t(k)].asked == mirror)) k = all[std::size_t(k)].sibling;
        return k;
    }
    int last(int before) const { return before < 0 ? first : all[std::size_t(before)].further; }
    int add(int before, Reflection one)
    {
        one.sibling = last(before);
        all.push_back(one);
        return (before < 0 ? first : all[std::size_t(before)].further) = int(all.size()) - 1;
    }
};

template<int dim>
double Images<dim>::place(const Entry& e, Mirror* mirrors, Vector<dim>& x, Feet* feet, bool weighted, Reflections& known) const
{
    if (known.source != e.source)
    {
        known.all.clear();
        known.first = -1;
        known.source = e.source;
    }
    const auto source = in3D(x);
    Faces faces;
    double share = 1;
    int last = -1;
    for (int r = 0; r < e.reflections; ++r)
    {
        int at = known.find(last, mirrors[r]);
        if (at < 0)
        {
            typename Reflections::Reflection one;
            one.asked = mirrors[r];
            const Foot f = walls_.footOf(mirrors[r], r, in3D(x), source);
            const double factor = volumeFactor(f);
            // The source may have moved beyond a centre of curvature since images were made, and a ghost that was mirrored once behind the next face.
            const bool exists = factor > 0 && std::isfinite(factor) && (r == 0 || f.distance > 0);
            one.found = mirrors[r];
            one.feet = {in<dim>(f.normal), f.distance, exists ? factor : 1,
                        walls_.geometry().patches[std::size_t(mirrors[r].patch)].wallAt(f.region)};
            if (weighted) share *= exists ? faceShare(f, walls_.spacing()) : 0;
            faces[std::size_t(r)] = one.face = {f.normal, in3D(x) - f.distance * f.normal};
            one.x = in<dim>(mirrorImage(in3D(x), f));
            if (weighted && r > 0) share *= shareAmong(walls_, mirrors, faces.data(), r, in3D(one.x));
            if (weighted && goesOnInWedge(mirrors, r, walls_.reflectors(), dim))
                share *= shareOfWedge(faces[std::size_t(r)].normal, faces[std::size_t(r) - 1].normal);
            one.share = share;
            at = known.add(last, one);
        }
        const auto& one = known.all[std::size_t(at)];
        mirrors[r] = one.found;
        feet[r] = one.feet;
        faces[std::size_t(r)] = one.face;
        x = one.x;
        share = one.share;
        last = at;
    }
    x += shiftOf(e, walls_.geometry());
    return share;
}

template<int dim> void Images<dim>::append(const std::vector<MadeImages<dim>>& all)
{
    for (const auto& made : all)
    {
        std::size_t foot = mirrors_.size();
        for (const auto& e : made.entries)
        {
            firstFoot_.push_back(unsigned(foot));
            foot += e.reflections;
        }
        entries_.insert(entries_.end(), made.entries.begin(), made.entries.end());
        places_.insert(places_.end(), made.places.begin(), made.places.end());
        mirrors_.insert(mirrors_.end(), made.mirrors.begin(), made.mirrors.end());
        fastest_ = std::max(fastest_, made.fastest);
    }
}

template<int dim> void Images<dim>::makeOfOwned(FieldStore<dim>& store, bool remember)
{
    double* const number = way_ > 0 ? store.component(ImagesMade::info.name, 0) : nullptr;
    auto made = makeImages<dim>(walls_, !layers_, store.pointers(Position{}), 0, owned_, {recalled_, number, way_, halo_ != nullptr});
    append(made);
    if (!number || !remember) return;
    for (auto& portion : made)
    {
        portion.places = {};
        portion.entries.shrink_to_fit();
        portion.mirrors.shrink_to_fit();
        portion.particles.shrink_to_fit();
    }
    recalled_ = std::move(made);
    std::iota(number, number + owned_, 1.0);
}

template<int dim> void Images<dim>::keepIf(const auto& kept)
{
    std::size_t count = 0, foot = 0;
    for (std::size_t k = 0; k < entries_.size(); ++k)
    {
        if (!kept(k)) continue;
        const std::size_t from = firstFoot_[k];
        const Entry e = entries_[count] = entries_[k];
        firstFoot_[count++] = unsigned(foot);
        std::copy_n(mirrors_.begin() + long(from), e.reflections, mirrors_.begin() + long(foot));
        if (!feet_.empty()) std::copy_n(feet_.begin() + long(from), e.reflections, feet_.begin() + long(foot));
        foot += e.reflections;
    }
    entries_.resize(count);
    firstFoot_.resize(count);
    mirrors_.resize(foot);
    if (!feet_.empty()) feet_.resize(foot);
}

namespace
{
/// Vectors that grow by themselves double, and images are forgotten: of many that is more than a field.
void trim(auto&... vectors) { ((vectors.capacity() > vectors.size() + vectors.size() / 10 ? vectors.shrink_to_fit() : void()), ...); }

/// What an image is by itself, rather than by its source.
const std::set<std::string> ofPlaces{Position::info.name, ImageWeight::info.name, GhostWall::info.name};
}

template<int dim> void Images<dim>::keepSeen(FieldStore<dim>& store, NeighbourLists<dim>& lists)
{
    const auto seen = lists.seen();
    const std::size_t copies = sources_ - owned_, made = entries_.size();
    keepIf([&](std::size_t k) { return seen[copies + k]; });
    trim(entries_, mirrors_, firstFoot_, feet_);
    if (entries_.size() < made)
    {
        // Of each particle behind the owned ones, the null particle last. An image that is forgotten has the number of the next that is not.
        std::vector<int> numbers(seen.size() + 1);
        int next = int(owned_);
        for (std::size_t k = 0; k < numbers.size(); ++k)
        {
            numbers[k] = next;
            next += k < copies || k >= copies + made || seen[k];
        }
        for (const auto& name : ofPlaces)
        {
            const std::size_t components = store.has(name) ? store.fields().at(name).component.size() : 0;
            for (std::size_t c = 0; c < components; ++c)
            {
                double* const a = store.component(name, int(c));
                for (std::size_t k = 0; k < numbers.size(); ++k) a[numbers[k]] = a[owned_ + k];
            }
        }
        lists.renumber(numbers);
        if (layers_) layers_->placedFrom(sources_ + entries_.size());
    }
    store.resize(nullParticle() + 1, owned_);
}

template<int dim> void Images<dim>::buildPlaces(FieldStore<dim>& store, std::size_t owned, bool remember)
{
    owned_ = sources_ = owned;
    entries_.clear();
    mirrors_.clear();
    feet_.clear();
    firstFoot_.clear();
    fastest_ = 1;
    makeOfOwned(store, remember);
    if (halo_)
    {
        sources_ += halo_->build(store, owned,
                                 [&](const auto& seen)
                                 {
                                     const auto x = store.pointers(Position{});
                                     std::size_t k = 0;
                                     for (int i = 0; i < int(owned); ++i)
                                     {
                                         seen(valueAt<Vector<dim>>(x, std::size_t(i)), i);
                                         for (; k < entries_.size() && entries_[k].source == i; ++k) seen(places_[k], i);
                                     }
                                 });
        append(makeImages<dim>(walls_, !layers_, store.pointers(Position{}), owned, sources_));
        keepIf([this](std::size_t k) { return halo_->isNear(places_[k]); }); // images that this rank's particles may see
        if (layers_) layers_->keepNear(*halo_);
        fastest_ = ofAllRanks(fastest_, 1.0, Larger{});
    }
    places_ = {};
    trim(entries_, mirrors_, firstFoot_);
    feet_.resize(mirrors_.size());
    store.makeRoom(ofPlaces, nullParticle() + 1);
    if (layers_) layers_->place(store, sources_ + entries_.size());
    move(store);
}

/// Prefetches, of meshes that no cache holds, what the first reflections of these images will read. (To gcc a function that only prefetches does nothing.)
template<int dim> [[gnu::noipa]] void Images<dim>::prefetchFacets(std::size_t begin, std::size_t end) const
{
    for (const bool corners : {false, true})
        for (std::size_t k = begin; k < end; ++k)
        {
            if (!entries_[k].ghost()) continue;
            const Mirror& first = mirrors_[firstFoot_[k]];
            const auto* mesh = walls_.meshOf(first.patch);
            if (mesh && corners) mesh->body().prefetchCorners(first.facet);
            else if (mesh) mesh->body().prefetchFacet(first.facet);
        }
}

template<int dim> void Images<dim>::move(FieldStore<dim>& store)
{
    if (halo_) halo_->refresh(store, std::array{std::string(Position::info.name)});
    const auto x = store.pointers(Position{});
    double* const weight = store.has(ImageWeight{}) ? store.component(ImageWeight::info.name, 0) : nullptr;
    double* const wall = store.has(GhostWall{}) ? store.component(GhostWall::info.name, 0) : nullptr;
    const bool inMeshes = std::ranges::any_of(walls_.geometry().patches, [](const auto& p) { return p.mesh != nullptr; });
    constexpr std::size_t atOnce = 32;
    Reflections known;
#pragma omp parallel for schedule(static) firstprivate(known)
    for (std::size_t begin = 0; begin < entries_.size(); begin += atOnce)
    {
        const std::size_t end = std::min(begin + atOnce, entries_.size());
        if (inMeshes) prefetchFacets(begin, end);
        for (std::size_t k = begin; k < end; ++k)
        {
            const Entry& e = entries_[k];
            const std::size_t at = sources_ + k;
            Feet* const feet = feet_.data() + firstFoot_[k];
            auto place_k = valueAt<Vector<dim>>(x, std::size_t(e.source));
            double w = place(e, mirrors_.data() + firstFoot_[k], place_k, feet, weight != nullptr, known);
            sph::store(place_k, [&](int c, double q) { x[c][at] = q; });
            if (weight)
            {
                for (int r = 0; r < e.reflections; ++r) w *= feet[r].weight;
                weight[at] = w;
            }
            if (wall) wall[at] = e.ghost() ? 1 + feet[e.reflections - 1u].wall : 0;
        }
    }
    const auto low = in<dim>(walls_.geometry().low), extent = in<dim>(walls_.geometry().high - walls_.geometry().low);
    sph::store(low - 1e3 * extent, [&](int c, double q) { x[c][nullParticle()] = q; });
    if (weight)
    {
        std::fill_n(weight, sources_, 1.0);
        weight[nullParticle()] = 1.0;
    }
    if (wall)
    {
        std::fill_n(wall, sources_, 0.0);
        wall[nullParticle()] = 0.0;
    }
}

template<int dim> std::vector<std::pair<std::size_t, double>> Images<dim>::nearFaces(double distance) const
{
    std::vector<std::pair<std::size_t, double>> near;
    for (std::size_t k = 0; k < entries_.size(); ++k)
    {
        if (!entries_[k].ghost() || std::size_t(entries_[k].source) >= owned_) continue;
        double d = feet_[firstFoot_[k]].distance;
        // An image in a smooth patch lies along a mean normal, and neighbours that have none may be nearer in hollows: among rocks
        // the surface is up to 7 % nearer.
        const auto& mirror = mirrors_[firstFoot_[k]];
        if (const auto* mesh = walls_.meshOf(mirror.patch); mesh && !mesh->body().facets()[std::size_t(mirror.facet)].planar) d *= 0.5;
        if (d < distance) near.emplace_back(entries_[k].source, d);
    }
    std::ranges::sort(near);
    const auto repeated = std::ranges::unique(near, {}, [](const auto& one) { return one.first; });
    near.erase(repeated.begin(), repeated.end());
    return near;
}

template<int dim> std::size_t Images<dim>::bytes() const
{
    std::size_t recalled = 0;
    for (const auto& made : recalled_)
        recalled += made.entries.capacity() * sizeof(Entry) + made.mirrors.capacity() * sizeof(Mirror) +
                    made.particles.capacity() * sizeof(typename MadeImages<dim>::Particle);
    return recalled + (layers_ ? layers_->bytes() : 0) + entries_.capacity() * sizeof(Entry) + feet_.capacity() * sizeof(Feet) +
           mirrors_.capacity() * sizeof(Mirror) + firstFoot_.capacity() * sizeof(unsigned);
}

template class Images<2>;
template class Images<3>;

}
