#include "images/WallLayers.hpp"
#include "base/CaseError.hpp"
#include "geometry/components.hpp"
#include "geometry/forEachFoot.hpp"
#include "geometry/periodicShifts.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <tuple>

namespace sph
{

template<int dim>
WallLayers<dim>::WallLayers(const Geometry& geometry, const Kernel<dim>& kernel, double reach, double spacing)
    : geometry_(geometry), kernel_(kernel), closest_(0.25 * spacing)
{
    const auto within = [&](Vector<3> x)
    {
        for (int c = 0; c < dim; ++c)
            if (geometry.periodic[c] &&
                (x.*component(c) < geometry.low.*component(c) - reach || x.*component(c) > geometry.high.*component(c) + reach))
                return false;
        return true;
    };
    const auto add = [&](const LayerParticle& particle, Vector<3> x, int original)
    {
        Particle p{in<dim>(x), particle.volumeFactor, original, unsigned(walls_.size()), 0};
        forEachFootAlone(
            geometry, x, 0,
            [&](const Foot& foot, int k)
            {
                if (foot.distance == 0 || p.walls == dim) return;
                walls_.push_back({k, geometry.patches[std::size_t(k)].wallAt(foot.region), foot, x - foot.distance * foot.normal});
                ++p.walls;
            });
        if (p.walls == 0)
            throw CaseError({"constant/lagrangian/wallLayers/positions", 0},
                            fmt::format("the particle at ({:.6g} {:.6g} {:.6g}) does not lie in a wall: run meshToGhost again", x.x, x.y,
                                        x.z));
        weighted_ = weighted_ || std::abs(p.weight - 1) > 1e-12;
        particles_.push_back(p);
    };
    for (const auto& particle : geometry.layers) add(particle, particle.x, int(particles_.size()));
    checkDepth(spacing);
    const auto originals = particles_.size();
    for (std::size_t k = 0; k < originals; ++k)
        forEachPeriodicShift(geometry,
                             [&](const Vector<3>& by)
                             {
                                 if (const auto x = geometry.layers[k].x + by; within(x)) add(geometry.layers[k], x, int(k));
                             });
    firstPair_.assign(originals + 1, 0);
}

/// Checks the first and the last layer of each wall: the one lies half a layer deep, and behind the other is no place for more, in the support, solid or domain.
template<int dim> void WallLayers<dim>::checkDepth(double spacing) const
{
    const double H = std::visit([](const auto& kernel) { return kernel.H; }, kernel_.choice());
    struct Layers
    {
        double first = Box::infinity, last = 0, deepest = 0;
        Vector<3> x, n;
    };
    std::map<int, Layers> all;
    for (const auto& particle : particles_)
        for (const auto& behind : wallsOf(particle))
        {
            auto& layers = all[behind.wall];
            const double depth = -behind.foot.distance;
            if (geometry_.layers[std::size_t(particle.original)].wall == behind.wall) layers.first = std::min(layers.first, depth);
            if (depth <= layers.last) continue;
            layers.last = depth;
            layers.x = in3D(particle.x);
            layers.n = behind.foot.normal;
            layers.deepest = std::min(H, geometry_.patches[std::size_t(behind.patch)].shape->smallestRadius());
        }
    for (const auto& [wall, layers] : all)
    {
        const auto& [name, where] = std::tie(geometry_.walls[std::size_t(wall)].name, geometry_.walls[std::size_t(wall)].where);
        if (std::isfinite(layers.first) && layers.first > 0.8 * spacing)
            throw CaseError(where,
                            fmt::format("the first layer of particles behind {} lies {:.4g} m deep, and particles are {:.4g} m apart: run "
                                        "meshToGhost again",
                                        name, layers.first, spacing));
        const auto next = layers.x - 2 * layers.first * layers.n;
        bool inDomain = true;
        for (int c = 0; c < dim; ++c)
            inDomain =
                inDomain && next.*component(c) > geometry_.low.*component(c) - H && next.*component(c) < geometry_.high.*component(c) + H;
        if (inDomain && layers.last + 2 * layers.first < (1 - 1e-6) * layers.deepest)
            throw CaseError(where,
                            fmt::format("the layers of particles behind {} are {:.4g} m thick, less than the kernel's support, {:.4g} m: "
                                        "run meshToGhost again",
                                        name, layers.last + layers.first, layers.deepest));
    }
}

template<int dim> void WallLayers<dim>::keepNear(const Halo<dim>& halo)
{
    halo_ = &halo;
    near_.clear();
    std::ranges::copy_if(particles_, std::back_inserter(near_), [&](const Particle& p) { return halo.isNear(p.x); });
}

template<int dim> void WallLayers<dim>::place(FieldStore<dim>& store, std::size_t first)
{
    first_ = first;
    const auto x = store.pointers(Position{});
    double* const weight = store.has(ImageWeight{}) ? store.component(ImageWeight::info.name, 0) : nullptr;
    double* const wall = store.has(GhostWall{}) ? store.component(GhostWall::info.name, 0) : nullptr;
    for (std::size_t k = 0; k < placed().size(); ++k)
    {
        const Particle& p = placed()[k];
        sph::store(p.x, [&](int c, double q) { x[c][first + k] = q; });
        if (weight) weight[first + k] = p.weight;
        if (wall) wall[first + k] = 1 + wallsOf(p).back().wall;
    }
}

template<int dim> void WallLayers<dim>::list(const NeighbourLists<dim>& lists, std::size_t owned)
{
    const auto& particles = placed();
    const auto each = [&](const auto& f)
    {
        typename NeighbourLists<dim>::Room room;
        for (std::size_t i = 0; i < owned; ++i)
            for (const int j : lists.of(i, room))
                if (const auto k = std::size_t(j) - first_; std::size_t(j) >= first_ && k < particles.size()) f(int(i), int(k));
    };
    std::fill(firstPair_.begin(), firstPair_.end(), 0);
    each([&](int, int j) { ++firstPair_[std::size_t(particles[std::size_t(j)].original) + 1]; });
    for (std::size_t k = 1; k < firstPair_.size(); ++k) firstPair_[k] += firstPair_[k - 1];
    pairs_.resize(firstPair_.back());
    auto next = firstPair_;
    each([&](int i, int j) { pairs_[next[std::size_t(particles[std::size_t(j)].original)]++] = {i, j}; });
    if (halo_) findSharers();
}

/// A rank names to each other what it sees near the other's box: what both name both see, whichever of its copies it is.
template<int dim> void WallLayers<dim>::findSharers()
{
    const auto& all = halo_->all();
    std::vector<std::vector<int>> seen(std::size_t(all.count()));
    for (const auto& particle : particles_)
    {
        const auto k = std::size_t(particle.original);
        if (firstPair_[k] == firstPair_[k + 1]) continue;
        halo_->forEachOtherNear(particle.x, [&](int r) { seen[std::size_t(r)].push_back(particle.original); });
    }
    for (auto& originals : seen)
    {
        std::ranges::sort(originals);
        originals.erase(std::ranges::unique(originals).begin(), originals.end());
    }
    const auto seenByOthers = exchangeParts<int>(all, seen);
    sharers_.clear();
    for (int r = 0; r < all.count(); ++r)
    {
        if (r == all.rank()) continue;
        Sharer sharer{r, {}};
        std::ranges::set_intersection(seen[std::size_t(r)], seenByOthers[std::size_t(r)], std::back_inserter(sharer.originals));
        if (!sharer.originals.empty()) sharers_.push_back(std::move(sharer));
    }
}

template<int dim> std::size_t WallLayers<dim>::bytes() const
{
    return (particles_.capacity() + near_.capacity()) * sizeof(Particle) + walls_.capacity() * sizeof(Behind) +
           pairs_.capacity() * sizeof(PressurePair) + firstPair_.capacity() * sizeof(std::size_t);
}

template class WallLayers<2>;
template class WallLayers<3>;

}
