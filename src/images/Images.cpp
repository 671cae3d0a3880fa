#include "images/Images.hpp"
#include "geometry/components.hpp"
#include "images/chainTable.hpp"
#include "images/imageShares.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

template<int dim>
Images<dim>::Images(const Geometry& geometry, double reach, double spacing, double skin, Halo<dim>* halo, double reachOfWalls)
    : walls_(geometry, reach, spacing, skin, reachOfWalls), halo_(halo)
{}

template<int dim> Vector<dim> Images<dim>::period(const Entry& e) const
{
    const auto extent = walls_.geometry().high - walls_.geometry().low;
    Vector<dim> by;
    fetch(by, [&](int c) { return e.shift[std::size_t(c)] * (extent.*component(c)); });
    return by;
}

template<int dim> Vector<dim> Images<dim>::place(const Entry& e, Mirror* mirrors, Vector<dim> x, Feet* feet, double* share) const
{
    const auto source = in3D(x);
    Faces faces;
    for (int r = 0; r < e.reflections; ++r)
    {
        const Foot f = walls_.footOf(mirrors[r], r, in3D(x), source);
        const double factor = volumeFactor(f);
        // The source may have moved beyond a centre of curvature since images were made, and a ghost that was mirrored once behind the next face.
        const bool exists = factor > 0 && std::isfinite(factor) && (r == 0 || f.distance > 0);
        feet[r] = {in<dim>(f.normal), f.distance, exists ? factor : 1,
                   walls_.geometry().patches[std::size_t(mirrors[r].patch)].wallAt(f.region)};
        if (share) *share *= exists ? faceShare(f, walls_.spacing()) : 0;
        faces[std::size_t(r)] = {f.normal, in3D(x) - f.distance * f.normal};
        x = in<dim>(mirrorImage(in3D(x), f));
        if (share && r > 0) *share *= shareAmong(walls_, mirrors, faces.data(), r, in3D(x));
        if (share && goesOnInWedge(mirrors, r, walls_.reflectors(), dim))
            *share *= shareOfWedge(faces[std::size_t(r)].normal, faces[std::size_t(r) - 1].normal);
    }
    return x + period(e);
}

template<int dim> void Images<dim>::make(const std::array<double*, dim>& x, std::size_t begin, std::size_t end)
{
    for (const auto& made : makeImages<dim>(walls_, !layers_, x, begin, end))
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

template<int dim> void Images<dim>::keepSeen(std::span<const char> seen)
{
    const std::size_t copies = sources_ - owned_;
    keepIf([&](std::size_t k) { return seen[copies + k]; });
}

template<int dim> void Images<dim>::build(FieldStore<dim>& store, std::size_t owned)
{
    owned_ = sources_ = owned;
    entries_.clear();
    mirrors_.clear();
    feet_.clear();
    firstFoot_.clear();
    fastest_ = 1;
    make(store.pointers(Position{}), 0, owned);
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
        make(store.pointers(Position{}), owned, sources_);
        keepIf([this](std::size_t k) { return halo_->isNear(places_[k]); }); // images that this rank's particles may see
        if (layers_) layers_->keepNear(*halo_);
        fastest_ = ofAllRanks(fastest_, 1.0, Larger{});
    }
    places_ = {};
    made_ = entries_.size();
    for (std::size_t k = 0; k < made_; ++k) entries_[k].place = int(k);
    // Vectors that grow by themselves double: of many images that is more than a field.
    const auto trim = [](auto& v)
    {
        if (v.capacity() > v.size() + v.size() / 10) v.shrink_to_fit();
    };
    trim(entries_);
    trim(mirrors_);
    trim(firstFoot_);
    const std::size_t feet = mirrors_.size();
    if (feet > feet_.capacity()) feet_.reserve(feet + feet / 20);
    feet_.resize(feet);
    store.resize(nullParticle() + 1, owned_);
    if (layers_) layers_->place(store, sources_ + made_);
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
#pragma omp parallel for schedule(static)
    for (std::size_t begin = 0; begin < entries_.size(); begin += atOnce)
    {
        const std::size_t end = std::min(begin + atOnce, entries_.size());
        if (inMeshes) prefetchFacets(begin, end);
        for (std::size_t k = begin; k < end; ++k)
        {
            const Entry& e = entries_[k];
            const std::size_t at = sources_ + std::size_t(e.place);
            Feet* const feet = feet_.data() + firstFoot_[k];
            const auto x_i = valueAt<Vector<dim>>(x, std::size_t(e.source));
            double w = 1;
            sph::store(place(e, mirrors_.data() + firstFoot_[k], x_i, feet, weight ? &w : nullptr), [&](int c, double q) { x[c][at] = q; });
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
    return (layers_ ? layers_->bytes() : 0) + entries_.capacity() * sizeof(Entry) + feet_.capacity() * sizeof(Feet) +
           mirrors_.capacity() * sizeof(Mirror) + firstFoot_.capacity() * sizeof(unsigned);
}

template class Images<2>;
template class Images<3>;

}
