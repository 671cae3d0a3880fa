#include "models/tension/FreeBodies.hpp"
#include "base/JoinedTrees.hpp"
#include "fields/freeSurfaceTags.hpp"

namespace sph
{

template<int dim> void FreeBodies<dim>::count(Particles<dim>& particles)
{
    double* const number = particles.store().component(ParticleNumber::info.name, 0);
    for (std::size_t i = 0; i < particles.size(); ++i) number[i] = double(i);
    isFound_ = false;
}

template<int dim> void FreeBodies<dim>::find(const Particles<dim>& particles)
{
    const auto& store = particles.store();
    const std::size_t n = particles.size();
    const double *const number = store.component(ParticleNumber::info.name, 0), *const ghosts = store.component(GhostsSeen::info.name, 0);

    JoinedTrees trees;
    trees.reset(n);
    const std::size_t last = particles.images().nullParticle();
    typename NeighbourLists<dim>::Room room;
    for (std::size_t i = 0; i < n; ++i)
        for (const int j : particles.lists().of(i, room))
            if (std::size_t(j) < last) trees.join(i, std::size_t(number[j]));
    body_.resize(n);
    touches_.clear();
    std::vector<int> of(n, -1);
    for (std::size_t i = 0; i < n; ++i)
    {
        int& body = of[std::size_t(trees.rootOf(i))];
        if (body < 0)
        {
            body = int(touches_.size());
            touches_.push_back(0);
        }
        body_[i] = body;
        if (ghosts[i] > 0) touches_[std::size_t(body)] = 1;
    }
    for (const int i : particles.held()) touches_[std::size_t(body_[std::size_t(i)])] = 1;
    isFound_ = true;
}

template<int dim> void FreeBodies<dim>::balance(Particles<dim>& particles) const
{
    const std::size_t n = particles.size();
    auto& store = particles.store();
    const double* const m = store.pointers(Mass{})[0];
    const auto a = store.pointers(Acceleration{}), tension = store.pointers(TensionAcceleration{});
    std::vector<double> mass(touches_.size(), 0.0), force(touches_.size());
    for (std::size_t i = 0; i < n; ++i) mass[std::size_t(body_[i])] += m[i];
    for (std::size_t c = 0; c < dim; ++c)
    {
        std::fill(force.begin(), force.end(), 0.0);
        for (std::size_t i = 0; i < n; ++i) force[std::size_t(body_[i])] += m[i] * tension[c][i];
        for (std::size_t i = 0; i < n; ++i)
            if (const auto b = std::size_t(body_[i]); !touches_[b]) a[c][i] -= force[b] / mass[b];
    }
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
