#include "images/makeImages.hpp"
#include "base/values.hpp"
#include "geometry/components.hpp"
#include "images/chainTable.hpp"
#include "images/imageShares.hpp"

namespace sph
{

namespace
{

/// All chains of one particle. The first is the particle itself, which has no reflections.
template<int dim> class Chains
{
    const ReflectingWalls& walls_;
    Vector<3> source_;
    std::vector<Chain>& chains_;

    /// Mirrors `from` once more, in this foot, and keeps the image where the table does; `faster`: its speed over that of what is mirrored.
    void mirror(const Chain& from, const Mirror& in, const Foot& f, double faster, ChainStep step)
    {
        const auto before = std::size_t(from.reflections);
        Chain next = from;
        next.mirrors[before] = in;
        next.x = in3D(sph::in<dim>(mirrorImage(from.x, f)));
        next.faces[before] = {f.normal, from.x - f.distance * f.normal, walls_.turnOf(in.patch, f, from.speed)};
        ++next.reflections;
        if (before < dim) next.speed *= faster;
        next.weight *= weightSoon(walls_, next, f, from.speed, dim);
        const auto fillsCorner = [&] { return walls_.fillsCorner(in.patch, from.lastPatch(), next.x); };
        if (keepsImage(next, step, chains_, walls_.reflectors(), walls_.spacing(), fillsCorner) == Kept::yes) chains_.push_back(next);
    }

    void mirrorInShape(const Chain& from, int p, ChainStep step)
    {
        Mirror in{p};
        const Foot f = walls_.footOf(in, from.reflections, from.x, source_);
        const bool onFluidSide = from.reflections == 0 || f.distance > 0;
        const bool exists = f.smooth || (std::isfinite(f.margin) && f.margin > -walls_.spacing()); // or fades in or out
        if (!exists || !onFluidSide || f.distance > walls_.reach() || !(volumeFactor(f) > 0)) return;
        mirror(from, in, f, walls_.speedOf(f), step);
    }

    /// Mirrors `from` in every face that owns the place where the image comes to lie, or soon will.
    void mirrorInMesh(const Chain& from, int p, ChainStep step)
    {
        const bool isFirst = from.reflections == 0;
        const auto& mesh = *walls_.meshOf(p);
        const auto x = mesh.local(from.x);
        mesh.body().forEachMirror(x, walls_.reach(), isFirst ? 0.5 * walls_.spacing() : 0, walls_.spacing(), mesh.hidden(),
                                  [&](int facet, const Foot& f)
                                  {
                                      if (!isFirst && f.distance <= 0) return;
                                      if (f.distance < 0 && mesh.body().distance(x) > 0)
                                          return; // beside an edge, in front of the next face
                                      if (!(volumeFactor(f) > 0) || (isFirst && !mesh.body().sees(x, facet))) return;
                                      // An image in a small hollow is faster still; lists would be built anew at every step for it.
                                      mirror(from, {p, facet}, f, std::min(walls_.speedOf(f), 2.0), step);
                                  });
    }

public:
    Chains(const ReflectingWalls& walls, const Vector<dim>& x, std::vector<Chain>& room) : walls_(walls), source_(in3D(x)), chains_(room)
    {
        chains_.assign(1, {source_});
    }
    /// Mirrors the particle, and each image once it is made.
    void grow()
    {
        for (std::size_t k = 0; k < chains_.size(); ++k)
        {
            const Chain from = chains_[k];
            for (const int p : walls_.near().patches(from.x))
                if (const auto step = stepInto(p, from, walls_.reflectors(), dim); step != ChainStep::none)
                    walls_.meshOf(p) ? mirrorInMesh(from, p, step) : mirrorInShape(from, p, step);
        }
    }
};

/// Returns the largest speed of an image over that of its source.
template<int dim> double reflect(const ReflectingWalls& walls, int source, const Vector<dim>& x, MadeImages<dim>& made)
{
    static thread_local std::vector<Chain> chains;
    Chains<dim>(walls, x, chains).grow();
    double fastest = 1;
    for (std::size_t k = 1; k < chains.size(); ++k)
    {
        made.add({source, {}, static_cast<unsigned char>(chains[k].reflections)}, in<dim>(chains[k].x), chains[k].mirrors.data());
        fastest = std::max(fastest, chains[k].speed);
    }
    return fastest;
}

/// Shifts a particle at x, and its images so far, from `first` on, across the periodic faces of one axis.
template<int dim>
void shift(const ReflectingWalls& walls, int source, const Vector<dim>& x, int axis, std::size_t first, std::size_t firstMirror,
           MadeImages<dim>& made)
{
    const auto c = component(axis);
    const double low = walls.geometry().low.*c, high = walls.geometry().high.*c;
    Vector<3> period;
    period.*c = high - low;
    const auto across = [&](ImageEntry<dim> e, const Vector<dim>& y, const Mirror* mirrors)
    {
        const double q = in3D(y).*c;
        for (const int way : {1, -1})
            if (way > 0 ? q < low + walls.reach() : q > high - walls.reach())
            {
                e.shift[std::size_t(axis)] = static_cast<signed char>(way);
                made.add(e, y + in<dim>(double(way) * period), mirrors);
            }
    };
    const std::size_t last = made.entries.size();
    across({source, {}}, x, nullptr);
    std::size_t mirror = firstMirror;
    for (std::size_t k = first; k < last; ++k)
    {
        const auto e = made.entries[k];
        Mirrors mirrors;
        std::copy_n(made.mirrors.begin() + long(mirror), e.reflections, mirrors.begin());
        mirror += e.reflections;
        across(e, Vector<dim>(made.places[k]), mirrors.data());
    }
}

/// Makes the images of particle i at x by the reflections and shifts of those that were made before; false where there are none, or x is too far from where they were made.
template<int dim>
bool recallImages(const ReflectingWalls& walls, const Recall<dim>& recall, int i, const Vector<dim>& x, MadeImages<dim>& images)
{
    const auto number = recall.number ? std::size_t(recall.number[i]) : 0;
    if (number == 0 || (number - 1) / particlesAtOnce >= recall.made.size()) return false;
    const auto& made = recall.made[(number - 1) / particlesAtOnce];
    const std::size_t k = (number - 1) % particlesAtOnce;
    if (k >= made.particles.size() || !(mag(x - made.particles[k].at) <= recall.way)) return false;
    auto particle = made.particles[k];
    const Mirror* mirrors = made.mirrors.data() + particle.mirror;
    const std::size_t first = particle.entry, last = k + 1 < made.particles.size() ? made.particles[k + 1].entry : made.entries.size();
    particle.entry = unsigned(images.entries.size());
    particle.mirror = unsigned(images.mirrors.size());
    images.fastest = std::max(images.fastest, particle.fastest);
    images.particles.push_back(particle);
    for (std::size_t e = first; e < last; ++e)
    {
        auto entry = made.entries[e];
        entry.source = i;
        auto y = in3D(x);
        for (int r = 0; recall.places && r < entry.reflections; ++r)
        {
            Mirror mirror = mirrors[r];
            y = mirrorImage(y, walls.footOf(mirror, r, y, in3D(x)));
        }
        images.add(entry, in<dim>(y) + shiftOf(entry, walls.geometry()), mirrors);
        mirrors += entry.reflections;
    }
    return true;
}

}

double recalledWithin(const Geometry& geometry, double spacing)
{
    constexpr double inSpacings = 0.15;
    const bool searchesFacets =
        geometry.layers.empty() && std::ranges::any_of(geometry.patches, [](const auto& p) { return p.mesh != nullptr; });
    return searchesFacets ? inSpacings * spacing : 0;
}

/// Images follow one another as their sources do: the parts of the arrays that a thread computes of particles and of images belong together.
template<int dim>
std::vector<MadeImages<dim>> makeImages(const ReflectingWalls& walls, bool wallsReflect, const std::array<double*, dim>& x,
                                        std::size_t begin, std::size_t end, const Recall<dim>& recall)
{
    constexpr std::size_t portion = particlesAtOnce;
    std::vector<MadeImages<dim>> made((end - begin + portion - 1) / portion);
    const auto& geometry = walls.geometry();
#pragma omp parallel for schedule(dynamic)
    for (std::size_t k = 0; k < made.size(); ++k)
    {
        MadeImages<dim> images; // of this thread alone: those of two portions may share a line of the cache
        for (std::size_t i = begin + k * portion; i < std::min(end, begin + (k + 1) * portion); ++i)
        {
            const auto x_i = valueAt<Vector<dim>>(x, i);
            if (recallImages(walls, recall, int(i), x_i, images)) continue;
            const std::size_t first = images.entries.size(), firstMirror = images.mirrors.size();
            const double fastest = !geometry.patches.empty() && wallsReflect ? reflect(walls, int(i), x_i, images) : 1;
            images.fastest = std::max(images.fastest, fastest);
            if (recall.number) images.particles.push_back({x_i, fastest, unsigned(first), unsigned(firstMirror)});
            for (int axis = 0; axis < dim; ++axis)
                if (geometry.periodic[std::size_t(axis)]) shift(walls, int(i), x_i, axis, first, firstMirror, images);
        }
        made[k] = std::move(images);
    }
    return made;
}

template std::vector<MadeImages<2>> makeImages<2>(const ReflectingWalls&, bool, const std::array<double*, 2>&, std::size_t, std::size_t,
                                                  const Recall<2>&);
template std::vector<MadeImages<3>> makeImages<3>(const ReflectingWalls&, bool, const std::array<double*, 3>&, std::size_t, std::size_t,
                                                  const Recall<3>&);

}
