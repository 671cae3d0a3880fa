#include "Images.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

namespace
{
/// Two surfaces that meet at a fluid angle above about 105 degrees fill the solid behind them with one reflection each. n_p . n_q =
/// -cos(angle).
constexpr double mostAlignedNormals = 0.26;
}

template<int dim>
Images<dim>::Images(const Geometry& geometry, double reach, double spacing, double skin)
    : geometry_(&geometry), grid_(geometry, reach), reach_(reach), spacing_(spacing), skin_(skin)
{}

/// The foot of what is mirrored: of the source itself, or of its image so far.
template<int dim> Foot Images<dim>::footOf(const Entry& e, int reflection, const Vector<3>& x, const Vector<3>& source) const
{
    const int p = e.patch[reflection];
    return reflection == 0 ? geometry_->foot(p, x) : geometry_->footOfGhost(p, x, source);
}

/// How many times as far as what is mirrored its image moves, until the lists are built anew: meanwhile the distance grows by half the skin
/// at most, and beyond the support it matters no more.
template<int dim> double Images<dim>::speedOf(const Foot& f) const
{
    const double k = std::max({f.k1, f.k2, 0.0}), d = std::max(f.distance, std::min(f.distance + 0.5 * skin_, reach_ - skin_));
    return k > 0 && f.distance <= reach_ - skin_ ? (1 + k * d) / std::max(1 - k * d, 0.01) : 1;
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

template<int dim> Vector<dim> Images<dim>::place(const Entry& e, Vector<dim> x, Feet* feet, double* share) const
{
    const auto source = in3D(x);
    for (int r = 0; r < mostReflections && e.patch[r] >= 0; ++r)
    {
        const Foot f = footOf(e, r, in3D(x), source);
        feet[r] = {in<dim>(f.normal), f.distance, volumeFactor(f)};
        if (share) *share *= faceShare(f, spacing_);
        x = in<dim>(mirrorImage(in3D(x), f));
    }
    return x + period(e);
}

template<int dim> bool Images<dim>::mirrorsAgain(const Entry& twice, int patch) const
{
    if (patch != twice.patch[0]) return false;
    const auto normal = [&](int p) { return geometry_->patches[std::size_t(p)].shape->foot({}).normal; };
    const auto isPlane = [&](int p)
    {
        const auto& shape = *geometry_->patches[std::size_t(p)].shape;
        return std::isinf(shape.smallestRadius()) && !shape.hasEdges();
    };
    if (!isPlane(twice.patch[0]) || !isPlane(twice.patch[1])) return false;
    // From about 75 degrees on two reflections fill the corner. Planes that all but face one another are a slit, whose third image is far.
    const double cosine = -dot(normal(twice.patch[0]), normal(twice.patch[1]));
    return cosine > 0.26 && cosine < 0.97;
}

template<int dim> void Images<dim>::reflect(std::vector<Entry>& entries, const std::array<double*, dim>& x)
{
    struct Ghost
    {
        Entry entry;
        Vector<dim> x;
        int wallReflections;
        double speed; ///< over that of its source
    };
    fastest_ = 1;
    if (geometry_->patches.empty() || layers_) return;

    const std::size_t chunkSize = 1024;
    std::vector<std::vector<Entry>> found((owned_ + chunkSize - 1) / chunkSize);
    double fastest = 1;
#pragma omp parallel for schedule(dynamic) reduction(max : fastest)
    for (std::size_t chunk = 0; chunk < found.size(); ++chunk)
    {
        std::vector<Ghost> ghosts;
        for (std::size_t i = chunk * chunkSize; i < std::min(owned_, (chunk + 1) * chunkSize); ++i)
        {
            Vector<dim> x_i;
            fetch(x_i, [&](int c) { return x[c][i]; });
            Entry self{int(i), {}, {}};
            self.patch.fill(-1);
            ghosts.assign(1, {self, x_i, 0, 1});
            // Each ghost is mirrored in the walls that its own chain has not used yet: box corners, and the pinch between grains.
            for (std::size_t g = 0; g < ghosts.size(); ++g)
            {
                const Ghost from = ghosts[g];
                if (from.wallReflections == mostReflections) continue;
                for (int p : grid_.near(in3D(from.x)))
                {
                    const bool again = from.wallReflections == 2 && mirrorsAgain(from.entry, p);
                    const bool used = std::find(from.entry.patch.begin(), from.entry.patch.end(), p) != from.entry.patch.end();
                    if (!again && (used || from.wallReflections == dim)) continue;
                    Ghost next = from;
                    next.entry.patch[from.wallReflections] = p;
                    const Foot f = footOf(next.entry, from.wallReflections, in3D(from.x), in3D(x_i));
                    const bool onFluidSide = from.wallReflections == 0 || f.distance > 0;
                    const bool exists = f.smooth || (std::isfinite(f.margin) && f.margin > -spacing_); // or fades in or out
                    if (!exists || !onFluidSide || f.distance > reach_ || volumeFactor(f) <= 0) continue;
                    next.x = in<dim>(mirrorImage(in3D(from.x), f));
                    ++next.wallReflections;
                    next.speed *= speedOf(f);
                    if (from.wallReflections > 0 && geometry_->mayBeCovered(p) &&
                        !fillsCorner(next.entry, from.wallReflections, in3D(next.x), in3D(x_i)))
                        continue;
                    // Walls at right angles give the same corner image in either order; at 60 degrees a third reflection does.
                    const bool twin =
                        std::any_of(ghosts.begin() + 1, ghosts.end(),
                                    [&](const Ghost& other)
                                    {
                                        return (again ? other.wallReflections == 3
                                                      : std::is_permutation(other.entry.patch.begin(), other.entry.patch.end(),
                                                                            next.entry.patch.begin())) &&
                                               mag(other.x - next.x) < 0.25 * spacing_;
                                    });
                    if (twin) continue;
                    ghosts.push_back(next);
                    fastest = std::max(fastest, next.speed);
                }
            }
            for (std::size_t g = 1; g < ghosts.size(); ++g) found[chunk].push_back(ghosts[g].entry);
        }
    }
    fastest_ = fastest;
    for (const auto& f : found) entries.insert(entries.end(), f.begin(), f.end());
}

/// Whether an image mirrored once more fills what the two solids leave: it lies in one of them, and they meet sharply enough.
template<int dim> bool Images<dim>::fillsCorner(const Entry& e, int last, const Vector<3>& x, const Vector<3>& source) const
{
    const int p = e.patch[last], q = e.patch[last - 1];
    const auto& near = geometry_->coverers[std::size_t(p)];
    if (std::find(near.begin(), near.end(), q) == near.end()) return true;
    if (dot(geometry_->foot(p, source).normal, geometry_->foot(q, source).normal) > mostAlignedNormals) return false;
    return geometry_->patches[std::size_t(p)].shape->foot(x).distance <= geometry_->tolerance() || geometry_->isCovered(p, x);
}

template<int dim> void Images<dim>::shift(std::vector<Entry>& entries, const std::array<double*, dim>& x) const
{
    for (int c = 0; c < dim; ++c)
    {
        if (!geometry_->periodic[c]) continue;
        double low = 0, high = 0;
        store(in<dim>(geometry_->low),
              [&](int d, double q)
              {
                  if (d == c) low = q;
              });
        store(in<dim>(geometry_->high),
              [&](int d, double q)
              {
                  if (d == c) high = q;
              });
        const std::size_t before = entries.size();
        const auto consider = [&](Entry e)
        {
            Feet feet[mostReflections];
            Vector<dim> x_i;
            fetch(x_i, [&](int d) { return x[d][e.source]; });
            double q = 0;
            store(place(e, x_i, feet),
                  [&](int d, double a)
                  {
                      if (d == c) q = a;
                  });
            if (q < low + reach_)
            {
                e.shift[c] = 1;
                entries.push_back(e);
            }
            if (q > high - reach_)
            {
                e.shift[c] = -1;
                entries.push_back(e);
            }
        };
        for (std::size_t i = 0; i < owned_; ++i)
            if (x[c][i] < low + reach_ || x[c][i] > high - reach_)
            {
                Entry e{int(i), {}, {}};
                e.patch.fill(-1);
                consider(e);
            }
        for (std::size_t k = 0; k < before; ++k) consider(entries[k]);
    }
}

template<int dim> void Images<dim>::build(FieldStore<dim>& store, std::size_t owned)
{
    owned_ = owned;
    entries_.clear();
    const auto x = store.pointers(Position{});
    reflect(entries_, x);
    shift(entries_, x);
    // Vectors that grow by themselves double: of many images that is more than a field.
    if (entries_.capacity() > entries_.size() + entries_.size() / 10) entries_.shrink_to_fit();
    const auto resize = [](auto& v, std::size_t n)
    {
        if (n > v.capacity()) v.reserve(n + n / 20);
        v.resize(n);
    };
    resize(firstFoot_, entries_.size());
    std::size_t feet = 0, k = 0;
    for (const auto& e : entries_)
    {
        firstFoot_[k++] = unsigned(feet);
        for (int p : e.patch) feet += p >= 0;
    }
    resize(feet_, feet);
    store.resize(nullParticle() + 1, owned_);
    if (layers_) layers_->place(store, owned_ + entries_.size());
    move(store);
}

template<int dim> void Images<dim>::move(FieldStore<dim>& store)
{
    const auto x = store.pointers(Position{});
    double* const weight = store.has(ImageWeight{}) ? store.component(ImageWeight::info.name, 0) : nullptr;
    double* const wall = store.has(GhostWall{}) ? store.component(GhostWall::info.name, 0) : nullptr;
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < entries_.size(); ++k)
    {
        const Entry& e = entries_[k];
        Feet none[mostReflections];
        Feet* const feet = e.ghost() ? feet_.data() + firstFoot_[k] : none;
        Vector<dim> x_i;
        fetch(x_i, [&](int c) { return x[c][e.source]; });
        double w = 1;
        sph::store(place(e, x_i, feet, weight ? &w : nullptr), [&](int c, double q) { x[c][owned_ + k] = q; });
        if (weight)
        {
            for (int r = 0; r < mostReflections && e.patch[r] >= 0; ++r) w *= feet[r].weight;
            weight[owned_ + k] = w;
        }
        if (wall)
        {
            double behind = 0;
            for (int r = 0; r < mostReflections && e.patch[r] >= 0; ++r) behind = 1 + geometry_->patches[e.patch[r]].wall;
            wall[owned_ + k] = behind;
        }
    }
    const auto low = in<dim>(geometry_->low), extent = in<dim>(geometry_->high - geometry_->low);
    sph::store(low - 1e3 * extent, [&](int c, double q) { x[c][nullParticle()] = q; });
    if (weight)
    {
        std::fill_n(weight, owned_, 1.0);
        weight[nullParticle()] = 1.0;
    }
    if (wall)
    {
        std::fill_n(wall, owned_, 0.0);
        wall[nullParticle()] = 0.0;
    }
}

template<int dim> std::size_t Images<dim>::bytes() const
{
    return (layers_ ? layers_->bytes() : 0) + entries_.capacity() * sizeof(Entry) + feet_.capacity() * sizeof(Feet) +
           firstFoot_.capacity() * sizeof(unsigned);
}

template class Images<2>;
template class Images<3>;

}
