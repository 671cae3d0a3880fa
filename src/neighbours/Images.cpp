#include "Images.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

template<int dim>
Images<dim>::Images(const Geometry& geometry, double reach, double spacing)
    : geometry_(&geometry), grid_(geometry, reach), reach_(reach), spacing_(spacing)
{}

template<int dim> Vector<dim> Images<dim>::period(const Entry& e) const
{
    const auto extent = in<dim>(geometry_->high - geometry_->low);
    Vector<dim> by;
    fetch(by, [&](int c)
          { double L = 0; int k = 0; store(extent, [&](int d, double q) { if (k++, d == c) L = q; }); return e.shift[c]*L; });
    return by;
}

template<int dim> Vector<dim> Images<dim>::place(const Entry& e, Vector<dim> x, Feet* feet, double* share) const
{
    for (int r = 0; r < mostReflections && e.patch[r] >= 0; ++r)
    {
        const Foot f = geometry_->patches[e.patch[r]].shape->foot(in3D(x));
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

template<int dim>
void Images<dim>::reflect(std::vector<Entry>& entries, const std::array<double*, dim>& x) const
{
    struct Ghost
    {
        Entry entry;
        Vector<dim> x;
        int wallReflections;
    };
    if (geometry_->patches.empty() || layers_) return;

    const std::size_t chunkSize = 1024;
    std::vector<std::vector<Entry>> found((owned_ + chunkSize - 1)/chunkSize);
    #pragma omp parallel for schedule(dynamic)
    for (std::size_t chunk = 0; chunk < found.size(); ++chunk)
    {
        std::vector<Ghost> ghosts;
        for (std::size_t i = chunk*chunkSize; i < std::min(owned_, (chunk + 1)*chunkSize); ++i)
        {
            Vector<dim> x_i;
            fetch(x_i, [&](int c) { return x[c][i]; });
            Entry self{int(i), {}, {}};
            self.patch.fill(-1);
            ghosts.assign(1, {self, x_i, 0});
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
                    const Foot f = geometry_->patches[p].shape->foot(in3D(from.x));
                    const bool onFluidSide = from.wallReflections == 0 || f.distance > 0;
                    const bool exists = f.smooth || (std::isfinite(f.margin) && f.margin > -spacing_); // or fades in or out
                    if (!exists || !onFluidSide || f.distance > reach_ || volumeFactor(f) <= 0) continue;
                    Ghost next{from.entry, in<dim>(mirrorImage(in3D(from.x), f)), from.wallReflections + 1};
                    next.entry.patch[from.wallReflections] = p;
                    // Walls at right angles give the same corner image in either order; at 60 degrees a third reflection does.
                    const bool twin = std::any_of(ghosts.begin() + 1, ghosts.end(), [&](const Ghost& other)
                        { return (again ? other.wallReflections == 3
                                        : std::is_permutation(other.entry.patch.begin(), other.entry.patch.end(), next.entry.patch.begin())) &&
                                 mag(other.x - next.x) < 0.25*spacing_; });
                    if (!twin) ghosts.push_back(next);
                }
            }
            for (std::size_t g = 1; g < ghosts.size(); ++g) found[chunk].push_back(ghosts[g].entry);
        }
    }
    for (const auto& f : found) entries.insert(entries.end(), f.begin(), f.end());
}

template<int dim> void Images<dim>::shift(std::vector<Entry>& entries, const std::array<double*, dim>& x) const
{
    for (int c = 0; c < dim; ++c)
    {
        if (!geometry_->periodic[c]) continue;
        double low = 0, high = 0;
        store(in<dim>(geometry_->low), [&](int d, double q) { if (d == c) low = q; });
        store(in<dim>(geometry_->high), [&](int d, double q) { if (d == c) high = q; });
        const std::size_t before = entries.size();
        const auto consider = [&](Entry e)
        {
            Feet feet[mostReflections];
            Vector<dim> x_i;
            fetch(x_i, [&](int d) { return x[d][e.source]; });
            double q = 0;
            store(place(e, x_i, feet), [&](int d, double a) { if (d == c) q = a; });
            if (q < low + reach_) { e.shift[c] = 1; entries.push_back(e); }
            if (q > high - reach_) { e.shift[c] = -1; entries.push_back(e); }
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
    inDomain_ = entries_.size();
    shift(entries_, x);
    // Vectors that grow by themselves double: of many images that is more than a field.
    if (entries_.capacity() > entries_.size() + entries_.size()/10) entries_.shrink_to_fit();
    const auto resize = [](auto& v, std::size_t n)
    {
        if (n > v.capacity()) v.reserve(n + n/20);
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
    sph::store(low - 1e3*extent, [&](int c, double q) { x[c][nullParticle()] = q; });
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
    return (layers_ ? layers_->bytes() : 0) + entries_.capacity()*sizeof(Entry) +
           feet_.capacity()*sizeof(Feet) + firstFoot_.capacity()*sizeof(unsigned);
}

template class Images<2>;
template class Images<3>;

}
