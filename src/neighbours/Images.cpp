#include "Images.hpp"
#include "components.hpp"
#include "reduce.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

namespace
{
/// Two surfaces that meet at a fluid angle from 105 to 120 degrees on fill the solid behind them with one reflection each. n_p . n_q =
/// -cos(angle).
constexpr double alignedNormals = 0.26, mostAlignedNormals = 0.5;
/// Normals whose product is less are at right angles: images in either order are one.
constexpr double rightAngle = 1e-6;
/// Half of the width over which the images of two surfaces fade into one another at the bisector behind the tip of their wedge [spacings].
constexpr double halfFade = 0.35;
/// Images in several bodies with less than this weight are left out. In the pinch between spheres that touch images of images are many and small: with a support of 3.05
/// spacings and ten of them across a sphere one particle had 1877 neighbours, and has 636, which fill 0.0013 less of its kernel.
constexpr double leastWeight = 0.01;

/// Products of the normals of two walls, 8 and 20 degrees between them: what is narrower is a gap, which no spacing resolves, and is filled by one image of an image.
constexpr double ofGap = -0.99, ofWedge = -0.94;
/// Largest change of their product until lists are built anew, of bodies with edges.
constexpr double mostTurn = 0.03;

/// Largest change of the product of two normals that turn towards one another by an angle [rad].
double changeOfProduct(const Vector<3>& n, const Vector<3>& m, double angle)
{
    const double product = std::clamp(dot(n, m), -1.0, 1.0);
    return std::min(mostTurn, std::cos(std::max(std::acos(product) - angle, 0.0)) - product);
}

/// Share of what is mirrored again in a wall of normal n after one of normal m: all of it in a wedge, nothing in a gap.
double shareOfWedge(const Vector<3>& n, const Vector<3>& m, double slack = 0)
{
    return smoothStep((dot(n, m) + slack - ofGap) / (ofWedge - ofGap));
}

/// Share of what was mirrored in a face of normal n, and lies h behind it, beside the images that end with another face, of normal m, and lies k behind [m],
/// in a solid behind both: half of it each on the bisecting plane.
double shareBeside(const Vector<3>& n, double h, const Vector<3>& m, double k, double spacing, double slack)
{
    const double ofAngle = smoothStep((mostAlignedNormals - dot(n, m)) / (mostAlignedNormals - alignedNormals));
    if (ofAngle == 0) return 0;
    const double turn = mag(n - m), width = std::min(halfFade * spacing, (h + k) / turn);
    return ofAngle * smoothStep(0.5 + 0.5 * ((h - k) / turn + slack) / width);
}
}

template<int dim>
Images<dim>::Images(const Geometry& geometry, double reach, double spacing, double skin, Halo<dim>* halo)
    : geometry_(&geometry), halo_(halo), grid_(geometry, reach), reach_(reach), spacing_(spacing), skin_(skin)
{}

/// The foot of what is mirrored: of the source itself, or of its image so far.
template<int dim> Foot Images<dim>::footOf(Mirror& mirror, int reflection, const Vector<3>& x, const Vector<3>& source) const
{
    const int p = mirror.patch;
    if (const auto* mesh = meshOf(p))
    {
        Foot f = mesh->body().mirror(mirror.facet, mesh->local(x), mesh->hidden());
        if (geometry_->mayBeCovered(p))
        {
            int facet = mirror.facet;
            f.exposure =
                geometry_->exposure(p, source, reflection == 0 ? f : mesh->body().mirror(facet, mesh->local(source), mesh->hidden()));
        }
        return f;
    }
    return reflection == 0 ? geometry_->foot(p, x) : geometry_->footOfGhost(p, x, source);
}

/// Speed of the image over that of its source, until the lists are built anew: meanwhile the distance grows by half the skin
/// at most, and an image beyond the support does not matter.
template<int dim> double Images<dim>::speedOf(const Foot& f) const
{
    const double k = std::max({f.k1, f.k2, 0.0}), d = std::max(f.distance, std::min(f.distance + 0.5 * skin_, reach_ - skin_));
    return k > 0 && f.distance <= reach_ - skin_ ? (1 + k * d) / std::max(1 - k * d, 0.01) : 1;
}

/// Largest angle by which the normal turns until the lists are built anew [rad]: the source moves by half the skin at most, and its image as many times as far as it
/// is faster. A body with edges may show another face at once.
template<int dim> double Images<dim>::turnOf(const Ghost& from, int patch, const Foot& f) const
{
    const auto& shape = *geometry_->patches[std::size_t(patch)].shape;
    if (meshOf(patch) || shape.hasEdges()) return std::numbers::pi;
    const double concave = std::max({f.k1, f.k2, 0.0});
    return 0.5 * skin_ * from.speed / (shape.smallestRadius() * std::max(1 - concave * f.distance, 0.01));
}

template<int dim> Vector<dim> Images<dim>::period(const Entry& e) const
{
    const auto extent = in<dim>(geometry_->high - geometry_->low);
    Vector<dim> by;
    fetch(by,
          [&](int c)
          {
              double L = 0;
              int k = 0;
              store(extent,
                    [&](int d, double q)
                    {
                        if (k++, d == c) L = q;
                    });
              return e.shift[c] * L;
          });
    return by;
}

template<int dim> Vector<dim> Images<dim>::place(const Entry& e, Mirror* mirrors, Vector<dim> x, Feet* feet, double* share) const
{
    const auto source = in3D(x);
    Faces faces;
    for (int r = 0; r < e.reflections; ++r)
    {
        const Foot f = footOf(mirrors[r], r, in3D(x), source);
        const double factor = volumeFactor(f);
        // The source may have moved beyond a centre of curvature since images were made, and a ghost that was mirrored once behind the next face.
        const bool exists = factor > 0 && std::isfinite(factor) && (r == 0 || f.distance > 0);
        feet[r] = {in<dim>(f.normal), f.distance, exists ? factor : 1, geometry_->patches[std::size_t(mirrors[r].patch)].wallAt(f.region)};
        if (share) *share *= exists ? faceShare(f, spacing_) : 0;
        faces[std::size_t(r)] = {f.normal, in3D(x) - f.distance * f.normal};
        x = in<dim>(mirrorImage(in3D(x), f));
        if (share && r > 0) *share *= shareAmong(mirrors, faces.data(), r, in3D(x));
        if (share && goesOnInWedge(mirrors, r)) *share *= shareOfWedge(faces[std::size_t(r)].normal, faces[std::size_t(r) - 1].normal);
    }
    return x + period(e);
}

template<int dim> bool Images<dim>::isPlane(int p) const
{
    const auto& shape = *geometry_->patches[std::size_t(p)].shape;
    return !meshOf(p) && std::isinf(shape.smallestRadius()) && !shape.hasEdges();
}

/// Whether an image may be mirrored in `patch`: in each wall once, as often as there are dimensions, and in two walls in turn as often as their wedge needs.
template<int dim> bool Images<dim>::mayGoOn(const Ghost& from, int patch) const
{
    const auto first = from.mirrors.begin(), last = first + from.entry.reflections;
    const auto isOf = [](int p) { return [p](const Mirror& m) { return m.patch == p; }; };
    if (std::none_of(first, last, isOf(patch))) return from.entry.reflections < dim;
    const int before = (last - 1)->patch;
    if (before == patch || from.entry.reflections == mostReflections || (isPlane(patch) && isPlane(before))) return false;
    return std::all_of(first, last, [&](const Mirror& m) { return m.patch == patch || m.patch == before; });
}

/// Share of an image y, last mirrored in `faces[last]`, beside those that end with the other bodies of its chain; of one that has moved by `slack` at most.
/// What is in one solid alone is its own.
template<int dim> double Images<dim>::shareAmong(const Mirror* mirrors, const Face* faces, int last, const Vector<3>& y, double slack) const
{
    const int p = mirrors[last].patch;
    if (last == 0 || !geometry_->mayBeCovered(p)) return 1;
    const auto& coverers = geometry_->coverers[std::size_t(p)];
    const auto within = [&](int patch)
    { return smoothStep(0.5 - 0.5 * geometry_->patches[std::size_t(patch)].shape->foot(y).distance / (halfFade * spacing_)); };
    double share = 1;
    for (int r = last - 1; r >= 0; --r)
    {
        const int q = mirrors[r].patch;
        const auto isOfThis = [&](const Mirror& m) { return m.patch == q; };
        if (q == p || std::any_of(mirrors + r + 1, mirrors + last, isOfThis) || !std::ranges::binary_search(coverers, q)) continue;
        const auto &face = faces[last], &other = faces[r];
        const double k = other.depthOf(y);
        if (std::abs(dot(face.normal, other.normal)) < rightAngle || k <= 0) continue;
        const double beside = shareBeside(face.normal, face.depthOf(y), other.normal, k, spacing_, slack), inThis = within(p),
                     inOther = within(q);
        if (inThis == 0 && inOther == 0) continue;
        share *= inThis * (1 - inOther * (1 - beside)) / (inThis + inOther - inThis * inOther);
    }
    return share;
}

/// The greatest factor that the last reflection may give to the weight until lists are built anew; `speed` is that of what it mirrors, over that of the source.
template<int dim> double Images<dim>::weightSoon(const Ghost& ghost, Foot f, double speed) const
{
    const double way = 0.5 * skin_;
    const auto volumeAt = [&f](double distance)
    {
        Foot at = f;
        at.distance = distance;
        const double factor = volumeFactor(at);
        return factor > 0 ? factor : Box::infinity; // beyond a centre of curvature
    };
    const double volume = std::max(volumeAt(f.distance + way * speed), volumeAt(std::max(f.distance - way * speed, 0.0)));
    f.exposure = 1;
    f.margin += way;
    const int last = ghost.entry.reflections - 1;
    const auto& faces = ghost.faces;
    double ofWedge = 1;
    if (goesOnInWedge(ghost.mirrors.data(), last))
    {
        const auto &face = faces[std::size_t(last)], &before = faces[std::size_t(last) - 1];
        ofWedge = shareOfWedge(face.normal, before.normal, changeOfProduct(face.normal, before.normal, face.turn + before.turn));
    }
    return volume * faceShare(f, spacing_) * ofWedge * shareAmong(ghost.mirrors.data(), faces.data(), last, in3D(ghost.x), way);
}

/// Whether the last reflection is one more than walls that do not meet in a wedge would have.
template<int dim> bool Images<dim>::goesOnInWedge(const Mirror* mirrors, int last) const
{
    if (last < dim) return false;
    const int p = mirrors[last].patch, q = mirrors[last - 1].patch;
    return p != q && !(isPlane(p) && isPlane(q));
}

template<int dim> bool Images<dim>::mirrorsAgain(const Mirrors& twice, int patch) const
{
    if (patch != twice[0].patch) return false;
    const auto normal = [&](int p) { return geometry_->patches[std::size_t(p)].shape->foot({}).normal; };
    if (!isPlane(twice[0].patch) || !isPlane(twice[1].patch)) return false;
    // From about 75 degrees on two reflections fill the corner. Planes that all but face one another are a slit, whose third image is far.
    const double cosine = -dot(normal(twice[0].patch), normal(twice[1].patch));
    return cosine > 0.26 && cosine < 0.97;
}

/// Images follow one another as their sources do: the parts of the arrays that a thread computes of particles and of images belong together.
template<int dim> void Images<dim>::make(const std::array<double*, dim>& x, std::size_t begin, std::size_t end)
{
    const std::size_t chunkSize = 256;
    std::vector<Made> made((end - begin + chunkSize - 1) / chunkSize);
#pragma omp parallel for schedule(dynamic)
    for (std::size_t chunk = 0; chunk < made.size(); ++chunk)
    {
        Made images; // of this thread alone: those of two chunks may share a line of the cache
        for (std::size_t i = begin + chunk * chunkSize; i < std::min(end, begin + (chunk + 1) * chunkSize); ++i)
        {
            const auto x_i = valueAt<Vector<dim>>(x, i);
            const std::size_t first = images.entries.size(), firstMirror = images.mirrors.size();
            if (!geometry_->patches.empty() && !layers_) reflect(int(i), x_i, images);
            for (int axis = 0; axis < dim; ++axis)
                if (geometry_->periodic[axis]) shift(int(i), x_i, axis, first, firstMirror, images);
        }
        made[chunk] = std::move(images);
    }
    for (const auto& part : made)
    {
        std::size_t foot = mirrors_.size();
        for (const auto& e : part.entries)
        {
            firstFoot_.push_back(unsigned(foot));
            foot += e.reflections;
        }
        entries_.insert(entries_.end(), part.entries.begin(), part.entries.end());
        places_.insert(places_.end(), part.places.begin(), part.places.end());
        mirrors_.insert(mirrors_.end(), part.mirrors.begin(), part.mirrors.end());
        fastest_ = std::max(fastest_, part.fastest);
    }
}

template<int dim> void Images<dim>::reflect(int source, const Vector<dim>& x, Made& made) const
{
    static thread_local std::vector<Ghost> ghosts;
    ghosts.assign(1, {{source, {}}, {}, x, 1});
    // Each ghost is mirrored once more: box corners, and the pinch between grains.
    for (std::size_t g = 0; g < ghosts.size(); ++g)
    {
        const Ghost from = ghosts[g];
        for (int p : grid_.near(in3D(from.x)))
            if (meshOf(p)) reflectInMesh(from, p, ghosts);
            else reflectInShape(from, p, in3D(x), ghosts);
    }
    for (std::size_t g = 1; g < ghosts.size(); ++g)
    {
        made.add(ghosts[g].entry, ghosts[g].x, ghosts[g].mirrors);
        made.fastest = std::max(made.fastest, ghosts[g].speed);
    }
}

/// Mirrors a ghost in each wall that the chain has not used yet, as often as there are dimensions.
template<int dim> void Images<dim>::reflectInShape(const Ghost& from, int p, const Vector<3>& source, std::vector<Ghost>& ghosts) const
{
    const int before = from.entry.reflections;
    const bool again = before == 2 && mirrorsAgain(from.mirrors, p);
    if (!again && !mayGoOn(from, p)) return;
    Ghost next = from;
    next.mirrors[std::size_t(before)] = {p};
    const Foot f = footOf(next.mirrors[std::size_t(before)], before, in3D(from.x), source);
    const bool onFluidSide = before == 0 || f.distance > 0;
    const bool exists = f.smooth || (std::isfinite(f.margin) && f.margin > -spacing_); // or fades in or out
    if (!exists || !onFluidSide || f.distance > reach_ || !(volumeFactor(f) > 0)) return;
    next.x = in<dim>(mirrorImage(in3D(from.x), f));
    next.faces[std::size_t(before)] = {f.normal, in3D(from.x) - f.distance * f.normal, turnOf(from, p, f)};
    ++next.entry.reflections;
    if (before < dim) next.speed *= speedOf(f);
    next.weight *= weightSoon(next, f, from.speed);
    if (next.weight < leastWeight && next.isOfSeveral()) return;
    if (before > 0 && geometry_->mayBeCovered(p) && !fillsCorner(p, from.mirrors[std::size_t(before) - 1].patch, in3D(next.x))) return;
    const bool twin =
        again ? std::any_of(ghosts.begin() + 1, ghosts.end(),
                            [&](const Ghost& other) { return other.entry.reflections == 3 && mag(other.x - next.x) < 0.25 * spacing_; })
              : isTwin(next, ghosts);
    if (!twin) ghosts.push_back(next);
}

/// Whether a ghost is one of two surfaces alone, not both planes, that do not meet at right angles: their images have shares of what is behind both.
template<int dim> bool Images<dim>::isOfWedge(const Ghost& ghost) const
{
    const std::size_t last = std::size_t(ghost.entry.reflections) - 1;
    const int p = ghost.mirrors[last].patch;
    int q = -1;
    bool square = true;
    for (std::size_t r = 0; r < last; ++r)
        if (const int other = ghost.mirrors[r].patch; other != p)
        {
            if (q >= 0 && other != q) return false;
            q = other;
            square = std::abs(dot(ghost.faces[r].normal, ghost.faces[last].normal)) < rightAngle;
        }
    return q >= 0 && !square && !(isPlane(p) && isPlane(q));
}

/// Walls at right angles give the same corner image in either order; at 60 degrees a third reflection does.
template<int dim> bool Images<dim>::isTwin(const Ghost& next, const std::vector<Ghost>& ghosts) const
{
    const auto count = next.entry.reflections;
    if (isOfWedge(next)) return false;
    return std::any_of(ghosts.begin() + 1, ghosts.end(),
                       [&](const Ghost& other)
                       {
                           return other.entry.reflections == count &&
                                  std::is_permutation(other.mirrors.begin(), other.mirrors.begin() + count, next.mirrors.begin()) &&
                                  mag(other.x - next.x) < 0.25 * spacing_;
                       });
}

/// Mirrors a ghost in every face that owns the place where the image comes to lie, or soon will: in one body as often as it takes to fill its edges and corners.
template<int dim> void Images<dim>::reflectInMesh(const Ghost& from, int p, std::vector<Ghost>& ghosts) const
{
    const int before = from.entry.reflections;
    if (before == mostReflections) return;
    const auto last = from.mirrors.begin() + before;
    const bool goesOn = before > 0 && (last - 1)->patch == p;
    if (!goesOn && !mayGoOn(from, p)) return;
    const auto* mesh = meshOf(p);
    const auto x = mesh->local(in3D(from.x));
    mesh->body().forEachMirror(x, reach_, before == 0 ? 0.5 * spacing_ : 0, spacing_, mesh->hidden(),
                               [&](int facet, Foot f)
                               {
                                   if (before > 0 && f.distance <= 0) return;
                                   if (f.distance < 0 && mesh->body().distance(x) > 0) return; // beside an edge, in front of the next face
                                   if (!(volumeFactor(f) > 0) || (before == 0 && !mesh->body().sees(x, facet))) return;
                                   Ghost next = from;
                                   next.mirrors[std::size_t(before)] = {p, facet};
                                   next.x = in<dim>(mirrorImage(in3D(from.x), f));
                                   next.faces[std::size_t(before)] = {f.normal, in3D(from.x) - f.distance * f.normal, turnOf(from, p, f)};
                                   ++next.entry.reflections;
                                   // An image in a small hollow is faster still; lists would be built anew at every step for it.
                                   if (before < dim) next.speed *= std::min(speedOf(f), 2.0);
                                   next.weight *= weightSoon(next, f, from.speed);
                                   if (next.weight < leastWeight && next.isOfSeveral()) return;
                                   if (before > 0 && !goesOn && geometry_->mayBeCovered(p) &&
                                       !fillsCorner(p, (last - 1)->patch, in3D(next.x)))
                                       return;
                                   if (!goesOn && isTwin(next, ghosts)) return;
                                   ghosts.push_back(next);
                               });
}

/// Whether an image mirrored once more, in `p` after `q`, fills what the two solids leave: it lies in one of them, and they meet sharply enough.
template<int dim> bool Images<dim>::fillsCorner(int p, int q, const Vector<3>& x) const
{
    const auto& near = geometry_->coverers[std::size_t(p)];
    if (std::find(near.begin(), near.end(), q) == near.end()) return true;
    return geometry_->patches[std::size_t(p)].shape->foot(x).distance <= geometry_->tolerance() || geometry_->isCovered(p, x);
}

/// Across the faces of one axis: a particle at x, and its images so far, from `first` on.
template<int dim>
void Images<dim>::shift(int source, const Vector<dim>& x, int axis, std::size_t first, std::size_t firstMirror, Made& made) const
{
    const auto c = component(axis);
    const double low = geometry_->low.*c, high = geometry_->high.*c;
    Vector<3> period;
    period.*c = high - low;
    const auto across = [&](Entry e, const Vector<dim>& y, const Mirrors& mirrors)
    {
        const double q = in3D(y).*c;
        for (const int way : {1, -1})
            if (way > 0 ? q < low + reach_ : q > high - reach_)
            {
                e.shift[std::size_t(axis)] = static_cast<signed char>(way);
                made.add(e, y + in<dim>(double(way) * period), mirrors);
            }
    };
    const std::size_t last = made.entries.size();
    across({source, {}}, x, {});
    std::size_t mirror = firstMirror;
    for (std::size_t k = first; k < last; ++k)
    {
        const Entry e = made.entries[k];
        Mirrors mirrors;
        std::copy_n(made.mirrors.begin() + long(mirror), e.reflections, mirrors.begin());
        mirror += e.reflections;
        across(e, Vector<dim>(made.places[k]), mirrors);
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

/// Forgets images that this rank's particles cannot see.
template<int dim> void Images<dim>::keepNear()
{
    keepIf([this](std::size_t k) { return halo_->isNear(places_[k]); });
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
        keepNear();
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
            const auto* mesh = meshOf(first.patch);
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
    const bool inMeshes = std::ranges::any_of(geometry_->patches, [](const auto& p) { return p.mesh != nullptr; });
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
    const auto low = in<dim>(geometry_->low), extent = in<dim>(geometry_->high - geometry_->low);
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

template<int dim> NearestFoot Images<dim>::nearestFoot(Vector<dim> x, double reach) const
{
    NearestFoot nearest;
    nearest.foot.distance = Box::infinity;
    for (const int p : wallsNear(x))
        if (const Foot foot = geometry_->foot(p, in3D(x));
            foot.exposure > 0 && foot.distance <= reach && foot.distance < nearest.foot.distance)
            nearest = {foot, p};
    return nearest;
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
        if (const auto* mesh = meshOf(mirror.patch); mesh && !mesh->body().facets()[std::size_t(mirror.facet)].planar) d *= 0.5;
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
