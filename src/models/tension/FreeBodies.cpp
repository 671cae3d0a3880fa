#include "models/tension/FreeBodies.hpp"
#include "base/JoinedTrees.hpp"
#include "fields/freeSurfaceTags.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <array>

namespace sph
{

template<int dim> void FreeBodies<dim>::count(Particles<dim>& particles)
{
    double* const number = particles.store().component(ParticleNumber::info.name, 0);
    before_ = sumOfRanksBefore(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) number[i] = double(before_ + i);
    isFound_ = false;
}

template<int dim> void FreeBodies<dim>::find(const Particles<dim>& particles)
{
    const auto& store = particles.store();
    const std::size_t n = particles.size();
    const double *const number = store.component(ParticleNumber::info.name, 0), *const ghosts = store.component(GhostsSeen::info.name, 0);

    JoinedTrees trees;
    trees.reset(n);
    std::vector<Link> across;
    const auto& images = particles.images();
    const std::size_t last = n + images.count();
    typename NeighbourLists<dim>::Room room;
    for (std::size_t i = 0; i < n; ++i)
        for (const int j : particles.lists().of(i, room))
        {
            if (std::size_t(j) >= last) continue;
            const auto of = std::size_t(number[images.sourceOf(std::size_t(j))]);
            if (of >= before_ && of < before_ + n) trees.join(i, of - before_);
            else across.push_back({i, of});
        }
    body_.resize(n);
    std::vector<int> of(n, -1);
    int bodies = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        int& body = of[std::size_t(trees.rootOf(i))];
        if (body < 0) body = bodies++;
        body_[i] = body;
    }
    touches_.assign(ranks() ? joinAcrossRanks(across, std::size_t(bodies)) : std::size_t(bodies), 0);
    for (std::size_t i = 0; i < n; ++i)
        if (ghosts[i] > 0) touches_[std::size_t(body_[i])] = 1;
    for (const int i : particles.held()) touches_[std::size_t(body_[std::size_t(i)])] = 1;
    touches_ = ofAllRanks(touches_, std::vector<int>(touches_.size(), 0), AddEach{});
    isFound_ = true;
}

template<int dim> std::size_t FreeBodies<dim>::joinAcrossRanks(const std::vector<Link>& across, std::size_t bodies)
{
    using Pair = std::array<std::size_t, 2>;
    const auto sortedOnce = [](std::vector<Pair>& pairs)
    {
        std::ranges::sort(pairs);
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    };
    const std::size_t first = sumOfRanksBefore(bodies), all = ofAllRanks(bodies, std::size_t(0), Add{});
    const auto owned = OfRanks<std::size_t>::gather(*ranks(), body_.size());

    // Whose the particles are, that the bodies of this rank see: each rank is told which of its particles, and by which body.
    std::vector<Pair> seen;
    for (const auto& [i, number] : across) seen.push_back({number, first + std::size_t(body_[i])});
    sortedOnce(seen);
    std::vector<std::vector<Pair>> told(owned.size());
    std::size_t r = 0, end = owned[0];
    for (const auto& pair : seen)
    {
        while (pair[0] >= end) end += owned[++r];
        told[r].push_back(pair);
    }
    std::vector<Pair> joined;
    for (const auto& part : exchangeParts<Pair>(*ranks(), told))
        for (const auto& [number, body] : part) joined.push_back({first + std::size_t(body_[number - before_]), body});
    sortedOnce(joined);

    std::vector<std::vector<Pair>> copies(owned.size(), joined);
    JoinedTrees trees;
    trees.reset(all);
    for (const auto& part : exchangeParts<Pair>(*ranks(), copies))
        for (const auto& [one, other] : part) trees.join(one, other);
    std::vector<int> label(all);
    int labels = 0;
    for (std::size_t k = 0; k < all; ++k)
    {
        const auto root = std::size_t(trees.rootOf(k));
        label[k] = root == k ? labels++ : label[root]; // the root is the least of its body
    }
    for (int& body : body_) body = label[first + std::size_t(body)];
    return std::size_t(labels);
}

template<int dim> void FreeBodies<dim>::balance(Particles<dim>& particles) const
{
    const std::size_t n = particles.size(), bodies = touches_.size();
    auto& store = particles.store();
    const double* const m = store.pointers(Mass{})[0];
    const auto a = store.pointers(Acceleration{}), tension = store.pointers(TensionAcceleration{});
    std::vector<double> sums((1 + dim) * bodies, 0.0); // mass, and each component of the force, of all bodies
    for (std::size_t i = 0; i < n; ++i) sums[std::size_t(body_[i])] += m[i];
    for (std::size_t c = 0; c < dim; ++c)
        for (std::size_t i = 0; i < n; ++i) sums[(1 + c) * bodies + std::size_t(body_[i])] += m[i] * tension[c][i];
    sums = ofAllRanks(sums, std::vector<double>(sums.size(), 0.0), AddEach{});
    for (std::size_t c = 0; c < dim; ++c)
        for (std::size_t i = 0; i < n; ++i)
            if (const auto b = std::size_t(body_[i]); !touches_[b]) a[c][i] -= sums[(1 + c) * bodies + b] / sums[b];
}

template<int dim> std::vector<Stage<dim>> FreeBodies<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::sorted)
        return {{"number particles", "for what images are images of", [this](Particles<dim>& p, const Substep&) { count(p); }}};
    if (place == JoinPoint::afterEvaluation)
        return {{"balance free bodies", "no force of tension on the whole of each",
                 [this](Particles<dim>& p, const Substep&)
                 {
                     if (!isFound_) find(p);
                     balance(p);
                 }}};
    return {};
}

template class FreeBodies<2>;
template class FreeBodies<3>;

}
